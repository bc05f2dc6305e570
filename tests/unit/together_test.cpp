#include "geometry/occt/merged_shape.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>

#include "geometry/measure/measure.h"
#include "support/support.h"

using namespace blossom;

namespace {

Mesh tetrahedronAt(double x) {
  Mesh mesh;
  mesh.points = {{x, 0, 0}, {x + 1, 0, 0}, {x, 1, 0}, {x, 0, 1}};
  for (const auto& face : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{0, 3, 2}})
    mesh.addFace(face);
  return mesh;
}

Region squareRegion(double x, double size) {
  Region region;
  Path path;
  path.closed = true;
  const Vec2 corners[] = {{x, 0}, {x + size, 0}, {x + size, size}, {x, size}};
  for (int i = 0; i < 4; ++i) path.segments.emplace_back(Line2{corners[i], corners[(i + 1) % 4]});
  region.loops.push_back(path);
  return region;
}

double measureOf(const Shape& shape, const std::string& name) {
  for (const Measure& each : measure(shape, Progress::none()).values)
    if (each.name == name)
      return std::holds_alternative<double>(each.value) ? std::get<double>(each.value)
                                                        : static_cast<double>(std::get<std::int64_t>(each.value));
  return -1;
}

}  // namespace

class TogetherTest : public QObject {
  Q_OBJECT
 private slots:
  void aSingleShapeStaysWhatItIs();
  void aSingleSolidWithoutANameIsGivenOne();
  void meshesAreMeasuredAsTheirSum();
  void solidsBecomeAnAssemblyWithNames();
  void drawingsKeepEveryPath();
  void drawingsBesideSolidsHaveAnExactForm();
  void meshesBesideSolidsAreRefused();
};

void TogetherTest::aSingleShapeStaysWhatItIs() {
  const Shape region = squareRegion(0, 2);
  QCOMPARE(mergedShape({{"a", region}}).kind(), ShapeKind::Region);
  QCOMPARE(mergedKind({ShapeKind::Motion}), ShapeKind::Motion);
}

void TogetherTest::aSingleSolidWithoutANameIsGivenOne() {
  const auto nameOf = [](const Shape& shape) { return shape.get<Brep>()->roots().front().name; };
  const TopoDS_Shape box = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  const Shape computed = mergedShape({{"Tube", Brep(box)}});
  QCOMPARE(nameOf(computed), std::string("Tube"));
  QVERIFY(computed.get<Brep>()->shape().IsSame(box));
  QCOMPARE(nameOf(mergedShape({{"Import", Brep(box, "Box")}})), std::string("Box"));
  Mesh mesh = tetrahedronAt(0);
  QCOMPARE(mergedShape({{"Sum", mesh}}).get<Mesh>()->name, std::string("Sum"));
  mesh.name = "Part 7";
  QCOMPARE(mergedShape({{"Sum", mesh}}).get<Mesh>()->name, std::string("Part 7"));
  const Shape frames = mergedShape({{"Melt", Sequence{{tetrahedronAt(0), tetrahedronAt(1)}, {0, 1}}}});
  for (const Shape& frame : frames.get<Sequence>()->frames) QCOMPARE(frame.get<Mesh>()->name, std::string("Melt"));
}

void TogetherTest::meshesAreMeasuredAsTheirSum() {
  const Shape all = mergedShape({{"a", tetrahedronAt(0)}, {"b", tetrahedronAt(5)}, {"c", tetrahedronAt(9)}});
  COMPARE_NEAR(measureOf(all, "volume"), 3.0 / 6, 1e-12);
  QCOMPARE(all.get<Mesh>()->faceCount(), std::size_t(12));
  COMPARE_NEAR(measureOf(all, "components"), 3, 0);
}

void TogetherTest::solidsBecomeAnAssemblyWithNames() {
  const Shape all = mergedShape({{"Box", Brep(BRepPrimAPI_MakeBox(1, 2, 3).Shape())},
                                 {"Ball", Brep(BRepPrimAPI_MakeSphere(gp_Pnt(20, 0, 0), 2).Shape())}});
  COMPARE_NEAR(measureOf(all, "volume"), 6 + 32 * M_PI / 3, 1e-9);
  QCOMPARE(all.get<Brep>()->roots().size(), std::size_t(2));
  QCOMPARE(all.get<Brep>()->roots()[1].name, std::string("Ball"));
}

void TogetherTest::drawingsKeepEveryPath() {
  Curves open;
  open.paths.push_back({{Line2{{0, 0}, {3, 4}}}, false, {}, {}});
  const Shape all = mergedShape({{"a", squareRegion(0, 2)}, {"b", open}});
  QCOMPARE(all.kind(), ShapeKind::Curves);
  COMPARE_NEAR(measureOf(all, "length"), 8 + 5, 1e-12);
}

void TogetherTest::drawingsBesideSolidsHaveAnExactForm() {
  const Shape all = mergedShape({{"a", squareRegion(10, 2)}, {"b", Brep(BRepPrimAPI_MakeBox(1, 1, 1).Shape())}});
  QCOMPARE(all.kind(), ShapeKind::Brep);
  COMPARE_NEAR(measureOf(all, "area"), 4 + 6, 1e-9);
}

void TogetherTest::meshesBesideSolidsAreRefused() {
  QCOMPARE(mergedKind({ShapeKind::Mesh, ShapeKind::Brep}), ShapeKind::None);
  VERIFY_ERROR(mergedShape({{"a", tetrahedronAt(0)}, {"b", Brep(BRepPrimAPI_MakeBox(1, 1, 1).Shape())}}),
               ErrorCode::InvalidInput);
}

BLOSSOM_TEST(TogetherTest)
#include "together_test.moc"
