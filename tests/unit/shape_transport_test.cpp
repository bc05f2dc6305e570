// What goes to another process comes back as it was: numbers, names, colours and layers.
#include "transport/shape_transport.h"

#include <BRepPrimAPI_MakeBox.hxx>
#include <cmath>
#include <numbers>

#include "core/file.h"
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// The value travels as text.
Shape thereAndBack(const Shape& shape) {
  const TemporaryFolder folder;
  const Value value = Value::parse(saveShape(shape, folder.path(), "shape").dump());
  return loadShape(value, folder.path());
}

template <class T>
bool survives(const T& value) {
  const Shape after = thereAndBack(value);
  return after.get<T>() && *after.get<T>() == value;
}

/// A line, an arc and a rational spline, with numbers that have no short decimal form.
std::vector<Path> drawnPaths() {
  Path open;
  open.layer = "Kontur \"außen\"";
  open.color = Color{1.0 / 3, 0, 1};
  open.segments = {Line2{{0.1, 1.0 / 3}, {std::numbers::pi, 0}}, Arc2{{1e-300, -0.0}, 1 / 7.0, 0.3, -2.1},
                   Spline2{2, {0, 0, 0, 1, 1, 1}, {{0, 0, 1}, {std::sqrt(0.5), 0.2, std::sqrt(0.5)}, {1, 1, 1}}}};
  Path closed;
  closed.closed = true;
  closed.segments = {Arc2{{0, 0}, 5, 0, 2 * std::numbers::pi}};
  return {open, closed};
}

Mesh colouredMesh() {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1.0 / 3, 0, 0}, {0, 1, 1e-17}, {1, 1, 0}};
  mesh.addFace(std::vector<int>{0, 1, 3, 2});
  mesh.creases = {{0, 1, 2.5}};
  mesh.corners = {{3, 10}};
  mesh.otherTags = {"t hole 1/0/0 0"};
  mesh.name = "Dach";
  mesh.color = Color{0.2, 0.4, 0.6};
  mesh.flatFaces = true;
  return mesh;
}

Curve someCurve() { return {1, {0, 0, 1, 1}, {{0, 0, 0, 1}, {0.1, 0.2, 0.3, 0.7}}}; }

Surface someSurface() {
  return {1, 1, {0, 0, 1, 1}, {0, 0, 1, 1}, {{0, 0, 0, 1}, {1, 0, 0, 1}, {0, 1.0 / 3, 0, 1}, {1, 1, 0.1, 0.9}}};
}

Region layeredStar(int points, double outer, double inner, const char* layer) {
  std::vector<Vec2> corners;
  for (int k = 0; k < 2 * points; ++k) {
    const double angle = k * std::numbers::pi / points, radius = k % 2 ? inner : outer;
    corners.emplace_back(radius * std::cos(angle), radius * std::sin(angle));
  }
  Region star{{polygon(corners)}};
  star.loops[0].layer = layer;
  star.loops[0].color = Color{0, 0.5, 1};
  return star;
}

}  // namespace

class ShapeTransportTest : public QObject {
  Q_OBJECT

 private slots:
  void drawingsKeepLayersAndColours() {
    QVERIFY(survives(Region{drawnPaths()}));
    for (const FillRule rule : {FillRule::NonZero, FillRule::EvenOdd}) QVERIFY(survives(Curves{drawnPaths(), rule}));
  }

  void meshesKeepNameColourAndTags() {
    QVERIFY(survives(colouredMesh()));
    QVERIFY(survives(Mesh()));
  }

  void splinesAndMotionsAreExact() {
    QVERIFY(survives(someCurve()));
    QVERIFY(survives(someSurface()));
    QVERIFY(survives(Motion{someCurve(), someSurface(), someSurface(), ClosedU::AntiPeriodic, {0.1, 0.2, 0.3}}));
  }

  void solidsKeepNameAndColour() {
    const Shape after = thereAndBack(Brep(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "Klötzchen", Color{0.1, 0.2, 0.3}));
    const Brep* brep = after.get<Brep>();
    QVERIFY(brep && brep->roots().size() == 1);
    QCOMPARE(brep->roots()[0].name, std::string("Klötzchen"));
    QVERIFY((brep->roots()[0].part->color == Color{0.1, 0.2, 0.3}));
  }

  /// Frames of several kinds, each with files of its own.
  void sequencesKeepTheirFrames() {
    Mesh other = colouredMesh();
    other.name = "Keller";
    const Shape after = thereAndBack(Sequence{{colouredMesh(), other, Region{drawnPaths()}}, {0, 0.1, 1}});
    const auto* sequence = after.get<Sequence>();
    QVERIFY(sequence && sequence->times == std::vector<double>({0, 0.1, 1}));
    QVERIFY(*sequence->frames.at(0).get<Mesh>() == colouredMesh());
    QVERIFY(*sequence->frames.at(1).get<Mesh>() == other);
    QVERIFY(*sequence->frames.at(2).get<Region>() == Region{drawnPaths()});
  }

  /// A morph too long for this process: its ends are the shapes drawn.
  void evaluationsInAChildKeepLayersAndColours() {
    const Evaluated morph = made("morph", {{"frames", 3}}, {layeredStar(300, 50, 10, "A"), layeredStar(301, 40, 8, "B")});
    QVERIFY(morph.stats.contains("worker_ms"));
    const auto* sequence = morph.shape.get<Sequence>();
    QVERIFY(sequence && sequence->frames.size() == 3);
    QVERIFY(*sequence->frames.front().get<Region>() == layeredStar(300, 50, 10, "A"));
    QVERIFY(*sequence->frames.back().get<Region>() == layeredStar(301, 40, 8, "B"));
  }

  /// What OCCT makes has no name: that of the first solid it was made of.
  void aSolidMadeInAChildHasNameAndColourOfTheFirst() {
    const auto named = [](const char* command, const char* name, const Color& color) {
      return Brep(made(command).shape.get<Brep>()->shape(), name, color);
    };
    const Evaluated both =
        made("boolean", Value::object(), {named("box", "Plate", {1, 0, 0}), named("sphere", "Ball", {0, 1, 0})});
    QVERIFY(both.stats.contains("worker_ms"));
    const auto& roots = both.shape.get<Brep>()->roots();
    QCOMPARE(roots.size(), std::size_t{1});
    QCOMPARE(roots[0].name, std::string("Plate"));
    QVERIFY((roots[0].part->color == Color{1, 0, 0}));
  }

  void otherKindsAreRefused() {
    const TemporaryFolder folder;
    Toolpath measuring;
    measuring.gougeOf = [](const Toolpath&, const Progress&) { return 0.0; };  // a function, which no file holds
    for (const Shape& shape : {Shape(), Shape(measuring), Shape(Brep())})
      VERIFY_ERROR(saveShape(shape, folder.path(), "shape"), ErrorCode::InvalidInput);
  }

  void damagedFilesAreAnError() {
    const TemporaryFolder folder;
    const Value value = saveShape(colouredMesh(), folder.path(), "shape");
    fs::resize_file(folder.path() / "shape.mesh", 20);
    VERIFY_ERROR(loadShape(value, folder.path()), ErrorCode::Internal);
  }
};

BLOSSOM_TEST(ShapeTransportTest)
#include "shape_transport_test.moc"
