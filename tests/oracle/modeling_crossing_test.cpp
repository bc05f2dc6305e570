/// 200 shapes that cross themselves and 200 that do not, by construction from lines and circles: of sweep, revolve, loft,
/// taper and pipe 40 each, none of the first missed and at most 2 of the second flagged.
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <BRepPrimAPI_MakeTorus.hxx>
#include <Eigen/Geometry>
#include <utility>

#include "geometry/crossing/part_overlap.h"
#include "geometry/crossing/surface_crossing.h"
#include "geometry/shape/bounds.h"
#include "geometry/shape/brep.h"
#include "modeling/kernel/solid/extrude.h"
#include "modeling/kernel/solid/loft.h"
#include "modeling/kernel/solid/pipe.h"
#include "modeling/kernel/solid/revolve.h"
#include "support/crossing_shapes.h"
#include "support/support.h"
#include "sweep/kernel/product_surface.h"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr int ofAKind = 40;
constexpr double leastDepth = 1.2e-3, greatestDepth = 0.02;  // of the size
constexpr double leastGap = 1e-4, greatestGap = 0.02;

/// What a construction said of a shape.
struct Told {
  bool crosses = false;
  std::string words;
};

/// Told by a refusal with a place, or by a warning with one.
template <class Make>
Told toldBy(const Make& make) {
  try {
    const auto made = make();
    for (const std::string& warning : made.warnings)
      if (warning.find("cuts through itself near (") != std::string::npos)
        return {warning.find(", by at least ") != std::string::npos, warning};
    return {};
  } catch (const Error& error) {
    return {error.code() == ErrorCode::Degenerate, error.message()};
  }
}

struct Extruded {
  TopoDS_Shape shape;
  std::vector<std::string> warnings;
};

Told toldOfSurface(const Surface& surface) {
  const CrossingResult found = findCrossing(surface);
  return {found.deepest.has_value(), {}};
}

}  // namespace

class ModelingCrossingTest : public QObject {
  Q_OBJECT

  std::mt19937_64 random_;

  /// Uniform in the exponent: as many small as large.
  double share(double least, double greatest) { return std::exp(uniform(random_, std::log(least), std::log(greatest))); }
  /// `by` for a shape of about a size.
  double drawn(bool crossing, double size) {
    return crossing ? size * share(leastDepth, greatestDepth) : -size * share(leastGap, greatestGap);
  }

  Told sweepTold(bool crossing) {
    const double radius = uniform(random_, 5, 20), height = uniform(random_, 10, 40),
                 size = std::hypot(2.2 * radius, height);
    const double first = std::abs(drawn(crossing, size)), last = std::abs(drawn(crossing, size));
    const int steps = 6 + static_cast<int>(uniform(random_, 1, 4));
    return toldOfSurface(sweep::productSurface(coil(radius, height, first, crossing ? -last : last, steps)).surface);
  }

  Told revolveTold(bool crossing) {
    const double radius = uniform(random_, 5, 20), height = uniform(random_, 4, 15), lean = uniform(random_, -2, 2);
    const double by = drawn(crossing, std::hypot(2 * (radius + 1.2 * height), 2 * (radius + 1.2 * height)));
    const modeling::RevolveOptions options{.direction = {0, 0, 1}, .angle = uniform(random_, 60, 360)};
    return toldBy([&] { return modeling::revolve(hookedProfile(radius, height, lean, by), options); });
  }

  Told loftTold(bool crossing) {
    const double low = uniform(random_, 8, 20), high = low * uniform(random_, 0.7, 0.95), height = uniform(random_, 10, 30);
    const double by = drawn(crossing, std::hypot(3 * low, height));
    std::vector<TopoDS_Shape> sections;
    for (const TopoDS_Wire& wire : cup(low, high, height, by)) sections.push_back(faceIn(wire));
    return toldBy([&] { return modeling::loft(sections, {.ruled = true, .solid = true}); });
  }

  Told taperTold(bool crossing) {
    const double size = uniform(random_, 20, 60), height = uniform(random_, 5, 15), degrees = uniform(random_, 5, 20);
    const double by = drawn(crossing, 1.8 * size);
    const modeling::ExtrudeOptions options{.height = height, .taper = -degrees};
    return toldBy([&] { return Extruded{modeling::extrude(slotted(size, height, degrees, by), options).shape, {}}; });
  }

  Told pipeTold(bool crossing) {
    const double size = uniform(random_, 30, 60), radius = size * uniform(random_, 0.03, 0.06);
    const double by = drawn(crossing, 1.6 * size);
    const TopoDS_Face disc = faceIn(circleWire({0, 0, 0}, radius));
    return toldBy([&] { return modeling::pipe(disc, overpass(size, radius, by), {}); });
  }

 private slots:
  void initTestCase() { random_ = seededRandom(); }

  void crossingsAreToldAndCleanShapesAreNot() {
    using Trial = Told (ModelingCrossingTest::*)(bool);
    const std::vector<std::pair<const char*, Trial>> kinds{{"sweep", &ModelingCrossingTest::sweepTold},
                                                           {"revolve", &ModelingCrossingTest::revolveTold},
                                                           {"loft", &ModelingCrossingTest::loftTold},
                                                           {"taper", &ModelingCrossingTest::taperTold},
                                                           {"pipe", &ModelingCrossingTest::pipeTold}};
    int missed = 0, flagged = 0, crossings = 0, clean = 0;
    for (const auto& [name, trial] : kinds) {
      int missedHere = 0, flaggedHere = 0;
      for (int k = 0; k < ofAKind; ++k) {
        if (!(this->*trial)(true).crosses) ++missedHere;
        const Told told = (this->*trial)(false);
        if (told.crosses) {
          ++flaggedHere;
          qInfo("flagged: %s %d: %s", name, k, told.words.c_str());
        }
      }
      qInfo("%s: %d of %d missed, %d of %d flagged", name, missedHere, ofAKind, flaggedHere, ofAKind);
      missed += missedHere, flagged += flaggedHere, crossings += ofAKind, clean += ofAKind;
    }
    std::printf("figure crossings_drawn %d\nfigure crossings_missed %d\nfigure clean_drawn %d\nfigure clean_flagged %d\n",
                crossings, missed, clean, flagged);
    QCOMPARE(missed, 0);
    QVERIFY2(flagged <= 2, qPrintable(QString::number(flagged)));
  }

  /// The layers of a coil meet where the distance between them, linear along v, is zero.
  void placeAndParametersAreThoseOfTheConstruction() {
    double off = 0;
    for (int k = 0; k < 20; ++k) {
      const double first = uniform(random_, 0.3, 1), last = uniform(random_, 0.3, 1), height = 20;
      const Surface surface = sweep::productSurface(coil(10, height, first, -last, 8)).surface;
      const auto crossing = findCrossing(surface).deepest;
      QVERIFY(crossing);
      const double v = first / (first + last);
      off = std::max({off, std::abs(crossing->first.at.y() - v), std::abs(crossing->second.at.y() - v),
                      std::abs(crossing->point.z() - v * height) / height,
                      std::abs(std::abs(crossing->first.at.x() - crossing->second.at.x()) - 6)});
      // No sheet reaches farther beyond the other than the layers are apart at an end.
      QVERIFY(crossing->depth > 0 && crossing->depth <= std::max(first, last));
    }
    std::printf("figure crossing_place_off %.3g\n", off);
    QVERIFY2(off < 1e-6, qPrintable(QString::number(off)));
  }

  void artefactsOfTrianglesAreNoCrossings() {
    // Seams, poles and degenerate edges.
    for (const TopoDS_Shape& shape :
         {BRepPrimAPI_MakeSphere(7).Shape(), BRepPrimAPI_MakeTorus(10, 4).Shape(), BRepPrimAPI_MakeCone(5, 0, 12).Shape()})
      QVERIFY(!findCrossing(shape).deepest);
    // A coil whose layers lie on one another exactly: tangent everywhere, nowhere through.
    QVERIFY(!findCrossing(sweep::productSurface(coil(10, 20, 0, 0, 8)).surface).deepest);
  }

  /// Boxes of 10 mm: apart, wall to wall, through each other along shared walls, within and upon one another.
  void partsOverlapWhereTheyHoldTheSameSpace() {
    const auto box = [](double x, double y, double z, double size) -> TopoDS_Shape {
      return BRepPrimAPI_MakeBox(gp_Pnt(x, y, z), size, size, size).Shape();
    };
    const TopoDS_Shape one = box(0, 0, 0, 10);
    QVERIFY(!overlapOf(one, box(20, 0, 0, 10)));
    QVERIFY(!overlapOf(one, box(10, 0, 0, 10)));
    QVERIFY(!overlapOf(one, box(10, 10, 10, 10)));
    QVERIFY(!overlapOf(one, box(10, 3, 3, 4)));
    QVERIFY(overlapOf(one, box(9.9, 0, 0, 10)));
    QVERIFY(overlapOf(one, box(9, 9, 9, 10)));
    QVERIFY(overlapOf(one, box(3, 3, 3, 4)));
    QVERIFY(overlapOf(one, one));
    const auto place = overlapOf(one, box(5, 2, 2, 10));
    QVERIFY(place && place->x() >= 5 - 1e-9 && place->x() <= 10 + 1e-9);
  }
};

BLOSSOM_TEST(ModelingCrossingTest)
#include "modeling_crossing_test.moc"
