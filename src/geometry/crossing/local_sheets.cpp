#include "geometry/crossing/local_sheets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>

#include "geometry/crossing/sheet_ball.h"
#include "geometry/mesh/triangle_distance.h"
#include "geometry/numeric/box_tree.h"

namespace blossom {
namespace {

/// Whether a point of a triangle lies on a side of it that is part of the rim.
bool isOnRim(const Triangle3& t, const std::array<bool, 3>& rim, const Vec3& foot) {
  for (std::size_t i = 0; i < 3; ++i) {
    if (!rim[i]) continue;
    const Vec3 &a = t[i], along = t[(i + 1) % 3] - a;
    if (along.cross(foot - a).squaredNorm() <= 1e-18 * along.squaredNorm() * along.squaredNorm()) return true;
  }
  return false;
}

/// Parameters beside a point of a triangle, drawn towards its middle by a share: off sides and corners, where the face may
/// have no normal, or another one.
Vec2 parametersBeside(const SheetTriangle& onFace, const Triangle3& t, const Vec3& foot, double inwards) {
  const Vec3 ownNormal = (t[1] - t[0]).cross(t[2] - t[0]);
  const double whole = ownNormal.squaredNorm();
  const Vec2 middle = (onFace.at[0] + onFace.at[1] + onFace.at[2]) / 3;
  if (!(whole > 0)) return middle;
  Vec2 at = inwards * middle;
  for (std::size_t i = 0; i < 3; ++i) {
    const Vec3 &a = t[(i + 1) % 3], &b = t[(i + 2) % 3];
    at += (1 - inwards) * (b - a).cross(foot - a).dot(ownNormal) / whole * onFace.at[i];
  }
  return at;
}

/// The unit normal of a face, towards the side its triangle is seen from.
Vec3 normalTowards(const SurfaceFrame& frame, const SheetTriangle& onFace, const Triangle3& t) {
  const Vec3 ownNormal = (t[1] - t[0]).cross(t[2] - t[0]);
  const Vec2 first = onFace.at[1] - onFace.at[0], second = onFace.at[2] - onFace.at[0];
  const double turn = first.x() * second.y() - first.y() * second.x();
  const Vec3 normal = frame.du.cross(frame.dv);
  const double length = normal.norm(), scale = std::max(frame.du.squaredNorm(), frame.dv.squaredNorm());
  if (!(ownNormal.squaredNorm() > 0) || turn == 0 || !(length > 1e-9 * scale)) return ownNormal.normalized();
  return std::copysign(1 / length, turn) * normal;
}

/// The unit normal of the smooth face beside a point of a triangle.
Vec3 smoothNormal(const SmoothSheets& smooth, const SheetTriangle& onFace, const Triangle3& t, const Vec3& foot) {
  constexpr double inwards = 0.1;
  return normalTowards(smooth.frame(onFace.face, parametersBeside(onFace, t, foot, inwards)), onFace, t);
}

/// The height of a point over the smooth face whose nearest point is looked for from a point of a triangle on.
/// @param near mm, how far the steps may end off that point  @returns nothing when they go astray
std::optional<double> projectedHeight(const SmoothSheets& smooth, const SheetTriangle& onFace, const Triangle3& t,
                                      const Vec3& foot, const Vec3& p, double near) {
  constexpr int steps = 8;
  constexpr double arrived = 1e-3, damping = 1e-9;
  Vec2 at = parametersBeside(onFace, t, foot, 0.02);
  SurfaceFrame frame = smooth.frame(onFace.face, at);
  double share = 1;  // of the step that the tangent plane suggests; less where the face bends more than that tells
  for (int step = 0; step < steps; ++step) {
    const Vec3 d = p - frame.point;
    const double uu = frame.du.squaredNorm(), uv = frame.du.dot(frame.dv), vv = frame.dv.squaredNorm();
    const double a = uu * (1 + damping), b = vv * (1 + damping), whole = a * b - uv * uv;
    if (!(whole > 0)) break;
    const double x = frame.du.dot(d), y = frame.dv.dot(d);
    const Vec2 move((b * x - uv * y) / whole, (a * y - uv * x) / whole);
    if ((move.x() * frame.du + move.y() * frame.dv).norm() <= arrived * near) break;
    const SurfaceFrame next = smooth.frame(onFace.face, at + share * move);
    if (!((p - next.point).squaredNorm() < d.squaredNorm())) {
      share /= 4;
      continue;
    }
    at += share * move;
    frame = next;
    share = 1;
  }
  const Vec3 d = p - frame.point;
  if (!d.allFinite() || (frame.point - foot).norm() > near) return {};
  const double height = d.dot(normalTowards(frame, onFace, t));
  return std::copysign(std::min(std::abs(height), d.norm()), height);
}

/// Distances of points from a sheet, with the side that they lie on; 0 where the nearest point of the sheet is on its rim.
class SheetSides {
 public:
  explicit SheetSides(const LocalSheet& sheet) : sheet_(sheet) {}

  /// By the triangles.
  double distance(const Vec3& p) {
    constexpr double same = 1 + 1e-9;
    least_ = std::numeric_limits<double>::max();
    nearest_.clear();
    const auto visit = [&](std::size_t k) {
      const Vec3 foot = closestOnTriangle(p, sheet_.triangles[k]);
      const double squared = (foot - p).squaredNorm();
      if (squared > least_ * same) return;
      if (squared * same < least_) nearest_.clear();
      least_ = std::min(least_, squared);
      nearest_.emplace_back(k, foot);
    };
    sheet_.tree.walk([&](const Box3& box) { return squaredDistance(box, p); }, visit,
                     [&](double squared) { return squared <= least_ * same; });
    for (const auto& [k, foot] : nearest_)
      if (isOnRim(sheet_.triangles[k], sheet_.rim[k], foot)) return 0;
    const double height = greatestHeight([&](std::size_t k, const Vec3& foot) {
      const Triangle3& t = sheet_.triangles[k];
      return (p - foot).dot((t[1] - t[0]).cross(t[2] - t[0]).normalized());
    });
    return std::copysign(std::sqrt(least_), height);
  }

  /// The height over the smooth face at the point that `distance` has just been asked for. It is the distance, except beyond
  /// an edge: where a sheet folds back on itself, what lies in its plane beyond the fold is on neither side of it, although
  /// it is far from it, and the triangles at the fold may stand in any direction.
  [[nodiscard]] double smoothHeight(const SmoothSheets& smooth, const Vec3& p) const {
    const double height = greatestHeight([&](std::size_t k, const Vec3& foot) {
      return (p - foot).dot(smoothNormal(smooth, sheet_.onFace[k], sheet_.triangles[k], foot));
    });
    return std::copysign(std::min(std::abs(height), std::sqrt(least_)), height);
  }

  /// The same over the nearest point of the smooth face itself; nothing where that is not found.
  [[nodiscard]] std::optional<double> heightByProjection(const SmoothSheets& smooth, const Vec3& p, double near) const {
    std::optional<double> best;
    for (const auto& [k, foot] : nearest_) {
      const auto height = projectedHeight(smooth, sheet_.onFace[k], sheet_.triangles[k], foot, p, near);
      if (!height) return {};
      if (!best || std::abs(*height) > std::abs(*best)) best = height;
    }
    return best;
  }

 private:
  /// Of the triangles around the nearest point the one that is seen most from the front tells the side.
  template <class HeightOver>
  [[nodiscard]] double greatestHeight(const HeightOver& over) const {
    double best = 0;
    for (const auto& [k, foot] : nearest_)
      if (const double height = over(k, foot); std::abs(height) > std::abs(best)) best = height;
    return best;
  }

  const LocalSheet& sheet_;
  double least_ = 0;                                   ///< squared distance of the last point
  std::vector<std::pair<std::size_t, Vec3>> nearest_;  ///< triangles, and their points
};

/// How far points reach on either side of a sheet, at most.
struct Reach {
  double lesser = 0, greater = 0;
};
Reach sketchedReach(const std::vector<Vec3>& points, const LocalSheet& sheet, const SmoothSheets& smooth, double radius,
                    const Progress& progress) {
  constexpr std::size_t enough = 400;
  const std::size_t stride = points.size() / enough + 1;
  SheetSides sides(sheet);
  double above = 0, below = 0;
  for (std::size_t k = 0; k < points.size(); k += stride) {
    progress.check();
    const double d = sides.distance(points[k]);
    if (d == 0) continue;
    const auto height = sides.heightByProjection(smooth, points[k], radius / 2);
    above = std::max(above, height ? *height : radius);
    below = std::max(below, height ? -*height : radius);
  }
  return {std::min(above, below), std::max(above, below)};
}

/// How far points reach on either side of a sheet.
Passage reachThrough(const std::vector<Vec3>& points, const LocalSheet& sheet, const SmoothSheets& smooth,
                     const Progress& progress) {
  constexpr std::size_t enough = 400;
  const std::size_t stride = points.size() / enough + 1;
  SheetSides sides(sheet);
  double above = 0, below = 0;
  for (std::size_t k = 0; k < points.size(); k += stride) {
    progress.check();
    double d = sides.distance(points[k]);
    // Smooth faces cost time: they are asked where it matters.
    if (d > above || -d > below) d = sides.smoothHeight(smooth, points[k]);
    above = std::max(above, d);
    below = std::max(below, -d);
  }
  return {true, std::min(above, below), std::max(above, below)};
}

}  // namespace

struct SheetSurroundings::Divided {
  Divided(SheetBall given, const Vec3& at, double within, double near)
      : middle(at), radius(within), off(near), ball(std::move(given)), sheets(ball) {}

  Vec3 middle;
  double radius, off;
  SheetBall ball;
  SheetsOfBall sheets;
};

SheetSurroundings::SheetSurroundings(const SheetMesh& mesh, const SmoothSheets& smooth) : mesh_(mesh), smooth_(smooth) {}
SheetSurroundings::~SheetSurroundings() = default;

const SheetSurroundings::Divided& SheetSurroundings::around(const Vec3& middle, double radius, double off,
                                                            const Progress& progress) {
  constexpr double same = 0.01;  // of the radius
  constexpr std::size_t most = 8;
  for (const std::unique_ptr<Divided>& each : divided_)
    if (each->radius == radius && each->off == off && (each->middle - middle).norm() <= same * radius) return *each;
  SheetBall ball(mesh_, smooth_, middle, radius);
  ball.divide(radius / 4, off, 0, progress);
  trianglesDivided_ += ball.triangles.size();
  auto made = std::make_unique<Divided>(std::move(ball), middle, radius, off);
  if (divided_.size() == most) divided_.erase(divided_.begin());
  return *divided_.emplace_back(std::move(made));
}

bool SheetSurroundings::hangTogether(const SheetMeeting& meeting, double radius) const {
  constexpr double inside = 0.98;  // of the radius: middles of sides may lie a little farther out than their ends
  SheetBall ball(mesh_, smooth_, meeting.point, radius);
  ball.keepWhole(inside);
  const SheetsOfBall sheets(ball);
  const double slack = mesh_.chord + radius / 16;
  const auto first = sheets.triangleAt(meeting.first, meeting.point, slack),
             second = sheets.triangleAt(meeting.second, meeting.point, slack);
  return first && second && sheets.sheetOf(*first) == sheets.sheetOf(*second);
}

SheetSurroundings::Sketch SheetSurroundings::sketchAt(const SheetMeeting& meeting, double radius, const Progress& progress) {
  SheetBall ball(mesh_, smooth_, meeting.point, radius);
  // Many triangles lie close enough one beside the other, be they long.
  constexpr std::size_t many = 2000;
  const double longest = ball.triangles.size() < many ? radius / 4 : radius / 2;
  const double off = radius / 16;
  ball.divide(longest, off, mesh_.chord <= off ? longest : 0, progress);
  trianglesDivided_ += ball.triangles.size();
  const SheetsOfBall sheets(ball);
  const double slack = mesh_.chord + radius / 16;
  const auto first = sheets.triangleAt(meeting.first, meeting.point, slack),
             second = sheets.triangleAt(meeting.second, meeting.point, slack);
  if (!first || !second || sheets.sheetOf(*first) == sheets.sheetOf(*second)) return {};
  const LocalSheet a = sheets.sheet(sheets.sheetOf(*first), meeting.point, radius),
                   b = sheets.sheet(sheets.sheetOf(*second), meeting.point, radius);
  const Reach ofA = sketchedReach(a.points, b, smooth_, radius, progress),
              ofB = sketchedReach(b.points, a, smooth_, radius, progress);
  return {true, std::max(ofA.lesser, ofB.lesser), std::min(ofA.greater, ofB.greater), std::max(ofA.greater, ofB.greater)};
}

Passage SheetSurroundings::passageAt(const SheetMeeting& meeting, double radius, double off, const Progress& progress) {
  if (hangTogether(meeting, radius)) return {};
  const Divided& here = around(meeting.point, radius, off, progress);
  const double slack = radius / 16;
  const auto first = here.sheets.triangleAt(meeting.first, meeting.point, slack),
             second = here.sheets.triangleAt(meeting.second, meeting.point, slack);
  if (!first || !second) return {};
  const int one = here.sheets.sheetOf(*first), other = here.sheets.sheetOf(*second);
  if (one == other) return {};
  const LocalSheet a = here.sheets.sheet(one, here.middle, radius), b = here.sheets.sheet(other, here.middle, radius);
  const Passage ofA = reachThrough(a.points, b, smooth_, progress), ofB = reachThrough(b.points, a, smooth_, progress);
  return ofA.lesser < ofB.lesser ? ofB : ofA;
}

}  // namespace blossom
