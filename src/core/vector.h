#pragma once
#include <Eigen/Core>

namespace blossom {

using Vec2 = Eigen::Vector2d;
using Vec3 = Eigen::Vector3d;
using Vec4 = Eigen::Vector4d;

}  // namespace blossom
