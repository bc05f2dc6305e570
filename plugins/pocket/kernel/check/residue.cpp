#include "kernel/check/residue.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "geometry/planar/planar.h"
#include "kernel/offset/clearance_diagram.h"
#include "kernel/path/slots.h"
#include "kernel/stroke/inside_test.h"
#include "kernel/stroke/stroke_tree.h"

namespace blossom::pocket {

namespace {

constexpr std::size_t maximumPlaces = 64;

/// How far from where it begins a round corner has risen to a height.
double widthOfCorner(double corner, double height) {
  const double rest = std::max(0.0, corner - height);
  return std::sqrt(std::max(0.0, corner * corner - rest * rest));
}

/// Adds a point that is at least a distance from all others.
void addApart(std::vector<Vec2>& places, const Vec2& p, double distance) {
  const auto near = [&](const Vec2& q) { return (p - q).norm() < distance; };
  if (std::none_of(places.begin(), places.end(), near)) places.push_back(p);
}

/// At most maximumPlaces of the points, spread over all of them: the distance between them is doubled until they are few.
std::vector<Vec2> fewApart(const std::vector<Vec2>& all, double distance) {
  std::vector<Vec2> few;
  for (const Vec2& p : all) {
    addApart(few, p, distance);
    while (few.size() > maximumPlaces) {
      distance *= 2;
      std::vector<Vec2> fewer;
      for (const Vec2& q : few) addApart(fewer, q, distance);
      few = std::move(fewer);
    }
  }
  return few;
}

struct Square {
  Vec2 middle;
  double half;
};

/// Which squares are left over, by distances to where the tool's centre may be and to where it was.
class ResidueSearch {
 public:
  ResidueSearch(const Region& centers, const ResidueProblem& problem, double tolerance)
      : radius_(problem.radius),
        clears_(problem.radius - problem.corner + widthOfCorner(problem.corner, problem.tolerance)),
        corner_(problem.corner),
        tolerance_(tolerance),
        cut_(problem.cut) {
    std::vector<Stroke> rim;
    for (const Path& loop : centers.loops) {
      const auto some = strokesOf(loop, tolerance / 10);
      rim.insert(rim.end(), some.begin(), some.end());
    }
    within_ = InsideTest(rim);
    rim_ = StrokeTree(std::move(rim));
  }

  [[nodiscard]] Residue search(const Square& square, const Progress& progress) const {
    Residue found;
    std::size_t looked = 0;
    std::vector<Square> open{square};
    while (!open.empty()) {
      const Square s = open.back();
      open.pop_back();
      if (++looked % 4096 == 0) progress.check();
      const double reach = s.half * std::sqrt(2.0);
      const double enough = clears_ + tolerance_ + 2 * reach;  // beyond it, all of the square is out of reach
      const double swept = cut_.nearest(s.middle, enough).distance;
      if (swept + reach <= clears_ + tolerance_) continue;
      const double centre = within_(s.middle) ? 0 : rim_.nearest(s.middle, enough).distance;
      if (centre - reach > clears_ - tolerance_) continue;
      const bool all = centre + reach <= clears_ - tolerance_ && swept - reach > clears_ + tolerance_;
      const bool smallest = reach <= tolerance_;
      if (all || smallest) {
        if (!all && (centre > clears_ - tolerance_ || swept <= clears_ + tolerance_)) continue;
        found.area += 4 * s.half * s.half;
        mark(found, s.middle);
        continue;
      }
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) open.push_back({s.middle + s.half * Vec2(x, y), s.half / 2});
    }
    return found;
  }

  /// mm that round corners leave between the ways of the tool, at most, where its tip may be.
  [[nodiscard]] double ridge(const Square& whole, const Progress& progress) const {
    if (!(corner_ > 0) || cut_.empty()) return 0;
    const double flat = radius_ - corner_;
    const double fineness = std::max(tolerance_, radius_ / 500);
    double farthest = 0;
    std::size_t looked = 0;
    std::vector<Square> open{whole};
    while (!open.empty() && farthest < radius_) {
      const Square s = open.back();
      open.pop_back();
      if (++looked % 4096 == 0) progress.check();
      const double reach = s.half * std::sqrt(2.0);
      const double away = cut_.nearest(s.middle).distance;
      if (away + reach <= std::max(flat, farthest + fineness)) continue;
      const bool in = within_(s.middle);
      if (!in && rim_.nearest(s.middle).distance > reach) continue;
      if (in) farthest = std::max(farthest, away);
      if (reach <= fineness) continue;
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) open.push_back({s.middle + s.half * Vec2(x, y), s.half / 2});
    }
    const double beside = std::clamp(farthest - flat, 0.0, corner_);
    return corner_ - std::sqrt(corner_ * corner_ - beside * beside);
  }

  /// mm2 that the tool opens of a square. Squares on the rim count by how far their middle lies within: what is off in one
  /// is mostly made good by its neighbours.
  [[nodiscard]] double opened(const Square& square) const {
    const double smallest = radius_ / 64;
    double sum = 0;
    std::vector<Square> open{square};
    while (!open.empty()) {
      const Square s = open.back();
      open.pop_back();
      const double reach = s.half * std::sqrt(2.0);
      const double centre = within_(s.middle) ? 0 : rim_.nearest(s.middle, radius_ + reach).distance;
      if (centre >= radius_ + reach) continue;
      const bool all = centre + reach <= radius_;
      if (all || s.half <= smallest) {
        sum += 4 * s.half * s.half * (all ? 1 : std::clamp(0.5 + (radius_ - centre) / (2 * s.half), 0.0, 1.0));
        continue;
      }
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) open.push_back({s.middle + s.half * Vec2(x, y), s.half / 2});
    }
    return sum;
  }

  void mark(Residue& found, const Vec2& p) const {
    if (found.places.size() < maximumPlaces) addApart(found.places, p, radius_);
  }

 private:
  double radius_;  ///< opens
  double clears_;  ///< .. as wide as it is the tolerance above its tip
  double corner_, tolerance_;
  StrokeTree cut_, rim_;
  InsideTest within_;
};

double perimeter(const Region& region) {
  double sum = 0;
  for (const Path& loop : region.loops) sum += length(loop);
  return sum;
}

}  // namespace

Residue residueOf(const Region& part, const ResidueProblem& problem, const Progress& progress) {
  progress.report(0, "Looking for what is left");
  const double tolerance = problem.tolerance;
  const ClearanceDiagram diagram(part, {.tolerance = tolerance / 4}, progress.part(0, 0.2));
  Residue total;
  total.resolution = tolerance;
  const double largest = diagram.largestClearance();
  const double slack = tolerance / 4;
  double away = problem.radius + problem.leave;
  if (away > largest + slack) return total;
  constexpr double rounding = 1e-9;
  // It just fits: its centre may be on a line, or at a point.
  if (away >= largest * (1 - rounding)) away = std::max(largest - slack, largest / 2);
  // Slots just as wide as the tool beside wider places: its centre has no area there, yet it goes through them.
  else
    away = std::max(away - slotSlack(diagram), away / 2);
  const Region centers = diagram.offset(away, Side::Inside, progress);
  if (centers.loops.empty()) return total;
  // Squares of the last size lie along the rim.
  constexpr double squaresAlong = 12;  // tested per length of the tolerance along the border
  double length = perimeter(centers);
  if (problem.corner > 0)
    for (const Stroke& s : problem.cut) length += 2 * s.length();  // ridges have two sides
  total.resolution = std::max(tolerance, squaresAlong * length / static_cast<double>(problem.cells));
  const ResidueSearch search(centers, problem, total.resolution);

  Vec2 low(1e300, 1e300), high(-1e300, -1e300);
  for (const Path& loop : centers.loops)
    for (const Stroke& s : strokesOf(loop, tolerance)) {
      const auto [a, b] = s.box();
      low = low.cwiseMin(a);
      high = high.cwiseMax(b);
    }
  low.array() -= problem.radius;
  high.array() += problem.radius;
  const double side = std::max((high - low).maxCoeff() / 64, problem.radius / 2);
  const auto columns = static_cast<std::size_t>(std::ceil((high.x() - low.x()) / side));
  const auto rows = static_cast<std::size_t>(std::ceil((high.y() - low.y()) / side));
  std::vector<Residue> parts(columns * rows);
  parallelFor(parts.size(), 1, progress.part(0.2, 1), [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      const std::size_t row = i / columns, column = i % columns;
      const Vec2 cell(static_cast<double>(column) + 0.5, static_cast<double>(row) + 0.5);
      const Square square{low + side * cell, side / 2};
      parts[i] = search.search(square, progress);
      parts[i].reachable = search.opened(square);
    }
  });
  total.ridge = search.ridge({(low + high) / 2, (high - low).maxCoeff() / 2}, progress);
  std::vector<Vec2> places;
  for (const Residue& each : parts) {
    total.area += each.area;
    total.reachable += each.reachable;
    places.insert(places.end(), each.places.begin(), each.places.end());
  }
  total.places = fewApart(places, problem.radius);
  return total;
}

}  // namespace blossom::pocket
