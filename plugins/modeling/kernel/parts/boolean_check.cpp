#include "kernel/parts/boolean_check.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "geometry/mesh/winding_field.h"
#include "geometry/numeric/boxes.h"
#include "geometry/shape/bounds.h"
#include "geometry/tessellate/tessellate.h"
#include "kernel/parts/shape_parts.h"

namespace blossom::modeling {

namespace {

std::vector<Triangle3> trianglesOf(const TopoDS_Shape& solid, double chord, const Progress& progress) {
  const Tessellation made = tessellate(Brep(solid), {.chord = chord, .angle = 0.5}, progress);
  std::vector<Triangle3> triangles;
  triangles.reserve(made.triangles.size());
  for (const auto& corners : made.triangles) {
    const auto at = [&](std::size_t k) { return made.points[static_cast<std::size_t>(corners[k])]; };
    triangles.push_back({at(0), at(1), at(2)});
  }
  return triangles;
}

Vec3 normalOf(const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

/// A solid as far as places are asked about it.
class Body {
 public:
  Body(const TopoDS_Shape& solid, double chord, const Progress& progress)
      : triangles_(solid.IsNull() ? std::vector<Triangle3>() : trianglesOf(solid, chord, progress)),
        field_(triangles_, progress) {
    for (const Triangle3& t : triangles_) {
      areas_.push_back(normalOf(t).norm());
      for (const Vec3& corner : t) box_.extend(corner);
    }
  }

  /// How often the solid holds all that is near a place: 1 inside, 0 outside, anything else where its shells cross; nothing
  /// where a surface is near.
  [[nodiscard]] std::optional<int> timesHeld(const Vec3& place, double reach) const {
    if (triangles_.empty() || boxDistance(box_, place) > 2 * reach) return 0;
    const int times = field_.at(place);
    for (int axis = 0; axis < 3; ++axis)
      for (const double side : {-reach, reach}) {
        Vec3 beside = place;
        beside[axis] += side;
        if (field_.at(beside) != times) return std::nullopt;
      }
    return times;
  }

  /// Both sides of places that are spread over the surface by area, and of some triangles of each size.
  void addPlacesBeside(double distance, std::mt19937_64& random, std::vector<Vec3>& places) const {
    if (triangles_.empty()) return;
    constexpr std::size_t count = 150;
    std::discrete_distribution<std::size_t> byArea(areas_.begin(), areas_.end());
    const std::size_t step = triangles_.size() / count + 1;
    for (std::size_t k = 0; k < count; ++k) addBeside(byArea(random), distance, random, places);
    for (std::size_t k = 0; k < triangles_.size(); k += step) addBeside(k, distance, random, places);
  }

 private:
  void addBeside(std::size_t number, double distance, std::mt19937_64& random, std::vector<Vec3>& places) const {
    const Triangle3& t = triangles_[number];
    if (!(areas_[number] > 0)) return;
    std::uniform_real_distribution<double> share(0, 1);
    const double root = std::sqrt(share(random)), b = share(random);
    const Vec3 on = (1 - root) * t[0] + root * (1 - b) * t[1] + root * b * t[2];
    const Vec3 aside = distance / areas_[number] * normalOf(t);
    places.emplace_back(on + aside);
    places.emplace_back(on - aside);
  }

  std::vector<Triangle3> triangles_;
  std::vector<double> areas_;
  Box3 box_;
  WindingField field_;
};

std::optional<bool> expected(const std::vector<Body>& inputs, BooleanOperation operation, const Vec3& place, double reach) {
  bool first = false, any = false, all = true, others = false;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const auto times = inputs[k].timesHeld(place, reach);
    if (!times) return std::nullopt;
    const bool isInside = *times > 0;
    if (k == 0) first = isInside;
    others = others || (k > 0 && isInside);
    any = any || isInside;
    all = all && isInside;
  }
  switch (operation) {
    case BooleanOperation::Union:
      return any;
    case BooleanOperation::Difference:
      return first && !others;
    case BooleanOperation::Intersection:
      return all;
  }
  return std::nullopt;
}

}  // namespace

std::optional<BooleanDoubt> booleanDoubt(const std::vector<TopoDS_Shape>& inputs, BooleanOperation operation,
                                         const TopoDS_Shape& result, const Progress& progress) {
  double smallest = diagonalOf(inputs.front());
  for (const TopoDS_Shape& input : inputs) smallest = std::min(smallest, diagonalOf(input));
  const double chord = 1e-3 * smallest, reach = 2 * chord;
  std::vector<Body> bodies;
  bodies.reserve(inputs.size());
  for (const TopoDS_Shape& input : inputs) bodies.emplace_back(input, chord, progress);
  const Body made(result, chord, progress);
  std::mt19937_64 random(1);  // the same places each time
  std::vector<Vec3> places;
  made.addPlacesBeside(2 * reach, random, places);
  for (const Body& body : bodies) body.addPlacesBeside(2 * reach, random, places);
  constexpr std::size_t mostPlaces = 3000;  // of many inputs
  std::shuffle(places.begin(), places.end(), random);
  places.resize(std::min(places.size(), mostPlaces));
  std::size_t asked = 0, wrong = 0;
  BooleanDoubt doubt;
  for (const Vec3& place : places) {
    progress.check();
    const auto wanted = expected(bodies, operation, place, reach);
    if (!wanted) continue;
    const auto times = made.timesHeld(place, reach);
    if (!times) continue;
    ++asked;
    if (*times == (*wanted ? 1 : 0)) continue;
    if (++wrong == 1) doubt.place = place;
  }
  if (wrong == 0) return std::nullopt;
  doubt.share = static_cast<double>(wrong) / static_cast<double>(asked);
  return doubt;
}

}  // namespace blossom::modeling
