#include "support/modeling.h"
#include "support/polyhedra.h"
#include "support/regions.h"

using namespace blossom;
using namespace blossom::test;

namespace {

Mesh unitCube() { return cuboid({0, 0, 0}, {1, 1, 1}); }

Mesh withoutFace(const Mesh& mesh, std::size_t left) {
  Mesh result;
  result.points = mesh.points;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    if (f != left) result.addFace(mesh.face(f));
  return result;
}

Mesh open() { return movedBy(withoutFace(unitCube(), 1), {10, 20, 30}); }
Mesh twisted() {
  Mesh mesh = withoutFace(unitCube(), 1);
  mesh.addFace(std::array{6, 7, 5, 4});
  return mesh;
}
Mesh doubled() {
  Mesh mesh = unitCube();
  mesh.addFace(std::array{0, 2, 3, 1});
  return mesh;
}
Mesh selfCrossing() { return prism({{0, 0}, {3, 3}, {3, 0}, {0, 2}}, 0, 1); }
Mesh notNumbers() {
  Mesh mesh = unitCube();
  mesh.points[3].y() = std::nan("");
  return mesh;
}
Mesh farAway() { return movedBy(unitCube(), {2e9, 0, 0}); }
/// Closed, but a sheet that goes there and back.
Mesh flattened() {
  Mesh mesh = unitCube();
  for (Vec3& p : mesh.points) p.z() = 0;
  return mesh;
}

struct Rubbish {
  const char* name;
  Mesh mesh;
  ErrorCode code;
  std::string words;
};

std::vector<Rubbish> allRubbish() {
  return {{"empty", Mesh(), ErrorCode::InvalidInput, "is empty"},
          {"open", open(), ErrorCode::InvalidInput, "is open: an edge near ("},
          {"twisted", twisted(), ErrorCode::InvalidInput, "is twisted: two faces near ("},
          {"doubled face", doubled(), ErrorCode::InvalidInput, "3 faces meet in an edge near ("},
          {"self-crossing", selfCrossing(), ErrorCode::InvalidInput, "crosses or touches itself near ("},
          {"not numbers", notNumbers(), ErrorCode::InvalidInput, "a coordinate of point 4 is not a number"},
          {"far away", farAway(), ErrorCode::LimitExceeded, "farther than 1e9 mm"},
          {"flattened", flattened(), ErrorCode::InvalidInput, "encloses no volume"}};
}

}  // namespace

/// Every feature refuses rubbish with a sentence that names the place and the remedy.
class MorphologyRefusalTest : public QObject {
  Q_OBJECT

 private slots:
  void everyFeatureRefusesRubbish() {
    int refused = 0;
    for (const Rubbish& rubbish : allRubbish()) {
      for (const char* command : {"solid-sum", "solid-difference", "solid-open", "solid-close", "solid-morph"}) {
        for (const bool first : {true, false}) {
          if (!first && std::string(rubbish.name) == "empty") continue;  // points are an element
          const std::vector<Shape> inputs =
              first ? std::vector<Shape>{rubbish.mesh, unitCube()} : std::vector<Shape>{unitCube(), rubbish.mesh};
          verifyRefused(refusal(command, Value::object(), inputs), rubbish, first ? "first" : "second");
          ++refused;
        }
      }
      for (const char* command : {"inflate", "melt"}) {
        verifyRefused(refusal(command, Value::object(), {rubbish.mesh}), rubbish, "The solid");
        ++refused;
      }
    }
    qInfo("figure refusals %d", refused);
  }

  // Places are named in the coordinates of the file, not in those of the computation.
  void thePlaceIsTheOneInTheFile() {
    const Error error = refusal("melt", Value::object(), {open()});
    VERIFY_REFUSED(error, ErrorCode::InvalidInput, "31)");
  }

  /// Two squares of a drawing: where they lap, the fill rule decides; what is taken is their union, or nothing at all.
  void drawingsAreTakenAsTheirFillRuleSays() {
    const auto drawing = [](const Vec2& second, FillRule rule, bool turned) {
      const Path other = rectanglePath(second, second + Vec2(4, 4));
      return Shape(Curves{{rectanglePath({0, 0}, {4, 4}), turned ? reversed(other) : other}, rule});
    };
    const auto sum = [&](const Shape& flat) { return made("solid-sum", Value::object(), {unitCube(), flat}); };
    for (const auto rule : {FillRule::EvenOdd, FillRule::NonZero}) {
      COMPARE_NEAR(volume(sum(drawing({4, 4}, rule, false))), 25 + 25 - 1, 1e-12);  // corner to corner
      COMPARE_NEAR(volume(sum(drawing({4, 0}, rule, false))), 9 * 5, 1e-12);        // side to side
      COMPARE_NEAR(volume(sum(drawing({2, 1}, FillRule::NonZero, false))), 25 + 25 - 3 * 4, 1e-12);
    }
    for (const Shape& lapped : {drawing({2, 1}, FillRule::EvenOdd, false), drawing({2, 1}, FillRule::NonZero, true)})
      VERIFY_REFUSED(refusal("solid-sum", Value::object(), {unitCube(), lapped}), ErrorCode::InvalidInput,
                     "The second shape has outlines that cross near (");
  }

  void whatHasNoVolumeIsNoSolid() {
    const Shape flat = rectangle(0, 0, 2, 2);
    for (const char* command : {"solid-difference", "solid-open", "solid-close"})
      QVERIFY(refusal(command, Value::object(), {unitCube(), Mesh()}).code() == ErrorCode::InvalidInput);
    VERIFY_REFUSED(refusal("solid-sum", Value::object(), {flat, flat}), ErrorCode::Degenerate, "no volume");
    VERIFY_REFUSED(refusal("melt", {{"radius", 3}}, {unitCube()}), ErrorCode::Degenerate, "Nothing is left of the solid");
    VERIFY_REFUSED(refusal("solid-difference", Value::object(), {unitCube(), cuboid({0, 0, 0}, {2, 2, 2})}),
                   ErrorCode::Degenerate, "Nothing is left of the first shape");
  }

  void whatCanBeMendedIsMended() {
    const Evaluated turned = made("solid-sum", Value::object(), {insideOut(unitCube()), unitCube()});
    COMPARE_NEAR(volume(turned), 8, 1e-12);
    QCOMPARE(turned.warnings.size(), std::size_t{1});
    QVERIFY(turned.warnings.front().find("inside out") != std::string::npos);
    const Evaluated overlapping =
        made("solid-sum", Value::object(), {together(unitCube(), movedBy(unitCube(), {0.5, 0, 0})), unitCube()});
    COMPARE_NEAR(volume(overlapping), 2.5 * 4, 1e-12);
    QVERIFY(overlapping.warnings.size() == 1);
    // Each shell by where it lies: the sign of all volumes together tells nothing of one of them.
    const Mesh large = cuboid({0, 0, 0}, {10, 10, 10}), small = cuboid({20, 0, 0}, {24, 4, 4});
    const Mesh hollow = together(large, insideOut(cuboid({3, 3, 3}, {7, 7, 7})));
    const Evaluated beside = made("solid-sum", Value::object(), {together(large, insideOut(small)), unitCube()});
    COMPARE_NEAR(volume(beside), 11.0 * 11 * 11 + 5 * 5 * 5, 1e-9);
    QCOMPARE(beside.warnings.size(), std::size_t{1});
    QVERIFY(beside.warnings.front().find("has a body near (2") != std::string::npos);
    const Evaluated apart = made("solid-sum", Value::object(), {together(small, insideOut(hollow)), unitCube()});
    COMPARE_NEAR(volume(apart), 11.0 * 11 * 11 - 3 * 3 * 3 + 5 * 5 * 5, 1e-9);
    QCOMPARE(apart.warnings.size(), std::size_t{2});
    const Evaluated hollowTurned = made("solid-sum", Value::object(), {insideOut(hollow), unitCube()});
    COMPARE_NEAR(volume(hollowTurned), 11.0 * 11 * 11 - 3 * 3 * 3, 1e-9);
    QCOMPARE(hollowTurned.warnings.size(), std::size_t{1});
    QVERIFY(made("solid-sum", Value::object(), {hollow, unitCube()}).warnings.empty());
    // Points that several faces have of their own, as STL writes them.
    Mesh soup;
    const Mesh cube = triangulated(unitCube()).first;
    for (std::size_t f = 0; f < cube.faceCount(); ++f) {
      const int from = static_cast<int>(soup.points.size());
      for (const Vec3& p : facePoints(cube, f)) soup.points.push_back(p);
      soup.addFace(std::array{from, from + 1, from + 2});
    }
    COMPARE_NEAR(volume(made("inflate", {{"radius", 0.1}}, {soup})), volumeWithCuboid(icosphere(0.1), {1, 1, 1}), 1e-12);
  }

 private:
  static Mesh icosphere(double radius) { return *made("ball", {{"radius", radius}, {"subdivisions", 1}}).shape.get<Mesh>(); }
  static void verifyRefused(const Error& error, const Rubbish& rubbish, const std::string& which) {
    const std::string text = std::string(rubbish.name) + ": " + error.what();
    QVERIFY2(error.code() == rubbish.code, text.c_str());
    QVERIFY2(error.message().find(rubbish.words) != std::string::npos, text.c_str());
    // What is no number is refused before the feature is asked, by the name of the input.
    const bool named = error.message().find(which) != std::string::npos || error.message().starts_with("The input \"");
    QVERIFY2(named, text.c_str());
    QVERIFY2(!error.hint().empty(), text.c_str());
  }
};

BLOSSOM_TEST(MorphologyRefusalTest)
#include "morphology_refusal_test.moc"
