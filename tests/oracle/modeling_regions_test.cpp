#include <array>

#include "core/error.h"
#include "geometry/occt/occt.h"
#include "geometry/planar/booleans/region_boolean.h"
#include "geometry/planar/planar.h"
#include "modeling/kernel/parts/boolean.h"
#include "modeling/kernel/solid/arrange.h"
#include "support/curved_regions.h"
#include "support/lattice_regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// Nothing where OCCT fails.
std::optional<Region> byOcct(const Region& a, const Region& b, BooleanOperation operation) {
  try {
    return modeling::asRegion(modeling::combine({toFaces(a), toFaces(b)}, {.operation = operation}).shape);
  } catch (const Error& error) {
    const bool nothing = error.message().find("empty") != std::string::npos || error.message().starts_with("Nothing");
    return nothing ? std::optional(Region{}) : std::nullopt;
  }
}

struct Tally {
  int compared = 0, unlike = 0;
};

void compare(const Region& a, const Region& b, Tally& tally) {
  for (const BooleanOperation operation :
       {BooleanOperation::Union, BooleanOperation::Difference, BooleanOperation::Intersection}) {
    const auto ours = combined(std::array{a, b}, operation);
    if (!ours) continue;
    const auto theirs = byOcct(a, b, operation);
    if (!theirs) continue;
    ++tally.compared;
    const double all = area(a) + area(b);
    if (std::abs(area(*ours) - area(*theirs)) > 1e-7 * all) ++tally.unlike;
  }
}

}  // namespace

/// Booleans of regions of lines and arcs beside OCCT's.
class ModelingRegionsTest : public QObject {
  Q_OBJECT

 private slots:
  void onALattice() {
    Random random = seededRandom();
    Tally tally;
    for (int i = 0; i < 100; ++i) compare(latticeRegion(random), latticeRegion(random), tally);
    QVERIFY(tally.compared > 250);
    QCOMPARE(tally.unlike, 0);
  }

  void roundedOutlines() {
    Random random = seededRandom();
    Tally tally;
    for (int i = 0; i < 60; ++i) {
      const Region b =
          moved(anyRounded(random, 5), 1, uniform(random, 0, 6), {uniform(random, -4, 4), uniform(random, -4, 4)});
      compare(anyRounded(random, 5), b, tally);
    }
    QVERIFY(tally.compared > 150);
    QCOMPARE(tally.unlike, 0);
  }
};

BLOSSOM_TEST(ModelingRegionsTest)
#include "modeling_regions_test.moc"
