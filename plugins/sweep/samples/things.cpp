#include <Eigen/Geometry>
#include <numbers>

#include "documents.h"
#include "sample_tree.h"

namespace blossom::sweep::samples {

namespace {

Value at(double u, double v) { return {{"u", u}, {"v", v}}; }
Value pullOf(double u, double v, const Vec3& to) { return {{"u", u}, {"v", v}, {"to", valueOf(to)}}; }

constexpr const char* byScaling = "scale";
Value pullBy(const char* way, Value pulls) {
  Value parameters = {{"pulls", std::move(pulls)}, {"translate", 0}, {"rotate", 0}, {"scale", 0}};
  parameters[way] = 1;
  return parameters;
}

/// A cone gets four corners at all heights, and is then turned by half a turn, evenly from the foot to the top.
SampleTree twistedTower(const App& app) {
  constexpr double foot = 18, top = 9, height = 110, corner = 1.3;
  constexpr int rows = 16;
  SampleTree tree(app);
  tree.begin("Cone",
             {{"kind", "cone"}, {"radius", foot}, {"top-radius", top}, {"height", height}, {"rows", rows}, {"columns", 1}});
  Value corners = Value::array();
  for (int k = 0; k <= 3; ++k) {
    const double v = k / 3.0;
    corners.push_back(pullOf(0, v, {corner * (foot + (top - foot) * v), 0, height * v}));
  }
  Value square = pullBy(byScaling, corners);
  square["fold"] = 4;
  tree.pull("Four corners", square);
  const auto around = [&](double v, double angle, Value pins) -> Value {
    return {{"places", Value::array({at(0, v)})},
            {"axis", valueOf(Vec3(0, 0, 1))},
            {"angle", angle},
            {"pins", std::move(pins)},
            {"fold", rows}};
  };
  tree.twist("Turn the top", around(1, 180, Value::array()));
  tree.twist("Even in between", around(0.5, 60, Value::array({at(0, 0), at(0, 1)})));
  tree.sweep("Tower");
  return tree;
}

/// One blade, swept back and twisted.
SampleTree bladeWithHub(const App& app) {
  constexpr double hub = 14, height = 40, reach = 110, back = 20 * std::numbers::pi / 180, pitch = -50;
  constexpr double u = 0.25, v = 0.5;
  const Vec3 middle(0, 0, height / 2), arm = Eigen::AngleAxisd(back, Vec3::UnitZ()) * Vec3(0, reach, 0);
  SampleTree tree(app);
  tree.begin("Hub", {{"kind", "cylinder"}, {"radius", hub}, {"height", height}, {"rows", 16}, {"columns", 12}});
  tree.pull("Pull out the blade", pullBy(byScaling, Value::array({pullOf(u, v, middle + Vec3(0, reach, 0))})));
  tree.pull("Sweep it back", pullBy("rotate", Value::array({pullOf(u, v, middle + arm)})));
  tree.twist("Twist it", {{"places", Value::array({at(u, v)})}, {"axis", valueOf(arm.normalized())}, {"angle", pitch}});
  tree.sweep("Blade with hub");
  return tree;
}

/// A strip of cloth: waves by the trajectory, and twists of whole sections.
SampleTree scarf(const App& app) {
  constexpr double width = 24, length = 150;
  SampleTree tree(app);
  tree.begin("Cloth", {{"kind", "plane"}, {"width", width}, {"height", length}, {"rows", 3}, {"columns", 12}});
  struct Wave {
    double v;
    Vec3 by;
  };
  int number = 0;
  for (const Wave& wave : {Wave{0.22, {6, 0, 26}}, Wave{0.5, {-10, 0, -22}}, Wave{0.78, {8, 0, 24}}}) {
    const Vec3 to = Vec3(0, length * (wave.v - 0.5), 0) + wave.by;
    tree.pull(("Wave " + std::to_string(++number)).c_str(), pullBy("translate", Value::array({pullOf(0.5, wave.v, to)})));
  }
  struct Turn {
    double v, angle;
  };
  number = 0;
  for (const Turn& turn : {Turn{0.36, 55}, Turn{0.64, -70}, Turn{1, 60}})
    tree.twist(("Twist " + std::to_string(++number)).c_str(),
               {{"places", Value::array({at(0, turn.v), at(0.5, turn.v), at(1, turn.v)})},
                {"axis", valueOf(Vec3(0, 1, 0))},
                {"angle", turn.angle}});
  tree.sweep("Scarf");
  return tree;
}

}  // namespace

void writeThings(const App& app, const std::filesystem::path& folder) {
  twistedTower(app).save(folder / "twisted-tower.blossom");
  bladeWithHub(app).save(folder / "blade-with-hub.blossom");
  scarf(app).save(folder / "scarf.blossom");
}

}  // namespace blossom::sweep::samples
