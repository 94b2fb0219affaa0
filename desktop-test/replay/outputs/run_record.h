#pragma once

#include "replay/readers/frame_source.h"

#include "glide/session.h"

#include <cstdint>
#include <memory>
#include <string>
#include <vector>

namespace glide::replay {

/// How frames are fed. Lossless waits for the mapper; realtime drops frames as a camera would.
enum class Pace { lossless, realtime };

/// One frame's answer; index counts the frames that the source delivered, dropped ones included.
struct FrameRecord {
  int index = 0;
  FrameResult result;
};

/// Everything that a run leaves behind for the files.
struct RunRecord {
  SourceInfo source;
  std::vector<Skip> skips;
  Config config;
  Pace pace = Pace::lossless;
  std::vector<FrameRecord> frames;
  int dropped = 0;           ///< frames that came while the tracker was busy (realtime only)
  bool interrupted = false;  ///< ended by a signal before the source did
  BackendInfo backend;
  /// At the end, everything mapped; the last one that frames were tracked in. Never null.
  std::shared_ptr<const MapView> map;
  std::size_t map_file_bytes = 0;  ///< of that map, when it is saved; 0 when there is none
  double startup_ms = 0.0;         ///< from the start of the program's work to the first frame
  double wall_s = 0.0;             ///< of the frame loop, decoding included
};

}  // namespace glide::replay
