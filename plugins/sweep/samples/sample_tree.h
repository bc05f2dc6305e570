#pragma once
#include <Eigen/Geometry>
#include <cmath>
#include <vector>

#include "app/sample_maker.h"
#include "core/vector.h"

namespace blossom::sweep::samples {

/// Numbers that can be read in a panel.
inline double readable(double value) {
  constexpr double digits = 1e10;
  const double rounded = std::round(value * digits) / digits;
  return rounded == 0 ? 0 : rounded;  // no -0
}
inline Value valueOf(const Vec3& p) { return {readable(p.x()), readable(p.y()), readable(p.z())}; }
inline Value valueOf(const std::vector<Vec3>& points) {
  Value list = Value::array();
  for (const Vec3& p : points) list.push_back(valueOf(p));
  return list;
}

/// A document under construction whose motion is edited one feature after another.
class SampleTree {
 public:
  explicit SampleTree(const App& app) : app_(app) {}

  /// What the next edits are made to.
  void begin(const char* name, Value primitive) {
    motions_ = {blossom::samples::add(app_, document_, "sweep-motion", name, std::move(primitive))};
  }
  void pull(const char* name, Value parameters) { edit("sweep-pull", name, std::move(parameters)); }
  void twist(const char* name, Value parameters) { edit("sweep-twist", name, std::move(parameters)); }
  FeatureId sweep(const char* name) {
    return blossom::samples::add(app_, document_, "sweep", name, Value::object(), {motions_.back()});
  }
  void move(const FeatureId& id, const char* name, const Vec3& by) {
    blossom::samples::add(app_, document_, "transform", name, {{"move", valueOf(by)}}, {id});
  }
  /// All that became of the motion, frame by frame.
  void grow(const char* name, int frames, int cells) {
    blossom::samples::add(app_, document_, "sweep-growth", name, {{"frames", frames}, {"cells", cells}}, motions_);
  }
  /// Straight lines from point to point.
  void line(const char* name, const std::vector<Vec3>& points) { stroke(name, points, false); }
  /// The same with a head at the last point.
  void arrow(const char* name, std::vector<Vec3> points, double head) {
    const Vec3 tip = points.back(), back = head * (points[points.size() - 2] - tip).normalized();
    const Vec3 side = 0.4 * head * back.unitOrthogonal();
    for (const Vec3& barb : {Vec3(tip + back + side), tip, Vec3(tip + back - side)}) points.push_back(barb);
    line(name, points);
  }
  void curve(const char* name, const std::vector<Vec3>& points) { stroke(name, points, true); }
  void import(const std::filesystem::path& file, const char* name) {
    FeatureId id;
    document_ = withImported(app_, document_, file, &id);
    Feature feature = document_.at(id);
    feature.name = name;
    document_ = document_.with(std::move(feature));
  }
  void save(const std::filesystem::path& file) const { saveDocument(document_, file); }

 private:
  void edit(const char* command, const char* name, Value parameters) {
    motions_.push_back(blossom::samples::add(app_, document_, command, name, std::move(parameters), {motions_.back()}));
  }
  void stroke(const char* name, const std::vector<Vec3>& points, bool smooth) {
    blossom::samples::add(app_, document_, "stroke", name, {{"points", valueOf(points)}, {"smooth", smooth}});
  }

  const App& app_;
  Document document_;
  std::vector<FeatureId> motions_;  ///< before the first edit, after that, and so on
};

}  // namespace blossom::sweep::samples
