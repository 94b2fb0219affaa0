#include "suites/growth_plot.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>

namespace glide::growth {

namespace {

// Pixels.
constexpr int kWidth = 900, kPanel = 220, kLeft = 80, kRight = 20, kTop = 36, kBottom = 30;
constexpr double kFont = 0.45;
const cv::Scalar kInk(40, 40, 40), kGrid(225, 225, 225), kLine(180, 90, 20);

using Value = std::function<double(const Sample&)>;

/// One, two or five times a power of ten: about four of them up to `top`.
double niceStep(double top) {
  const double power = std::pow(10.0, std::floor(std::log10(top / 4.0)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power * 4.0 >= top) return factor * power;
  }
  return 10.0 * power;
}

void write(cv::Mat* image, const std::string& text, const cv::Point& at) {
  cv::putText(*image, text, at, cv::FONT_HERSHEY_SIMPLEX, kFont, kInk, 1, cv::LINE_AA);
}

/// One curve with its axes; `image` is the panel's part of the picture.
void drawPanel(const std::vector<Sample>& samples,
               const std::string& title,
               const Value& value,
               cv::Mat image) {
  double top = 1.0;
  for (const Sample& sample : samples) top = std::max(top, value(sample));
  const double step = niceStep(top), end_s = std::max(1.0, samples.back().t_s);
  top = step * std::ceil(top / step);
  const auto place = [&](double t_s, double y) {
    return cv::Point(kLeft + cvRound(t_s / end_s * (kWidth - kLeft - kRight)),
                     kPanel - kBottom - cvRound(y / top * (kPanel - kTop - kBottom)));
  };
  for (double y = 0.0; y <= top; y += step) {
    cv::line(image, place(0.0, y), place(end_s, y), kGrid);
    write(&image, std::to_string(cvRound(y)), place(0.0, y) + cv::Point(-60, 4));
  }
  constexpr double kMinute = 60.0;
  for (double t_s = 0.0; t_s <= end_s; t_s += kMinute) {
    cv::line(image, place(t_s, 0.0), place(t_s, top), kGrid);
    write(&image,
          std::to_string(cvRound(t_s / kMinute)) + " min",
          place(t_s, 0.0) + cv::Point(-18, 18));
  }
  std::vector<cv::Point> curve;
  for (const Sample& sample : samples) curve.push_back(place(sample.t_s, value(sample)));
  cv::polylines(image, curve, false, kLine, 2, cv::LINE_AA);
  write(&image, title, {kLeft, kTop - 12});
}

}  // namespace

bool writePlot(const std::vector<Sample>& samples, const std::string& file) {
  if (samples.empty()) return false;
  const std::array<std::pair<std::string, Value>, 3> panels{{
      {"keyframes", [](const Sample& sample) { return static_cast<double>(sample.keyframes); }},
      {"landmarks", [](const Sample& sample) { return static_cast<double>(sample.landmarks); }},
      {"resident memory, MB", [](const Sample& sample) { return sample.rss_mb; }},
  }};
  cv::Mat image(kPanel * static_cast<int>(panels.size()), kWidth, CV_8UC3, cv::Scalar::all(255.0));
  int row = 0;
  for (const auto& [title, value] : panels) {
    drawPanel(samples, title, value, image.rowRange(row, row + kPanel));
    row += kPanel;
  }
  try {
    return cv::imwrite(file, image);
  } catch (const cv::Exception&) {
    return false;
  }
}

}  // namespace glide::growth
