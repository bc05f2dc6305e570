// Edges that stand on the ends of a side of an outline which was divided, or joined with the next: they lie where they lay
// and are found; the edges of the side itself are lost.
#include <numbers>

#include "support/part_models.h"
#include "support/picked_parts.h"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr double height = 20, filletRadius = 5;
const std::vector<Vec2> plateCorners{{0, 0}, {60, 0}, {60, 40}, {0, 40}};

Value partNumber(SubShapeKind kind, int number) {
  return {{"input", "shape"}, {"kind", subShapeKindName(kind)}, {"index", number}};
}

Document prism(const Corners& corners) {
  return with(with({}, "outline", "outline", corners.parameters()), "prism", "extrude", {{"height", height}}, {"outline"});
}

Document rounded(const Document& prism, const Value& edges) {
  return with(prism, "fillet", "fillet", {{"radius", filletRadius}, {"edges", edges}}, {"prism"});
}

Document holding(const Document& prism, const Value& part) {
  return with(prism, "hold", "hold", {{"edges", Value::array({part})}}, {"prism"});
}

/// The edges at these places, with the signatures that a document keeps.
Value keptEdges(const Document& document, const std::vector<Vec3>& places) {
  const Shape shape = evaluated(document).at("prism")->evaluated.shape;
  Value edges = Value::array();
  for (const Vec3& place : places)
    edges.push_back(partNumber(SubShapeKind::Edge, *numberAt(shape, SubShapeKind::Edge, place)));
  const Document named = with(document, "hold", "hold", {{"edges", edges}}, {"prism"});
  return evaluated(named).at("hold")->parts.at("edges");
}

/// Where the edge is after the edit; nothing when it is lost.
std::optional<Vec3> placeAfter(const Document& before, const Vec3& place, const Document& edited) {
  const Results results = evaluated(holding(edited, keptEdges(before, {place}).at(0)));
  const FeatureResult& held = *results.at("hold");
  if (held.error) return std::nullopt;
  const int number = held.parts.at("edges").at(0).at("index").get<int>();
  return likenessOf(results.at("prism")->evaluated.shape, SubShapeKind::Edge, number).place;
}

bool isAt(const std::optional<Vec3>& place, const Vec3& wanted) { return place && (*place - wanted).norm() < 1e-9; }

/// The same corners as points of a path whose first side is an arc.
Document roundedBack(const std::vector<Vec2>& more) {
  Value segments =
      Value::array({{{"kind", "arc"}, {"through", Value::array({Value::array({30, -30, 0})})}, {"to", {60, 0, 0}}}});
  for (const Vec2& p : more) segments.push_back({{"kind", "line"}, {"to", {p.x(), p.y(), 0}}});
  const Document drawn = with({}, "outline", "outline", {{"start", {0, 0, 0}}, {"segments", segments}});
  return with(drawn, "prism", "extrude", {{"height", height}}, {"outline"});
}

}  // namespace

class PartPiecesTest : public QObject {
  Q_OBJECT
 private slots:
  void filletsStayWhileASideIsDivided_data();
  void filletsStayWhileASideIsDivided();
  void edgesOfTheSideItselfAreLost();
  void whatMovedAwayIsNotGuessed();
  void edgesBesideARemovedCornerStay();
  void twoEdgesBetweenTheSameSides();
  void thoseThatAreNotLostGetTheirNumbers();
};

void PartPiecesTest::filletsStayWhileASideIsDivided_data() {
  QTest::addColumn<int>("side");
  QTest::addColumn<double>("bulge");
  for (int side = 0; side < 4; ++side)
    for (const double bulge : {0.0, 0.1, -0.1}) QTest::addRow("side %d, bulge %g", side, bulge) << side << bulge;
}

void PartPiecesTest::filletsStayWhileASideIsDivided() {
  QFETCH(int, side);
  QFETCH(double, bulge);
  Corners corners(plateCorners);
  const std::vector<Vec3> places{{60, 0, height / 2}, {60, 40, height / 2}};
  const Value kept = keptEdges(prism(corners), places);
  corners.insert(side, bulge);
  const Results results = evaluated(rounded(prism(corners), kept));
  const FeatureResult& fillet = *results.at("fillet");
  QVERIFY2(!fillet.error, fillet.error ? fillet.error->what() : "");
  const Shape& solid = results.at("prism")->evaluated.shape;
  const Value& edges = fillet.parts.at("edges");
  QCOMPARE(edges.size(), places.size());
  for (std::size_t k = 0; k < places.size(); ++k)
    QVERIFY(isAt(likenessOf(solid, SubShapeKind::Edge, edges.at(k).at("index").get<int>()).place, places[k]));
  if (bulge != 0) return;  // the corners have other angles
  const double corner = (1 - std::numbers::pi / 4) * filletRadius * filletRadius * height;
  const double cut = figure(solid, "volume") - figure(fillet.evaluated.shape, "volume");
  QVERIFY(std::abs(cut - 2 * corner) < 1e-6);
}

void PartPiecesTest::edgesOfTheSideItselfAreLost() {
  for (const double bulge : {0.0, 0.1}) {
    Corners corners(plateCorners);
    const Document before = prism(corners);
    corners.insert(1, bulge);
    for (const double z : {0.0, height}) QVERIFY(!placeAfter(before, {60, 20, z}, prism(corners)));
    for (const double z : {0.0, height}) QVERIFY(isAt(placeAfter(before, {30, 0, z}, prism(corners)), {30, 0, z}));
  }
}

// All of the outline moved by the length of a side, and one was divided: an edge stands where another one stood.
void PartPiecesTest::whatMovedAwayIsNotGuessed() {
  for (const Vec2& by : {Vec2(60, 0), Vec2(-60, 0), Vec2(0, 40), Vec2(0, -40), Vec2(60, 40)})
    for (int side = 0; side < 4; ++side) {
      Corners corners(plateCorners);
      const Document before = prism(corners);
      corners.insert(side, 0.1);
      corners.moveAll(by);
      for (const Vec2& corner : plateCorners) {
        const auto found = placeAfter(before, {corner.x(), corner.y(), height / 2}, prism(corners));
        QVERIFY(!found || isAt(found, {corner.x() + by.x(), corner.y() + by.y(), height / 2}));
      }
    }
}

void PartPiecesTest::edgesBesideARemovedCornerStay() {
  Corners corners({{0, 0}, {60, 0}, {70, 20}, {60, 40}, {0, 40}});
  const Document before = prism(corners);
  corners.erase(2);
  QVERIFY(!placeAfter(before, {70, 20, height / 2}, prism(corners)));
  for (const Vec3& place : {Vec3(60, 0, height / 2), Vec3(60, 40, height / 2), Vec3(0, 0, height / 2)})
    QVERIFY(isAt(placeAfter(before, place, prism(corners)), place));
}

// An arc and its chord: two edges stand between the same two faces.
void PartPiecesTest::twoEdgesBetweenTheSameSides() {
  const Document before = roundedBack({}), after = roundedBack({{25, 0}});
  for (const double x : {0.0, 60.0}) {
    const Vec3 place(x, 0, height / 2);
    QVERIFY(isAt(placeAfter(before, place, before), place));
    QVERIFY(isAt(placeAfter(before, place, after), place));
  }
}

// So that the window shows which one is lost, and the others by the numbers that they have now.
void PartPiecesTest::thoseThatAreNotLostGetTheirNumbers() {
  Corners corners({{0, 0}, {30, -8}, {60, 0}, {60, 40}, {0, 40}});
  const Vec3 gone(30, -8, height / 2), stays(60, 40, height / 2);
  const Value kept = keptEdges(prism(corners), {gone, stays});
  corners.erase(1);
  const Results results = evaluated(rounded(prism(corners), kept));
  const FeatureResult& fillet = *results.at("fillet");
  QVERIFY(fillet.error.has_value());
  QCOMPARE(fillet.lost, std::vector<Value>{kept.at(0)});
  const Value& edges = fillet.parts.at("edges");
  QCOMPARE(edges.at(0), kept.at(0));
  const Shape& solid = results.at("prism")->evaluated.shape;
  QVERIFY(isAt(likenessOf(solid, SubShapeKind::Edge, edges.at(1).at("index").get<int>()).place, stays));
}

BLOSSOM_TEST(PartPiecesTest)
#include "part_pieces_test.moc"
