#pragma once

#include "map/map_snapshot.h"
#include "map/messages.h"

#include "base/published.h"
#include "geometry/camera_model.h"

#include "glide/config.h"

#include <atomic>
#include <memory>

namespace glide {

/// Extends and refines the map, one message at a time: insert, cull recent landmarks, triangulate
/// with covisible neighbours, fuse duplicates, local bundle adjustment, cull redundant keyframes,
/// publish (ALGORITHMS section 4). Owns the Map; called by one thread (mapping, or the app's when
/// inline).
class LocalMapper {
 public:
  /// `published` outlives the mapper; every new revision of the map is stored there.
  LocalMapper(const Config& config, const CameraModel& camera, Published<MapSnapshot>* published);
  ~LocalMapper();

  /// `interrupt` (may be null): when true, bundle adjustment ends early and optional work is
  /// skipped, because another message waits. The map stays consistent. False when a correction was
  /// ignored, since the map was bent or replaced after it was solved.
  bool process(const MappingMessage& message, const std::atomic<bool>* interrupt);

 private:
  struct Impl;
  std::unique_ptr<Impl> impl_;
};

}  // namespace glide
