// An application of the installed library: it sees the public headers only.
#include <cstdio>
#include <glide/session.h>
#include <vector>

int main() {
  glide::Config config;
  config.backend = glide::Backend::cpu;
  config.camera.width = 640;
  config.camera.height = 480;
  config.camera.fx = config.camera.fy = 500.0;
  config.camera.cx = 319.5;
  config.camera.cy = 239.5;
  glide::Result<glide::Session> session = glide::Session::create(config);
  if (!session) {
    std::printf("no session: %s\n", session.error().message.c_str());
    return 1;
  }
  const std::vector<std::uint8_t> gray(640 * 480, 128);
  const auto result = session->update({1, glide::Luma{gray.data(), 640, 480, 640}});
  const bool is_waiting = result && result.value().state == glide::TrackingState::initializing;
  std::printf("glide %d.%d: a blank image %s\n",
              GLIDE_VERSION_MAJOR,
              GLIDE_VERSION_MINOR,
              is_waiting ? "starts no map" : "should not start a map");
  return is_waiting ? 0 : 1;
}
