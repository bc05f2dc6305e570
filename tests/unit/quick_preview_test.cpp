/// What is dragged is previewed where that is quick.
#include "document/evaluation/quick_preview.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

struct PreviewedParameters {
  int preview = 0;
};

FeatureType previewedType(const char* id) {
  return feature<PreviewedParameters>(id, "Slow", "Takes long.")
      .produces({ShapeKind::Mesh})
      .previewedBy("preview")
      .input({.name = "shape", .help = "Any.", .kinds = {}, .minimum = 0, .maximum = anyNumber})
      .parameter("preview", &PreviewedParameters::preview, count(0, 100), "Cells; 0: none.")
      .evaluate([](const PreviewedParameters&, const Inputs&, const Progress&) { return Evaluated{}; });
}

struct UnpreviewedParameters {};

FeatureType unpreviewedType() {
  return feature<UnpreviewedParameters>("test.quick", "Quick", "Takes no time.")
      .produces({ShapeKind::Mesh})
      .input({.name = "shape", .help = "Any.", .kinds = {}, .minimum = 0, .maximum = anyNumber})
      .evaluate([](const UnpreviewedParameters&, const Inputs&, const Progress&) { return Evaluated{}; });
}

Feature previewFeature(const char* id, const char* type, std::vector<FeatureId> inputs) {
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
    registry.addAll(previewedType("test.slow"), unpreviewedType());
    Document document;
    for (Feature& each : std::vector<Feature>{
             previewFeature("a", "test.quick", {}), previewFeature("b", "test.quick", {}),
             previewFeature("sum", "test.slow", {"a"}), previewFeature("cut", "test.quick", {"sum"}),
             previewFeature("more", "test.slow", {"cut", "b"}), previewFeature("other", "test.slow", {"b"})})
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
