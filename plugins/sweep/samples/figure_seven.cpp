#include <Eigen/Geometry>
#include <array>
#include <numbers>
#include <string>

#include "documents.h"
#include "sample_tree.h"

namespace blossom::sweep::samples {

namespace {

constexpr double radius = 10, hubLength = 36, bladeReach = 62, bladePitch = 62, turnedUp = 35;
constexpr int rows = 16, columns = 14;
constexpr double degree = std::numbers::pi / 180, arrowHead = 5;
const Vec3 middle(0, 0, hubLength / 2);

/// Along a blade.
Vec3 outward(int blade) {
  const double angle = (45 + 90 * blade) * degree;
  return {std::cos(angle), std::sin(angle), 0};
}

/// Where a blade is pulled; its row of poles stands there.
double placeOf(int blade) { return (1 + 2 * blade) / 8.0; }

std::string numbered(const char* words, int blade) { return words + std::string(" ") + std::to_string(blade + 1); }

Vec3 tip(int blade) { return middle + bladeReach * outward(blade); }

/// A tip turned up about the middle, as seen from there.
Vec3 turnedTip(int blade) {
  return middle + bladeReach * (std::cos(turnedUp * degree) * outward(blade) + std::sin(turnedUp * degree) * Vec3::UnitZ());
}

void addCylinder(SampleTree& tree) {
  tree.begin("Cylinder",
             {{"kind", "cylinder"}, {"radius", radius}, {"height", hubLength}, {"rows", rows}, {"columns", columns}});
}

Value pullTo(int blade, const Vec3& to, double rotate, double scale) {
  const Value pull = {{"u", placeOf(blade)}, {"v", 0.5}, {"to", valueOf(to)}};
  return {{"pulls", Value::array({pull})}, {"translate", 0}, {"rotate", rotate}, {"scale", scale}};
}

/// Four drags by scaling alone.
void addBlades(SampleTree& tree) {
  for (int blade = 0; blade < 4; ++blade)
    tree.pull(numbered("Pull out blade", blade).c_str(), pullTo(blade, tip(blade), 0, 1));
}

void addTwists(SampleTree& tree) {
  for (int blade = 0; blade < 4; ++blade) {
    const Value place = {{"u", placeOf(blade)}, {"v", 0.5}};
    const Vec3 axis = std::sqrt(2.0) * outward(blade);
    tree.twist(numbered("Twist blade", blade).c_str(),
               {{"places", Value::array({place})}, {"axis", valueOf(axis)}, {"angle", bladePitch}});
  }
}

/// Two opposite blades are turned up, which keeps their distance from the axis.
constexpr std::array<int, 2> turnedBlades{0, 2};

/// Where an axis ends that sticks out of a tip.
Vec3 axisEnd(int blade) { return tip(blade) + 14 * outward(blade); }

/// Three quarters of a turn about an axis, the way its blade is twisted.
std::vector<Vec3> turnAbout(int blade) {
  constexpr double turnRadius = 8, from = -135, to = 135, step = 15;
  const Vec3 side = Vec3::UnitZ().cross(outward(blade));
  std::vector<Vec3> points;
  for (double angle = from; angle <= to; angle += step)
    points.push_back(axisEnd(blade) +
                     turnRadius * (std::cos(angle * degree) * side + std::sin(angle * degree) * Vec3::UnitZ()));
  return points;
}

}  // namespace

void writeFigureSeven(const App& app, const std::filesystem::path& folder) {
  SampleTree hub(app);
  addCylinder(hub);
  SampleTree blades = hub;
  addBlades(blades);

  SampleTree drags = hub;
  drags.sweep("Cylinder");
  for (int blade = 0; blade < 4; ++blade)
    drags.arrow(numbered("Drag", blade).c_str(), {middle + radius * outward(blade), tip(blade)}, arrowHead);
  drags.save(folder / "propeller-a-drags.blossom");

  SampleTree pulled = blades;
  pulled.sweep("Four blades");
  pulled.save(folder / "propeller-b-blades.blossom");

  SampleTree toTurn = blades, tips = blades;
  toTurn.sweep("Four blades");
  for (const int blade : turnedBlades) {
    toTurn.arrow(numbered("Drag", blade).c_str(), {tip(blade), turnedTip(blade)}, arrowHead);
    tips.pull(numbered("Turn up blade", blade).c_str(), pullTo(blade, turnedTip(blade), 1, 0));
  }
  toTurn.save(folder / "propeller-c-turns.blossom");
  tips.sweep("Two blades turned up");
  tips.save(folder / "propeller-d-turned.blossom");

  SampleTree axes = blades, twisted = blades;
  axes.sweep("Four blades");
  for (int blade = 0; blade < 4; ++blade) {
    axes.line(numbered("Axis", blade).c_str(), {tip(blade), axisEnd(blade)});
    axes.arrow(numbered("Turn", blade).c_str(), turnAbout(blade), arrowHead);
  }
  axes.save(folder / "propeller-e-axes.blossom");
  addTwists(twisted);
  SampleTree growing = twisted;
  twisted.sweep("Propeller");
  twisted.save(folder / "propeller-f-twisted.blossom");

  constexpr int framesOfEdit = 3, edits = 8, cells = 10;  // tips need finer cells than most
  growing.grow("Cylinder to propeller", framesOfEdit * edits + 1, cells);
  growing.save(folder / "propeller-growing.blossom");
}

}  // namespace blossom::sweep::samples
