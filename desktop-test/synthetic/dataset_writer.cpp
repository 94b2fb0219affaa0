#include "synthetic/dataset_writer.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <array>
#include <atomic>
#include <cstdio>
#include <fstream>
#include <future>
#include <mutex>
#include <string>
#include <thread>
#include <utility>
#include <vector>

namespace glide::synthetic {

namespace fs = std::filesystem;

namespace {

constexpr double kNsPerS = 1e9;

/// Body as in EuRoC's sense (x forward, y left, z up), a few centimetres from the camera, so that
/// readers that forget T_BS are found out.
SE3d bodyFromCamera() {
  Mat3d R_body_cam;
  R_body_cam << 0, 0, 1, -1, 0, 0, 0, -1, 0;
  return {Eigen::Quaterniond(R_body_cam), Vec3d(0.06, 0.02, -0.01)};
}

template <class... Values>
std::string format(const char* pattern, Values... values) {
  std::array<char, 512> line{};
  const int length = std::snprintf(line.data(), line.size(), pattern, values...);
  return {line.data(), static_cast<std::size_t>(length)};
}

std::string joined(const std::vector<double>& values) {
  std::string list;
  for (const double value : values) list += (list.empty() ? "" : ", ") + format("%.10g", value);
  return list;
}

Status writeText(const fs::path& file, const std::string& text) {
  std::ofstream stream(file);
  stream << text << std::flush;
  if (!stream) return Error{ErrorCode::io, file.string() + ": cannot be written"};
  return Unit{};
}

/// The view's pixels, in OpenCV's order of colours. Valid as long as `image`.
cv::Mat pixelsOf(const ImageU8& image, bool in_color) {
  const int channels = in_color ? 3 : 1;
  const cv::Mat pixels(image.height(),
                       image.width() / channels,
                       CV_8UC(channels),
                       const_cast<std::uint8_t*>(image.row(0)),
                       static_cast<std::size_t>(image.stride()));
  if (!in_color) return pixels;
  cv::Mat blue_first;
  cv::cvtColor(pixels, blue_first, cv::COLOR_RGB2BGR);
  return blue_first;
}

Status writePng(const fs::path& file, const cv::Mat& pixels) {
  constexpr int kFast = 1;  // zlib level: speed over the last 10 % of size
  try {
    if (cv::imwrite(file.string(), pixels, {cv::IMWRITE_PNG_COMPRESSION, kFast})) return Unit{};
  } catch (const cv::Exception&) {  // same outcome as false
  }
  return Error{ErrorCode::io, file.string() + ": cannot be written"};
}

std::string secondsText(std::int64_t t_ns, int decimals) {
  return format("%.*f", decimals, static_cast<double>(t_ns) / kNsPerS);
}

/// Calibration in the widespread ORB-SLAM form.
std::string tumCalibration(const SequenceOptions& options) {
  const CameraIntrinsics& camera = options.camera;
  const bool is_fisheye = camera.distortion == DistortionModel::kannala_brandt4;
  std::string text = "%YAML:1.0\n\n";
  text += format("Camera.type: \"%s\"\n", is_fisheye ? "KannalaBrandt8" : "PinHole");
  text += format("Camera.fx: %.10g\nCamera.fy: %.10g\n", camera.fx, camera.fy);
  text += format("Camera.cx: %.10g\nCamera.cy: %.10g\n", camera.cx, camera.cy);
  const std::array<const char*, 5> brown{"k1", "k2", "p1", "p2", "k3"},
      fisheye{"k1", "k2", "k3", "k4", ""};
  for (std::size_t i = 0; i < camera.coefficients.size(); ++i) {
    text +=
        format("Camera.%s: %.10g\n", is_fisheye ? fisheye[i] : brown[i], camera.coefficients[i]);
  }
  text += format("Camera.width: %d\nCamera.height: %d\n", camera.width, camera.height);
  return text + format("Camera.fps: %.10g\nCamera.RGB: 1\n", options.fps);
}

std::string eurocCalibration(const SequenceOptions& options) {
  const CameraIntrinsics& camera = options.camera;
  const bool is_fisheye = camera.distortion == DistortionModel::kannala_brandt4;
  const Mat4d T_body_cam = bodyFromCamera().matrix();
  std::vector<double> rows;
  for (int i = 0; i < 16; ++i) rows.push_back(T_body_cam(i / 4, i % 4));
  std::vector<double> coefficients = camera.coefficients;
  if (coefficients.empty()) coefficients.assign(4, 0.0);
  std::string text = "sensor_type: camera\ncomment: synthetic\nT_BS:\n  cols: 4\n  rows: 4\n";
  text += "  data: [" + joined(rows) + "]\n";
  text += format("rate_hz: %.10g\nresolution: [%d, %d]\ncamera_model: pinhole\n",
                 options.fps,
                 camera.width,
                 camera.height);
  text += "intrinsics: [" + joined({camera.fx, camera.fy, camera.cx, camera.cy}) + "]\n";
  text += format("distortion_model: %s\n", is_fisheye ? "equidistant" : "radial-tangential");
  return text + "distortion_coefficients: [" + joined(coefficients) + "]\n";
}

/// Where the parts of a layout go, and its lists, which grow frame by frame.
struct Files {
  fs::path images, image_list, truth, calibration;
  std::string image_lines, truth_lines, calibration_text;
};

Files beginTum(const fs::path& folder, const SequenceOptions& options) {
  return {folder / "rgb",
          folder / "rgb.txt",
          folder / "groundtruth.txt",
          folder / "camera.yaml",
          "# timestamp filename\n",
          "# timestamp tx ty tz qx qy qz qw\n",
          tumCalibration(options)};
}

Files beginEuroc(const fs::path& folder, const SequenceOptions& options) {
  const fs::path camera = folder / "mav0" / "cam0";
  return {camera / "data",
          camera / "data.csv",
          folder / "mav0" / "state_groundtruth_estimate0" / "data.csv",
          camera / "sensor.yaml",
          "#timestamp [ns],filename\n",
          "#timestamp [ns], p_RS_R_x [m], p_RS_R_y [m], p_RS_R_z [m], q_RS_w [], q_RS_x [], q_RS_y "
          "[], q_RS_z []\n",
          eurocCalibration(options)};
}

/// Adds an image to the list; returns its name.
std::string addTumImage(std::int64_t t_ns, Files* files) {
  const std::string name = secondsText(t_ns, 6) + ".png";
  files->image_lines += secondsText(t_ns, 6) + " rgb/" + name + "\n";
  return name;
}

std::string addEurocImage(std::int64_t t_ns, Files* files) {
  const std::string stamp = std::to_string(t_ns), name = stamp + ".png";
  files->image_lines += stamp + "," + name + "\n";
  return name;
}

void addTumTruth(std::int64_t t_ns, const SE3d& T_world_cam, Files* files) {
  const Vec3d& t = T_world_cam.t;
  const Eigen::Quaterniond& q = T_world_cam.q;
  files->truth_lines += secondsText(t_ns, 6) + format(" %.9f %.9f %.9f", t.x(), t.y(), t.z()) +
                        format(" %.9f %.9f %.9f %.9f\n", q.x(), q.y(), q.z(), q.w());
}

void addEurocTruth(std::int64_t t_ns, const SE3d& T_world_cam, Files* files) {
  const SE3d T_world_body = T_world_cam * bodyFromCamera().inverse();
  const Vec3d& t = T_world_body.t;
  const Eigen::Quaterniond& q = T_world_body.q;
  files->truth_lines += std::to_string(t_ns) + format(",%.9f,%.9f,%.9f", t.x(), t.y(), t.z()) +
                        format(",%.9f,%.9f,%.9f,%.9f\n", q.w(), q.x(), q.y(), q.z());
}

Status makeFolders(const Files& files) {
  for (const fs::path& folder : {files.images, files.truth.parent_path()}) {
    std::error_code error;
    fs::create_directories(folder, error);
    if (error) return Error{ErrorCode::io, folder.string() + ": " + error.message()};
  }
  return Unit{};
}

/// Files of the images, one by one as threads ask for them, and what became of them.
class ImageQueue {
 public:
  ImageQueue(std::vector<fs::path> files, const Progress& progress)
      : files_(std::move(files)), progress_(progress) {}

  /// Renders and writes until there are no more, or one could not be written.
  void work(Sequence* sequence, bool in_color) {
    ImageU8 image;
    for (std::size_t i = next_++; i < files_.size() && !has_failed_; i = next_++) {
      const int frame = static_cast<int>(i);
      if (in_color) {
        sequence->colorImage(frame, &image);
      } else {
        sequence->image(frame, &image);
      }
      finish(writePng(files_[i], pixelsOf(image, in_color)));
    }
  }
  /// Of the first that failed; when all threads have come back.
  const Status& status() const { return status_; }

 private:
  void finish(const Status& status) {
    const std::lock_guard lock(mutex_);
    if (!status && !has_failed_.exchange(true)) status_ = status;
    progress_(++done_);
  }

  const std::vector<fs::path> files_;
  const Progress& progress_;
  std::atomic<std::size_t> next_{0};
  std::atomic<bool> has_failed_{false};
  std::mutex mutex_;
  int done_ = 0;
  Status status_ = Unit{};
};

/// On all cores: frames do not depend on each other.
Status writeImages(Sequence* sequence, bool in_color, ImageQueue* queue) {
  std::vector<Sequence> copies;
  for (unsigned k = 1; k < std::thread::hardware_concurrency(); ++k) {
    Result<Sequence> copy = Sequence::create(sequence->options(), sequence->scene());
    if (!copy) return copy.error();
    copies.push_back(std::move(*copy));
  }
  std::vector<std::future<void>> helpers;
  for (Sequence& copy : copies)
    helpers.push_back(std::async(std::launch::async, [&] { queue->work(&copy, in_color); }));
  queue->work(sequence, in_color);
  for (const std::future<void>& helper : helpers) helper.wait();
  return queue->status();
}

}  // namespace

Status writeDataset(Sequence* sequence,
                    const DatasetFormat& format,
                    const fs::path& folder,
                    const Progress& progress) {
  const bool is_tum = format.layout == Layout::tum;
  Files files =
      is_tum ? beginTum(folder, sequence->options()) : beginEuroc(folder, sequence->options());
  if (const Status status = makeFolders(files); !status) return status;
  std::vector<fs::path> images;
  for (int frame = 0; frame < sequence->size(); ++frame) {
    const std::int64_t t_ns = sequence->timestamp(frame);
    images.push_back(files.images / (is_tum ? addTumImage : addEurocImage)(t_ns, &files));
    if (!sequence->isKidnapped(frame))
      (is_tum ? addTumTruth : addEurocTruth)(t_ns, sequence->T_world_cam(frame), &files);
  }
  ImageQueue queue(std::move(images), progress);
  if (const Status status = writeImages(sequence, format.in_color, &queue); !status) return status;
  if (const Status status = writeText(files.image_list, files.image_lines); !status) return status;
  if (const Status status = writeText(files.truth, files.truth_lines); !status) return status;
  return writeText(files.calibration, files.calibration_text);
}

}  // namespace glide::synthetic
