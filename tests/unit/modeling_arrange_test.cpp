
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

Mesh tetrahedron() {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
  for (const auto& face : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{0, 3, 2}})
    mesh.addFace(face);
  return mesh;
}

Value anyTransform(std::mt19937_64& random, bool similar) {
  std::uniform_real_distribution<double> any(-20, 20), factor(0.5, 2);
  const auto three = [&] { return Value::array({any(random), any(random), any(random)}); };
  Value p{{"move", three()}, {"axis", three()}, {"centre", three()}, {"angle", 10 * any(random)}, {"scale", factor(random)}};
  if (!similar) p["stretch"] = Value::array({factor(random), factor(random), factor(random)});
  return p;
}

double volumeFactor(const Value& p) {
  double factor = std::pow(p.at("scale").get<double>(), 3);
  if (p.contains("stretch"))
    for (const Value& each : p.at("stretch")) factor *= each.get<double>();
  return factor;
}

}  // namespace

class ModelingArrangeTest : public QObject {
  Q_OBJECT

 private slots:
  void volumesGrowWithTheDeterminant() {
    auto random = seededRandom();
    const Shape solid = made("boolean", {{"operation", "difference"}}, {made("box").shape, made("sphere").shape}).shape;
    for (int i = 0; i < 8; ++i) {
      const Value p = anyTransform(random, i < 4);
      const Evaluated moved = made("transform", p, {solid});
      QVERIFY(isSound(moved));
      COMPARE_NEAR(volume(moved), figure(solid, "volume") * volumeFactor(p), 1e-5 * volume(moved));
      const Evaluated mesh = made("transform", p, {tetrahedron()});
      COMPARE_NEAR(volume(mesh), volumeFactor(p) / 6, 1e-9 * volumeFactor(p));
    }
  }

  void reflectionsKeepFacesOutward() {
    const Evaluated mirrored = made("transform", {{"stretch", {-1, 1, 1}}}, {made("cone").shape});
    QVERIFY(isSound(mirrored));
    COMPARE_NEAR(volume(made("transform", {{"stretch", {1, 1, -1}}}, {tetrahedron()})), 1.0 / 6, 1e-12);
  }

  void theCentreStays() {
    const Evaluated grown = made("transform", {{"centre", {40, 30, 20}}, {"scale", 2}}, {made("box").shape});
    const Bounds b = bounds(grown.shape);
    QVERIFY((b.high - Vec3(40, 30, 20)).norm() < 1e-6);
    QVERIFY((b.low - Vec3(-40, -30, -20)).norm() < 1e-6);
  }

  void turnsGoCounterClockwise() {
    const Evaluated turned = made("transform", {{"angle", 90}}, {rectangle(1, 0, 3, 1)});
    const Bounds b = bounds(turned.shape);
    QVERIFY((b.low - Vec3(-1, 1, 0)).norm() < 1e-9);
    QVERIFY((b.high - Vec3(0, 3, 0)).norm() < 1e-9);
  }

  void regionsStayFlatWhileTheyCan() {
    Region plate = rectangle(0, 0, 10, 10);
    plate.loops.push_back(circle({5, 5}, 2, true));
    const Evaluated flat = made("transform", {{"move", {3, 4, 0}}, {"angle", 30}, {"scale", 2}}, {plate});
    QVERIFY(flat.shape.get<Region>());
    COMPARE_NEAR(area(*flat.shape.get<Region>()), 4 * (100 - 4 * pi), 1e-9);
    const Evaluated mirrored = made("transform", {{"stretch", {-1, 1, 1}}}, {plate});
    COMPARE_NEAR(area(*mirrored.shape.get<Region>()), 100 - 4 * pi, 1e-9);
    const Evaluated lifted = made("transform", {{"move", {0, 0, 5}}}, {plate});
    QVERIFY(lifted.shape.get<Brep>());
    COMPARE_NEAR(figure(lifted.shape, "area"), 100 - 4 * pi, 1e-9);
  }

  void curvesKeepTheirLength() {
    auto random = seededRandom();
    Value p = anyTransform(random, true);
    p["scale"] = 1;
    const Curve curve{2, {0, 0, 0, 1, 1, 1}, {{1, 0, 0, 1}, {0.7, 0.7, 0, 0.7}, {0, 1, 0, 1}}};
    COMPARE_NEAR(figure(made("transform", p, {curve}).shape, "length"), figure(curve, "length"), 1e-9);
    const Curves drawn{{polygon({{0, 0}, {3, 4}}, false)}, FillRule::EvenOdd};
    COMPARE_NEAR(figure(made("transform", p, {drawn}).shape, "length"), 5, 1e-9);
  }

  void assembliesKeepNamesAndColours() {
    const auto part =
        std::make_shared<BrepPart>(BrepPart{"Bolt", Color{0, 1, 0}, made("cylinder").shape.get<Brep>()->shape(), {}, {}});
    const Brep assembly(std::vector<BrepInstance>{{"Bolt 1", {}, gp_Trsf(), part}});
    for (const double scale : {1.0, 2.0}) {
      const Evaluated moved = made("transform", {{"move", {1, 2, 3}}, {"scale", scale}}, {assembly});
      const auto& root = moved.shape.get<Brep>()->roots().front();
      QCOMPARE(root.name, std::string("Bolt 1"));
      QCOMPARE(root.part->name, std::string("Bolt"));
      QVERIFY(root.part->color == part->color);
      QCOMPARE(root.part == part, scale == 1.0);
    }
  }

  void whatIsFlattenedIsRefused() {
    VERIFY_REFUSED(refusal("transform", {{"stretch", {1, 1, 0}}}, {made("box").shape}), ErrorCode::Degenerate, "flattens");
    VERIFY_REFUSED(refusal("transform", {{"angle", 10}, {"axis", {0, 0, 0}}}, {made("box").shape}),
                   ErrorCode::InvalidParameter, "axis");
  }

  void rowsOfCopies() {
    const Shape pin = made("cylinder", {{"radius", 2}, {"height", 5}}).shape;
    const Evaluated grid =
        made("pattern", {{"count", 4}, {"step", {10, 0, 0}}, {"second-count", 3}, {"second-step", {0, 8, 0}}}, {pin});
    COMPARE_NEAR(volume(grid), 12 * 20 * pi, 1e-8);
    COMPARE_NEAR(figure(grid.shape, "components"), 12, 0);
    QCOMPARE(grid.stats["copies"], Value(12));
    const Bounds b = bounds(grid.shape);
    COMPARE_NEAR(b.high.x() - b.low.x(), 34, 1e-5);
    COMPARE_NEAR(b.high.y() - b.low.y(), 20, 1e-5);
  }

  void copiesShareTheirPart() {
    const Evaluated row = made("pattern", {{"count", 5}}, {made("box").shape});
    const auto& roots = row.shape.get<Brep>()->roots();
    QCOMPARE(roots.size(), std::size_t{5});
    for (const BrepInstance& root : roots) QCOMPARE(root.part, roots.front().part);
  }

  void roundAnAxis() {
    const Region hole{{circle({10, 0}, 1)}};
    const Evaluated full = made("pattern", {{"kind", "circular"}, {"count", 6}}, {hole});
    COMPARE_NEAR(area(*full.shape.get<Region>()), 6 * pi, 1e-9);
    QVERIFY(bounds(full.shape).center().norm() < 1e-6);
    const Evaluated part = made("pattern", {{"kind", "circular"}, {"count", 3}, {"angle", 90}}, {hole});
    COMPARE_NEAR(bounds(part.shape).high.y(), 11, 1e-9);
    COMPARE_NEAR(bounds(part.shape).low.x(), -1, 1e-9);
  }

  void fieldsOfTheOtherKindDoNotCount() {
    const Region hole{{circle({10, 0}, 1)}};
    Value ring{{"kind", "circular"}, {"count", 12}}, row{{"count", 4}};
    const Bounds round = bounds(made("pattern", ring, {hole}).shape), straight = bounds(made("pattern", row, {hole}).shape);
    ring.update({{"step", {3, 4, 5}}, {"second-count", 1000}, {"second-step", {1, 1, 1}}});
    row.update({{"axis", {0, 0, 0}}, {"centre", {9, 9, 9}}, {"angle", 1}});  // no direction: a circular one is refused
    const Evaluated around = made("pattern", ring, {hole}), along = made("pattern", row, {hole});
    QCOMPARE(around.stats["copies"], Value(12));
    QVERIFY(bounds(around.shape).low == round.low && bounds(around.shape).high == round.high);
    QVERIFY(bounds(along.shape).low == straight.low && bounds(along.shape).high == straight.high);
  }

  void copiesThatOverlapAreJoined() {
    const Shape bar = made("box", {{"width", 10}, {"depth", 2}, {"height", 2}}).shape;
    const Evaluated joined = made("pattern", {{"count", 3}, {"step", {8, 0, 0}}, {"join", true}}, {bar});
    QVERIFY(isSound(joined));
    COMPARE_NEAR(volume(joined), 4 * 26, 1e-8);
    COMPARE_NEAR(figure(joined.shape, "faces"), 6, 0);
    const Evaluated region = made("pattern", {{"count", 3}, {"step", {8, 0, 0}}}, {rectangle(0, 0, 10, 2)});
    COMPARE_NEAR(area(*region.shape.get<Region>()), 52, 1e-9);
    VERIFY_REFUSED(refusal("pattern", {{"join", true}}, {tetrahedron()}), ErrorCode::InvalidInput,
                   "Only solids and regions");
    VERIFY_REFUSED(refusal("pattern", {{"count", 1000}, {"second-count", 1000}}, {bar}), ErrorCode::LimitExceeded, "10000");
  }

  void mirrorImages() {
    const Shape half = made("box", {{"width", 10}, {"depth", 4}, {"height", 3}}).shape;
    const Evaluated whole = made("mirror", {{"join", true}}, {half});
    QVERIFY(isSound(whole));
    COMPARE_NEAR(volume(whole), 240, 1e-8);
    COMPARE_NEAR(bounds(whole.shape).low.x(), -10, 1e-6);
    const Evaluated image = made("mirror", {{"keep", false}, {"point", {0, 0, 5}}, {"normal", {0, 0, 2}}}, {half});
    QVERIFY(isSound(image));
    COMPARE_NEAR(bounds(image.shape).high.z(), 10, 1e-6);
    const Evaluated mesh = made("mirror", {{"point", {-1, 0, 0}}}, {tetrahedron()});
    COMPARE_NEAR(volume(mesh), 2.0 / 6, 1e-12);
    const Evaluated region = made("mirror", {{"normal", {0, 1, 0}}}, {rectangle(0, 0, 4, 2)});
    COMPARE_NEAR(area(*region.shape.get<Region>()), 16, 1e-9);
    QCOMPARE(region.shape.get<Region>()->loops.size(), std::size_t{1});
  }

  void aMirrorTwiceIsTheIdentity() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> any(-5, 5);
    const Value plane{
        {"point", {any(random), any(random), any(random)}}, {"normal", {any(random), any(random), 6}}, {"keep", false}};
    const Shape once = made("mirror", plane, {tetrahedron()}).shape;
    const Shape twice = made("mirror", plane, {once}).shape;
    for (std::size_t i = 0; i < 4; ++i) QVERIFY((twice.get<Mesh>()->points[i] - tetrahedron().points[i]).norm() < 1e-12);
  }
};

BLOSSOM_TEST(ModelingArrangeTest)
#include "modeling_arrange_test.moc"
