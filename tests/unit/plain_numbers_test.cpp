#include "core/file.h"
#include "exchange/formats.h"
#include "geometry/bspline/bspline.h"
#include "geometry/planar/planar.h"
#include "support/support.h"

using namespace blossom;

namespace {

Imported readNamed(const std::string& name, const std::string& text, const Value& options = Value::object()) {
  const TemporaryFolder folder;
  const auto file = folder.path() / name;
  writeAtomically(file, text);
  return readShape(standardFormats(), file, options);
}

}  // namespace

/// Control points, polygons and segments written as plain numbers.
class PlainNumbersTest final : public QObject {
  Q_OBJECT
 private slots:
  void pointsAlongALineMakeThatLine() {
    const Imported imported = readNamed("line.cpt", "\"x\",\"y\",\"z\"\n0,0,0\n1,2,3\n2,4,6\n3,6,9\n");
    const Curve& curve = *imported.shape.get<Curve>();
    QCOMPARE(curve.degree, 3);
    for (const double t : {0.0, 0.2, 0.7, 1.0}) QVERIFY((point(curve, t) - 3 * t * Vec3(1, 2, 3)).norm() < 1e-14);
  }

  void weightsAreMultipliedIn() {
    const Imported imported = readNamed("arc.cptw", "1,0,0,1\n0.5,0.5,0,0.5\n0,2,0,2\n", {{"degree-u", 2}});
    const Curve& curve = *imported.shape.get<Curve>();
    QVERIFY((point(curve, 0) - Vec3(1, 0, 0)).norm() < 1e-15);
    QVERIFY((point(curve, 1) - Vec3(0, 1, 0)).norm() < 1e-15);
  }

  void rowsMakeASurface() {
    const Imported imported = readNamed("plane.cpt", "0,0,0;0,1,0;0,2,0\n1,0,0;1,1,0;1,2,0\n");
    const Surface& surface = *imported.shape.get<Surface>();
    QCOMPARE(surface.degreeU, 1);
    QCOMPARE(surface.degreeV, 2);
    QVERIFY((point(surface, 0.25, 0.5) - Vec3(0.25, 1, 0)).norm() < 1e-15);
    QCOMPARE(imported.entities.at("control point").get<int>(), 6);
  }

  void segmentsWithAndWithoutPoints() {
    QCOMPARE(readNamed("a.txt", "2\n0 0 1 0\n1 0 1 1\n").shape.get<Curves>()->paths.size(), std::size_t(2));
    const Imported withPoints = readNamed("b.txt", "1\n5 5\n1\n0 0 3 4\n");
    COMPARE_NEAR(length(withPoints.shape.get<Curves>()->paths.at(0)), 5, 1e-15);
    QCOMPARE(withPoints.skipped.at("point").get<int>(), 1);
  }

  void captionedPolygonsAreClosed() {
    const Imported imported =
        readNamed("c.txt", "CAPTION: 1.\nCLIPTYPE: UNION\nSUBJECTS\n0,0, 4,0, 4,3\nCLIPS\n0,0, 1,0, 1,1\n");
    const auto& paths = imported.shape.get<Curves>()->paths;
    QCOMPARE(paths.size(), std::size_t(2));
    COMPARE_NEAR(signedArea(paths[0]), 6, 1e-14);
  }

  void rubbishIsRefused() {
    VERIFY_ERROR(readNamed("a.cpt", "1,2\n3,4\n"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readNamed("a.cpt", "1,2,3\n"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readNamed("a.cpt", "1,2,3;4,5,6\n1,2,3\n"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readNamed("a.cptw", "1,2,3,0\n1,2,3,1\n"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readNamed("a.txt", "3\n0 0 1 1\n"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readNamed("a.txt", "hello"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readNamed("a.txt", "1e300 4 4"), ErrorCode::FormatDamaged);
  }
};

BLOSSOM_TEST(PlainNumbersTest)
#include "plain_numbers_test.moc"
