#include "guest/guest_fixture.h"

#include <map>

namespace glide::test {
namespace {

constexpr double kStep_m = 0.02;
constexpr std::int64_t kFrame_ns = 33'333'333;
// A walk of the direct tracker is there long before.
constexpr int kMaxFrames = 40;
// Far more names than the tests make.
constexpr GLuint kNames = 512;

template <class IsName>
int count(IsName is_name) {
  int names = 0;
  for (GLuint name = 1; name <= kNames; ++name) names += is_name(name) == GL_TRUE ? 1 : 0;
  return names;
}

}  // namespace

const ImageU8& walkImage(int frame) {
  static const SequenceFixture fixture;
  static std::map<int, ImageU8> images;
  const auto found = images.find(frame);
  if (found != images.end()) return found->second;
  return images.emplace(frame, fixture.imageAt(frame * kStep_m)).first->second;
}

Config GuestTest::config() const {
  Config config = SequenceFixture().config();
  config.backend = Backend::gles;
  config.direct.levels = 3;
  config.direct.patch_size = 5;
  config.direct.max_points = 60;
  config.direct.max_iterations = isSlow() ? 3 : 6;
  config.features.count = 400;
  config.features.initialization_count = 600;
  config.gl.autotune = GpuAutotune::off;
  return config;
}

Result<FrameResult> GuestTest::feed(Session* session, int frame) const {
  const ImageU8& image = walkImage(frame);
  return feed(session, frame, Luma{image.row(0), image.width(), image.height(), image.stride()});
}

Result<FrameResult> GuestTest::feed(Session* session,
                                    int frame,
                                    const decltype(FrameInput::image)& image) const {
  return session->update({(frame + 1) * kFrame_ns, image});
}

int GuestTest::trackDirectly(Session* session) const {
  for (int frame = 0; frame < kMaxFrames; ++frame) {
    const Result<FrameResult> result = feed(session, frame);
    if (!result) {
      ADD_FAILURE() << result.error().message;
      return frame;
    }
    if (result->tracker == TrackerKind::direct) return frame + 1;
  }
  ADD_FAILURE() << "the direct tracker has placed no frame";
  return kMaxFrames;
}

std::vector<int> countNames() {
  const int programs = count([](GLuint n) { return glIsProgram(n) || glIsShader(n) ? 1 : 0; });
  return {count(glIsBuffer),
          count(glIsTexture),
          programs,
          count(glIsSampler),
          count(glIsFramebuffer),
          count(glIsVertexArray),
          count(glIsQuery)};
}

}  // namespace glide::test
