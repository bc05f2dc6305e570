#pragma once
#include <memory>
#include <optional>
#include <utility>
#include <vector>

#include "geometry/shape/shape.h"
#include "manipulators/ladder_loader.h"
#include "parameter/value.h"

namespace blossom::minkowski {

/// What the tools of all morphs of a document have in common.
struct MorphHabits {
  bool ladder = false;      ///< it is drawn
  bool influences = false;  ///< so are they, on the card
  bool path = false;        ///< its pad is open
};

/// A side of a polygon of de Casteljau's algorithm, on which an intermediate shape lies: the blend of the two at its ends.
struct LadderLeg {
  std::size_t level;  ///< of that shape, 1 for a blend of control shapes
  std::size_t index;  ///< of it and of the end where it begins
  friend bool operator==(const LadderLeg&, const LadderLeg&) = default;
};

/// t of a frame of the morph, counted from 0, as its keys have it.
double timeOfFrame(const Value& parameters, int frame, int frames);

/// The numbers by which the in-between that is seen is blended, one for each level: those of the blossom or of the path, or
/// all t.
/// @param parameters of the morph, complete
/// @param seen the time of the frame that is seen of a sequence
std::vector<double> levelsSeen(const Value& parameters, std::size_t shapes, std::optional<double> seen);

/// The place on the path that is seen, or t; nothing where blossom numbers are given.
std::optional<double> placeSeen(const Value& parameters, std::optional<double> seen);

/// Whether de Casteljau's algorithm makes the morph of so many shapes: no B-spline, of knots or of a lower degree.
bool hasLadder(const Value& parameters, std::size_t shapes);

/// The points of de Casteljau's algorithm from the centres of the control shapes on: the levels 1 to n-1, each a polygon.
std::vector<std::vector<Vec3>> ladderOfPoints(std::vector<Vec2> points, const std::vector<double>& t);

/// The leg that comes nearest to a place, within `reach` of it.
/// @param points the centres of the control shapes
std::optional<LadderLeg> legNear(const Vec2& place, std::vector<Vec2> points, const std::vector<double>& t, double reach);
/// Its ends. @pre there is such a leg
std::pair<Vec2, Vec2> endsOf(const LadderLeg&, std::vector<Vec2> points, const std::vector<double>& t);

}  // namespace blossom::minkowski
