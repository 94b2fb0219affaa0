// The README shows this file from here on (check_readme.py), consumer_test.sh compiles and runs it.

#include <cstdio>
#include <glide/session.h>
#include <vector>

int main() {
  glide::Config config;
  config.camera = {640, 480, 525.0, 525.0, 319.5, 239.5, glide::DistortionModel::none, {}};
  auto session = glide::Session::create(config);
  if (!session) return std::printf("%s\n", session.error().message.c_str()), 1;
  std::vector<std::uint8_t> gray(640 * 480);  // your camera's image, frame by frame
  for (std::int64_t t_ns = 1; t_ns < 1'000'000'000; t_ns += 33'333'333) {
    auto frame = session->update({t_ns, glide::Luma{gray.data(), 640, 480, 640}});
    if (!frame || frame->state != glide::TrackingState::tracking) continue;
    const auto& t_world_cam = frame->T_world_cam.t_xyz;
    std::printf("%f %f %f\n", t_world_cam[0], t_world_cam[1], t_world_cam[2]);
  }
}
