#pragma once

#include "unit/session/sequence_fixture.h"

#include "gpu/app_fixture.h"

#include <cstddef>
#include <vector>

namespace glide::test {

/// Sessions with Backend::gles in contexts of an app.
class GuestTest : public AppTest {
 protected:
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
};

/// The walk's images; each is rendered once in the program.
const ImageU8& walkImage(int frame);

/// How many names of each kind the current context has, in the order buffers, textures, programs
/// and shaders, samplers, framebuffers, vertex arrays, queries.
std::vector<int> countNames();

}  // namespace glide::test
