// What lists hold for each shape of an input goes with the shapes.
#include "feature/input_items.h"
#include "feature/feature_type.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

ParameterSpec listed(const char* name, ParameterSpec spec) {
  spec.name = name;
  return spec;
}

/// With one item for each shape, one for each after the first, and lists of these.
FeatureType morphing() {
  FeatureType type;
  type.parameters = {listed("offsets", onePer(list(displacement()), "shape")),
                     listed("scales", onePer(list(positiveNumber()), "shape")),
                     listed("blossom", onePer(list(ratio()), "shape", -1)),
                     listed("path", list(onePer(list(ratio()), "shape", -1))), listed("knots", list(blossom::number()))};
  return type;
}

Value given() {
  return Value::parse(R"({"offsets": [[1,0,0],[2,0,0],[3,0,0]], "scales": [1.5], "blossom": [0.1, 0.2],
                          "path": [[0, 0], [0.3, 0.4]], "knots": [0, 1]})");
}

using Ids = std::vector<std::string>;

Value after(const Ids& before, const Ids& now) {
  return withItemsOfShapes(morphing(), given(), "shape", formerPlaces(before, now), before.size());
}

}  // namespace

class InputItemsTest : public QObject {
  Q_OBJECT

 private slots:
  void itemsMoveWithTheirShapes() {
    const Value moved = after({"a", "b", "c"}, {"b", "a", "c"});
    QCOMPARE(moved.at("offsets"), Value::parse("[[2,0,0],[1,0,0],[3,0,0]]"));
    QCOMPARE(moved.at("scales"), Value::parse("[1.0, 1.5]"));  // that of b is as it was: as large as drawn
    QCOMPARE(moved.at("blossom"), given().at("blossom"));
    QCOMPARE(moved.at("knots"), given().at("knots"));
  }

  void itemsGoWithTheirShapes() {
    for (const auto& [rest, offsets, blossom, path] : std::vector<std::tuple<Ids, const char*, const char*, const char*>>{
             {{"a", "b"}, "[[1,0,0],[2,0,0]]", "[0.1]", "[[0],[0.3]]"},
             {{"a", "c"}, "[[1,0,0],[3,0,0]]", "[0.2]", "[[0],[0.4]]"},
             {{"b", "c"}, "[[2,0,0],[3,0,0]]", "[0.2]", "[[0],[0.4]]"}}) {
      const Value left = after({"a", "b", "c"}, rest);
      QCOMPARE(left.at("offsets"), Value::parse(offsets));
      QCOMPARE(left.at("blossom"), Value::parse(blossom));
      QCOMPARE(left.at("path"), Value::parse(path));
    }
  }

  void newShapesHaveNone() {
    QCOMPARE(after({"a", "b", "c"}, {"a", "b", "c", "d"}), given());
    // One that replaces another one takes over what was set for it.
    QCOMPARE(after({"a", "b", "c"}, {"a", "d", "c"}), given());
  }

  /// A shape may be there twice.
  void equalShapesKeepTheirOrder() {
    const FormerPlaces places = formerPlaces({"a", "b", "a"}, {"b", "a", "a"});
    QCOMPARE(places, (FormerPlaces{1, 0, 2}));
  }

  void otherInputsChangeNothing() { QCOMPARE(withItemsOfShapes(morphing(), given(), "tool", {1, 0}, 2), given()); }
};

BLOSSOM_TEST(InputItemsTest)
#include "input_items_test.moc"
