#include "glide/session.h"

#include "session/session_impl.h"

#include "base/file_io.h"

#include <exception>
#include <string>
#include <utility>

namespace glide {

Session::Session(std::unique_ptr<Impl> impl) : impl_(std::move(impl)) {}
Session::Session(Session&&) noexcept = default;
Session& Session::operator=(Session&&) noexcept = default;
Session::~Session() = default;

Result<Session> Session::create(const Config& config) try {
  const Status valid = validate(config);
  if (!valid) return valid.error();
  const Result<CameraModel> camera = CameraModel::create(config.camera);
  if (!camera) return camera.error();
  ChosenAligner aligner;
  const bool is_later =
      config.backend != Backend::cpu && config.gl.creation == GlCreation::at_first_update;
  if (config.tracker == TrackerMode::hybrid && !is_later) {
    Result<ChosenAligner> chosen = chooseAligner(config, *camera);
    if (!chosen) return chosen.error();
    aligner = std::move(*chosen);
  }
  return Session(std::make_unique<Impl>(config, *camera, std::move(aligner)));
} catch (const std::exception& exception) {
  return Error{ErrorCode::internal, std::string("Session::create: ") + exception.what()};
}

Result<FrameResult> Session::update(const FrameInput& frame) try {
  const Status valid = impl_->take(frame);
  if (!valid) return valid.error();
  return impl_->update(frame);
} catch (const std::exception& exception) {
  return Error{ErrorCode::internal, std::string("Session::update: ") + exception.what()};
}

std::shared_ptr<const MapView> Session::map() const { return impl_->view(); }

std::shared_ptr<const FrameMap> Session::frameMap() const { return impl_->frameMap(); }

MapSize Session::mapSize() const {
  const std::shared_ptr<const MapSnapshot> map = impl_->map();
  return {map->keyframes().size(), map->landmarks().size(), map->loops().size()};
}

LocatedCamera Session::locate(std::int64_t t_ns) const { return impl_->locate(t_ns); }

void Session::reset() { impl_->reset(); }
void Session::pause() { impl_->pause(); }
void Session::resume() { impl_->resume(); }
void Session::releaseGl() { impl_->releaseGl(); }
void Session::abandonGl() { impl_->abandonGl(); }

Status Session::saveMap(const std::filesystem::path& path) const try {
  const Result<std::vector<std::byte>> bytes = saveMap();
  if (!bytes) return bytes.error();
  return writeFileAtomically(path, *bytes, FileDurability::synced);
} catch (const std::exception& exception) {
  return Error{ErrorCode::internal, std::string("Session::saveMap: ") + exception.what()};
}

Result<std::vector<std::byte>> Session::saveMap() const try {
  const StoredMap stored = impl_->stored();
  if (stored.map->empty()) return Error{ErrorCode::no_map, "there is no map to save"};
  return encodeMap(stored);
} catch (const std::exception& exception) {
  return Error{ErrorCode::internal, std::string("Session::saveMap: ") + exception.what()};
}

Result<Session::MapFile> Session::MapFile::read(const std::filesystem::path& path) try {
  const Result<std::vector<std::byte>> bytes = readFile(path);
  if (!bytes) return bytes.error();
  Result<MapFile> file = decode(*bytes);
  if (!file) return Error{file.error().code, path.string() + ": " + file.error().message};
  return file;
} catch (const std::exception& exception) {
  return Error{ErrorCode::internal, std::string("MapFile::read: ") + exception.what()};
}

Result<Session::MapFile> Session::MapFile::decode(std::span<const std::byte> bytes) try {
  Result<StoredMap> stored = decodeMap(bytes);
  if (!stored) return stored.error();
  return MapFile(std::make_shared<const StoredMap>(std::move(*stored)));
} catch (const std::exception& exception) {
  return Error{ErrorCode::internal, std::string("MapFile::decode: ") + exception.what()};
}

Status Session::loadMap(const std::filesystem::path& path) {
  const Result<MapFile> file = MapFile::read(path);
  if (!file) return file.error();
  Status taken = takeMap(*file);
  if (!taken) return Error{taken.error().code, path.string() + ": " + taken.error().message};
  waitForMapping();
  return taken;
}

Status Session::loadMap(std::span<const std::byte> bytes) {
  const Result<MapFile> file = MapFile::decode(bytes);
  if (!file) return file.error();
  Status taken = takeMap(*file);
  if (taken) waitForMapping();
  return taken;
}

Status Session::takeMap(const MapFile& file) try {
  return impl_->restore(*file.stored_);
} catch (const std::exception& exception) {
  return Error{ErrorCode::internal, std::string("Session::loadMap: ") + exception.what()};
}

void Session::waitForMapping() { impl_->waitForMapping(); }

const BackendInfo& Session::backend() const { return impl_->backend(); }

const std::vector<TrackedPoint>& Session::trackedPoints() const { return impl_->trackedPoints(); }

}  // namespace glide
