#include "capi/conversion.h"
#include "capi/counted.h"
#include "capi/handles.h"
#include "capi/sized_struct.h"

#include "glide/glide.h"

#include <memory>
#include <optional>
#include <string>
#include <vector>

namespace glide {

MapTable& mapTable() {
  static MapTable& table = *new MapTable(8);
  return table;
}

namespace {

using AppMap = AppSession::AppMap;

// Read in pieces: how much there is, is known only at the end.
constexpr std::size_t kReadStep = 1U << 16U;

glide_status doneOr(const Status& status) { return status ? kDone : refuse(status.error()); }

/// Runs function(const AppMap&) on the map of a handle, or says that there is none.
template <class Function>
glide_status withMap(const glide_map* handle, Function&& function) noexcept {
  return guarded([&]() -> glide_status {
    const MapTable::Use map = mapTable().find(handle);
    if (!map) return refuse(GLIDE_ERROR_SESSION_CLOSED, "the map is null or was released");
    return function(*map);
  });
}

using GetMap = std::shared_ptr<const AppMap> (AppSession::*)() const;

glide_status acquire(glide_session* session, glide_map** map, GetMap get) {
  return withSession(session, [&](AppSession& app) {
    if (map == nullptr) return refuseArgument("map is null");
    *map = mapTable().add((app.*get)());
    return kDone;
  });
}

std::vector<std::byte> readAll(const glide_io& io) {
  std::vector<std::byte> bytes;
  for (;;) {
    const std::size_t have = bytes.size();
    bytes.resize(have + kReadStep);
    const std::size_t got = std::min(io.read(io.user, bytes.data() + have, kReadStep), kReadStep);
    bytes.resize(have + got);
    if (got < kReadStep) return bytes;
  }
}

}  // namespace
}  // namespace glide

using namespace glide;  // NOLINT(google-build-using-namespace): the file is the C side of it

extern "C" {

glide_status glide_map_acquire(glide_session* session, glide_map** map) {
  return acquire(session, map, &AppSession::map);
}

glide_status glide_map_acquire_frame(glide_session* session, glide_map** map) {
  return acquire(session, map, &AppSession::frameMap);
}

void glide_map_release(glide_map* map) {
  guarded([&] {
    mapTable().remove(map);
    return kDone;
  });
}

glide_status glide_map_revision(const glide_map* map, uint64_t* revision) {
  return withMap(map, [&](const AppMap& app) {
    if (revision == nullptr) return refuseArgument("revision is null");
    *revision = app.view->revision;
    return kDone;
  });
}

glide_status glide_map_generation(const glide_map* map, uint64_t* generation) {
  return withMap(map, [&](const AppMap& app) {
    if (generation == nullptr) return refuseArgument("generation is null");
    *generation = app.view->generation;
    return kDone;
  });
}

glide_status glide_map_points(const glide_map* map,
                              size_t capacity,
                              glide_point* points,
                              size_t* count) {
  return withMap(map, [&](const AppMap& app) {
    const CountedOut<glide_point> out{capacity, points, count};
    if (!out.isValid()) return refuseArgument("points or count is null");
    const auto& landmarks = app.view->landmarks;
    return out.fill(landmarks.size(), [&](std::size_t i) { return toC(landmarks[i], app.world); });
  });
}

glide_status glide_map_keyframes(const glide_map* map,
                                 size_t capacity,
                                 glide_keyframe* keyframes,
                                 size_t* count) {
  return withMap(map, [&](const AppMap& app) {
    const CountedOut<glide_keyframe> out{capacity, keyframes, count};
    if (!out.isValid()) return refuseArgument("keyframes or count is null");
    const auto& all = app.view->keyframes;
    return out.fill(all.size(), [&](std::size_t i) { return toC(all[i], app.world); });
  });
}

glide_status glide_map_loops(const glide_map* map,
                             size_t capacity,
                             glide_loop* loops,
                             size_t* count) {
  return withMap(map, [&](const AppMap& app) {
    const CountedOut<glide_loop> out{capacity, loops, count};
    if (!out.isValid()) return refuseArgument("loops or count is null");
    const auto& all = app.view->loops;
    return out.fill(all.size(), [&](std::size_t i) {
      return glide_loop{all[i].newer, all[i].older};
    });
  });
}

glide_status glide_map_corrected_camera(const glide_map* map, glide_intrinsics* camera) {
  return withMap(map, [&](const AppMap& app) {
    if (camera == nullptr) return refuseArgument("camera is null");
    if (!app.view->corrected_camera)
      return refuse(GLIDE_ERROR_NOT_YET_AVAILABLE, "the camera is as it was given");
    *camera = toC(*app.view->corrected_camera);
    return kDone;
  });
}

glide_status glide_map_save(glide_session* session, const char* path) {
  return withSession(session, [&](AppSession& app) {
    if (path == nullptr) return refuseArgument("path is null");
    return doneOr(app.saveMap(path));
  });
}

glide_status glide_map_load(glide_session* session, const char* path) {
  return withSession(session, [&](AppSession& app) {
    if (path == nullptr) return refuseArgument("path is null");
    return doneOr(app.loadMap(path));
  });
}

glide_status glide_map_save_io(glide_session* session, const glide_io* io) {
  return withSession(session, [&](AppSession& app) {
    const std::optional<glide_io> known = readSized(io);
    if (!known || known->write == nullptr) return refuseArgument("io or io->write is null");
    const Result<std::vector<std::byte>> bytes = app.saveMap();
    if (!bytes) return refuse(bytes.error());
    const std::size_t written = known->write(known->user, bytes->data(), bytes->size());
    if (written == bytes->size()) return kDone;
    return refuse(GLIDE_ERROR_IO,
                  "io->write took " + std::to_string(written) + " of " +
                      std::to_string(bytes->size()) + " bytes");
  });
}

glide_status glide_map_load_io(glide_session* session, const glide_io* io) {
  return withSession(session, [&](AppSession& app) {
    const std::optional<glide_io> known = readSized(io);
    if (!known || known->read == nullptr) return refuseArgument("io or io->read is null");
    return doneOr(app.loadMap(readAll(*known)));
  });
}

}  // extern "C"
