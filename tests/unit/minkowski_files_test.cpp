#include <fmt/format.h>

#include "geometry/planar/planar.h"
#include "geometry/planar/sums/region_sum.h"
#include "support/curved_regions.h"
#include "support/exchange.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::planar;

namespace {

struct Sides {
  std::size_t lines = 0, arcs = 0;
};

Sides sidesIn(const Region& region) {
  Sides sides;
  for (const Path& loop : region.loops)
    for (const Segment& segment : loop.segments) ++(std::holds_alternative<Line2>(segment) ? sides.lines : sides.arcs);
  return sides;
}

Region ringOf(double outer, double inner) {
  Region ring{{circleRegion(outer).loops.front(), blossom::reversed(circleRegion(inner).loops.front())}};
  return ring;
}

Region readBack(const Region& region, const char* extension) {
  return toRegion(*roundTrip(region, extension).shape.get<Curves>());
}

}  // namespace

/// Sums of what was written to a file and read again: formats cut circles, and end outlines a rounding beside their
/// beginning.
class MinkowskiFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void sumsAreThoseOfWhatWasWritten_data() {
    QTest::addColumn<QString>("extension");
    for (const char* extension : {"svg", "dxf"}) QTest::newRow(extension) << QString::fromLatin1(extension);
  }

  void sumsAreThoseOfWhatWasWritten() {
    QFETCH(QString, extension);
    const std::string format = extension.toStdString();
    std::mt19937_64 random = seededRandom();
    for (int k = 0; k < 60; ++k) {
      const double radius = uniform(random, 0.2, 3);
      // The tool fills the hole, or leaves one that is wider than the tolerance.
      const double hole = radius * uniform(random, k % 8 == 0 ? 0.3 : 1.1, k % 8 == 0 ? 0.9 : 1.5);
      const Region drawn = k % 4 == 0 ? ringOf(uniform(random, 5, 30), hole) : anyRounded(random, 20);
      const Region read = readBack(drawn, format.c_str()), tool = circleRegion(radius);
      const Region sum = minkowskiSum(std::vector{drawn, tool}).region, again = minkowskiSum(std::vector{read, tool}).region;
      const std::string what = fmt::format("{}, pair {}: {} + {} and {} + {} lines and arcs", format, k, sidesIn(sum).lines,
                                           sidesIn(sum).arcs, sidesIn(again).lines, sidesIn(again).arcs);
      QVERIFY2(std::abs(area(sum) - area(again)) <= 1e-9 * area(sum), what.c_str());
      QCOMPARE(sidesIn(again).lines, sidesIn(sum).lines);
      const std::size_t cutInThree = 2 * again.loops.size();  // circles of convex outlines stay as the file cuts them
      QVERIFY2(sidesIn(again).arcs <= sidesIn(sum).arcs + cutInThree, what.c_str());
    }
  }
};

BLOSSOM_TEST(MinkowskiFilesTest)
#include "minkowski_files_test.moc"
