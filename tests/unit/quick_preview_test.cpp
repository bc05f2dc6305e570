/// What is dragged is previewed where that is quick.
#include "document/evaluation/quick_preview.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

struct GridParameters {
  int preview = 0;
};

FeatureType slowType(const char* id) {
  return feature<GridParameters>(id, "Slow", "Takes long.")
      .produces({ShapeKind::Mesh})
      .input({.name = "shape", .help = "Any.", .minimum = 0, .maximum = anyNumber})
      .parameter("preview", &GridParameters::preview, count(0, 100), "Cells; 0: none.")
      .evaluate([](const GridParameters&, const Inputs&, const Progress&) { return Evaluated{}; });
}

struct NoParameters {};

FeatureType quickType() {
  return feature<NoParameters>("test.quick", "Quick", "Takes no time.")
      .produces({ShapeKind::Mesh})
      .input({.name = "shape", .help = "Any.", .minimum = 0, .maximum = anyNumber})
      .evaluate([](const NoParameters&, const Inputs&, const Progress&) { return Evaluated{}; });
}

Feature made(const char* id, const char* type, std::vector<FeatureId> inputs) {
  Feature feature;
  feature.id = id;
  feature.type = type;
  feature.inputs = std::move(inputs);
  return feature;
}

}  // namespace

class QuickPreviewTest : public QObject {
  Q_OBJECT

 private slots:
  void whatIsMadeOfTheFeatureIsPreviewed() {
    Registry registry;
    registry.addAll(slowType("test.slow"), quickType());
    Document document;
    for (Feature& each : std::vector<Feature>{made("a", "test.quick", {}), made("b", "test.quick", {}),
                                              made("sum", "test.slow", {"a"}), made("cut", "test.quick", {"sum"}),
                                              made("more", "test.slow", {"cut", "b"}), made("other", "test.slow", {"b"})})
      document = document.with(std::move(each));
    Feature chosen = document.at("other");
    chosen.parameters["preview"] = 12;
    document = document.with(chosen);
    const auto cellsIn = [](const Document& of, const char* id) { return of.at(id).parameters.value("preview", Value(0)); };

    const auto ofA = quickPreview(document, registry, "a");
    QVERIFY(ofA);
    QCOMPARE(ofA->last, FeatureId("more"));
    QVERIFY(cellsIn(ofA->document, "sum") > 0 && cellsIn(ofA->document, "more") > 0);
    QVERIFY(cellsIn(document, "sum") == 0);  // the document itself stays
    const auto ofB = quickPreview(document, registry, "b");
    QVERIFY(ofB && cellsIn(ofB->document, "sum") == 0);
    QVERIFY(cellsIn(ofB->document, "other") == 12);  // as it was chosen
    QVERIFY(quickPreview(document, registry, "sum"));
    QVERIFY(!quickPreview(document, registry, "other"));
  }
};

BLOSSOM_TEST(QuickPreviewTest)
#include "quick_preview_test.moc"
