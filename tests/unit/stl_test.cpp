#include <Eigen/Geometry>
#include <cstring>

#include "exchange/format/export_shape.h"
#include "geometry/mesh/mesh_topology.h"
#include "support/exchange.h"

using namespace blossom;
using namespace blossom::test;

namespace {

std::string facet(const std::string& a, const std::string& b, const std::string& c) {
  return "facet normal 0 0 0\n outer loop\n  vertex " + a + "\n  vertex " + b + "\n  vertex " + c + "\n endloop\nendfacet\n";
}

const std::string asciiTetrahedron = "solid four\n" + facet("0 0 0", "0 1 0", "1 0 0") + facet("0 0 0", "1 0 0", "0 0 1") +
                                     facet("0 0 0", "0 0 1", "0 1 0") + facet("1 0 0", "0 1 0", "0 0 1") + "endsolid four\n";

Mesh cube() {
  Mesh mesh;
  for (int i = 0; i < 8; ++i) mesh.points.emplace_back(i & 1, i >> 1 & 1, i >> 2);
  for (const auto& f : {std::array{0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}})
    mesh.addFace(f);
  return mesh;
}

/// Divergence theorem over a fan of each face.
double enclosedVolume(const Mesh& mesh) {
  double six = 0;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto v = mesh.face(f);
    const auto p = [&](std::size_t i) { return mesh.points[static_cast<std::size_t>(v[i])]; };
    for (std::size_t i = 1; i + 1 < v.size(); ++i) six += p(0).dot(p(i).cross(p(i + 1)));
  }
  return six / 6;
}

}  // namespace

class StlTest : public QObject {
  Q_OBJECT

 private slots:
  void equalCornersBecomeOneVertex() {
    const Imported imported = readText(asciiTetrahedron, "stl");
    const Mesh& mesh = *imported.shape.get<Mesh>();
    QCOMPARE(mesh.points.size(), std::size_t(4));
    QCOMPARE(mesh.faceCount(), std::size_t(4));
    QCOMPARE(imported.entities, (Value{{"facet", 4}}));
    QCOMPARE(mesh.name, std::string("four"));
    COMPARE_NEAR(enclosedVolume(mesh), 1.0 / 6, 1e-15);
  }

  void keepsFacetsWithoutArea() {
    const Imported imported =
        readText("solid\n" + facet("0 0 0", "0 0 0", "1 0 0") + facet("-0 0 0", "0 1 0", "1 0 0") + "endsolid\n", "stl");
    QCOMPARE(imported.shape.get<Mesh>()->faceCount(), std::size_t(2));
    QCOMPARE(imported.shape.get<Mesh>()->points.size(), std::size_t(3));
    QCOMPARE(imported.warnings.size(), std::size_t(1));
  }

  void binaryThatBeginsWithSolidIsBinary() {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a.stl";
    writeShape(formats(), cube(), path);
    std::string bytes = readFile(path);
    QCOMPARE(bytes.size(), std::size_t(84 + 50 * 12));
    std::memcpy(bytes.data(), "solid facet normal", 18);
    writeText(path, bytes);
    COMPARE_NEAR(enclosedVolume(*readShape(formats(), path).shape.get<Mesh>()), 1, 1e-12);
  }

  void roundTripKeepsVolumeAndFaces() {
    for (const bool ascii : {false, true}) {
      const Imported imported = roundTrip(cube(), "stl", {{"ascii", ascii}});
      const Mesh& mesh = *imported.shape.get<Mesh>();
      QCOMPARE(mesh.faceCount(), std::size_t(12));
      QCOMPARE(mesh.points.size(), std::size_t(8));
      COMPARE_NEAR(enclosedVolume(mesh), 1, 1e-12);
    }
  }

  /// A sliver whose corners fall together in single precision leaves no facet that would join what only touches there.
  void collapsedTrianglesAreLeftOut() {
    Mesh mesh;
    for (const double x : {0.0, 1e-12}) mesh.points.emplace_back(x + 100, 0, 0);
    mesh.points.emplace_back(100, 1, 0);
    mesh.points.emplace_back(101, 0, 0);
    mesh.points.emplace_back(100, 0, 1);
    // A tetrahedron with a corner split in two: six triangles, two of them without width.
    for (const auto& f : {std::array{0, 2, 1}, {1, 2, 3}, {0, 1, 4}, {1, 3, 4}, {0, 4, 2}, {2, 4, 3}}) mesh.addFace(f);
    COMPARE_NEAR(enclosedVolume(mesh), 1.0 / 6, 1e-9);
    const Mesh coarse = *roundTrip(mesh, "stl", {{"ascii", false}}).shape.get<Mesh>();
    QCOMPARE(coarse.faceCount(), std::size_t(4));
    QVERIFY(meshTopology(coarse).closed());
    QCOMPARE(meshTopology(coarse).components.size(), std::size_t(1));
    COMPARE_NEAR(enclosedVolume(coarse), 1.0 / 6, 1e-5);
    QCOMPARE(roundTrip(mesh, "stl", {{"ascii", true}}).shape.get<Mesh>()->faceCount(), std::size_t(6));
  }

  void trianglesWithoutAreaAreNoFile() {
    Mesh flat;
    flat.points = {{0, 0, 0}, {1, 0, 0}, {1, 0, 0}};
    flat.addFace(std::array{0, 1, 2});
    const TemporaryFolder folder;
    for (const bool ascii : {false, true})
      VERIFY_ERROR(writeShape(formats(), flat, folder.path() / "flat.stl", {{"ascii", ascii}}),
                   ErrorCode::OutputNotSupported);
  }

  void shapesFarFromTheOriginAreWarnedOf() {
    const TemporaryFolder folder;
    for (const double away : {0.0, 100.0, 1e4, 1e6, 1e7}) {
      Mesh moved = cube();
      for (Vec3& p : moved.points) p += away / 7 * Vec3(3, 5, 7);
      for (const bool ascii : {false, true}) {
        const fs::path file = folder.path() / "far.stl";
        const ExportReport report = exportShape(formats(), moved, file, {{"ascii", ascii}}, false);
        const double error = std::abs(signedVolume(triangulated(*readShape(formats(), file).shape.get<Mesh>()).first) - 1);
        QCOMPARE(report.warnings.size(), std::size_t(!ascii && away > 1e3 ? 1 : 0));
        if (report.warnings.empty()) QVERIFY2(error < 1e-4 + 1e-8 * away, qPrintable(QString::number(error)));
      }
    }
  }

  void refusesDamage_data() {
    QTest::addColumn<QByteArray>("text");
    const auto row = [](const char* name, const std::string& text) {
      QTest::newRow(name) << QByteArray::fromStdString(text);
    };
    row("no end", asciiTetrahedron.substr(0, asciiTetrahedron.size() - 15));
    row("in a facet", asciiTetrahedron.substr(0, 60));
    row("two corners", "solid\nfacet normal 0 0 1\nvertex 0 0 0\nvertex 1 0 0\nendfacet\nendsolid\n");
    row("four corners",
        "solid\nfacet normal 0 0 1\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 0 0\nvertex 1 0 0\nendfacet\nendsolid\n");
    row("no facets", "solid\nendsolid\n");
    row("nan", "solid\n" + facet("nan 0 0", "0 1 0", "1 0 0") + "endsolid\n");
    row("prose", "solid as a rock, it stands here and is no STL file at all, though it is long enough for a binary header.");
    row("huge count", std::string(80, ' ') + std::string("\xff\xff\xff\xff", 4) + std::string(50, '\0'));
    row("no room for a facet", std::string(80, ' ') + std::string("\x01\0\0\0", 4));
  }
  void refusesDamage() {
    QFETCH(QByteArray, text);
    VERIFY_ERROR(readText(text.toStdString(), "stl"), ErrorCode::FormatDamaged);
  }
};

BLOSSOM_TEST(StlTest)
#include "stl_test.moc"
