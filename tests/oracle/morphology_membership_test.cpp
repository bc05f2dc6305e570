#include "support/membership.h"
#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

Mesh randomSolid(std::mt19937_64& random, int kind) {
  switch (kind % 4) {
    case 0:
      return spikyCube(random, 2);
    case 1:
      return spikyRing(random, 3, 1.2, 4);
    case 2:
      return triangulated(turnedBy(lBlock(), randomTurn(random))).first;
    default:
      return together(spikyCube(random, 1), movedBy(spikyCube(random, 1), {2.5, 0.5, 0}));
  }
}

Mesh randomTetrahedron(std::mt19937_64& random) {
  std::uniform_real_distribution<double> any(-0.1, 0.1);
  Mesh mesh = turnedBy(cornerTetrahedron(), randomTurn(random));
  for (Vec3& p : mesh.points) p += Vec3(any(random), any(random), any(random));
  return mesh;
}

/// Half of the points lie anywhere, half within 1e-6 of a face.
Vec3 placeToAsk(std::mt19937_64& random, const Mesh& sum, int k) {
  if (k % 2 == 0) return randomPoint(random, boundsOf(sum));
  std::uniform_real_distribution<double> share(0, 1);
  std::uniform_int_distribution<std::size_t> face(0, sum.faceCount() - 1);
  const auto corners = facePoints(sum, face(random));
  double s = share(random), t = share(random);
  if (s + t > 1) s = 1 - s, t = 1 - t;
  const Vec3 on = corners[0] + s * (corners[1] - corners[0]) + t * (corners[2] - corners[0]);
  return on + (share(random) < 0.5 ? -1e-6 : 1e-6) * (0.01 + share(random)) * vectorArea(corners).normalized();
}

}  // namespace

/// x lies in A + B exactly when A meets x - B, and in A - B exactly when x + B leaves A nowhere.
class MorphologyMembershipTest : public QObject {
  Q_OBJECT

 private slots:
  void sums() {
    std::mt19937_64 random = seededRandom();
    int asked = 0, wrong = 0;
    for (int pair = 0; pair < 5; ++pair) {
      const Mesh a = randomSolid(random, pair);
      const Mesh b = pair < 4 ? randomTetrahedron(random) : scaledBy(spikyCube(random, 2), 0.6);
      const Mesh sum = triangulated(solidSumOf(a, b)).first, mirrored = reflected(b);
      for (int k = 0; k < 1000; ++k, ++asked) {
        const Vec3 x = placeToAsk(random, sum, k);
        wrong += contains(sum, x) != meet(a, movedBy(mirrored, x)) ? 1 : 0;
      }
    }
    QCOMPARE(wrong, 0);
    qInfo("figure membership_points %d", asked);
    qInfo("figure membership_wrong %d", wrong);
  }

  void differences() {
    std::mt19937_64 random = seededRandom();
    int wrong = 0, asked = 0;
    for (int pair = 0; pair < 3; ++pair) {
      const Mesh solids[] = {scaledBy(spikyCube(random, 2), 2), lBlock(), frameBlock(3, 1, 0, 2)};
      const Mesh a = triangulated(solids[pair]).first;
      const Mesh b = scaledBy(randomTetrahedron(random), 0.3);
      const Mesh left = triangulated(solidDifferenceOf(a, b)).first;
      for (int k = 0; k < 400; ++k, ++asked) {
        const Vec3 x = placeToAsk(random, left, k);
        const Mesh there = movedBy(b, x);
        bool leaves = !contains(a, there.points.front());
        for (std::size_t f = 0; f < a.faceCount() && !leaves; ++f)
          for (std::size_t g = 0; g < there.faceCount() && !leaves; ++g)
            leaves = trianglesCross(facePoints(a, f), facePoints(there, g));
        wrong += contains(left, x) == leaves ? 1 : 0;
      }
    }
    QCOMPARE(wrong, 0);
    qInfo("figure difference_membership_points %d", asked);
  }
};

BLOSSOM_TEST(MorphologyMembershipTest)
#include "morphology_membership_test.moc"
