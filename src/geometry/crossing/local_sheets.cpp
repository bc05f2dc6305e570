#include "geometry/crossing/local_sheets.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <compare>
#include <limits>
#include <span>
#include <unordered_map>
#include <utility>

#include "geometry/crossing/divided_triangles.h"
#include "geometry/mesh/triangle_distance.h"
#include "geometry/numeric/box_tree.h"

namespace blossom {
namespace {

using TriangleSide = std::pair<int, int>;

TriangleSide sideBetween(int a, int b) { return {std::min(a, b), std::max(a, b)}; }

/// The triangles in a ball, divided until they are small.
class Ball {
 public:
  Ball(const SheetMesh& mesh, const SmoothSheets& sheets, const Vec3& middle, double radius)
      : sheets_(sheets), middle_(middle), radius_(radius) {
    const Box3 box(Vec3(middle.array() - radius), Vec3(middle.array() + radius));
    for (const SheetBlock& block : mesh.blocks) {
      if (!block.box.intersects(box)) continue;
      for (std::uint32_t k = block.first; k < block.first + block.count; ++k)
        if (reaches(mesh.at(mesh.triangles[k]))) take(mesh, mesh.triangles[k]);
    }
  }

  /// Leaves what lies within a part of the ball with all its corners.
  void keepWhole(double share) {
    const double within = share * radius_;
    std::erase_if(triangles, [&](const SheetTriangle& t) {
      const Triangle3 corners = at(t);
      return std::any_of(corners.begin(), corners.end(), [&](const Vec3& p) { return (p - middle_).norm() > within; });
    });
  }

  /// Halves the sides that are longer than `longest` or farther than `off` from the smooth face, as often as it takes; those
  /// up to `fine` are not looked at.
  void divide(double longest, double off, double fine, const Progress& progress) {
    constexpr int rounds = 14;
    constexpr std::size_t many = 20000;
    const auto tooLong = [&](const Vec3& p, const Vec3& q, const Vec3& middle) {
      const Vec3 along = q - p;
      return along.squaredNorm() > longest * longest ||
             along.cross(middle - p).squaredNorm() > off * off * along.squaredNorm();
    };
    const auto wanted = [&](const Triangle3& t) { return reaches(t); };
    TriangleDivision division(points, triangles, sheets_, tooLong, fine);
    for (int round = 0; round < rounds && division.count() < many; ++round) {
      progress.check();
      if (!division.divideOnce(wanted)) break;
    }
    triangles = division.triangles(wanted);
  }

  [[nodiscard]] Triangle3 at(const SheetTriangle& t) const {
    return {points[static_cast<std::size_t>(t.corners[0])], points[static_cast<std::size_t>(t.corners[1])],
            points[static_cast<std::size_t>(t.corners[2])]};
  }

  std::vector<Vec3> points;
  std::vector<SheetTriangle> triangles;

 private:
  [[nodiscard]] bool reaches(const Triangle3& t) const {
    return (closestOnTriangle(middle_, t) - middle_).squaredNorm() <= radius_ * radius_;
  }

  void take(const SheetMesh& mesh, SheetTriangle t) {
    for (int& corner : t.corners) {
      const auto [found, isNew] = numbers_.try_emplace(corner, static_cast<int>(points.size()));
      if (isNew) points.push_back(mesh.points[static_cast<std::size_t>(corner)]);
      corner = found->second;
    }
    triangles.push_back(t);
  }

  const SmoothSheets& sheets_;
  Vec3 middle_;
  double radius_;
  std::unordered_map<int, int> numbers_;
};

/// What hangs together over sides, all of its triangles turned one way round.
struct LocalSheet {
  std::vector<Triangle3> triangles;
  std::vector<SheetTriangle> onFace;     ///< the same on their faces, with the corners in the same order
  std::vector<std::array<bool, 3>> rim;  ///< whether the side from corner k to the next is of one triangle alone
  std::vector<Vec3> points;              ///< corners within the ball
  BoxTree<3> tree;                       ///< of the triangles

  void finish() {
    std::vector<Box3> boxes;
    boxes.reserve(triangles.size());
    for (const Triangle3& t : triangles) boxes.push_back(boxOf(t));
    tree = BoxTree<3>(boxes);
  }
};

/// The sheets of a ball, by numbers from 1.
class Sheets {
 public:
  explicit Sheets(const Ball& ball) : ball_(ball), mark_(ball.triangles.size(), 0), sides_(3 * ball.triangles.size()) {
    listSides();
    int count = 0;
    for (std::size_t k = 0; k < mark_.size(); ++k)
      if (mark_[k] == 0) flood(k, ++count);
  }

  /// The triangle of a face nearest to a point, of those equally near the one nearest by its parameters.
  [[nodiscard]] std::optional<std::size_t> triangleAt(const SheetPlace& place, const Vec3& point, double slack) const {
    std::optional<std::size_t> best;
    double least = std::numeric_limits<double>::max();
    for (std::size_t k = 0; k < ball_.triangles.size(); ++k) {
      const SheetTriangle& t = ball_.triangles[k];
      if (t.face != place.face) continue;
      const double off = ((t.at[0] + t.at[1] + t.at[2]) / 3 - place.at).squaredNorm();
      if (off >= least || (closestOnTriangle(point, ball_.at(t)) - point).norm() > slack) continue;
      least = off, best = k;
    }
    return best;
  }

  [[nodiscard]] int sheetOf(std::size_t triangle) const { return std::abs(mark_[triangle]); }

  [[nodiscard]] LocalSheet sheet(int number, const Vec3& middle, double radius) const {
    LocalSheet result;
    std::vector<bool> taken(ball_.points.size());
    for (std::size_t k = 0; k < ball_.triangles.size(); ++k) {
      if (std::abs(mark_[k]) != number) continue;
      SheetTriangle t = ball_.triangles[k];
      std::array<bool, 3> rim{};
      for (std::size_t i = 0; i < 3; ++i) rim[i] = over(k, i).size() == 1;
      if (mark_[k] < 0) std::swap(t.corners[0], t.corners[1]), std::swap(t.at[0], t.at[1]), std::swap(rim[1], rim[2]);
      result.triangles.push_back(ball_.at(t));
      result.onFace.push_back(t);
      result.rim.push_back(rim);
      for (const int corner : ball_.triangles[k].corners) {
        const auto c = static_cast<std::size_t>(corner);
        if (!taken[c] && (ball_.points[c] - middle).norm() <= radius) result.points.push_back(ball_.points[c]);
        taken[c] = true;
      }
    }
    result.finish();
    return result;
  }

 private:
  [[nodiscard]] TriangleSide side(std::size_t k, std::size_t i) const {
    const auto& corners = ball_.triangles[k].corners;
    return sideBetween(corners[i], corners[(i + 1) % 3]);
  }
  struct Listed {
    TriangleSide side;
    std::size_t triangle = 0, which = 0;  ///< of its three sides
    friend auto operator<=>(const Listed&, const Listed&) = default;
  };

  void listSides() {
    for (std::size_t k = 0; k < mark_.size(); ++k)
      for (std::size_t i = 0; i < 3; ++i) sides_[3 * k + i] = {side(k, i), k, i};
    std::sort(sides_.begin(), sides_.end());
    from_.resize(sides_.size());
    for (std::size_t first = 0, e = 0; e < sides_.size(); ++e) {
      if (sides_[e].side != sides_[first].side) first = e;
      from_[3 * sides_[e].triangle + sides_[e].which] = first;
    }
  }

  /// The triangles that have side i of triangle k.
  [[nodiscard]] std::span<const Listed> over(std::size_t k, std::size_t i) const {
    const std::size_t first = from_[3 * k + i];
    std::size_t last = first;
    while (last < sides_.size() && sides_[last].side == sides_[first].side) ++last;
    return std::span(sides_).subspan(first, last - first);
  }

  /// Marks what hangs together with a triangle.
  void flood(std::size_t seed, int number) {
    std::vector<std::size_t> open{seed};
    mark_[seed] = number;
    while (!open.empty()) {
      const std::size_t k = open.back();
      open.pop_back();
      for (std::size_t i = 0; i < 3; ++i)
        for (const Listed& other : over(k, i)) {
          if (mark_[other.triangle] != 0) continue;
          const bool sameWay = runsUp(k, i) != runsUp(other.triangle, other.which);
          mark_[other.triangle] = sameWay ? mark_[k] : -mark_[k];
          open.push_back(other.triangle);
        }
    }
  }

  /// Whether a triangle runs along a side from the lower number to the higher one.
  [[nodiscard]] bool runsUp(std::size_t k, std::size_t i) const {
    const auto& corners = ball_.triangles[k].corners;
    return corners[i] < corners[(i + 1) % 3];
  }

  const Ball& ball_;
  std::vector<int> mark_;          ///< number of the sheet, negative where the triangle is turned
  std::vector<Listed> sides_;      ///< sorted
  std::vector<std::size_t> from_;  ///< of side i of triangle k, at 3 k + i: its first place in `sides_`
};

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
  Divided(Ball given, const Vec3& at, double within, double near)
      : middle(at), radius(within), off(near), ball(std::move(given)), sheets(ball) {}

  Vec3 middle;
  double radius, off;
  Ball ball;
  Sheets sheets;
};

SheetSurroundings::SheetSurroundings(const SheetMesh& mesh, const SmoothSheets& smooth) : mesh_(mesh), smooth_(smooth) {}
SheetSurroundings::~SheetSurroundings() = default;

const SheetSurroundings::Divided& SheetSurroundings::around(const Vec3& middle, double radius, double off,
                                                            const Progress& progress) {
  constexpr double same = 0.01;  // of the radius
  constexpr std::size_t most = 8;
  for (const std::unique_ptr<Divided>& each : divided_)
    if (each->radius == radius && each->off == off && (each->middle - middle).norm() <= same * radius) return *each;
  Ball ball(mesh_, smooth_, middle, radius);
  ball.divide(radius / 4, off, 0, progress);
  trianglesDivided_ += ball.triangles.size();
  auto made = std::make_unique<Divided>(std::move(ball), middle, radius, off);
  if (divided_.size() == most) divided_.erase(divided_.begin());
  return *divided_.emplace_back(std::move(made));
}

bool SheetSurroundings::hangTogether(const SheetMeeting& meeting, double radius) const {
  constexpr double inside = 0.98;  // of the radius: middles of sides may lie a little farther out than their ends
  Ball ball(mesh_, smooth_, meeting.point, radius);
  ball.keepWhole(inside);
  const Sheets sheets(ball);
  const double slack = mesh_.chord + radius / 16;
  const auto first = sheets.triangleAt(meeting.first, meeting.point, slack),
             second = sheets.triangleAt(meeting.second, meeting.point, slack);
  return first && second && sheets.sheetOf(*first) == sheets.sheetOf(*second);
}

SheetSurroundings::Sketch SheetSurroundings::sketchAt(const SheetMeeting& meeting, double radius, const Progress& progress) {
  Ball ball(mesh_, smooth_, meeting.point, radius);
  // Many triangles lie close enough one beside the other, be they long.
  constexpr std::size_t many = 2000;
  const double longest = ball.triangles.size() < many ? radius / 4 : radius / 2;
  const double off = radius / 16;
  ball.divide(longest, off, mesh_.chord <= off ? longest : 0, progress);
  trianglesDivided_ += ball.triangles.size();
  const Sheets sheets(ball);
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
