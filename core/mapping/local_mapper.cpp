#include "mapping/local_mapper.h"

#include "mapping/fusion.h"
#include "mapping/initial_map.h"
#include "mapping/insertion.h"
#include "mapping/keyframe_culling.h"
#include "mapping/mapper_state.h"
#include "mapping/new_landmarks.h"
#include "mapping/recent_landmarks.h"
#include "mapping/self_calibration.h"
#include "mapping/window_adjustment.h"

#include "map/map_correction.h"
#include "map/map_restore.h"
#include "map/snapshot_builder.h"

#include <algorithm>
#include <cstdint>
#include <variant>

namespace glide {
namespace {

// Keyframes adjusted when another one waits: a mapper that never keeps up still does not drift.
constexpr int kHurriedWindow = 5;

}  // namespace

struct LocalMapper::Impl {
  MapperState state;
  RecentLandmarks recent;
  SelfCalibration calibration;
  std::uint64_t revision = 0;
  std::uint64_t generation = 0;
  std::uint64_t corrections = 0;
  std::uint64_t bent = 0;  ///< `corrections` when a loop or another lens last bent the map
  Published<MapSnapshot>* const published;

  Impl(const Config& config, const CameraModel& camera, Published<MapSnapshot>* published_in)
      : state(config, camera), published(published_in) {}

  bool process(const InitialMap& message, const std::atomic<bool>*) {
    beginMap();
    startMap(&state, message);
    publish();
    return true;
  }

  bool process(const RestoredMap& message, const std::atomic<bool>*) {
    beginMap();
    state.useCamera(message.map->cameraOr(state.given_camera));
    restoreMap(*message.map, &state.map);
    publish();
    return true;
  }

  bool process(const ClearMap&, const std::atomic<bool>*) {
    beginMap();
    publish();
    return true;
  }

  /// What was solved before the map was bent or replaced would bend it back.
  bool isStale(const SolvedOn& snapshot) const {
    return snapshot.generation != generation || snapshot.corrections < bent;
  }

  bool process(const LoopCorrection& message, const std::atomic<bool>* interrupt) {
    if (isStale(message.snapshot)) return false;
    bent = ++corrections;
    applyCorrection(message, &state.map);
    if (state.map.keyframe(message.edge.newer) != nullptr)
      fuseAround(&state, message.edge.newer, interrupt);
    publish();
    return true;
  }

  bool process(const GlobalAdjustment& message, const std::atomic<bool>*) {
    if (isStale(message.snapshot)) return false;
    ++corrections;
    applyAdjustment(message, &state.map);
    publish();
    return true;
  }

  void beginMap() {
    recent.clear();
    calibration.beginMap();
    state.map.clear();
    state.bearings.clear();
    ++generation;
  }

  bool process(const NewKeyframe& message, const std::atomic<bool>* interrupt) {
    for (const LandmarkSighting& sighting : message.sightings) state.map.countSighting(sighting);
    if (insertKeyframe(&state, message)) extend(message.id, interrupt);
    publish();
    return true;
  }

  void extend(KeyframeId id, const std::atomic<bool>* interrupt) {
    recent.cull(&state.map);
    recent.add(createLandmarks(&state, id, interrupt));
    fuseAround(&state, id, interrupt);
    publish();  // so that tracking profits before the adjustment
    adjust(id, interrupt);
    cullRedundantKeyframes(&state, id);
    if (calibration.update(&state)) bent = ++corrections;
  }

  void adjust(KeyframeId id, const std::atomic<bool>* interrupt) {
    const bool is_hurried = interrupt != nullptr && interrupt->load();
    const Config::Mapping& config = state.config.mapping;
    BundleOptions options;
    options.max_iterations = config.ba_iterations;
    options.cancel = is_hurried ? nullptr : interrupt;  // the small window always gets its turn
    const int size =
        is_hurried ? std::min(kHurriedWindow, config.local_keyframes) : config.local_keyframes;
    adjustWindow(&state, windowAround(state.map, id, size), options);
  }

  void publish() {
    published->store(snapshotOf(state.map,
                                {++revision,
                                 generation,
                                 corrections,
                                 state.config.mapping.min_covisibility,
                                 state.corrected_camera}));
  }
};

LocalMapper::LocalMapper(const Config& config,
                         const CameraModel& camera,
                         Published<MapSnapshot>* published)
    : impl_(std::make_unique<Impl>(config, camera, published)) {}

LocalMapper::~LocalMapper() = default;

bool LocalMapper::process(const MappingMessage& message, const std::atomic<bool>* interrupt) {
  return std::visit([&](const auto& content) { return impl_->process(content, interrupt); },
                    message);
}

}  // namespace glide
