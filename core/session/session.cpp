#include "glide/session.h"

#include "session/map_view_builder.h"
#include "session/session_impl.h"

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
  if (config.tracker == TrackerMode::hybrid) {
    Result<ChosenAligner> chosen = chooseAligner(config, *camera);
    if (!chosen) return chosen.error();
    aligner = std::move(*chosen);
  }
  return Session(std::make_unique<Impl>(config, *camera, std::move(aligner)));
} catch (const std::exception& exception) {
  return Error{ErrorCode::internal, std::string("Session::create: ") + exception.what()};
}

Result<FrameResult> Session::update(const FrameInput& frame) try {
  const Status valid = impl_->check(frame);
  if (!valid) return valid.error();
  return impl_->update(frame);
} catch (const std::exception& exception) {
  return Error{ErrorCode::internal, std::string("Session::update: ") + exception.what()};
}

std::shared_ptr<const MapView> Session::map() const {
  return buildMapView(*impl_->snapshot(), impl_->resets());
}

void Session::waitForMapping() { impl_->waitForMapping(); }

BackendInfo Session::backend() const { return impl_->backend(); }

}  // namespace glide
