#pragma once

namespace glide::replay {

enum class ViewerKey { pause, step, follow, quit };

/// Whether a replay that a person watches goes on to the next frame.
class Playback {
 public:
  /// follow is none of its business.
  void obey(ViewerKey key);
  /// Another frame is on the screen: a step has been made.
  void showFrame() { takes_step_ = false; }

  bool mayGoOn() const { return !is_paused_ || takes_step_ || has_quit_; }
  bool hasQuit() const { return has_quit_; }

 private:
  bool is_paused_ = false;
  bool takes_step_ = false;
  bool has_quit_ = false;
};

}  // namespace glide::replay
