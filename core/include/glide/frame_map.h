#pragma once

#include "glide/map_view.h"
#include "glide/version.h"

#include <cstdint>
#include <memory>

namespace glide {

/// The map that a frame was tracked in: the one that the poses of its FrameResult are of, whatever
/// the mapper has corrected since. Immutable, and hardly larger than a pointer until it is viewed.
/// Any thread. From Session::frameMap().
class GLIDE_API FrameMap {
 public:
  FrameMap() = default;
  FrameMap(const FrameMap&) = delete;
  FrameMap& operator=(const FrameMap&) = delete;
  virtual ~FrameMap();

  virtual std::uint64_t generation() const = 0;  ///< MapView::generation
  virtual std::uint64_t revision() const = 0;    ///< MapView::revision
  /// A copy, never null: made for who asks first, which takes milliseconds for a large map, and
  /// shared by all.
  virtual std::shared_ptr<const MapView> view() const = 0;
};

}  // namespace glide
