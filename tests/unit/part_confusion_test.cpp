// Edits after which another part has the number, the neighbours or the place of the one that was picked: it is found where
// it is, or told to be lost.
#include <fmt/format.h>

#include <fstream>

#include "core/file.h"
#include "document/part_references.h"
#include "support/picked_parts.h"

using namespace blossom;
using namespace blossom::test;

namespace {

Value picked(SubShapeKind kind, int number) {
  return {{"input", "shape"}, {"kind", subShapeKindName(kind)}, {"index", number}};
}

Document holdingPart(const Document& document, const FeatureId& last, SubShapeKind kind, const Value& part) {
  const char* const list = kind == SubShapeKind::Face ? "faces" : "edges";
  return with(document, "hold", "hold", {{list, Value::array({part})}}, {last});
}

struct Found {
  std::string problem;  ///< why nothing can be told
  bool lost = false;
  Vec3 place = Vec3::Zero();
};

/// A part is picked by its place in the result of a feature, then the document is another one.
Found afterEdit(const Document& before, const Document& edited, const FeatureId& last, SubShapeKind kind,
                const Vec3& place) {
  const Results first = evaluated(before);
  if (first.at(last)->error) return {first.at(last)->error->message()};
  const auto number = numberAt(first.at(last)->evaluated.shape, kind, place);
  if (!number) return {"nothing lies there"};
  const Results signs = evaluated(holdingPart(before, last, kind, picked(kind, *number)));
  const Value part = signs.at("hold")->parts.begin().value().at(0);
  const Results after = evaluated(holdingPart(edited, last, kind, part));
  if (after.at(last)->error) return {after.at(last)->error->message()};
  const auto& error = after.at("hold")->error;
  if (error) return {error->message().find(" lost: ") == std::string::npos ? error->message() : "", true};
  const Value& now = after.at("hold")->parts.begin().value().at(0);
  return {{}, false, likenessOf(after.at(last)->evaluated.shape, kind, now.at("index").get<int>()).place};
}

Document suppressed(const Document& document, const FeatureId& id) {
  Feature feature = document.at(id);
  feature.suppressed = true;
  return document.with(std::move(feature));
}

Document outline(const Document& document, const char* id, const std::vector<Vec2>& corners) {
  Value segments = Value::array();
  for (std::size_t k = 1; k < corners.size(); ++k)
    segments.push_back({{"kind", "line"}, {"to", {corners[k].x(), corners[k].y(), 0}}});
  return with(document, id, "outline", {{"start", {corners[0].x(), corners[0].y(), 0}}, {"segments", segments}});
}

constexpr SubShapeKind edge = SubShapeKind::Edge, face = SubShapeKind::Face;

}  // namespace

#define VERIFY_LOST(found)                                                                                         \
  do {                                                                                                             \
    const Found thisOne = (found);                                                                                 \
    QVERIFY2(thisOne.problem.empty(), thisOne.problem.c_str());                                                    \
    QVERIFY2(thisOne.lost,                                                                                         \
             fmt::format("taken: ({}, {}, {})", thisOne.place.x(), thisOne.place.y(), thisOne.place.z()).c_str()); \
  } while (false)

#define VERIFY_AT(found, where)                                                                                    \
  do {                                                                                                             \
    const Found thisOne = (found);                                                                                 \
    QVERIFY2(thisOne.problem.empty(), thisOne.problem.c_str());                                                    \
    QVERIFY2(!thisOne.lost, "lost");                                                                               \
    QVERIFY2((thisOne.place - (where)).norm() < 1e-6,                                                              \
             fmt::format("taken: ({}, {}, {})", thisOne.place.x(), thisOne.place.y(), thisOne.place.z()).c_str()); \
  } while (false)

#define VERIFY_AT_OR_LOST(found, where)                   \
  do {                                                    \
    const Found foundOrLost = (found);                    \
    if (!foundOrLost.lost) VERIFY_AT(foundOrLost, where); \
  } while (false)

class PartConfusionTest : public QObject {
  Q_OBJECT
 private slots:
  void theOnlyOneLeftOfTwoIsAnother();
  void rimsOfAFullRevolution();
  void copiesOfCopies();
  void imagesOfImages();
  void anExtrusionThatIsSuppressed();
  void aGridThatGrows();
  void holesThatChangePlaces();
  void endsOfExtrudedCurves();
  void aRoundingThatIsGone();
  void sidesOfAPipe();
  void whatWasPickedJustNow();
};

void PartConfusionTest::theOnlyOneLeftOfTwoIsAnother() {
  const auto plate = [](double x) {
    Document document = with({}, "plate", "box", {{"width", 100}, {"depth", 40}, {"height", 10}, {"anchor", "corner"}});
    document = with(document, "slot", "box",
                    {{"width", 3}, {"depth", 6}, {"height", 6}, {"anchor", "corner"}, {"position", {x, -1, 5}}});
    return with(document, "cut", "boolean", {{"operation", "difference"}}, {"plate", "slot"});
  };
  VERIFY_LOST(afterEdit(plate(15), plate(-2), "cut", edge, {7.5, 0, 10}));
  VERIFY_AT_OR_LOST(afterEdit(plate(15), plate(25), "cut", edge, {7.5, 0, 10}), Vec3(12.5, 0, 10));
}

void PartConfusionTest::rimsOfAFullRevolution() {
  const auto ring = [](const std::vector<Vec2>& corners) {
    return with(outline({}, "profile", corners), "ring", "revolve", Value::object(), {"profile"});
  };
  const Document before = ring({{10, 0}, {20, 0}, {20, 8}, {10, 8}});
  VERIFY_AT(afterEdit(before, ring({{10, 0}, {20, 0}, {20, 9}, {10, 8}}), "ring", edge, {-20, 8, 0}), Vec3(-20, 9, 0));
  VERIFY_AT_OR_LOST(afterEdit(before, ring({{10, 8}, {20, 8}, {20, 16}, {10, 16}}), "ring", edge, {-20, 8, 0}),
                    Vec3(-20, 16, 0));
  VERIFY_AT(afterEdit(before, ring({{10, 0}, {25, 0}, {25, 8}, {10, 8}}), "ring", edge, {-20, 8, 0}), Vec3(-25, 8, 0));
}

void PartConfusionTest::copiesOfCopies() {
  const auto holes = [](int row, int rows) {
    Document document = with({}, "plate", "box", {{"width", 100}, {"depth", 60}, {"height", 5}, {"anchor", "corner"}});
    document = with(document, "drill", "cylinder", {{"radius", 2}, {"height", 30}, {"position", {10, 10, -10}}});
    document = with(document, "row", "pattern", {{"count", row}, {"step", {20, 0, 0}}}, {"drill"});
    document = with(document, "grid", "pattern", {{"count", rows}, {"step", {0, 20, 0}}}, {"row"});
    return with(document, "holes", "boolean", {{"operation", "difference"}}, {"plate", "grid"});
  };
  VERIFY_LOST(afterEdit(holes(3, 2), holes(1, 2), "holes", edge, {28, 10, 5}));
  VERIFY_AT(afterEdit(holes(3, 2), holes(4, 2), "holes", edge, {28, 10, 5}), Vec3(28, 10, 5));
  VERIFY_AT(afterEdit(holes(3, 2), holes(3, 1), "holes", edge, {28, 10, 5}), Vec3(28, 10, 5));
}

void PartConfusionTest::imagesOfImages() {
  Document document = with({}, "block", "box",
                           {{"width", 10}, {"depth", 10}, {"height", 10}, {"anchor", "corner"}, {"position", {5, 5, 0}}});
  document = with(document, "across", "mirror", {{"normal", {1, 0, 0}}, {"keep", true}}, {"block"});
  document = with(document, "along", "mirror", {{"normal", {0, 1, 0}}, {"keep", true}}, {"across"});
  VERIFY_LOST(afterEdit(document, suppressed(document, "across"), "along", face, {-10, 10, 10}));
  VERIFY_AT(afterEdit(document, suppressed(document, "across"), "along", face, {10, -10, 10}), Vec3(10, -10, 10));
}

void PartConfusionTest::anExtrusionThatIsSuppressed() {
  Document document = with({}, "outline", "rectangle", {{"width", 20}, {"height", 20}});
  document = with(document, "block", "extrude", {{"height", 10}}, {"outline"});
  const auto bottom = numberAt(evaluated(document).at("block")->evaluated.shape, face, {0, 0, 0});
  QVERIFY(bottom.has_value());
  document = with(document, "pad", "extrude",
                  {{"height", -5}, {"face", {{"input", "profile"}, {"kind", "face"}, {"index", *bottom}}}}, {"block"});
  const Results results = evaluated(document);
  QVERIFY2(!results.at("pad")->error, results.at("pad")->error ? results.at("pad")->error->what() : "");
  for (const double z : {-5.0, 5.0})
    if (numberAt(results.at("pad")->evaluated.shape, face, {0, 0, z}))
      VERIFY_LOST(afterEdit(document, suppressed(document, "pad"), "pad", face, {0, 0, z}));
}

void PartConfusionTest::aGridThatGrows() {
  const auto holes = [](int columns) {
    Document document = with({}, "plate", "box", {{"width", 100}, {"depth", 60}, {"height", 5}, {"anchor", "corner"}});
    document = with(document, "drill", "cylinder", {{"radius", 2}, {"height", 30}, {"position", {10, 10, -10}}});
    document = with(document, "grid", "pattern",
                    {{"count", columns}, {"step", {20, 0, 0}}, {"second-count", 2}, {"second-step", {0, 20, 0}}}, {"drill"});
    return with(document, "holes", "boolean", {{"operation", "difference"}}, {"plate", "grid"});
  };
  VERIFY_AT(afterEdit(holes(3), holes(4), "holes", edge, {8, 30, 5}), Vec3(8, 30, 5));
  VERIFY_LOST(afterEdit(holes(3), holes(2), "holes", edge, {48, 10, 5}));
}

void PartConfusionTest::holesThatChangePlaces() {
  const auto plate = [](const std::vector<Vec3>& holes) {  // x, y, radius
    Document document = with({}, "sheet", "rectangle", {{"width", 100}, {"height", 100}});
    std::vector<FeatureId> inputs{"sheet"};
    for (std::size_t k = 0; k < holes.size(); ++k) {
      inputs.push_back(fmt::format("hole-{}", k));
      document = with(document, inputs.back().c_str(), "circle",
                      {{"radius", holes[k].z()}, {"centre", {holes[k].x(), holes[k].y(), 0}}});
    }
    document = with(document, "region", "boolean", {{"operation", "difference"}}, inputs);
    return with(document, "plate", "extrude", {{"height", 5}}, {"region"});
  };
  const Document before = plate({{15, 20, 3}, {15, 28, 3}});
  const Results results = evaluated(before);
  QVERIFY(!results.at("plate")->error);
  // The rim of the first hole, wherever its middle is taken.
  std::optional<Vec3> rim;
  for (const Likeness& each : likenesses(results.at("plate")->evaluated.shape, edge))
    if (each.form == "circle" && std::abs(each.place.z() - 5) < 1e-9 && (each.place - Vec3(15, 20, 5)).norm() < 3 + 1e-6)
      rim = each.place;
  QVERIFY(rim.has_value());
  const Vec3 off = *rim - Vec3(15, 20, 5);
  VERIFY_AT_OR_LOST(afterEdit(before, plate({{15, 32, 3}, {15, 28, 3}}), "plate", edge, *rim), Vec3(15, 32, 5) + off);
  VERIFY_AT_OR_LOST(afterEdit(before, plate({{15, 36, 3}, {15, 28, 3}}), "plate", edge, *rim), Vec3(15, 36, 5) + off);
  VERIFY_LOST(afterEdit(before, plate({{15, 28, 3}}), "plate", edge, *rim));
  VERIFY_LOST(afterEdit(before, plate({{15, 28, 3}, {15, 40, 6}}), "plate", edge, *rim));
}

void PartConfusionTest::endsOfExtrudedCurves() {
  const TemporaryFolder folder;
  const std::filesystem::path file = folder.path() / "hole.svg";
  std::ofstream(file) << R"(<svg xmlns="http://www.w3.org/2000/svg" width="20mm" height="20mm" viewBox="0 0 20 20">)"
                      << R"(<path d="M5 5H15V15H5Z"/></svg>)";
  const auto part = [&](double z) {
    Feature import;
    import.id = import.name = "import";
    import.type = "exchange.import";
    import.parameters = {{ "file", file.string() }};
    Document document = Document().with(import);
    document = with(document, "tool", "extrude", {{"height", 10}}, {"import"});
    document = with(document, "placed", "transform", {{"move", {0, 0, z}}}, {"tool"});
    document = with(document, "plate", "box", {{"width", 60}, {"depth", 60}, {"height", 10}, {"anchor", "base"}});
    return with(document, "part", "boolean", {{"operation", "difference"}}, {"plate", "placed"});
  };
  const Results results = evaluated(part(-5));
  QVERIFY2(!results.at("part")->error, results.at("part")->error ? results.at("part")->error->what() : "");
  int rims = 0;
  for (const Likeness& each : likenesses(results.at("part")->evaluated.shape, edge)) {
    const bool upright = std::abs(each.place.x()) > 29;  // an edge of the plate
    if (upright || std::abs(each.place.z() - 5) > 1e-9 || std::abs(each.size - 10) > 1e-9) continue;
    ++rims;
    VERIFY_LOST(afterEdit(part(-5), part(5), "part", edge, each.place));  // the end lies above the plate now
  }
  QCOMPARE(rims, 4);
}

void PartConfusionTest::aRoundingThatIsGone() {
  const Document block = with({}, "block", "box", {{"width", 40}, {"depth", 40}, {"height", 20}, {"anchor", "base"}});
  const Shape shape = evaluated(block).at("block")->evaluated.shape;
  Value first = picked(edge, *numberAt(shape, edge, {-20, -20, 10})),
        second = picked(edge, *numberAt(shape, edge, {20, 20, 10}));
  const auto rounded = [&](const Value& edges) {
    return with(block, "rounded", "fillet", {{"radius", 5}, {"edges", edges}}, {"block"});
  };
  const Document before = rounded({first, second}), after = rounded(Value::array({second}));
  const Results results = evaluated(before);
  QVERIFY(!results.at("rounded")->error);
  int faces = 0;
  for (const Likeness& each : likenesses(results.at("rounded")->evaluated.shape, face)) {
    if (each.form != "cylinder") continue;
    ++faces;
    const Found found = afterEdit(before, after, "rounded", face, each.place);
    if (each.place.x() < 0)
      VERIFY_LOST(found);
    else
      VERIFY_AT_OR_LOST(found, each.place);
  }
  QCOMPARE(faces, 2);
}

void PartConfusionTest::sidesOfAPipe() {
  const auto pipe = [](std::vector<Vec2> corners, int begin) {
    std::rotate(corners.begin(), corners.begin() + begin, corners.end());
    Document document = outline({}, "profile", corners);
    document = with(document, "path", "outline",
                    {{"start", {0, 0, 0}}, {"segments", {{{"kind", "line"}, {"to", {60, 0, 0}}}}}, {"closed", false}});
    return with(document, "pipe", "pipe", Value::object(), {"profile", "path"});
  };
  const std::vector<Vec2> corners{{-3, -2}, {4, -2}, {4, 5}, {-3, 5}};
  const Results results = evaluated(pipe(corners, 0));
  QVERIFY2(!results.at("pipe")->error, results.at("pipe")->error ? results.at("pipe")->error->what() : "");
  for (const Likeness& each : likenesses(results.at("pipe")->evaluated.shape, face))
    VERIFY_AT_OR_LOST(afterEdit(pipe(corners, 0), pipe(corners, 1), "pipe", face, each.place), each.place);
}

// A part that was named by its number alone, and an edit before the first evaluation: it is meant as it was seen.
void PartConfusionTest::whatWasPickedJustNow() {
  const auto model = [](const std::vector<Vec2>& corners) {
    return with(outline({}, "outline", corners), "prism", "extrude", {{"height", 20}}, {"outline"});
  };
  const Document seen = model({{0, 0}, {60, 0}, {60, 40}, {0, 40}});
  const Results shown = evaluated(seen);
  const Shape shape = shown.at("prism")->evaluated.shape;
  const auto number = numberAt(shape, edge, {60, 40, 10});
  const Document named = holdingPart(seen, "prism", edge, picked(edge, *number));
  const auto shapeOf = [&](const FeatureId& id) {
    const auto found = shown.find(id);
    return found == shown.end() ? nullptr : &found->second->evaluated.shape;
  };
  auto registry = std::make_shared<Registry>(*theApp().registry);
  registry->add(holdFeature());
  const Document kept = withAppearances(named, seen, *registry, shapeOf);
  const Value part = kept.at("hold").parameters.at("edges").at(0);
  QVERIFY(part.contains("signature"));
  // Before it is evaluated, a corner comes in front of it.
  const Document edited = holdingPart(model({{0, 0}, {30, -4}, {60, 0}, {60, 40}, {0, 40}}), "prism", edge, part);
  const Results after = evaluated(edited);
  QVERIFY(!after.at("hold")->error);
  const int now = after.at("hold")->parts.at("edges").at(0).at("index").get<int>();
  const Likeness found = likenessOf(after.at("prism")->evaluated.shape, edge, now);
  QVERIFY((found.place - Vec3(60, 40, 10)).norm() < 1e-9);
}

BLOSSOM_TEST(PartConfusionTest)
#include "part_confusion_test.moc"
