#include <map>

#include "geometry/bspline/bspline.h"
#include "geometry/planar/polygons/bounding_polyline.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/winding/nesting.h"
#include "geometry/planar/winding/snap_rounding.h"
#include "geometry/planar/winding/winding_faces.h"
#include "support/random.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::planar;
using std::numbers::pi;

namespace {

/// Without edges between equal corners.
std::vector<CountedEdge> withoutPoints(std::vector<CountedEdge> edges) {
  std::erase_if(edges, [](const CountedEdge& edge) { return edge.from == edge.to; });
  return edges;
}

bool isBetween(const GridPoint& p, const CountedEdge& edge) {
  return cross(edge.to - edge.from, p - edge.from) == 0 && dot(p - edge.from, p - edge.to) < 0;
}

bool meetInEndsOnly(const CountedEdge& e, const CountedEdge& f) {
  for (const GridPoint& p : {f.from, f.to})
    if (isBetween(p, e)) return false;
  for (const GridPoint& p : {e.from, e.to})
    if (isBetween(p, f)) return false;
  const auto side = [](const CountedEdge& edge, const GridPoint& p) {
    const Wide turn = cross(edge.to - edge.from, p - edge.from);
    return turn > 0 ? 1 : turn < 0 ? -1 : 0;
  };
  return (e.from == f.from && e.to == f.to) || side(e, f.from) * side(e, f.to) >= 0 || side(f, e.from) * side(f, e.to) >= 0;
}

}  // namespace

/// What is done to outlines before and after a sum: drawn in chords, rounded, nested, cleared of crumbs.
class MinkowskiLoopsTest : public QObject {
  Q_OBJECT

 private slots:
  /// Splines that bend both ways, with weights: every point of the curve is inside of the polyline beside it, or on it.
  void polylinesBesideCurvesKeepToTheirSide() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> unit(0, 1);
    for (int shape = 0; shape < 60; ++shape) {
      const int degree = 2 + shape % 3, pieces = 3 + shape % 4, poles = degree * pieces;
      std::vector<Vec2> corners = spikyPoints(random, {0, 0}, 10, poles);
      corners.push_back(corners.front());
      Path path;
      path.closed = true;
      for (int piece = 0; piece < pieces; ++piece) {
        Spline2 spline{degree, {}, {}};
        for (int k = 0; k <= degree; ++k) {
          const double weight = k == 0 || k == degree ? 1 : 0.3 + 2 * unit(random);
          const Vec2& pole = corners[static_cast<std::size_t>(degree * piece + k)];
          spline.poles.emplace_back(weight * pole.x(), weight * pole.y(), weight);
        }
        spline.knots.assign(static_cast<std::size_t>(degree) + 1, 0.0);
        spline.knots.insert(spline.knots.end(), static_cast<std::size_t>(degree) + 1, 1.0);
        path.segments.emplace_back(spline);
      }
      for (const double tolerance : {1.0, 1e-2, 1e-4}) {
        const Path outside = polygonPath(polylineToTheRight(path, tolerance)),
                   inside = polygonPath(polylineToTheLeft(path, tolerance));
        for (const Segment& segment : path.segments) {
          const Curve curve = toCurve(std::get<Spline2>(segment));
          for (int k = 0; k < 60; ++k) {
            const Vec2 p = point(curve, unit(random)).head<2>();
            const auto holds = [&](const Path& loop, bool within) {
              double nearest = 1e300;
              for (const Segment& each : loop.segments) {
                const Line2& line = std::get<Line2>(each);
                const Vec2 along = line.to - line.from;
                const double t = along.isZero() ? 0 : std::clamp((p - line.from).dot(along) / along.squaredNorm(), 0.0, 1.0);
                nearest = std::min(nearest, (p - line.from - t * along).norm());
              }
              return nearest < 1e-11 || (nearest <= tolerance && (windingNumber(loop, p) > 0) == within);
            };
            QVERIFY(holds(outside, true));
            QVERIFY(holds(inside, false));
          }
        }
      }
    }
  }

  /// A spike that rounding turned inside out for half of its length: there the loop counts -1, and no sum must see that.
  void tangledLoopsAreUntangled() {
    constexpr std::int64_t k = 1 << 20;
    const std::vector<GridPolygon> tangled{{{{0, 0},
                                             {k, 0},
                                             {k, k},
                                             {k / 2 + 4, k},
                                             {k / 2 - 2, 5 * k / 4},
                                             {k / 2 - 2, 7 * k / 4},
                                             {k / 2 + 1, 2 * k},
                                             {k / 2 - 1, 2 * k},
                                             {k / 2 + 2, 7 * k / 4},
                                             {k / 2 + 2, 5 * k / 4},
                                             {k / 2 - 4, k},
                                             {0, k}},
                                            {}}};
    const std::vector<GridPolygon> small{{{{0, 0}, {k / 4, 0}, {k / 4, k / 4}, {0, k / 4}}, {}}};
    const auto areaWith = [&](const std::vector<GridPolygon>& loops) {
      return planar::area(windingFaces(convolution(loops, small))) / (double(k) * double(k));
    };
    QVERIFY(!isClear(tangled));
    const std::vector<GridPolygon> plain = untangled(tangled);
    QVERIFY(!misplacedFace(edgesOf(plain), 0));
    const double spike = 1.25 * 1.25 + 0.25;  // the square, and the spike without width, both as wide as the small one
    COMPARE_NEAR(areaWith(plain), spike, 1e-4);
  }

  /// Of loops whose corners are few units apart, so that edges pass several of them: afterwards edges meet in common ends
  /// only and still are closed loops.
  void roundingOfCrowdedCornersComesToAnEnd() {
    auto random = seededRandom();
    for (int round = 0; round < 3000; ++round) {
      const int width = uniformInt(random, 1, 6),
                stretch = round % 3 == 0 ? uniformInt(random, 2, 1000000) : 1;  // flat edges
      const GridPoint far{uniformInt(random, -1, 1) * (std::int64_t{1} << 43),
                          uniformInt(random, -1, 1) * std::int64_t{12345}};
      std::vector<GridPolygon> loops(static_cast<std::size_t>(uniformInt(random, 1, 4)));
      for (GridPolygon& loop : loops)
        for (int corner = uniformInt(random, 3, 9); corner > 0; --corner)
          loop.outer.push_back(far + GridPoint{stretch * uniformInt(random, 0, width), uniformInt(random, 0, width)});
      const std::vector<CountedEdge> edges = snapRounded(withoutPoints(edgesOf(loops)));
      std::map<GridPoint, int> balance;
      for (const CountedEdge& edge : edges) balance[edge.from] += edge.count, balance[edge.to] -= edge.count;
      for (const auto& [corner, count] : balance) QCOMPARE(count, 0);
      for (std::size_t i = 0; i < edges.size(); ++i)
        for (std::size_t j = 0; j < i; ++j) QVERIFY(meetInEndsOnly(edges[i], edges[j]));
    }
  }

  /// Loops that share corners bound what they should only if they do not cross there.
  void loopsThatTouchInCorners() {
    constexpr std::int64_t k = 1 << 20;
    constexpr double units = 64;
    const auto touches = [](const std::vector<GridPolygon>& loops) {
      return touchesInCorners(loops, Progress::none(), units);
    };
    const GridLoop square{{0, 0}, {2 * k, 0}, {2 * k, 2 * k}, {0, 2 * k}};
    const GridLoop beside{{2 * k, 2 * k}, {3 * k, 2 * k}, {3 * k, 3 * k}};
    QVERIFY(touches({{square, {}}, {beside, {}}}));
    QVERIFY(!isClear({{square, {}}, {beside, {}}}));
    const GridLoop inside{{0, 0}, {k, k / 2}, {k / 2, k}};
    QVERIFY(touches({{square, {{inside.rbegin(), inside.rend()}}}}));
    QVERIFY(!touches({{square, {}}, {inside, {}}}));
    const GridLoop first{{0, 0}, {2 * k, 0}, {2 * k, k}, {2 * k, 2 * k}, {k, 2 * k}, {0, 2 * k}},
        crossingIt{{k, k}, {2 * k, k}, {3 * k, k}, {3 * k, 3 * k}, {k, 3 * k}, {k, 2 * k}};
    QVERIFY(!touches({{first, {}}, {crossingIt, {}}}));
    for (const std::int64_t gap : {1, 30, 63}) {  // beside a corner, or a corner beside an edge
      QVERIFY(!touches({{square, {}}, {{{2 * k + gap, 2 * k}, {3 * k, 2 * k}, {3 * k, 3 * k}}, {}}}));
      QVERIFY(!touches({{square, {}}, {{{2 * k + gap, k}, {3 * k, k / 2}, {3 * k, k}}, {}}}));
    }
    QVERIFY(!touches({{square, {}}, {{{2 * k, k}, {3 * k, k / 2}, {3 * k, k}}, {}}}));  // a corner on an edge
    QVERIFY(touches({{square, {}}, {{{2 * k + 65, k}, {3 * k, k / 2}, {3 * k, k}}, {}}}));
    // Petals of a hole, one after the other, each clockwise: where they follow each other counter-clockwise they cross.
    const GridLoop around{{-8 * k, -8 * k}, {8 * k, -8 * k}, {8 * k, 8 * k}, {-8 * k, 8 * k}};
    const std::vector<GridLoop> petals{{{0, 0}, {6 * k, -2 * k}, {5 * k, -4 * k}},
                                       {{0, 0}, {k, 2 * k}, {2 * k, 2 * k}},
                                       {{0, 0}, {-5 * k, k}, {-4 * k, 3 * k}}};
    GridLoop crossingPetals;
    for (const GridLoop& petal : petals) crossingPetals.insert(crossingPetals.end(), petal.begin(), petal.end());
    QVERIFY(!touches({{around, {crossingPetals}}}));
    const GridLoop pinched{{0, 0}, {k, k}, {2 * k, 0}, {2 * k, 2 * k}, {k, k}, {0, 2 * k}};
    QVERIFY(!touches({{{pinched.rbegin(), pinched.rend()}, {}}}));  // clockwise
    QVERIFY(touches({{pinched, {}}}));
  }

  /// One loop around a hole and, beyond the corner where it crosses the outline, around a lobe: nothing of it is lost,
  /// whichever of the two lies farther to the left.
  void holesWithALobeBeyondTheOutlineAreKept() {
    for (int degrees = 0; degrees < 360; degrees += 10) {
      const auto at = [&](double radius, double angle) -> Vec2 {
        const double turned = (angle + degrees) * pi / 180;
        return radius * Vec2(std::cos(turned), std::sin(turned));
      };
      const Region drawn{{polygonPath({{0, 0}, at(20, 300), at(28, 345), at(28, 30), at(28, 75), at(20, 120)}),
                          polygonPath({{0, 0}, at(10, 60), at(10, 0), {0, 0}, at(6, 180), at(6, 240)})}};
      COMPARE_NEAR(blossom::area(soundRegion(drawn, {}, "a").region), blossom::area(drawn), 1e-9);
    }
  }

  /// Corners that each turn by less than a crumb, many thousands of them: the outline must not drift away.
  void droppedCornersStayWithinACrumb() {
    constexpr double crumb = 4;  // units of the grid
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> unit(0, 1);
    for (const int corners : {60, 4'000, 100'000})
      for (const double squeeze : {1.0, 1e-3, 1e-6}) {
        Loop loop;
        for (int k = 0; k < corners; ++k) {
          const double angle = 2 * pi * (k + 0.4 * unit(random)) / corners;
          loop.emplace_back(1e7 * std::cos(angle), squeeze * 1e7 * std::sin(angle));
        }
        const Polygons made = onPlane({{loop, {}}}, Grid());
        QCOMPARE(made.size(), std::size_t{1});
        const Loop& kept = made.front().outer;
        QVERIFY(kept.size() >= 3);
        // Corners come in order, so the edge that stands for a dropped one lies between the next kept ones.
        std::size_t next = 0;
        for (const Vec2& p : loop) {
          if (p == kept[next % kept.size()]) ++next;
          const Vec2 a = kept[(next + kept.size() - 1) % kept.size()], along = kept[next % kept.size()] - a;
          const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
          QVERIFY2((p - a - t * along).norm() <= crumb + 1e-6, qPrintable(QString::number((p - a - t * along).norm())));
        }
        QVERIFY(next >= kept.size());
      }
  }

  /// A sieve with an island in each of 10,000 holes, two of which touch their holes in corners.
  void loopsByTheThousandLieInOneAnotherAsTheyDo() {
    for (const bool touching : {false, true}) {
      Region sieve{{rectanglePath({0, 0}, {1000, 1000})}};
      for (int x = 0; x < 100; ++x)
        for (int y = 0; y < 100; ++y) {
          const Vec2 at(10 * x, 10 * y);
          sieve.loops.push_back(reversed(rectanglePath(at + Vec2(2, 2), at + Vec2(8, 8))));
          const double reach = touching && x == y && x < 2 ? 3 : 2;
          sieve.loops.push_back(polygonPath(
              {at + Vec2(5 + reach, 5), at + Vec2(5, 5 + reach), at + Vec2(5 - reach, 5), at + Vec2(5, 5 - reach)}));
        }
      const Polygons parts = flattened(sieve, {}, "sieve");
      QCOMPARE(parts.size(), std::size_t{10'001});
      std::size_t holes = 0;
      for (const Polygon& part : parts) {
        QVERIFY(planar::signedArea(part.outer) > 0);
        for (const Loop& hole : part.holes) QVERIFY(planar::signedArea(hole) < 0);
        holes += part.holes.size();
      }
      QCOMPARE(holes, std::size_t{10'000});
      COMPARE_NEAR(planar::area(parts), 1e6 - 10'000 * (36 - 8) + (touching ? 2 * 10 : 0), 1e-3);
    }
  }

  /// Rings in rings in all places, on few levels of x, so that many begin and end at once.
  void nestingIsThatOfEachPoint() {
    std::mt19937_64 random = seededRandom();
    std::uniform_int_distribution<std::int64_t> split(1, 3);
    std::vector<GridLoop> loops;
    std::vector<std::optional<std::size_t>> wanted;
    // Each box holds up to nine smaller ones, apart from one another.
    const auto fill = [&](const auto& self, GridPoint low, std::int64_t size, std::optional<std::size_t> around) -> void {
      const std::size_t me = loops.size();
      GridLoop loop{low, {low.x + size, low.y}, {low.x + size, low.y + size}, {low.x, low.y + size}};
      if (size % 5 == 0) loop = {{low.x, low.y + size / 2}, {low.x + size / 2, low.y}, {low.x + size, low.y + size}};
      if (loops.size() % 2 == 1) std::reverse(loop.begin(), loop.end());
      loops.push_back(loop);
      wanted.push_back(around);
      if (size < 400 || size % 5 == 0) return;
      const std::int64_t count = split(random), step = size / count;
      for (std::int64_t x = 0; x < count; ++x)
        for (std::int64_t y = 0; y < count; ++y)
          if (split(random) > 1) self(self, {low.x + x * step + 20, low.y + y * step + 20}, step - 40 - split(random), me);
    };
    for (int k = 0; k < 5; ++k) fill(fill, {k * 100'100, 0}, 100'000 + k, {});
    QVERIFY(loops.size() > 100);
    const auto around = loopsAround(loops);
    for (std::size_t i = 0; i < loops.size(); ++i) QVERIFY(around[i] == wanted[i]);
  }
};

BLOSSOM_TEST(MinkowskiLoopsTest)
#include "minkowski_loops_test.moc"
