#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>

#include "support/modeling.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

Value edge(int index) { return {{"input", "shape"}, {"kind", "edge"}, {"index", index}}; }
Value face(int index) { return {{"input", "shape"}, {"kind", "face"}, {"index", index}}; }

Shape box(double a, double b, double c) { return made("box", {{"width", a}, {"depth", b}, {"height", c}}).shape; }

/// Length of edge k of a shape whose edges are straight.
double edgeLength(const Shape& shape, int index) {
  TopTools_IndexedMapOfShape edges;
  TopExp::MapShapes(shape.get<Brep>()->shape(), TopAbs_EDGE, edges);
  return figure(Shape(Brep(edges(index + 1))), "length");
}

/// Faces of a box: which one lies in the plane x_axis = value?
int faceAt(const Shape& shape, int axis, double value) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape.get<Brep>()->shape(), TopAbs_FACE, faces);
  for (int i = 1; i <= faces.Extent(); ++i) {
    const Bounds b = bounds(Brep(faces(i)));
    if (std::abs(b.low[axis] - value) < 1e-5 && std::abs(b.high[axis] - value) < 1e-5) return i - 1;
  }
  return -1;
}

}  // namespace

class ModelingFilletTest : public QObject {
  Q_OBJECT

 private slots:
  void oneEdgeLosesACorner() {
    const Shape block = box(40, 30, 20);
    for (const int index : {0, 5, 11}) {
      const Evaluated rounded = made("fillet", {{"edges", {edge(index)}}, {"radius", 3}}, {block});
      QVERIFY(isSound(rounded));
      COMPARE_NEAR(volume(rounded), 24000 - (1 - pi / 4) * 9 * edgeLength(block, index), 1e-7);
      QCOMPARE(rounded.stats["rounded_edges"], Value(1));
      const Evaluated cut = made("chamfer", {{"edges", {edge(index)}}, {"distance", 3}}, {block});
      QVERIFY(isSound(cut));
      COMPARE_NEAR(volume(cut), 24000 - 4.5 * edgeLength(block, index), 1e-7);
    }
  }

  void aBoxRoundedAllOverIsASumWithABall() {
    const double a = 34, b = 24, c = 14, r = 3;  // of the box inside, to which Steiner's formula adds
    const Evaluated rounded = made("fillet", {{"radius", r}}, {box(a + 2 * r, b + 2 * r, c + 2 * r)});
    QVERIFY(isSound(rounded));
    QCOMPARE(rounded.stats["rounded_edges"], Value(12));
    const double steiner = a * b * c + 2 * r * (a * b + b * c + c * a) + pi * r * r * (a + b + c) + 4 * pi / 3 * r * r * r;
    COMPARE_NEAR(volume(rounded), steiner, 1e-5 * steiner);
    COMPARE_NEAR(figure(rounded.shape, "faces"), 26, 0);
    COMPARE_NEAR(figure(rounded.shape, "genus"), 0, 0);
  }

  void aChamferMayBeUneven() {
    const Shape block = box(40, 30, 20);
    const Evaluated cut = made("chamfer", {{"edges", {edge(0)}}, {"distance", 2}, {"second", 5}}, {block});
    COMPARE_NEAR(volume(cut), 24000 - 5 * edgeLength(block, 0), 1e-7);
  }

  void roundEdgesOfACylinder() {
    const Evaluated rounded = made("fillet", {{"radius", 2}}, {made("cylinder", {{"radius", 10}, {"height", 30}}).shape});
    QVERIFY(isSound(rounded));
    QCOMPARE(rounded.stats["rounded_edges"], Value(2));
    // Pappus: the square of the corner less the quarter disc, both about the axis.
    const double square = 4, disc = pi, squareAt = 9, discAt = 8 + 8 / (3 * pi);
    COMPARE_NEAR(volume(rounded), 3000 * pi - 2 * 2 * pi * (square * squareAt - disc * discAt), 1e-6);
  }

  void theLargestRadiusIsToldAndWorks() {
    const Shape block = box(40, 30, 20);
    const Error error = refusal("fillet", {{"edges", {edge(3)}}, {"radius", 25}}, {block});
    VERIFY_REFUSED(error, ErrorCode::InvalidInput, "Edge 3 cannot be rounded with 25 mm: the largest radius here is about ");
    const double told = std::stod(error.message().substr(error.message().find("about ") + 6));
    QVERIFY2(told > 0.99 * 20 && told <= 20, error.what());
    QVERIFY(isSound(made("fillet", {{"edges", {edge(3)}}, {"radius", told}}, {block})));
  }

  void ofManyEdgesTheLargestForAllIsTold() {
    const Shape block = box(40, 30, 20);
    for (const auto& [command, size] : {std::pair{"fillet", "radius"}, std::pair{"chamfer", "distance"}}) {
      const Error error = refusal(command, {{size, 15}}, {block});
      QCOMPARE(error.code(), ErrorCode::InvalidInput);
      const auto at = error.message().find("about ");
      QVERIFY2(at != std::string::npos, error.what());
      const double told = std::stod(error.message().substr(at + 6));
      QVERIFY2(told > 0.99 * 10 && told <= 10, error.what());
      QVERIFY(isSound(made(command, {{size, told}}, {block})));
    }
  }

  void edgesThatCannotBeRoundedAreRefused() {
    const Shape block = box(40, 30, 20);
    VERIFY_REFUSED(refusal("fillet", {{"edges", {edge(12)}}}, {block}), ErrorCode::NotFound,
                   "The shape has 12 edges; edge 12 is not among them.");
    const Evaluated rounded = made("fillet", {{"edges", {edge(0)}}, {"radius", 3}}, {block});
    bool smoothFound = false;
    for (int index = 0; index < static_cast<int>(figure(rounded.shape, "edges")); ++index) {
      const Error error = refusal("fillet", {{"edges", {edge(index)}}, {"radius", 0.1}}, {rounded.shape});
      smoothFound = smoothFound || error.message().find("meet smoothly") != std::string::npos;
    }
    QVERIFY(smoothFound);
    VERIFY_REFUSED(refusal("fillet", {}, {made("sphere").shape}), ErrorCode::InvalidInput, "no edge");
    const Shape sheet = made("extrude", {{"solid", false}}, {rectangle(0, 0, 9, 9)}).shape;
    VERIFY_REFUSED(refusal("fillet", {}, {sheet}), ErrorCode::InvalidInput, "edges of a solid");
    VERIFY_REFUSED(refusal("fillet", {{"radius", 0}}, {block}), ErrorCode::InvalidParameter, "radius");
  }

  void anOpenBoxHasWallsInside() {
    const Shape block = box(40, 30, 20);
    const Evaluated tray = made("shell", {{"faces", {face(faceAt(block, 2, 20))}}, {"thickness", 2}}, {block});
    QVERIFY(isSound(tray));
    COMPARE_NEAR(volume(tray), 24000 - 36 * 26 * 18, 1e-7);
    const Evaluated tube =
        made("shell", {{"faces", {face(faceAt(block, 2, 20)), face(faceAt(block, 2, 0))}}, {"thickness", 2}}, {block});
    QVERIFY(isSound(tube));
    COMPARE_NEAR(volume(tube), 20 * (1200 - 36 * 26), 1e-7);
    COMPARE_NEAR(figure(tube.shape, "genus"), 1, 0);
  }

  void wallsMayGrowOutside() {
    const Shape block = box(40, 30, 20);
    const Evaluated tray =
        made("shell", {{"faces", {face(faceAt(block, 2, 20))}}, {"thickness", 2}, {"side", "outside"}}, {block});
    QVERIFY(isSound(tray));
    COMPARE_NEAR(volume(tray), 44 * 34 * 22 - 24000, 1e-6);
  }

  void aClosedHollow() {
    const Evaluated hollow = made("shell", {{"thickness", 2}}, {box(40, 30, 20)});
    QVERIFY(isSound(hollow));
    COMPARE_NEAR(volume(hollow), 24000 - 36 * 26 * 16, 1e-7);
    const Evaluated ball = made("shell", {{"thickness", 2}, {"side", "outside"}}, {made("sphere", {{"radius", 10}}).shape});
    QVERIFY(isSound(ball));
    COMPARE_NEAR(volume(ball), 4 * pi / 3 * (1728 - 1000), 1e-6);
  }

  void wallsThatAreTooThickAreRefused() {
    const Shape block = box(40, 30, 20);
    const Value top = face(faceAt(block, 2, 20));
    const Error error = refusal("shell", {{"faces", {top}}, {"thickness", 16}}, {block});
    VERIFY_REFUSED(error, ErrorCode::InvalidInput, "thickest possible are about ");
    const double told = std::stod(error.message().substr(error.message().find("about ") + 6));
    QVERIFY2(told > 0.99 * 15 && told <= 15, error.what());
    VERIFY_REFUSED(refusal("shell", {{"faces", {face(6)}}}, {block}), ErrorCode::NotFound, "6 faces");
    VERIFY_REFUSED(refusal("shell", {{"faces", {face(0), face(1), face(2), face(3), face(4), face(5)}}}, {block}),
                   ErrorCode::InvalidInput, "no wall is left");
  }
};

BLOSSOM_TEST(ModelingFilletTest)
#include "modeling_fillet_test.moc"
