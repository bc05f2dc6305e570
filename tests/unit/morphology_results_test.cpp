/// Results are solids like any others: closed and without crossings. How many of them are refused as operands, because
/// rounding them to the grid makes faces cross, is a figure.
#include "geometry/mesh/mesh_crossing.h"
#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

/// Rough, smooth, with holes, of several bodies, along the axes and turned out of them.
Mesh anySolid(std::mt19937_64& random, double size) {
  switch (std::uniform_int_distribution<int>(0, 7)(random)) {
    case 0:
      return spikyRing(random, size, 0.4 * size, 6);
    case 1:
      return scaledBy(turnedBy(lBlock(), randomTurn(random)), 0.3 * size);
    case 2:
      return together(spikyCube(random, size), movedBy(spikyCube(random, size), {1.2 * size, 0.3 * size, 0}));
    case 3:
      return scaledBy(frameBlock(2, 1, 0, 1), 0.5 * size);
    case 4:
      return scaledBy(turnedBy(frameBlock(2, 1, 0, 1), randomTurn(random)), 0.5 * size);
    case 5:
      return ballOf(size, 1);
    case 6:
      return scaledBy(lBlock(), 0.3 * size);
    default:
      return spikyCube(random, size);
  }
}

Mesh anyResult(std::mt19937_64& random, const Mesh& a, const Mesh& b) {
  switch (std::uniform_int_distribution<int>(0, 4)(random)) {
    case 0:
      return solidDifferenceOf(a, scaledBy(b, 0.2));
    case 1:
      return openingOf(a, scaledBy(b, 0.2));
    case 2:
      return closingOf(a, scaledBy(b, 0.5));
    case 3:
      return morphOf(a, b, {std::uniform_real_distribution<double>(0, 1)(random)}).solids.front();
    default:
      return solidSumOf(a, b);
  }
}

int resultsAsked() {
  const QByteArray given = qgetenv("BLOSSOM_SOLID_RESULTS");
  return given.isEmpty() ? 40 : given.toInt();
}

}  // namespace

class MorphologyResultsTest : public QObject {
  Q_OBJECT

 private slots:
  void resultsAreSolids() {
    std::mt19937_64 random = seededRandom();
    int made = 0, refused = 0, crossing = 0;
    const int asked = resultsAsked();
    while (made < asked) {
      const Mesh a = anySolid(random, 3), b = anySolid(random, 1.5);
      Mesh result;
      try {
        result = anyResult(random, a, b);
      } catch (const Error& error) {
        QVERIFY2(error.code() == ErrorCode::Degenerate, error.message().c_str());  // nothing was left
        continue;
      }
      ++made;
      crossing += firstCrossing(result) ? 1 : 0;
      QVERIFY(meshTopology(result).closed());
      try {
        const Mesh again = solidSumOf(result, anySolid(random, 0.5));
        crossing += firstCrossing(again) ? 1 : 0;
        QVERIFY(volumeOf(again) > volumeOf(result));
      } catch (const Error& error) {
        qWarning("result %d: %s", made, error.message().c_str());
        ++refused;
      }
    }
    qInfo("figure solid_results %d", made);
    qInfo("figure solid_results_refused %d", refused);
    qInfo("figure solid_results_crossing %d", crossing);
    QCOMPARE(crossing, 0);
  }
};

BLOSSOM_TEST(MorphologyResultsTest)
#include "morphology_results_test.moc"
