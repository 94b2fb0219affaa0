#pragma once

#include <cassert>
#include <cstddef>
#include <cstdint>
#include <vector>

namespace glide {

/// A borrowed image, row-major. Stride counts elements, not bytes.
template <class T>
struct ImageView {
  const T* data = nullptr;
  int width = 0;
  int height = 0;
  std::ptrdiff_t stride = 0;

  const T* row(int y) const { return data + y * stride; }
  const T& at(int x, int y) const {
    assert(x >= 0 && y >= 0 && x < width && y < height);
    return data[y * stride + x];
  }
};

/// An owned image. Rows are padded to a multiple of 16 elements, and the buffer ends with 64 spare
/// elements, so that vector loads that start inside the image never leave it.
template <class T>
class Image {
 public:
  Image() = default;
  Image(int width, int height) { resize(width, height); }

  /// Keeps the allocation when the size does not grow; contents are unspecified.
  void resize(int width, int height) {
    width_ = width;
    height_ = height;
    stride_ = (static_cast<std::ptrdiff_t>(width) + 15) / 16 * 16;
    data_.resize(static_cast<std::size_t>(stride_ * height) + 64);
  }

  T* row(int y) { return data_.data() + y * stride_; }
  const T* row(int y) const { return data_.data() + y * stride_; }
  T& at(int x, int y) {
    assert(x >= 0 && y >= 0 && x < width_ && y < height_);
    return row(y)[x];
  }
  const T& at(int x, int y) const {
    assert(x >= 0 && y >= 0 && x < width_ && y < height_);
    return row(y)[x];
  }
  int width() const { return width_; }
  int height() const { return height_; }
  std::ptrdiff_t stride() const { return stride_; }
  bool empty() const { return data_.empty(); }
  ImageView<T> view() const { return {data_.data(), width_, height_, stride_}; }

 private:
  int width_ = 0, height_ = 0;
  std::ptrdiff_t stride_ = 0;
  std::vector<T> data_;
};

using ImageU8 = Image<std::uint8_t>;
using ImageF = Image<float>;
using ImageViewU8 = ImageView<std::uint8_t>;
using ImageViewF = ImageView<float>;

}  // namespace glide
