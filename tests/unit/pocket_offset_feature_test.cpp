#include <numbers>

#include "document/evaluator.h"
#include "geometry/planar/medial_axis.h"
#include "support/modeling.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

/// A plate of 60 x 40 x 10 with a hole of radius 8 in its middle.
Shape plate() {
  const Value where = {{"radius", 8}, {"height", 10}, {"position", {30, 20, 0}}};
  return made("boolean", {{"operation", "difference"}},
              {made("box", {{"width", 60}, {"depth", 40}, {"height", 10}}).shape, made("cylinder", where).shape})
      .shape;
}

Value onFace(int index) { return {{"input", "part"}, {"kind", "face"}, {"index", index}}; }

Curves drawing(std::vector<Path> paths) { return {std::move(paths), FillRule::EvenOdd}; }

/// How many faces give an offset with this area.
int facesWith(double area, double distance) {
  int found = 0;
  for (int face = 0; face < 6; ++face) try {
      const Evaluated inset = made("offset", {{"face", onFace(face)}, {"distance", {distance}}}, {plate()});
      found += std::abs(surfaceArea(inset) - area) < 1e-6 ? 1 : 0;
    } catch (const Error& error) {
      if (error.message().find("is not flat") == std::string::npos) throw;
    }
  return found;
}

}  // namespace

/// The feature types offset and medial axis as command line and window call them.
class PocketOffsetFeatureTest final : public QObject {
  Q_OBJECT
 private slots:
  void severalDistancesMakeALayerEach() {
    const Evaluated rings = made("offset", {{"distance", {1, 2, 30}}, {"side", "both"}}, {rectangle(0, 0, 40, 20)});
    const Curves* curves = rings.shape.get<Curves>();
    QVERIFY(curves);
    std::set<std::string> layers;
    for (const Path& path : curves->paths) layers.insert(path.layer);
    QCOMPARE(layers, (std::set<std::string>{"inside 1", "inside 2", "outside 1", "outside 2", "outside 30"}));
    QCOMPARE(rings.stats["offsets"].size(), std::size_t(6));
    COMPARE_NEAR(rings.stats["offsets"][0]["area"].get<double>(), 38 * 18, 1e-9);
    QCOMPARE(rings.warnings.size(), std::size_t(1));
    QVERIFY2(rings.warnings[0].find("30 mm; the distance must be below 10 mm") != std::string::npos,
             rings.warnings[0].c_str());
  }
  void bothSidesMakeABand() {
    const Evaluated band = made("offset", {{"distance", {2}}, {"side", "both"}}, {rectangle(0, 0, 40, 20)});
    COMPARE_NEAR(surfaceArea(band), 800 + 120 * 2 + pi * 4 - 36 * 16, 1e-9);
  }
  void aFaceOfASolidIsThePart() {
    // Top and bottom with their hole, and the four sides.
    QCOMPARE(facesWith(56 * 36 - pi * 100, 2), 2);
    QCOMPARE(facesWith(56 * 6, 2), 2);
    QCOMPARE(facesWith(36 * 6, 2), 2);
    VERIFY_REFUSED(refusal("offset", {}, {plate()}), ErrorCode::InvalidInput, "The input is a solid");
    VERIFY_REFUSED(refusal("offset", {{"face", onFace(99)}}, {plate()}), ErrorCode::NotFound, "face 99");
    int curved = 0;
    for (int face = 0; face < 7; ++face)
      curved += refusal("medial-axis", {{"face", onFace(face)}}, {plate()}).message().ends_with("is not flat.") ? 1 : 0;
    QCOMPARE(curved, 1);
  }
  void theAxisOfAFaceGoesRoundItsHole() {
    for (int face = 0; face < 6; ++face) {
      if (refusal("medial-axis", {{"face", onFace(face)}}, {plate()}).code() != ErrorCode::Internal) continue;
      const Evaluated made_ = made("medial-axis", {{"face", onFace(face)}}, {plate()});
      const MedialAxis* axis = made_.shape.get<MedialAxis>();
      QVERIFY(axis);
      const int loops = int(axis->edges.size()) - int(axis->vertices.size()) + 1;
      QCOMPARE(loops, lengthOf(*axis) > 110 ? 1 : 0);
    }
  }
  void openLinesAreRefusedOrLeftOut() {
    const Curves part = drawing({polygon({{0, 0}, {30, 0}, {30, 20}, {0, 20}}), polygon({{-5, 10}, {35, 10}}, false)});
    for (const char* command : {"offset", "medial-axis"}) {
      const Error said = refusal(command, {}, {part});
      VERIFY_REFUSED(said, ErrorCode::InvalidInput, "from (-5, 10) to (35, 10)");
      QVERIFY2(said.hint().find("--skip-open") != std::string::npos, said.hint().c_str());
      const Evaluated rest = made(command, {{"skip-open", true}}, {part});
      QCOMPARE(rest.warnings.size(), std::size_t(1));
      QVERIFY2(rest.warnings[0].find("from (-5, 10) to (35, 10)") != std::string::npos, rest.warnings[0].c_str());
    }
    COMPARE_NEAR(surfaceArea(made("offset", {{"skip-open", true}}, {part})), 28 * 18, 1e-9);
    const Curves open = drawing({polygon({{0, 0}, {30, 0}, {30, 20}}, false)});
    VERIFY_REFUSED(refusal("offset", {{"skip-open", true}}, {open}), ErrorCode::InvalidInput, "no closed outline");
  }
  void rubbishIsRefusedWithPlaceAndRemedy() {
    const Region bow{{polygon({{0, 0}, {10, 10}, {10, 0}, {0, 10}})}};
    const Region bad{{polygon({{0, 0}, {10, std::nan("")}, {10, 10}})}};
    const Region overlapping{{polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), circle({10, 5}, 3)}};
    for (const char* command : {"offset", "medial-axis"}) {
      VERIFY_REFUSED(refusal(command, {}, {Region{}}), ErrorCode::InvalidInput, "empty");
      VERIFY_REFUSED(refusal(command, {}, {drawing({})}), ErrorCode::InvalidInput, "enclose no area");
      VERIFY_REFUSED(refusal(command, {}, {bow}), ErrorCode::InvalidInput, "(5, 5)");
      VERIFY_REFUSED(refusal(command, {}, {bad}), ErrorCode::InvalidInput, "egment ");
      VERIFY_REFUSED(refusal(command, {}, {overlapping}), ErrorCode::InvalidInput, "crosses itself near (10, ");
      for (const Region& region : {Region{}, bow, bad, overlapping}) QVERIFY(!refusal(command, {}, {region}).hint().empty());
    }
    const Error tooFar = refusal("offset", {{"distance", {10.5}}}, {rectangle(0, 0, 40, 20)});
    VERIFY_REFUSED(tooFar, ErrorCode::InvalidParameter, "10.5 mm; the distance must be below 10 mm");
    QVERIFY(!tooFar.hint().empty());
  }
  void figuresTellHowItCameAbout() {
    const Evaluated axis = made("medial-axis", {}, {rectangle(0, 0, 40, 20)});
    QCOMPARE(figure(axis.shape, "edges"), 5.0);
    QCOMPARE(figure(axis.shape, "certified"), 6.0);
    QCOMPARE(figure(axis.shape, "uncertified"), 0.0);
    COMPARE_NEAR(figure(axis.shape, "length"), 20 + 40 * std::numbers::sqrt2, 1e-9);
    COMPARE_NEAR(axis.stats["largest_distance"].get<double>(), 10, 1e-9);
    for (const char* key : {"diagram_ms", "sites", "voronoi_vertices", "diagrams_built", "method"})
      QVERIFY2(axis.stats.contains(key), key);
  }
  void everyFeatureHasItsIconAndExamples() {
    for (const auto& type : theApp().registry->types()) {
      if (!type->id.starts_with("pocket.")) continue;
      QVERIFY2(fs::exists(sourceFolder() / "resources/icons" / (type->icon + ".svg")), type->id.c_str());
      QVERIFY2(!type->examples.empty(), type->id.c_str());
      for (const std::string& example : type->examples)
        QVERIFY2(example.starts_with("blossom " + type->command), example.c_str());
    }
    QVERIFY(fs::exists(sourceFolder() / "resources/icons/pocket.svg"));
  }
};

BLOSSOM_TEST(PocketOffsetFeatureTest)
#include "pocket_offset_feature_test.moc"
