#include "unit/capi/c_walk_fixture.h"

#include "capi/conversion.h"

#include <gtest/gtest.h>

#include <map>
#include <mutex>
#include <utility>

namespace glide::test {
namespace {
constexpr std::int64_t kFrame_ns = 33'333'333;
constexpr double kStep_m = 0.01;
constexpr const char* kStartsSoon = "initialization.min_matches=60";

glide_config configOf(std::int32_t axes, std::int32_t execution) {
  glide_config config = sized<glide_config>();
  config.axes = axes;
  config.execution = execution;
  return config;
}
}  // namespace

CWalk::CWalk(std::int32_t axes) : CWalk(axes, GLIDE_EXECUTION_INLINE) {}

CWalk::CWalk(std::int32_t axes, std::int32_t execution) : CWalk(configOf(axes, execution)) {}

CWalk::CWalk(const char* setting)
    : CWalk(configOf(GLIDE_AXES_GL, GLIDE_EXECUTION_INLINE), {kStartsSoon, setting}) {}

CWalk::CWalk(const glide_config& wishes) : CWalk(wishes, {kStartsSoon}) {}

CWalk::CWalk(const glide_config& wishes, std::vector<const char*> settings)
    : settings_(std::move(settings)), config_(wishes) {
  config_.backend = GLIDE_BACKEND_CPU;
  config_.setting_count = static_cast<std::uint32_t>(settings_.size());
  config_.settings = settings_.data();
  config_.camera = toC(sequence_.config().camera);
  EXPECT_EQ(glide_session_create(&config_, &session_), GLIDE_OK) << glide_last_error();
}

CWalk::~CWalk() { glide_session_destroy(session_); }

glide_frame CWalk::feed(const ImageU8& image) {
  glide_image input = sized<glide_image>();
  input.kind = GLIDE_IMAGE_LUMA8;
  input.t_ns = t_ns_ += kFrame_ns;
  input.width = image.width();
  input.height = image.height();
  input.pixels = image.row(0);
  input.row_stride = image.stride();
  glide_frame frame = sized<glide_frame>();
  status_ = glide_session_update(session_, &input, &frame);
  return frame;
}

glide_frame CWalk::feed(double x) { return feed(sequence_.imageAt(x)); }

glide_frame CWalk::walk(int count) {
  glide_frame frame{};
  for (; fed_ < count; ++fed_) frame = feed(image(fed_));
  return frame;
}

const ImageU8& CWalk::image(int frame) {
  static std::mutex mutex;
  static std::map<int, ImageU8> images;
  const std::lock_guard<std::mutex> lock(mutex);
  const auto found = images.find(frame);
  if (found != images.end()) return found->second;
  return images.emplace(frame, SequenceFixture().imageAt(frame * kStep_m)).first->second;
}

}  // namespace glide::test
