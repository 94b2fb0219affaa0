#pragma once

#include "geometry/lie.h"

#include <cstdint>

namespace glide::synthetic {

/// What the camera sees while it is carried away.
enum class KidnapView {
  black,    ///< nothing: the lens is covered
  foreign,  ///< another place, through which it moves
};

/// The camera is carried away and put back onto its earlier path, a little beside it.
struct Kidnap {
  int begin = 0,
      end = 0;  ///< frames without sight of the scene: begin <= frame < end; none if equal
  KidnapView view = KidnapView::black;
};

/// Where the camera goes on after being carried away.
struct Return {
  double t_s = 0.0;  ///< the time whose pose it returns to, seconds
  SE3d T_path_cam;   ///< how it lies beside its earlier path from then on
};

/// `begin_s` is when it was carried away; lengths scale with the depth of the scene (metres). The
/// same seed gives the same place.
Return returnAfter(double begin_s, double depth, std::uint64_t seed);

}  // namespace glide::synthetic
