/// Closed meshes, as files and sums of solids are, where solids are taken.
#include "geometry/mesh/mesh_topology.h"
#include "support/modeling.h"
#include "support/polyhedra.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

/// As STL has it.
Mesh inTriangles(const Mesh& mesh) { return triangulated(mesh).first; }

}  // namespace

class ModelingMeshTest : public QObject {
  Q_OBJECT

 private slots:
  void planarFacesAreOne() {
    const Evaluated solid = made("mesh-solid", {}, {inTriangles(cuboid({1, 2, 3}, {5, 5, 5}))});
    QVERIFY(isSound(solid));
    COMPARE_NEAR(figure(solid.shape, "faces"), 6, 0);
    COMPARE_NEAR(figure(solid.shape, "edges"), 12, 0);
    COMPARE_NEAR(volume(solid), 4 * 3 * 2, 1e-9);
  }

  /// As OBJ and PLY often have it: each face has corners of its own.
  void cornersMayBeWrittenForEachFace() {
    const Mesh cube = cuboid({0, 0, 0}, {2, 2, 2});
    Mesh apart;
    for (std::size_t f = 0; f < cube.faceCount(); ++f) {
      std::vector<int> face;
      for (const int v : cube.face(f)) {
        face.push_back(static_cast<int>(apart.points.size()));
        apart.points.push_back(cube.points[static_cast<std::size_t>(v)]);
      }
      apart.addFace(face);
    }
    COMPARE_NEAR(volume(made("mesh-solid", {}, {apart})), 8, 1e-9);
  }

  void anySolidKeepsItsVolume() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 8; ++round) {
      const Mesh mesh = inTriangles(turnedBy(round % 2 ? lBlock() : spikyCube(random, 20), randomTurn(random)));
      const Evaluated solid = made("mesh-solid", {}, {mesh});
      QVERIFY(isSound(solid));
      COMPARE_NEAR(volume(solid), signedVolume(mesh), 1e-9 * signedVolume(mesh));
    }
    const Mesh hollow = together(cuboid({0, 0, 0}, {4, 4, 4}), insideOut(cuboid({1, 1, 1}, {2, 2, 2})));
    COMPARE_NEAR(volume(made("mesh-solid", {}, {hollow})), 63, 1e-9);
  }

  void meshesAreCutAndRounded() {
    const double a = 34, b = 24, c = 14, r = 3;
    const Mesh block = inTriangles(cuboid({0, 0, 0}, {a + 2 * r, b + 2 * r, c + 2 * r}));
    const Evaluated rounded = made("fillet", {{"radius", r}}, {block});
    const double steiner = a * b * c + 2 * r * (a * b + b * c + c * a) + pi * r * r * (a + b + c) + 4 * pi / 3 * r * r * r;
    QVERIFY(isSound(rounded));
    COMPARE_NEAR(volume(rounded), steiner, 1e-5 * steiner);

    const Shape pin = made("cylinder", {{"radius", 5}, {"height", 100}, {"position", {20, 15, -10}}}).shape;
    const double whole = signedVolume(block), height = c + 2 * r;
    const Evaluated drilled = made("boolean", {{"operation", "difference"}}, {block, pin});
    QVERIFY(isSound(drilled));
    COMPARE_NEAR(volume(drilled), whole - pi * 25 * height, 1e-6 * whole);
    COMPARE_NEAR(volume(made("boolean", {{"operation", "union"}}, {block, movedBy(block, {40, 0, 0})})), 2 * whole,
                 1e-6 * whole);
    COMPARE_NEAR(volume(made("chamfer", {{"distance", 1}}, {block})),
                 volume(made("chamfer", {{"distance", 1}}, {made("mesh-solid", {}, {block}).shape})), 1e-9 * whole);
    COMPARE_NEAR(volume(made("shell", {{"thickness", 1}}, {block})), whole - (a + 4) * (b + 4) * (c + 4), 1e-6 * whole);
  }

  void whatBoundsNoSolidIsRefused() {
    Mesh open = inTriangles(cuboid({0, 0, 0}, {1, 1, 1}));
    Mesh lidless;
    lidless.points = open.points;
    for (std::size_t f = 1; f < open.faceCount(); ++f) lidless.addFace(open.face(f));
    const Error error = refusal("mesh-solid", {}, {lidless});
    QVERIFY2(error.code() == ErrorCode::InvalidInput && std::string(error.message()).find("near (") != std::string::npos,
             error.message().c_str());
    const Error crossing = refusal("mesh-solid", {}, {together(open, movedBy(open, {0.5, 0.25, 0.125}))});
    QVERIFY2(std::string(crossing.message()).find("crosses itself near (") != std::string::npos, crossing.message().c_str());
    const Value picked{{"edges", {{{"input", "shape"}, {"kind", "edge"}, {"index", 0}}}}};
    QVERIFY(std::string(refusal("fillet", picked, {open}).hint()).find("Solid from mesh") != std::string::npos);
    QCOMPARE(refusal("boolean", {}, {open, made("rectangle").shape}).code(), ErrorCode::InvalidInput);
  }
};

BLOSSOM_TEST(ModelingMeshTest)
#include "modeling_mesh_test.moc"
