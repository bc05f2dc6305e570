#include "kernel/parts/boolean_check.h"

#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>

#include <Eigen/Geometry>
#include <algorithm>
#include <random>

#include "geometry/mesh/winding_field.h"
#include "geometry/numeric/box_tree.h"
#include "geometry/occt/sub_shape.h"
#include "geometry/shape/bounds.h"
#include "geometry/tessellate/tessellate.h"
#include "kernel/parts/shape_parts.h"

namespace blossom::modeling {

namespace {

Vec3 normalOf(const Triangle3& t) { return (t[1] - t[0]).cross(t[2] - t[0]); }

/// How fine triangles are.
struct Fineness {
  double chord = 0;  ///< mm between them and curved faces
  double fuzzy = 0;  ///< mm by which faces may have been moved
};

/// A solid as far as places are asked about it.
class Body {
 public:
  Body(const TopoDS_Shape& solid, const Fineness& fineness, const Progress& progress) {
    if (solid.IsNull()) return;
    addTriangles(solid, fineness, progress);
    tree_ = BoxTree<3>(boxes_, 4, progress);
    field_.emplace(triangles_, progress);
  }

  /// How often the solid holds a place: 1 inside, 0 outside, anything else where its shells cross; nothing where a surface
  /// is nearer than its triangles may lie.
  [[nodiscard]] std::optional<int> timesHeld(const Vec3& place) const {
    if (triangles_.empty() || boxDistance(box_, place) > 2 * reach_) return 0;
    if (isBesideSurface(place)) return std::nullopt;
    return field_->at(place);
  }

  /// Both sides of places that are spread over the surface by area, and of some triangles of each size.
  void addPlacesBeside(std::size_t most, std::mt19937_64& random, std::vector<Vec3>& places) const {
    if (triangles_.empty()) return;
    const std::size_t count = most / 4;
    std::discrete_distribution<std::size_t> byArea(areas_.begin(), areas_.end());
    const std::size_t step = triangles_.size() / count + 1;
    for (std::size_t k = 0; k < count; ++k) addBeside(byArea(random), random, places);
    for (std::size_t k = 0; k < triangles_.size(); k += step) addBeside(k, random, places);
  }

 private:
  void addTriangles(const TopoDS_Shape& solid, const Fineness& fineness, const Progress& progress) {
    // Of a body that is large beside another one, chords as fine as that asks for would be too many.
    constexpr double finestShare = 2e-4, flatShare = 1e-6;
    const double size = diagonalOf(solid), chord = std::max(fineness.chord, finestShare * size);
    const double moved = std::max(BRep_Tool::MaxTolerance(solid, TopAbs_VERTEX), fineness.fuzzy);
    reach_ = 2 * (chord + moved);
    const double flatReach = std::max(flatShare * size, 2 * moved);
    std::vector<bool> isFlat;
    for (const TopoDS_Shape& face : subShapesOf(solid, TopAbs_FACE))
      isFlat.push_back(BRepAdaptor_Surface(TopoDS::Face(face), Standard_False).GetType() == GeomAbs_Plane);
    const Tessellation made = tessellate(Brep(solid), {.chord = chord, .angle = 0.5}, progress);
    for (std::size_t k = 0; k < made.triangles.size(); ++k) {
      const auto at = [&](std::size_t corner) { return made.points[static_cast<std::size_t>(made.triangles[k][corner])]; };
      const Triangle3& t = triangles_.emplace_back(Triangle3{at(0), at(1), at(2)});
      areas_.push_back(normalOf(t).norm());
      reaches_.push_back(isFlat[static_cast<std::size_t>(made.faceOfTriangle[k])] ? flatReach : reach_);
      boxes_.push_back(boxOf(t));
      box_.extend(boxes_.back());
    }
  }

  [[nodiscard]] bool isBesideSurface(const Vec3& place) const {
    bool beside = false;
    const Vec3 reach = Vec3::Constant(reach_);
    tree_.meeting(Box3(Vec3(place - reach), Vec3(place + reach)), [&](std::size_t t) {
      beside = beside || (boxDistance(boxes_[t], place) <= reaches_[t] &&
                          (closestOnTriangle(place, triangles_[t]) - place).norm() <= reaches_[t]);
    });
    return beside;
  }

  void addBeside(std::size_t number, std::mt19937_64& random, std::vector<Vec3>& places) const {
    const Triangle3& t = triangles_[number];
    if (!(areas_[number] > 0)) return;
    std::uniform_real_distribution<double> share(0, 1);
    const double root = std::sqrt(share(random)), b = share(random);
    const Vec3 on = (1 - root) * t[0] + root * (1 - b) * t[1] + root * b * t[2];
    // Beside flat faces near them, within the thinnest plates, and farther away.
    const double distance = 2 * (random() % 2 == 0 ? reaches_[number] : reach_);
    const Vec3 aside = distance / areas_[number] * normalOf(t);
    places.emplace_back(on + aside);
    places.emplace_back(on - aside);
  }

  double reach_ = 0;  ///< of curved faces
  std::vector<Triangle3> triangles_;
  std::vector<double> areas_, reaches_;
  std::vector<Box3> boxes_;
  Box3 box_;
  BoxTree<3> tree_;
  std::optional<WindingField> field_;
};

std::optional<bool> expected(const std::vector<Body>& inputs, BooleanOperation operation, const Vec3& place) {
  bool first = false, any = false, all = true, others = false;
  for (std::size_t k = 0; k < inputs.size(); ++k) {
    const auto times = inputs[k].timesHeld(place);
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

/// What places say that lie beside one shape.
struct Answers {
  std::size_t asked = 0, wrong = 0;
  Vec3 wrongAt = Vec3::Zero();

  [[nodiscard]] bool isSure() const {
    constexpr std::size_t chance = 2;
    constexpr double chanceShare = 0.005;
    return wrong > chance && static_cast<double>(wrong) > chanceShare * static_cast<double>(asked);
  }
};

Answers answersBeside(const Body& body, std::size_t most, const std::vector<Body>& inputs, BooleanOperation operation,
                      const Body& made, const Progress& progress) {
  std::mt19937_64 random(1);  // the same places each time
  std::vector<Vec3> places;
  body.addPlacesBeside(most, random, places);
  Answers answers;
  for (const Vec3& place : places) {
    progress.check();
    const auto times = made.timesHeld(place);
    const auto wanted = times ? expected(inputs, operation, place) : std::nullopt;
    if (!wanted) continue;
    ++answers.asked;
    if (*times == (*wanted ? 1 : 0)) continue;
    if (answers.wrong++ == 0) answers.wrongAt = place;
  }
  return answers;
}

}  // namespace

BooleanCheck checkBoolean(const std::vector<TopoDS_Shape>& inputs, BooleanOperation operation, const TopoDS_Shape& result,
                          double fuzzy, const Progress& progress) {
  double smallest = diagonalOf(inputs.front());
  for (const TopoDS_Shape& input : inputs) smallest = std::min(smallest, diagonalOf(input));
  const Fineness fineness{1e-3 * smallest, fuzzy};
  std::vector<Body> bodies;
  bodies.reserve(inputs.size());
  for (const TopoDS_Shape& input : inputs) bodies.emplace_back(input, fineness, progress);
  const Body made(result, fineness, progress);
  constexpr std::size_t mostPlaces = 3000, mostOfOne = 600, leastOfOne = 60;
  const std::size_t most = std::clamp(mostPlaces / (inputs.size() + 1), leastOfOne, mostOfOne);
  BooleanCheck check;
  const auto ask = [&](const Body& body) {
    const Answers answers = answersBeside(body, most, bodies, operation, made, progress);
    if (answers.isSure() && !check.wrongAt) check.wrongAt = answers.wrongAt;
    return answers.asked > 0;
  };
  ask(made);
  for (std::size_t k = 0; k < bodies.size(); ++k)
    if (!ask(bodies[k])) check.unasked.push_back(k);
  return check;
}

}  // namespace blossom::modeling
