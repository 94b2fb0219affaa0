#include "synthetic/sequence.h"

#include "synthetic/random.h"

#include <algorithm>
#include <cmath>
#include <string>
#include <utility>

namespace glide::synthetic {

namespace {

constexpr std::int64_t kFirstTimestamp =
    1'000'000'000'000;  // ns; not zero, as clocks of cameras are not
constexpr double kNsPerS = 1e9;

Status checkOptions(const SequenceOptions& options) {
  const Sensor& sensor = options.sensor;
  const auto invalid = [](const std::string& what) {
    return Error{ErrorCode::invalid_argument, what};
  };
  const bool is_walk = options.motion.kind == MotionKind::walk;
  if (options.frames < (is_walk ? 0 : 1)) return invalid("frames: must be at least 1");
  if (!(options.fps > 0.0)) return invalid("fps: must be greater than 0");
  if (!(sensor.noise >= 0.0)) return invalid("noise: must not be negative");
  if (!(sensor.gain_begin > 0.0 && sensor.gain_end > 0.0))
    return invalid("gain: must be greater than 0");
  if (!(sensor.metering >= 0.0 && sensor.metering <= 1.0))
    return invalid("metering: must be between 0 and 1");
  if (sensor.shutter_samples < 1) return invalid("shutter samples: must be at least 1");
  const double frame_s = 1.0 / options.fps;
  if (!(sensor.shutter_s >= 0.0 && sensor.shutter_s <= frame_s)) {
    return invalid("shutter: must be between 0 and the time of one frame");
  }
  if (!(sensor.readout_s >= 0.0 && sensor.readout_s <= frame_s)) {
    return invalid("rolling shutter: must be between 0 and the time of one frame");
  }
  const Kidnap& kidnap = options.kidnap;
  if (kidnap.end < kidnap.begin || kidnap.begin < 0) return invalid("kidnap: must run from A to B");
  return Unit{};
}

/// As many frames as the walk takes.
int framesOfWalk(const SequenceOptions& options, const Scene& scene) {
  return 1 + static_cast<int>(duration(scene.viewpoint.way) / options.motion.speed * options.fps);
}

/// A view of another place.
SequenceOptions foreignOptions(const SequenceOptions& options) {
  SequenceOptions foreign;
  foreign.scene = options.scene == SceneKind::facade ? SceneKind::room : SceneKind::facade;
  foreign.camera = options.camera;
  foreign.sensor = options.sensor;
  foreign.frames = options.frames;
  foreign.fps = options.fps;
  foreign.seed = mixBits(options.seed);
  return foreign;
}

template <class Value>
void average(const Image<Value>& image, int samples, Image<Value>* sum) {
  const float weight = 1.0F / static_cast<float>(samples);
  for (int y = 0; y < image.height(); ++y) {
    const Value* in = image.row(y);
    Value* out = sum->row(y);
    for (int x = 0; x < image.width(); ++x) out[x] += weight * in[x];
  }
}

template <class Value>
void clear(const CameraModel& camera, Image<Value>* image) {
  image->resize(camera.width(), camera.height());
  for (int y = 0; y < camera.height(); ++y)
    std::fill_n(image->row(y), camera.width(), black<Value>());
}

/// Gray pixels as colours.
void spread(const ImageU8& gray, ImageU8* color) {
  color->resize(3 * gray.width(), gray.height());
  for (int y = 0; y < gray.height(); ++y) {
    for (int x = 0; x < gray.width(); ++x) std::fill_n(color->row(y) + 3 * x, 3, gray.row(y)[x]);
  }
}

double meanOf(const ImageF& image) {
  double sum = 0.0;
  for (int y = 0; y < image.height(); ++y) {
    const float* row = image.row(y);
    for (int x = 0; x < image.width(); ++x) sum += static_cast<double>(row[x]);
  }
  return sum / (static_cast<double>(image.width()) * image.height());
}

}  // namespace

CameraIntrinsics makeCamera(DistortionModel model, int width, int height) {
  CameraIntrinsics camera;
  camera.width = width;
  camera.height = height;
  camera.distortion = model;
  double focal = 0.82;  // focal length over width
  if (model == DistortionModel::radial_tangential) {
    focal = 0.61;
    camera.coefficients = {-0.28, 0.074, 0.0002, -0.0001};
  }
  if (model == DistortionModel::kannala_brandt4) {
    focal = 0.38;
    camera.coefficients = {0.0035, 0.0007, -0.0021, 0.0002};
  }
  camera.fx = focal * width;
  camera.fy = camera.fx;
  camera.cx = 0.5 * (width - 1) + 0.005 * width;
  camera.cy = 0.5 * (height - 1) - 0.005 * width;
  return camera;
}

Result<Sequence> Sequence::create(const SequenceOptions& options) {
  if (const Status status = checkOptions(options); !status) return status.error();
  return create(options, std::make_shared<const Scene>(makeScene(options.scene, options.seed)));
}

Result<Sequence> Sequence::create(const SequenceOptions& options,
                                  std::shared_ptr<const Scene> scene) {
  if (const Status status = checkOptions(options); !status) return status.error();
  const Result<CameraModel> camera = CameraModel::create(options.camera);
  if (!camera) return camera.error();
  SequenceOptions complete = options;
  if (options.motion.kind == MotionKind::walk) {
    if (scene->viewpoint.way.x_z_yaw.empty())
      return Error{ErrorCode::invalid_argument, "motion: this scene has no way to walk"};
    if (options.frames == 0) complete.frames = framesOfWalk(options, *scene);
  }
  Sequence sequence(complete, *camera, std::move(scene));
  const Kidnap& kidnap = options.kidnap;
  if (kidnap.end > kidnap.begin && kidnap.view == KidnapView::foreign) {
    Result<Sequence> elsewhere = create(foreignOptions(complete));
    if (!elsewhere) return elsewhere.error();
    sequence.elsewhere_ = std::make_unique<Sequence>(std::move(*elsewhere));
  }
  return sequence;
}

Sequence::Sequence(const SequenceOptions& options,
                   const CameraModel& camera,
                   std::shared_ptr<const Scene> scene)
    : options_(options),
      camera_(camera),
      scene_(std::move(scene)),
      renderer_(camera),
      return_(returnAfter(seconds(options.kidnap.begin), scene_->viewpoint.depth, options.seed)) {}

std::int64_t Sequence::timestamp(int frame) const {
  return kFirstTimestamp + static_cast<std::int64_t>(std::llround(seconds(frame) * kNsPerS));
}

bool Sequence::isKidnapped(int frame) const {
  return frame >= options_.kidnap.begin && frame < options_.kidnap.end;
}

SE3d Sequence::poseNear(int frame, double offset_s) const {
  const Kidnap& kidnap = options_.kidnap;
  const auto pathAt = [this](double t_s) {
    return poseAt(options_.motion, scene_->viewpoint, t_s);
  };
  if (isKidnapped(frame)) return pathAt(seconds(std::max(0, kidnap.begin - 1)));
  if (kidnap.end == kidnap.begin || frame < kidnap.begin) return pathAt(seconds(frame) + offset_s);
  return pathAt(return_.t_s + seconds(frame - kidnap.end) + offset_s) * return_.T_path_cam;
}

SE3d Sequence::T_world_cam(int frame) const { return poseNear(frame, 0.0); }

void Sequence::render(int frame, double offset_s) {
  const double readout = options_.sensor.readout_s;
  const int rows = readout > 0.0 ? camera_.height() : 1;
  row_poses_.clear();
  for (int row = 0; row < rows; ++row) {
    const double offset = rows == 1 ? 0.0 : readout * (static_cast<double>(row) / (rows - 1) - 0.5);
    row_poses_.push_back(poseNear(frame, offset_s + offset));
  }
  renderer_.render(*scene_, row_poses_, &rendering_);
}

void Sequence::expose(int frame) {
  const Sensor& sensor = options_.sensor;
  clear(camera_, &exposed_);
  if (scene_->has_color) clear(camera_, &exposed_color_);
  if (isKidnapped(frame)) return;
  const int samples = sensor.shutter_s > 0.0 ? sensor.shutter_samples : 1;
  for (int k = 0; k < samples; ++k) {
    render(frame, sensor.shutter_s * ((k + 0.5) / samples - 0.5));
    average(rendering_.radiance, samples, &exposed_);
    if (scene_->has_color) average(rendering_.color, samples, &exposed_color_);
  }
}

std::uint64_t Sequence::noiseSeed(int frame) const {
  return mixBits(options_.seed) + static_cast<std::uint64_t>(frame);
}

Exposure Sequence::exposureOf(int frame) const {
  const double share =
      options_.frames > 1 ? static_cast<double>(frame) / (options_.frames - 1) : 0.0;
  Exposure exposure = exposureAt(options_.sensor, share, noiseSeed(frame));
  if (options_.sensor.metering > 0.0)
    exposure.gain *= meteredGain(options_.sensor, meanOf(exposed_));
  return exposure;
}

void Sequence::image(int frame, ImageU8* out) {
  if (isKidnapped(frame) && elsewhere_) return elsewhere_->image(frame, out);
  expose(frame);
  develop(exposed_, exposureOf(frame), options_.sensor.noise, noiseSeed(frame), out);
}

void Sequence::colorImage(int frame, ImageU8* out) {
  if (isKidnapped(frame) && elsewhere_) {
    elsewhere_->image(frame, &gray_);
    return spread(gray_, out);
  }
  expose(frame);
  develop(exposed_color_, exposureOf(frame), options_.sensor.noise, noiseSeed(frame), out);
}

const Rendering& Sequence::rendering(int frame) {
  render(frame, 0.0);
  return rendering_;
}

}  // namespace glide::synthetic
