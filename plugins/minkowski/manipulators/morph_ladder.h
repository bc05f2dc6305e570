#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "geometry/shape/shape.h"
#include "manipulators/ladder_loader.h"
#include "parameter/value.h"

namespace blossom::minkowski {

/// What the tools of all morphs of a document have in common.
struct MorphHabits {
  bool ladder = false;      ///< it is drawn
  bool influences = false;  ///< so are they, on the card
};

/// The numbers by which the in-between that is seen is blended, one for each level: those of the blossom, or all t.
/// @param parameters of the morph, complete
/// @param seen the time of the frame that is seen of a sequence
std::vector<double> levelsSeen(const Value& parameters, std::size_t shapes, std::optional<double> seen);

/// Whether de Casteljau's algorithm makes the morph: one without knots.
bool hasLadder(const Value& parameters);

/// The points of de Casteljau's algorithm from the centres of the control shapes on: the levels 1 to n-1, each a polygon.
std::vector<std::vector<Vec3>> ladderOfPoints(std::vector<Vec2> points, const std::vector<double>& t);

}  // namespace blossom::minkowski
