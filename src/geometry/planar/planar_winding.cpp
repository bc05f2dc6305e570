#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>
#include <optional>
#include <vector>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/planar_bezier.h"
#include "geometry/planar/segment_point.h"

namespace blossom {
namespace {

constexpr int deepest = 48;  // a box halved so often is a point

/// Crossing of the ray to the right of q, +1 upwards, -1 downwards. Half-open, so that polylines count every level once.
int crossing(const Vec2& a, const Vec2& b, const Vec2& q) {
  const bool below = a.y() <= q.y();
  if (below == (b.y() <= q.y())) return 0;
  const double side = (b.x() - a.x()) * (q.y() - a.y()) - (b.y() - a.y()) * (q.x() - a.x());
  if (below) return side > 0 ? 1 : 0;
  return side < 0 ? -1 : 0;
}

// A curve may be replaced by its chord when the point is outside a convex hull of the curve: the one can be moved into the
// other without crossing the point.

int crossings(const Line2& line, const Vec2& q) { return crossing(line.from, line.to, q); }

/// Of points that are computed from numbers so far away. Halves of shorter pieces need not lie in them.
double roundingAt(double farthest) { return 8 * std::numeric_limits<double>::epsilon() * farthest; }

int crossings(const BezierPiece& piece, const Vec2& q, int depth) {
  Vec2 low = euclidean(piece.front());
  Vec2 high = low;
  for (const Vec3& pole : piece) {
    low = low.cwiseMin(euclidean(pole));
    high = high.cwiseMax(euclidean(pole));
  }
  const bool outside = (q.array() < low.array()).any() || (q.array() > high.array()).any();
  const double rounding = roundingAt(low.cwiseAbs().cwiseMax(high.cwiseAbs()).maxCoeff());
  if (outside || depth == 0 || (high - low).maxCoeff() <= rounding)
    return crossing(euclidean(piece.front()), euclidean(piece.back()), q);
  const auto [left, right] = halves(piece);
  return crossings(left, q, depth - 1) + crossings(right, q, depth - 1);
}

int crossings(const Spline2& spline, const Vec2& q) {
  int sum = 0;
  for (const BezierPiece& piece : bezierPieces(spline)) sum += crossings(piece, q, deepest);
  return sum;
}

struct ArcPiece {
  double from, to;
  Vec2 start, end;
};

int crossings(const Arc2& arc, const ArcPiece& piece, const Vec2& q, int depth) {
  const double sweep = piece.to - piece.from;
  if (std::abs(sweep) <= std::numbers::pi / 2) {
    const double half = (piece.start - piece.end).norm() / 2;
    const bool outside =
        (q - (piece.start + piece.end) / 2).squaredNorm() > half * half;  // this disc contains an arc of up to a half circle
    const double rounding = roundingAt(arc.center.cwiseAbs().maxCoeff() + arc.radius);
    if (outside || depth == 0 || half <= rounding) return crossing(piece.start, piece.end, q);
  }
  const double middle = (piece.from + piece.to) / 2;
  const Vec2 point = arc.center + arc.radius * Vec2(std::cos(middle), std::sin(middle));
  return crossings(arc, {piece.from, middle, piece.start, point}, q, depth - 1) +
         crossings(arc, {middle, piece.to, point, piece.end}, q, depth - 1);
}

int crossings(const Arc2& arc, const Vec2& q) {
  return crossings(arc, {arc.start, arc.start + arc.sweep, startPoint(Segment(arc)), endPoint(Segment(arc))}, q, deepest);
}

/// A stretch of a horizontal line.
struct Stretch {
  double from = 0, to = 0, y = 0;
  [[nodiscard]] double width() const { return to - from; }
  [[nodiscard]] Vec2 middle() const { return {(from + to) / 2, y}; }
};

/// The stretches of the level y inside the polygon; none where a corner is as near to the level as that.
void addStretchesInside(const std::vector<Vec2>& polygon, double y, double near, std::vector<Stretch>& stretches) {
  if (std::any_of(polygon.begin(), polygon.end(), [&](const Vec2& p) { return std::abs(p.y() - y) < near; })) return;
  std::vector<double> places;
  for (std::size_t i = 0; i < polygon.size(); ++i) {
    const Vec2& a = polygon[i];
    const Vec2& b = polygon[(i + 1) % polygon.size()];
    if ((a.y() <= y) != (b.y() <= y)) places.push_back(a.x() + (b.x() - a.x()) * (y - a.y()) / (b.y() - a.y()));
  }
  std::sort(places.begin(), places.end());
  for (std::size_t i = 0; i + 1 < places.size(); i += 2)
    if (places[i] < places[i + 1]) stretches.push_back({places[i], places[i + 1], y});
}

double extent(const std::vector<Vec2>& polygon) {
  Vec2 low = polygon.front();
  Vec2 high = low;
  for (const Vec2& p : polygon) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  return (high - low).norm();
}

/// Between the way there and back along one line, rounding makes stretches that are no wider.
double widthOfRounding(const std::vector<Vec2>& polygon, double height) {
  double farthest = 0;
  for (const Vec2& p : polygon) farthest = std::max(farthest, p.cwiseAbs().maxCoeff());
  return 2 * roundingAt(farthest) * extent(polygon) / height;
}

/// On levels that are spread over a polygon, the widest first. Levels that pass corners are left out: rounding makes
/// stretches along the sides that lie on them.
std::vector<Stretch> stretchesInside(const std::vector<Vec2>& polygon) {
  const auto [lowest, highest] =
      std::minmax_element(polygon.begin(), polygon.end(), [](const Vec2& a, const Vec2& b) { return a.y() < b.y(); });
  constexpr int levels = 15;
  const double height = highest->y() - lowest->y();
  std::vector<Stretch> stretches;
  if (!(height > 0)) return stretches;
  for (const double near : {1e-9 * height, 0.0}) {
    if (!stretches.empty()) break;
    for (int i = 0; i < levels; ++i) {
      // Steps by the golden ratio rarely meet the vertices of regular drawings.
      const double fraction = std::fmod(0.5 + i / std::numbers::phi, 1.0);
      addStretchesInside(polygon, lowest->y() + height * fraction, near, stretches);
    }
  }
  std::erase_if(stretches,
                [least = widthOfRounding(polygon, height)](const Stretch& stretch) { return stretch.width() <= least; });
  std::stable_sort(stretches.begin(), stretches.end(),
                   [](const Stretch& a, const Stretch& b) { return a.width() > b.width(); });
  return stretches;
}

}  // namespace

int crossingsToTheRight(const Segment& segment, const Vec2& point) {
  return std::visit([&](const auto& s) { return crossings(s, point); }, segment);
}

int windingNumber(const Path& path, const Vec2& point) {
  if (path.segments.empty()) return 0;
  int sum = 0;
  Vec2 last = endPoint(path);
  for (const Segment& segment : path.segments) {
    sum += crossing(last, startPoint(segment), point);  // bridges rounding between segments, else a level could slip through
    sum += crossingsToTheRight(segment, point);
    last = endPoint(segment);
  }
  return sum;
}

Vec2 interiorPoint(const Path& path) {
  if (!path.segments.empty()) {
    const double area = signedArea(path);
    double chord = std::max(std::sqrt(std::abs(area)) / 100, 1e-5 * length(path));
    for (int attempt = 0; attempt < 4 && chord > 0; ++attempt, chord /= 16) {
      const std::vector<Vec2> polygon = flatten(path, chord);
      if (polygon.size() < 2 || !(extent(polygon) > 0)) continue;
      std::optional<Vec2> other;
      for (const Stretch& stretch : stretchesInside(polygon)) {
        const int winding = windingNumber(path, stretch.middle());
        if (winding * area > 0) return stretch.middle();
        if (winding != 0 && !other) other = stretch.middle();
      }
      if (other) return *other;
    }
  }
  std::string place;
  if (!path.segments.empty()) {
    const Vec2 start = startPoint(path);
    place = fmt::format(" that begins at ({:.6g}, {:.6g})", start.x(), start.y());
  }
  throw Error(ErrorCode::Degenerate, fmt::format("A closed path{} encloses no area.", place),
              "Remove it, or look whether it crosses itself.");
}

}  // namespace blossom
