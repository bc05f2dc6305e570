/// What the warnings of a sweep say, and in what order.
#include <cmath>
#include <numbers>

#include "geometry/shape/motion.h"
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// A coil about z whose layers pass through each other on their way to the middle, and all of which end in one point of the
/// axis, at the end of v.
Motion pointedCoil(double end) {
  constexpr int rows = 9;
  std::vector<double> knots{0};
  for (int i = 0; i < rows; ++i) knots.push_back(i);
  knots.push_back(rows - 1);
  Motion motion;
  motion.point = Vec3(1, 0, 0);
  motion.trajectory = {1, {0, 0, end, end}, {Vec4(0, 0, 0, 1), Vec4(0, 0, 20, 1)}};
  motion.orientation = {1, 1, knots, {0, 0, end, end}, {}};
  motion.scaling = {1, 1, knots, {0, 0, end / 2, end, end}, {}};
  for (int i = 0; i < rows; ++i) {
    const double half = i * std::numbers::pi / 6;
    motion.orientation.poles.insert(motion.orientation.poles.end(), 2, Vec4(std::cos(half), 0, 0, std::sin(half)));
    for (const double factor : {10 + i / 6.0, 10 - i / 6.0, 0.0})
      motion.scaling.poles.emplace_back(factor, factor, factor, 1);
  }
  validate(motion);
  return motion;
}

}  // namespace

class SweepWarningsTest : public QObject {
  Q_OBJECT
 private slots:
  void theWorstIsToldFirst() {
    const Evaluated swept = made("sweep", {}, {pointedCoil(1)});
    QCOMPARE(swept.warnings.size(), std::size_t{2});
    QVERIFY2(swept.warnings[0].starts_with("The surface crosses itself near ("), swept.warnings[0].c_str());
    QVERIFY2(swept.warnings[1].starts_with("The surface has no normal near u = "), swept.warnings[1].c_str());
  }

  void placesAreToldInFourDigits() {
    constexpr double end = 0.6175850365689627;
    const Evaluated swept = made("sweep", {}, {pointedCoil(end)});
    QVERIFY2(swept.warnings.back().find(", v = 0.6176: it runs into a point") != std::string::npos,
             swept.warnings.back().c_str());

    // One trajectory cannot leave the plane of the sections by scaling alone.
    const Value pull{
        {"pulls", {{{"u", 1.2367299199104309}, {"v", end / 3}, {"to", {3, 4, 19}}}}}, {"rotate", 0.0}, {"scale", 1.0}};
    const Evaluated pulled = made("sweep-pull", pull, {pointedCoil(end)});
    QCOMPARE(pulled.warnings.size(), std::size_t{1});
    QVERIFY2(pulled.warnings[0].starts_with("At u = 1.237, v = 0.2059, "), pulled.warnings[0].c_str());
  }
};

BLOSSOM_TEST(SweepWarningsTest)
#include "sweep_warnings_test.moc"
