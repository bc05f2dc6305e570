// What pictures and files of a document show, and what has gone into a result.
#include <BRepPrimAPI_MakeBox.hxx>
#include <map>

#include "document/shown.h"
#include "feature/acceptance.h"
#include "feature/registry.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/brep.h"
#include "support/documents.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

FeatureType type(const char* command, std::vector<InputSpec> inputs) {
  FeatureType made;
  made.id = std::string("test.") + command;
  made.command = command;
  made.title = made.summary = command;
  made.inputs = std::move(inputs);
  made.evaluate = [](const Value&, const Inputs&, const Progress&) { return Evaluated(); };
  return made;
}

InputSpec input(const char* name, InputUse use, std::size_t minimum = 1, std::size_t maximum = 1,
                std::vector<ShapeKind> kinds = {}) {
  return {.name = name, .help = name, .kinds = std::move(kinds), .minimum = minimum, .maximum = maximum, .use = use};
}

/// Features by their type's command; all have a shape until one is taken away.
class Made {
 public:
  Made() {
    registry.addAll(
        type("source", {}), type("unite", {input("shapes", InputUse::Consumed, 2, anyNumber)}),
        type("raise", {input("profile", InputUse::Outline)}),
        type("morph", {input("shape", InputUse::Control, 2, anyNumber)}), type("axis", {input("part", InputUse::Kept)}),
        type("deform", {input("cage", InputUse::Consumed, 1, 1, {ShapeKind::Brep}),
                        input("pins", InputUse::Kept, 0, anyNumber, {ShapeKind::Region}),
                        input("target", InputUse::Control, 0, anyNumber, {ShapeKind::Region, ShapeKind::Brep})}));
  }
  void add(const FeatureId& id, const char* command, Ids inputs = {}, Shape shape = Shape(Region())) {
    Feature feature;
    feature.id = feature.name = id;
    feature.type = std::string("test.") + command;
    feature.inputs = std::move(inputs);
    document = document.with(feature);
    shapes[id] = std::move(shape);
  }
  void change(const FeatureId& id, bool Feature::*flag, bool value) {
    Feature feature = document.at(id);
    feature.*flag = value;
    document = document.with(feature);
  }
  [[nodiscard]] ShapeOf shapeOf() const {
    return [this](const FeatureId& id) { return shapes.contains(id) ? &shapes.at(id) : nullptr; };
  }
  [[nodiscard]] Ids shown() const { return shownFeatures(document, registry, shapeOf()); }

  Registry registry;
  Document document;
  std::map<FeatureId, Shape> shapes;
};

Shape solid() { return Shape(Brep(BRepPrimAPI_MakeBox(1, 2, 3).Shape())); }

}  // namespace

class ShownFeaturesTest : public QObject {
  Q_OBJECT

 private slots:
  void whatHasGoneIntoAResultIsNotShown() {
    Made made;
    made.add("a", "source");
    made.add("b", "source");
    made.add("c", "unite", {"a", "b"});
    made.add("d", "raise", {"c"});
    QCOMPARE(made.shown(), (Ids{"d"}));
    made.shapes.erase("d");  // it has failed
    QCOMPARE(made.shown(), (Ids{"c"}));
    made.shapes.erase("c");
    QCOMPARE(made.shown(), (Ids{"a", "b"}));
  }

  void whatIsHiddenStaysAwayAndBringsNothingBack() {
    Made made;
    made.add("a", "source");
    made.add("b", "source");
    made.add("c", "unite", {"a", "b"});
    made.change("c", &Feature::visible, false);
    QCOMPARE(made.shown(), Ids{});
    made.change("c", &Feature::visible, true);
    made.change("a", &Feature::visible, false);
    QCOMPARE(made.shown(), (Ids{"c"}));
  }

  void oneThatIsSuppressedPassesItsFirstInputOn() {
    Made made;
    made.add("a", "source");
    made.add("b", "source");
    made.add("c", "unite", {"a", "b"});
    made.add("d", "raise", {"c"});
    made.change("c", &Feature::suppressed, true);
    QCOMPARE(made.shown(), (Ids{"b", "d"}));  // "a" is in "d" now
    made.change("d", &Feature::suppressed, true);
    QCOMPARE(made.shown(), (Ids{"a", "b"}));
  }

  void controlsAndPartsStay() {
    Made made;
    made.add("a", "source");
    made.add("b", "source");
    made.add("m", "morph", {"a", "b"});
    made.add("x", "axis", {"m"});
    QCOMPARE(made.shown(), (Ids{"a", "b", "m", "x"}));
    const InputsByUse use = inputsByUse(made.document.at("m"), made.registry, made.shapeOf());
    QCOMPARE(use.controls, (Ids{"a", "b"}));
    QVERIFY(use.consumed.empty());
  }

  void aSolidWhoseFaceIsRaisedStays() {
    Made made;
    made.add("box", "source", {}, solid());
    made.add("boss", "raise", {"box"}, solid());
    QCOMPARE(made.shown(), (Ids{"box", "boss"}));
  }

  void inputsBelongToTheSpecThatTakesThem() {
    Made made;
    made.add("cage", "source", {}, solid());
    made.add("pin", "source");
    made.add("goal", "source", {}, solid());
    made.add("other", "source");
    made.add("d", "deform", {"cage", "pin", "goal", "other"}, solid());
    const InputsByUse use = inputsByUse(made.document.at("d"), made.registry, made.shapeOf());
    QCOMPARE(use.consumed, (Ids{"cage"}));
    QCOMPARE(use.controls, (Ids{"goal", "other"}));  // an optional spec leaves what it does not accept to the next
  }

  void countsFollowTheMinimaOfLaterSpecs() {
    const FeatureType two = type("two", {input("a", InputUse::Kept, 1, anyNumber), input("b", InputUse::Kept, 2, 2)});
    const auto any = [](std::size_t, std::size_t) { return true; };
    QCOMPARE(inputCounts(two, 5, any), (std::vector<std::size_t>{3, 2}));
    QCOMPARE(inputCounts(two, 3, any), (std::vector<std::size_t>{1, 2}));
    QCOMPARE(inputCounts(two, 2, any), (std::vector<std::size_t>{0, 2}));
    QCOMPARE(inputCounts(type("none", {}), 3, any), std::vector<std::size_t>{});
    QCOMPARE(inputCounts(type("one", {input("a", InputUse::Kept)}), 3, any), (std::vector<std::size_t>{3}));
  }
};

BLOSSOM_TEST(ShownFeaturesTest)
#include "shown_features_test.moc"
