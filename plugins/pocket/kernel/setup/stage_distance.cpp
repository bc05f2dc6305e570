#include "kernel/setup/stage_distance.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace blossom::pocket {

namespace {

/// From a place (radius, height) to the profile, without what is round about it; 0 inside.
double toProfile(const std::vector<Vec2>& profile, const Vec2& place) {
  double widest = 0;
  for (const Vec2& corner : profile) widest = std::max(widest, corner.x());
  // A profile without area, of a disc or a point, has an inside, too.
  bool inside = place.x() <= widest && place.y() >= profile.front().y() && place.y() <= profile.back().y();
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    const Vec2& from = profile[i];
    const Vec2 along = profile[i + 1] - from;
    const double length = along.squaredNorm();
    const Vec2 offset = place - from;
    inside = inside && cross(along, offset) >= 0;
    const double share = length > 0 ? std::clamp(offset.dot(along) / length, 0.0, 1.0) : 0;
    nearest = std::min(nearest, (offset - share * along).squaredNorm());
  }
  return inside ? 0 : std::sqrt(nearest);
}

/// The point of the stage, without what is round about it, that lies farthest in a direction.
Vec3 farthest(const ToolStage& stage, const Vec3& direction) {
  const double across = direction.head<2>().norm();
  const auto far = std::max_element(stage.profile.begin(), stage.profile.end(), [&](const Vec2& a, const Vec2& b) {
    return a.dot(Vec2(across, direction.z())) < b.dot(Vec2(across, direction.z()));
  });
  Vec3 point(0, 0, far->y());
  if (across > 0) point.head<2>() = far->x() / across * direction.head<2>();
  return point;
}

/// Of an upright line: in the plane of radius and height it is upright, too.
double toUprightSide(const ToolStage& stage, const Vec3& a, const Vec3& b) {
  const auto [low, high] = std::minmax(a.z(), b.z());
  const double across = a.head<2>().norm();
  double nearest = std::min(distanceTo(stage, a), distanceTo(stage, b));
  for (const Vec2& corner : stage.profile)
    if (corner.y() > low && corner.y() < high) nearest = std::min(nearest, distanceTo(stage, Vec3(across, 0, corner.y())));
  return nearest;
}

/// Of a level line: at its height the distance grows with the radius.
double toLevelSide(const ToolStage& stage, const Vec3& a, const Vec3& b) {
  const Vec2 along = (b - a).head<2>();
  const double share = std::clamp(-a.head<2>().dot(along) / along.squaredNorm(), 0.0, 1.0);
  return distanceTo(stage, a + share * (b - a));
}

/// By golden sections (Kiefer 1953).
double toSlopingSide(const ToolStage& stage, const Vec3& a, const Vec3& b) {
  constexpr double golden = 0.6180339887498949;
  constexpr int sections = 44;  // to 1e-9 of the length
  const auto at = [&](double t) { return distanceTo(stage, a + t * (b - a)); };
  double low = 0, high = 1;
  double left = high - golden, right = low + golden;
  double ofLeft = at(left), ofRight = at(right);
  for (int i = 0; i < sections && std::min(ofLeft, ofRight) > 0; ++i) {
    if (ofLeft < ofRight) {
      high = right, right = left, ofRight = ofLeft;
      left = high - golden * (high - low);
      ofLeft = at(left);
    } else {
      low = left, left = right, ofLeft = ofRight;
      right = low + golden * (high - low);
      ofRight = at(right);
    }
  }
  return std::min(ofLeft, ofRight);
}

double toSide(const ToolStage& stage, const Vec3& a, const Vec3& b) {
  if (a.head<2>() == b.head<2>()) return toUprightSide(stage, a, b);
  return a.z() == b.z() ? toLevelSide(stage, a, b) : toSlopingSide(stage, a, b);
}

bool isOver(const std::array<Vec3, 3>& triangle, const Vec3& normal, const Vec3& point) {
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3& a = triangle[i];
    if ((triangle[(i + 1) % 3] - a).cross(point - a).dot(normal) < 0) return false;
  }
  return true;
}

}  // namespace

double distanceTo(const ToolStage& stage, const Vec3& point) {
  return std::max(0.0, toProfile(stage.profile, {point.head<2>().norm(), point.z()}) - stage.round);
}

double distanceTo(const ToolStage& stage, const std::array<Vec3, 3>& triangle) {
  double least = 0;  // that it can be
  const Vec3 normal = (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
  const double longest = std::max({(triangle[1] - triangle[0]).squaredNorm(), (triangle[2] - triangle[1]).squaredNorm(),
                                   (triangle[0] - triangle[2]).squaredNorm()});
  constexpr double thinnest = 1e-7;  // of which the normal is still good for the distance
  if (const double size = normal.norm(); size > thinnest * longest) {
    const Vec3 unit = normal / size;
    const Vec3 above = farthest(stage, -unit);  // nearest to the plane for a stage on the side of the normal
    const Vec3 below = farthest(stage, unit);
    const double lowest = unit.dot(above - triangle[0]);
    const double highest = unit.dot(below - triangle[0]);
    const double away = std::max(lowest, -highest);  // of the plane; negative where it cuts the stage
    least = std::max(0.0, away - stage.round);
    if (away > 0) {
      if (isOver(triangle, unit, lowest > 0 ? above : below)) return least;
    } else if (highest > lowest) {
      const Vec3 within = above + (below - above) * (-lowest / (highest - lowest));
      if (isOver(triangle, unit, within)) return 0;
    }
  }
  const std::array<double, 3> ends{distanceTo(stage, triangle[0]), distanceTo(stage, triangle[1]),
                                   distanceTo(stage, triangle[2])};
  double nearest = *std::min_element(ends.begin(), ends.end());
  for (std::size_t i = 0; i < 3 && nearest > least; ++i) {
    const std::size_t k = (i + 1) % 3;
    // No distance falls faster than the way is long.
    const double onSide = (ends[i] + ends[k] - (triangle[k] - triangle[i]).norm()) / 2;
    if (onSide < nearest) nearest = std::min(nearest, toSide(stage, triangle[i], triangle[k]));
  }
  return nearest;
}

double distanceAtLeast(const ToolStage& stage, const Eigen::AlignedBox3d& box) {
  const Vec2 nearest(std::clamp(0.0, box.min().x(), box.max().x()), std::clamp(0.0, box.min().y(), box.max().y()));
  const double across = std::max(0.0, nearest.norm() - stage.reach());
  const double up = std::max({0.0, box.min().z() - stage.high(), stage.low() - box.max().z()});
  return std::hypot(across, up);
}

}  // namespace blossom::pocket
