#include <algorithm>

#include "geometry/planar/sums/region_sum.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using Ring = std::vector<Vec2>;
using Rings = std::vector<Ring>;

Rings ringsOf(const Region& region) {
  Rings rings;
  for (const Path& loop : region.loops) {
    Ring& ring = rings.emplace_back();
    for (const Segment& segment : loop.segments) ring.push_back(startPoint(segment));
  }
  return rings;
}

double side(const Vec2& a, const Vec2& b, const Vec2& p) { return cross(b - a, p - a); }

/// By the even-odd rule.
bool inside(const Rings& rings, const Vec2& p) {
  bool odd = false;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = ring[i], &b = ring[(i + 1) % ring.size()];
      if ((a.y() > p.y()) != (b.y() > p.y()) && (side(a, b, p) > 0) == (b.y() > a.y())) odd = !odd;
    }
  return odd;
}

bool segmentsMeet(const Vec2& a, const Vec2& b, const Vec2& c, const Vec2& d) {
  return (side(a, b, c) > 0) != (side(a, b, d) > 0) && (side(c, d, a) > 0) != (side(c, d, b) > 0);
}

/// x - B.
Rings mirrored(const Rings& rings, const Vec2& x) {
  Rings result = rings;
  for (Ring& ring : result)
    for (Vec2& p : ring) p = x - p;
  return result;
}

bool anyVertexInside(const Rings& rings, const Rings& of) {
  return std::any_of(of.begin(), of.end(), [&](const Ring& ring) { return inside(rings, ring.front()); });
}

/// Whether two sets have a point in common: boundaries that cross, or a loop of one within the other.
bool meet(const Rings& a, const Rings& b) {
  for (const Ring& r : a)
    for (std::size_t i = 0; i < r.size(); ++i)
      for (const Ring& s : b)
        for (std::size_t j = 0; j < s.size(); ++j)
          if (segmentsMeet(r[i], r[(i + 1) % r.size()], s[j], s[(j + 1) % s.size()])) return true;
  return anyVertexInside(b, a) || anyVertexInside(a, b);
}

double distanceTo(const Rings& rings, const Vec2& p) {
  double best = 1e300;
  for (const Ring& ring : rings)
    for (std::size_t i = 0; i < ring.size(); ++i) {
      const Vec2 &a = ring[i], along = ring[(i + 1) % ring.size()] - a;
      const double t = std::clamp((p - a).dot(along) / along.squaredNorm(), 0.0, 1.0);
      best = std::min(best, (p - a - t * along).norm());
    }
  return best;
}

/// Points around the sum, most of them within 1e-6 of its boundary and beside a random pair of boundary points of A and B:
/// the latter do not depend on what the sum says.
Vec2 probe(std::mt19937_64& random, const Rings& sum, const Rings& a, const Rings& b, int kind) {
  std::uniform_real_distribution<double> unit(0, 1);
  const auto onEdge = [&](const Rings& rings) -> std::pair<Vec2, Vec2> {
    const Ring& ring = rings[static_cast<std::size_t>(unit(random) * 0.999999 * static_cast<double>(rings.size()))];
    const auto i = static_cast<std::size_t>(unit(random) * 0.999999 * static_cast<double>(ring.size()));
    const Vec2 along = ring[(i + 1) % ring.size()] - ring[i];
    return {ring[i] + unit(random) * along, Vec2(along.y(), -along.x()).normalized()};
  };
  const double off = (unit(random) - 0.5) * 2e-6;
  if (kind % 10 == 0) return onEdge(a).first + onEdge(b).first;
  if (kind % 10 == 1) {
    const auto [p, normal] = onEdge(a);
    const Ring& ring = b[static_cast<std::size_t>(kind) % b.size()];
    return p + ring[static_cast<std::size_t>(kind / 7) % ring.size()] + off * normal;
  }
  const auto [p, normal] = onEdge(sum);
  return p + off * normal;
}

/// A line that the acceptance script reads.
void figure(const char* name, double value) { qInfo("figure %s %.10g", name, value); }

int holesOf(const Region& region) {
  return static_cast<int>(
      std::count_if(region.loops.begin(), region.loops.end(), [](const Path& loop) { return signedArea(loop) < 0; }));
}

}  // namespace

/// x is in A + B exactly when A meets x - B: decided here with segments and points alone.
class MinkowskiMembershipTest : public QObject {
  Q_OBJECT

 private slots:
  void sumsOfRegionsWithHolesAndParts() {
    std::mt19937_64 random = seededRandom();
    int near = 0, wrong = 0, holes = 0, holed = 0, several = 0;
    constexpr int pairs = 500, points = 1000;
    for (int pair = 0; pair < pairs; ++pair) {
      std::uniform_real_distribution<double> size(0.1, 1);
      const Region a = randomRegion(random, 10), b = randomRegion(random, 10 * size(random) * size(random));
      const Region sum = planar::minkowskiSum(std::vector{a, b}).region;
      const Rings ringsA = ringsOf(a), ringsB = ringsOf(b), ringsSum = ringsOf(sum);
      holes += holesOf(sum);
      holed += holesOf(a) + holesOf(b) > 0 ? 1 : 0;
      several += components(a).size() > 1 || components(b).size() > 1 ? 1 : 0;
      for (int asked = 0, k = 0; asked < points; ++k) {
        QVERIFY2(k < 2 * points, "hardly a point is farther from the boundary than rounding");
        const Vec2 x = probe(random, ringsSum, ringsA, ringsB, k);
        const double distance = distanceTo(ringsSum, x);
        if (distance < 1e-9) continue;  // rounding of the sum
        ++asked;
        near += distance <= 1e-6 ? 1 : 0;
        wrong += inside(ringsSum, x) == meet(ringsA, mirrored(ringsB, x)) ? 0 : 1;
      }
    }
    figure("membership_pairs", pairs);
    figure("membership_points_a_pair", points);
    figure("membership_pairs_with_holes", holed);
    figure("membership_pairs_with_several_parts", several);
    figure("membership_holes_in_sums", holes);
    figure("membership_near_percent", 100.0 * near / (pairs * points));
    figure("membership_wrong", wrong);
    QCOMPARE(wrong, 0);
    QVERIFY(near > pairs * points / 2);
    QVERIFY(holes > 0 && holed > pairs / 4 && several > pairs / 4);
  }

  void differencesOfRegionsWithHolesAndParts() {
    std::mt19937_64 random = seededRandom();
    int wrong = 0, asked = 0;
    for (int pair = 0; pair < 40; ++pair) {
      const Region a = randomRegion(random, 10), b = randomRegion(random, 0.4);
      const Region room = planar::minkowskiDifference(std::vector{a, b}).region;
      if (room.loops.empty()) continue;
      const Rings ringsA = ringsOf(a), ringsB = ringsOf(b), ringsRoom = ringsOf(room);
      for (int k = 2; k < 150; ++k) {
        Vec2 x = probe(random, ringsRoom, ringsA, ringsB, k);
        if (k % 10 == 1) x -= 2 * ringsB[0][0];
        if (distanceTo(ringsRoom, x) < 1e-9) continue;
        Rings placed = mirrored(ringsB, -x);  // -x - b, turned about
        for (Ring& ring : placed)
          for (Vec2& p : ring) p = -p;
        bool within = true;  // x + B in A: no boundary crossed, all loops of B inside, no hole of A inside of B
        for (const Ring& r : ringsA)
          for (std::size_t i = 0; i < r.size() && within; ++i)
            for (const Ring& s : placed)
              for (std::size_t j = 0; j < s.size() && within; ++j)
                within = !segmentsMeet(r[i], r[(i + 1) % r.size()], s[j], s[(j + 1) % s.size()]);
        for (const Ring& s : placed) within = within && inside(ringsA, s.front());
        for (const Ring& r : ringsA) within = within && !inside(placed, r.front());
        ++asked;
        wrong += inside(ringsRoom, x) == within ? 0 : 1;
      }
    }
    figure("difference_points", asked);
    figure("difference_wrong", wrong);
    QCOMPARE(wrong, 0);
    QVERIFY(asked > 1000);
  }
};

BLOSSOM_TEST(MinkowskiMembershipTest)
#include "minkowski_membership_test.moc"
