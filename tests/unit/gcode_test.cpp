#include "core/file.h"

#include <numbers>

#include "exchange/formats.h"
#include "geometry/planar/planar.h"
#include "support/support.h"

using namespace blossom;

namespace {

Imported readProgram(const std::string& text) {
  const TemporaryFolder folder;
  const auto file = folder.path() / "program.ngc";
  writeAtomically(file, text);
  return readShape(standardFormats(), file);
}

}  // namespace

class GcodeTest final : public QObject {
  Q_OBJECT
 private slots:
  void fullCircleIsOneClosedArc() {
    const Imported imported = readProgram("G21 G0 X5 Y0\nG3 X5 Y0 I-5 J0 (a circle)\nG0 X0 Y0\nM2\n");
    const auto& paths = imported.shape.get<Curves>()->paths;
    QCOMPARE(paths.size(), std::size_t(1));
    QVERIFY(paths[0].closed);
    COMPARE_NEAR(signedArea(paths[0]), std::numbers::pi * 25, 1e-12);
    QCOMPARE(imported.entities.at("G3").get<int>(), 1);
    QCOMPARE(imported.entities.at("G0").get<int>(), 2);
  }

  void radiusFormTakesTheShortArcAndTheLongOne() {
    // a chord of 2 in a circle of radius sqrt(2): a quarter, or the other three
    const auto lengthOf = [](const char* r) {
      const Imported imported = readProgram(std::string("G0 X0 Y0\nG2 X2 Y0 R") + r + "\n");
      return length(imported.shape.get<Curves>()->paths.at(0));
    };
    const double circle = 2 * std::numbers::pi * std::sqrt(2.0);
    COMPARE_NEAR(lengthOf("1.4142135623730951"), circle / 4, 1e-7);
    COMPARE_NEAR(lengthOf("-1.4142135623730951"), circle * 3 / 4, 1e-7);
  }

  void clockwiseArcsSweepNegatively() {
    const Imported imported = readProgram("G0 X1 Y0\nG2 X0 Y-1 I-1 J0\n");
    COMPARE_NEAR(std::get<Arc2>(imported.shape.get<Curves>()->paths.at(0).segments.at(0)).sweep, -std::numbers::pi / 2,
                 1e-12);
  }

  void inchesAndIncrementsAreUnderstood() {
    const Imported imported = readProgram("G20 G91\nG1 X1\nG1 Y1\nG1 X-1\nG1 Y-1\n");
    const Path& square = imported.shape.get<Curves>()->paths.at(0);
    QVERIFY(square.closed);
    COMPARE_NEAR(signedArea(square), 25.4 * 25.4, 1e-9);
  }

  void nurbsStartsWhereTheToolIs() {
    const Imported imported = readProgram("G0 X0 Y1\nG1 Z0 F100\nG5.2 X0 Y1 P1 L3\n X1 Y1 P1\n X1 Y0 P2\nG5.3\n");
    const auto& spline = std::get<Spline2>(imported.shape.get<Curves>()->paths.at(0).segments.at(0));
    QCOMPARE(spline.degree, 2);
    QCOMPARE(spline.poles.size(), std::size_t(4));
    QCOMPARE(spline.poles.front(), Vec3(0, 1, 1));
    QCOMPARE(spline.poles.back(), Vec3(2, 0, 2));
  }

  void rubbishNamesTheLine() {
    try {
      readProgram("G0 X0\nG1 Xhello\n");
      QFAIL("read without complaint");
    } catch (const Error& error) {
      QCOMPARE(error.code(), ErrorCode::FormatDamaged);
      QVERIFY(error.message().find("Line 2") != std::string::npos);
    }
    VERIFY_ERROR(readProgram("(nothing here)\n"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readProgram("G1 X1\nG2 X9 Y9 R1\n"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readProgram("X1 Y1\n"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readProgram("G1 X[1+1]\n"), ErrorCode::FormatDamaged);
  }
};

BLOSSOM_TEST(GcodeTest)
#include "gcode_test.moc"
