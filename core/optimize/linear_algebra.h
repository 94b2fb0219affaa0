#pragma once

#include <ceres/types.h>

namespace glide {

/// Who factorises sparse systems. Not SuiteSparse, Ceres' default: it runs OpenMP threads of its
/// own behind our back, its supernodal part is under the GPL, and phones do not have it.
inline constexpr ceres::SparseLinearAlgebraLibraryType kSparseLibrary = ceres::EIGEN_SPARSE;

}  // namespace glide
