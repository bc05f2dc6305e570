#include <Eigen/Geometry>
#include <numbers>

#include "documents.h"
#include "geometry/bspline/bspline.h"
#include "kernel/begin/primitive_motions.h"
#include "kernel/grid/motion_point.h"
#include "kernel/quaternion.h"
#include "sample_tree.h"
#include "samples.h"

namespace blossom::sweep::samples {

namespace {

constexpr double rightAngle = std::numbers::pi / 2;

/// Fig. 1: the frame at one place of the trajectory, and its y and z axes as u goes from 0 to 1.
SampleTree movingFrame(const App& app, const std::filesystem::path& folder) {
  constexpr double v = 0.5;
  constexpr int fans = 16;
  const Motion motion = sweptPoint();
  const Vec3 centre = blossom::point(motion.trajectory, v);
  const auto axis = [&](double u, Eigen::Index k) -> Vec3 {
    const Vec4 r = blossom::evaluate(motion.orientation, u, v), s = blossom::evaluate(motion.scaling, u, v);
    return centre + turned(r, s[k] / s[3] * Vec3::Unit(k));
  };
  SampleTree tree(app);
  tree.import(folder / "swept-point.json", "Motion");
  tree.line("Frame at u = 0", {axis(0, 0), centre, axis(0, 1), centre, axis(0, 2)});
  for (const Eigen::Index k : {1, 2}) {
    std::vector<Vec3> fan{centre};
    for (int i = 0; i <= fans; ++i) {
      fan.push_back(axis(static_cast<double>(i) / fans, k));
      if (i % 2 == 0) fan.insert(fan.end(), {centre, fan.back()});
    }
    tree.line(k == 1 ? "Its y axis along u" : "Its z axis along u", fan);
  }
  return tree;
}

/// The bent tube that is pulled in Figs. 3 to 6, and a place on top of it. It stands beside the pulled one.
constexpr double bend = 45, section = 10;
constexpr MotionPlace onTop{0.25, 0.5};
const Vec3 aside(0, -75, 0);

struct Tube {
  explicit Tube(const App& app) : tree(app) {
    const PrimitiveOptions options{
        .kind = PrimitiveKind::Tube, .radius = bend, .profile = section, .angle = 150, .rows = 8, .columns = 5};
    const Motion motion = primitiveMotion(options).motion;
    centre = blossom::point(motion.trajectory, onTop.v);
    start = evaluate(motion, onTop.u, onTop.v).point;
    outward = centre.normalized();
    tree.begin("Tube", {{"kind", "tube"},
                        {"radius", options.radius},
                        {"profile", options.profile},
                        {"angle", options.angle},
                        {"rows", options.rows},
                        {"columns", options.columns}});
    tree.move(tree.sweep("Tube"), "Tube before the drag", aside);
  }
  /// The place after a turn about the direction outward, by a share of a right angle, seen from the trajectory.
  [[nodiscard]] Vec3 turned(double share) const {
    return centre + Eigen::AngleAxisd(share * rightAngle, outward) * (start - centre);
  }
  void pull(const char* name, const Vec3& to, double translate, double rotate, double scale) {
    const Value one = {{"u", onTop.u}, {"v", onTop.v}, {"to", valueOf(to)}};
    tree.pull(name, {{"pulls", Value::array({one})}, {"translate", translate}, {"rotate", rotate}, {"scale", scale}});
    tree.sweep("Pulled tube");
    tree.arrow("Drag", {start + aside, to + aside}, 3);
  }

  SampleTree tree;
  Vec3 centre, start, outward;
};

/// Fig. 3: the trajectory takes whole sections along.
SampleTree pulledTrajectory(const App& app) {
  Tube tube(app);
  tube.pull("Move the trajectory", tube.start + 12 * tube.outward + 12 * Vec3::UnitZ(), 1, 0, 0);
  return tube.tree;
}

/// Fig. 4: scaling changes what is near the place.
SampleTree pulledScaling(const App& app) {
  Tube tube(app);
  tube.pull("Scale", tube.centre + 2.6 * (tube.start - tube.centre), 0, 0, 1);
  return tube.tree;
}

/// Fig. 5: a drag is a turn about the trajectory and a way along the new arm.
SampleTree dragInTwoParts(const App& app) {
  constexpr double share = 0.5, longer = 2.4;
  constexpr int steps = 12;
  Tube tube(app);
  const Vec3 half = tube.turned(share), to = tube.centre + longer * (half - tube.centre);
  tube.pull("Turn and scale", to, 0, 1, 1);
  std::vector<Vec3> arc;
  for (int i = 0; i <= steps; ++i) arc.push_back(tube.turned(share * i / steps) + aside);
  tube.tree.curve("Turn", arc);
  tube.tree.line("Scaling", {half + aside, to + aside});
  tube.tree.line("Arms", {tube.start + aside, tube.centre + aside, half + aside});
  return tube.tree;
}

/// Fig. 6: turning alone.
SampleTree pulledOrientation(const App& app) {
  Tube tube(app);
  tube.pull("Turn", tube.turned(2.0 / 3), 0, 1, 0);
  return tube.tree;
}

}  // namespace

void writeFigures(const App& app, const std::filesystem::path& folder) {
  movingFrame(app, folder).save(folder / "moving-frame.blossom");
  pulledTrajectory(app).save(folder / "pulled-trajectory.blossom");
  pulledScaling(app).save(folder / "pulled-scaling.blossom");
  dragInTwoParts(app).save(folder / "drag-in-two-parts.blossom");
  pulledOrientation(app).save(folder / "pulled-orientation.blossom");
}

}  // namespace blossom::sweep::samples
