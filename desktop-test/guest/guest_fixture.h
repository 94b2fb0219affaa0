#pragma once

#include "support/app_context.h"
#include "unit/session/sequence_fixture.h"

#include "gpu/gl_test.h"

#include <cstddef>
#include <optional>
#include <vector>

namespace glide::test {

/// Sessions with Backend::gles in contexts of an app. Each test begins with a new context current,
/// app(), and fails when the driver complains about a call in it.
class GuestTest : public GlTest {
 protected:
  void SetUp() override;
  void TearDown() override;

  AppContext& app() { return *app_; }
  /// The app's context is destroyed, with all that is in it.
  void destroyApp();
  /// Another context than app(), current afterwards.
  AppContext makeContext(ContextSharing sharing);

  /// Small enough for software drivers; mapping is inline.
  Config config() const;
  /// The walk's next frame; all sessions of a test see the same frames.
  Result<FrameResult> feed(Session* session, int frame) const;
  /// The same with another image of that frame.
  Result<FrameResult> feed(Session* session,
                           int frame,
                           const decltype(FrameInput::image)& image) const;
  /// Feeds frames 0.. until the direct tracker has placed one; the number of the next frame.
  int trackDirectly(Session* session) const;

 private:
  std::optional<ScopedCurrentContext> main_;
  std::optional<AppContext> app_;
};

/// The walk's images; each is rendered once in the program.
const ImageU8& walkImage(int frame);

/// How many names of each kind the current context has, in the order buffers, textures, programs
/// and shaders, samplers, framebuffers, vertex arrays, queries.
std::vector<int> countNames();

}  // namespace glide::test
