#include "plot/line_plot.h"

#include <opencv2/imgcodecs.hpp>
#include <opencv2/imgproc.hpp>

#include <algorithm>
#include <cmath>

namespace glide::plot {

namespace {

// Pixels.
constexpr int kWidth = 900, kPanel = 220, kLeft = 80, kRight = 40, kTop = 36, kBottom = 30;
constexpr int kLegendStep = 110;
constexpr double kFont = 0.45;
const cv::Scalar kInk(40, 40, 40), kGrid(225, 225, 225);
const cv::Scalar kLines[] = {{180, 90, 20}, {30, 120, 230}, {60, 150, 60}};

/// One, two or five times a power of ten: at most `count` of them up to `top`.
double niceStep(double top, double count) {
  const double power = std::pow(10.0, std::floor(std::log10(top / count)));
  for (const double factor : {1.0, 2.0, 5.0}) {
    if (factor * power * count >= top) return factor * power;
  }
  return 10.0 * power;
}

std::string text(double number) {
  std::string digits = std::to_string(std::round(number * 100.0) / 100.0);
  digits.erase(digits.find_last_not_of('0') + 1);
  if (digits.back() == '.') digits.pop_back();
  return digits;
}

/// The part of the picture that a panel has, and where its numbers lie there.
class Axes {
 public:
  Axes(const Panel& panel, cv::Mat image) : image_(std::move(image)) {
    for (const Curve& curve : panel.curves) {
      for (const Point& point : curve.points) {
        end_ = std::max(end_, point.x);
        top_ = std::max(top_, point.y);
      }
    }
    constexpr double kColumns = 10.0, kRows = 4.0;
    x_step_ = niceStep(end_, kColumns);
    y_step_ = niceStep(top_, kRows);
    top_ = y_step_ * std::ceil(top_ / y_step_);
  }

  void drawGrid(const std::string& x_unit) {
    constexpr double kHalf = 0.5;  // of a step: sums of steps are not exact
    for (double y = 0.0; y <= top_ + kHalf * y_step_; y += y_step_) {
      cv::line(image_, place({0.0, y}), place({end_, y}), kGrid);
      write(text(y), place({0.0, y}) + cv::Point(-60, 4), kInk);
    }
    for (double x = 0.0; x <= end_; x += x_step_) {
      cv::line(image_, place({x, 0.0}), place({x, top_}), kGrid);
      write(text(x) + x_unit, place({x, 0.0}) + cv::Point(-18, 18), kInk);
    }
  }

  void drawCurve(const Curve& curve, const cv::Scalar& color) {
    std::vector<cv::Point> line;
    for (const Point& point : curve.points) line.push_back(place(point));
    cv::polylines(image_, line, false, color, 2, cv::LINE_AA);
  }

  void write(const std::string& words, const cv::Point& at, const cv::Scalar& color) {
    cv::putText(image_, words, at, cv::FONT_HERSHEY_SIMPLEX, kFont, color, 1, cv::LINE_AA);
  }

 private:
  cv::Point place(const Point& point) const {
    return {kLeft + cvRound(point.x / end_ * (kWidth - kLeft - kRight)),
            kPanel - kBottom - cvRound(point.y / top_ * (kPanel - kTop - kBottom))};
  }

  cv::Mat image_;
  double end_ = 1.0, top_ = 1.0, x_step_ = 1.0, y_step_ = 1.0;
};

void drawPanel(const Panel& panel, const cv::Mat& image) {
  Axes axes(panel, image);
  axes.drawGrid(panel.x_unit);
  axes.write(panel.title, {kLeft, kTop - 12}, kInk);
  int legend = kWidth - kRight - kLegendStep * static_cast<int>(panel.curves.size());
  for (std::size_t i = 0; i < panel.curves.size(); ++i) {
    const cv::Scalar& color = kLines[i % std::size(kLines)];
    axes.drawCurve(panel.curves[i], color);
    axes.write(panel.curves[i].name, {legend, kTop - 12}, color);
    legend += kLegendStep;
  }
}

}  // namespace

bool write(const std::vector<Panel>& panels, const std::string& file) {
  cv::Mat image(kPanel * static_cast<int>(panels.size()), kWidth, CV_8UC3, cv::Scalar::all(255.0));
  int row = 0;
  for (const Panel& panel : panels) {
    drawPanel(panel, image.rowRange(row, row + kPanel));
    row += kPanel;
  }
  try {
    return cv::imwrite(file, image);
  } catch (const cv::Exception&) {
    return false;
  }
}

}  // namespace glide::plot
