#include "kernel/residue.h"

#include <algorithm>
#include <cmath>

#include "core/parallel.h"
#include "geometry/planar.h"
#include "kernel/clearance_diagram.h"
#include "kernel/stroke_tree.h"

namespace blossom::pocket {

namespace {

constexpr std::size_t mostPlaces = 64;

struct Square {
  Vec2 middle;
  double half;
};

/// Which squares are left over, by distances to where the tool's centre may be and to where it was.
class ResidueSearch {
 public:
  ResidueSearch(const Region& centers, const ResidueProblem& problem, double tolerance)
      : radius_(problem.radius), tolerance_(tolerance), cut_(problem.cut) {
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
      const double enough = radius_ + tolerance_ + 2 * reach;  // beyond it, all of the square is out of reach
      const double swept = cut_.nearest(s.middle, enough).distance;
      if (swept + reach <= radius_ + tolerance_) continue;
      const double centre = within_(s.middle) ? 0 : rim_.nearest(s.middle, enough).distance;
      if (centre - reach > radius_ - tolerance_) continue;
      const bool all = centre + reach <= radius_ - tolerance_ && swept - reach > radius_ + tolerance_;
      const bool smallest = reach <= tolerance_;
      if (all || smallest) {
        if (!all && (centre > radius_ - tolerance_ || swept <= radius_ + tolerance_)) continue;
        found.area += 4 * s.half * s.half;
        mark(found, s.middle);
        continue;
      }
      for (const double x : {-0.5, 0.5})
        for (const double y : {-0.5, 0.5}) open.push_back({s.middle + s.half * Vec2(x, y), s.half / 2});
    }
    return found;
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
    const auto near = [&](const Vec2& q) { return (p - q).norm() < radius_; };
    if (found.places.size() < mostPlaces && std::none_of(found.places.begin(), found.places.end(), near))
      found.places.push_back(p);
  }

 private:
  double radius_, tolerance_;
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
  if (diagram.largestClearance() <= problem.radius + problem.leave) return total;
  const Region centers = diagram.offset(problem.radius + problem.leave, Side::Inside, progress);
  if (centers.loops.empty()) return total;
  // Squares of the last size lie along the rim.
  constexpr double squaresAlong = 12;  // looked at for each length of the tolerance along the rim
  const double length = perimeter(centers);
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
  for (const Residue& each : parts) {
    total.area += each.area;
    total.reachable += each.reachable;
    for (const Vec2& p : each.places) search.mark(total, p);
  }
  return total;
}

}  // namespace blossom::pocket
