#pragma once

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace glide {

using Vec2d = Eigen::Vector2d;
using Vec3d = Eigen::Vector3d;
using Vec4d = Eigen::Vector4d;
using Vec6d = Eigen::Matrix<double, 6, 1>;
using Vec7d = Eigen::Matrix<double, 7, 1>;
using Vec2f = Eigen::Vector2f;
using Vec3f = Eigen::Vector3f;
using Mat2d = Eigen::Matrix2d;
using Mat3d = Eigen::Matrix3d;
using Mat4d = Eigen::Matrix4d;
using Mat6d = Eigen::Matrix<double, 6, 6>;
using Mat7d = Eigen::Matrix<double, 7, 7>;
using Mat23d = Eigen::Matrix<double, 2, 3>;
using Mat26d = Eigen::Matrix<double, 2, 6>;

}  // namespace glide
