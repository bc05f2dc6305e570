#include <fmt/format.h>

#include <cmath>

#include "geometry/planar/winding/snap_rounding.h"
#include "support/boundary_distance.h"
#include "support/planar_peer.h"
#include "support/random.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using planar::CountedEdge, planar::GridLoop, planar::GridPoint, planar::GridPolygon, planar::Inside, planar::Polygons;

namespace {

/// Around the origin: corners by angle at random distances, rounded to multiples of a step.
GridLoop starOnGrid(Random& random, int corners, std::int64_t reach, std::int64_t step, double nearest) {
  for (;;) {
    GridLoop loop;
    for (int i = 0; i < corners; ++i) {
      const double angle = 2 * M_PI * (i + uniform(random, 0, 0.9)) / corners;
      const double r = static_cast<double>(reach) * uniform(random, nearest, 1);
      loop.push_back({static_cast<std::int64_t>(std::lround(r * std::cos(angle))) * step,
                      static_cast<std::int64_t>(std::lround(r * std::sin(angle))) * step});
    }
    loop = planar::cleaned(loop);
    double doubled = 0;
    for (std::size_t i = 0; i < loop.size(); ++i)
      doubled += static_cast<double>(cross(loop[i], loop[(i + 1) % loop.size()]));
    if (loop.size() >= 3 && doubled > 0) return loop;
  }
}

GridLoop moved(GridLoop loop, const GridPoint& by) {
  for (GridPoint& p : loop) p = p + by;
  return loop;
}

/// A frame of lines around a hole: what the other set enters when it is small.
GridPolygon frameOnGrid(Random& random, std::int64_t step) {
  const std::int64_t out = uniformInt(random, 8, 20) * step, in = uniformInt(random, 1, 7) * step;
  return {{{-out, -out}, {out, -out}, {out, out}, {-out, out}}, {{{-in, -in}, {-in, in}, {in, in}, {in, -in}}}};
}

/// Pairs of the kinds that go wrong: lattices where nearly everything touches, general ones, thin ones, several parts,
/// holes.
std::vector<GridPolygon> operand(Random& random, int kind, bool first) {
  const std::int64_t fine = std::int64_t(1) << 34, coarse = std::int64_t(1) << 40;
  const int corners = uniformInt(random, 3, 12);
  switch (kind % 6) {
    case 0:
      return {{starOnGrid(random, corners, uniformInt(random, 2, 6), coarse, 0.2), {}}};
    case 1:
      return {{starOnGrid(random, corners, fine, 32, 0.3), {}}};
    case 2:  // spikes
      return {{starOnGrid(random, 2 * corners, fine, 32, 0.02), {}}};
    case 3: {  // thin: a flat star
      GridLoop loop = starOnGrid(random, corners, fine, 32, 0.4);
      for (GridPoint& p : loop) p.y /= 1 << 20;
      loop = planar::cleaned(loop);
      return loop.size() < 3 ? operand(random, 1, first) : std::vector<GridPolygon>{{loop, {}}};
    }
    case 4: {  // parts of a lattice that touch or lie apart
      std::vector<GridPolygon> parts;
      for (int k = uniformInt(random, 2, 4); k > 0; --k)
        parts.push_back(
            {moved({{0, 0}, {coarse, 0}, {coarse, coarse}, {0, coarse}}, {2 * k * coarse, (k % 2) * coarse}), {}});
      return parts;
    }
    default:
      return {first ? frameOnGrid(random, coarse)
                    : GridPolygon{starOnGrid(random, corners, uniformInt(random, 1, 9), coarse, 0.5), {}}};
  }
}

std::size_t holesIn(const Polygons& polygons) {
  std::size_t holes = 0;
  for (const planar::Polygon& polygon : polygons) holes += polygon.holes.size();
  return holes;
}

struct Differences {
  double area = 0;      ///< over size times perimeter
  double distance = 0;  ///< of a corner of one from the boundary of the other, over the size
  int parts = 0, holes = 0;

  void add(const Polygons& ours, const ArrangedFaces& wanted) {
    double size = 0, length = 0;
    for (const auto& [a, b] : wanted.boundary) size = std::max({size, a.norm(), b.norm()}), length += (b - a).norm();
    if (size == 0) {
      parts += ours.empty() ? 0 : 1;
      return;
    }
    area = std::max(area, std::abs(planar::area(ours) - wanted.area) / (size * length));
    distance = std::max(distance, distanceBetween(sidesOf(ours), wanted.boundary) / size);
    parts += ours.size() == wanted.parts ? 0 : 1;
    holes += holesIn(ours) == wanted.holes ? 0 : 1;
  }
};

}  // namespace

/// The boundaries of sums and differences against the faces of CGAL's exact arrangement of the same convolutions.
class MinkowskiFacesTest : public QObject {
  Q_OBJECT

 private slots:
  /// BLOSSOM_PLANAR_SUMS says how many pairs; 2000 without it.
  void boundariesAreThoseOfTheArrangement() {
    Random random = seededRandom();
    const int asked = qEnvironmentVariableIntValue("BLOSSOM_PLANAR_SUMS"), pairs = asked > 0 ? asked : 2000;
    Differences all;
    for (int pair = 0; pair < pairs; ++pair) {
      const std::vector<GridPolygon> a = planar::untangled(operand(random, pair, true)),
                                     b = planar::untangled(operand(random, pair / 6, false));
      const std::vector<CountedEdge> edges = planar::convolution(a, b);
      const auto rule = std::array{Inside::Positive, Inside::NonZero, Inside::Hollow}[static_cast<std::size_t>(pair % 3)];
      const Differences before = all;
      all.add(windingFaces(edges, Progress::none(), rule), arrangedFaces(edges, rule));
      if (all.area > 1e-9 || all.distance > 1e-9 || all.parts + all.holes > before.parts + before.holes)
        qWarning("pair %d, rule %d: area %.3g, distance %.3g, parts %d, holes %d", pair, static_cast<int>(rule), all.area,
                 all.distance, all.parts, all.holes);
    }
    qInfo("figure sums %d", pairs);
    qInfo("figure area_difference %.3g", all.area);
    qInfo("figure boundary_distance %.3g", all.distance);
    qInfo("figure other_parts %d", all.parts);
    qInfo("figure other_holes %d", all.holes);
    QVERIFY(all.area <= 1e-9);
    QVERIFY(all.distance <= 1e-9);
    QCOMPARE(all.parts, 0);
    QCOMPARE(all.holes, 0);
  }
};

BLOSSOM_TEST(MinkowskiFacesTest)
#include "minkowski_faces_test.moc"
