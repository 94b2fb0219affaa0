#include "replay/render/playback.h"

namespace glide::replay {

void Playback::obey(ViewerKey key) {
  switch (key) {
    case ViewerKey::pause:
      is_paused_ = !is_paused_;
      break;
    case ViewerKey::step:
      is_paused_ = takes_step_ = true;
      break;
    case ViewerKey::quit:
      has_quit_ = true;
      break;
    case ViewerKey::follow:
      break;
  }
}

}  // namespace glide::replay
