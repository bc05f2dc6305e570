#pragma once
#include <array>
#include <optional>
#include <vector>

#include "core/progress.h"
#include "geometry/crossing/sheet_mesh.h"
#include "geometry/crossing/smooth_sheets.h"

namespace blossom {

/// How far two sheets pass through one another near a place where they meet.
struct Passage {
  bool apart = false;  ///< whether they are two sheets within the ball at all, not one that runs from side to side
  /// mm, how far one sheet reaches on either side of the other: the lesser of the two sides, and the greater. Of the two
  /// sheets the one whose lesser reach is greater.
  double lesser = 0, greater = 0;
};

/// Judges a meeting in a ball around it. The triangles there are divided on the smooth faces until their sides are a quarter
/// of the radius and within `off` of the face; what hangs together over their sides is a sheet. Of the points of one sheet
/// those count whose nearest point of the other is not on its rim. So what ends at a sheet, lies against it or passes beside
/// it has no lesser reach beyond about twice `off`: a sheet that has points on both sides of another has passed through it.
/// O(n log n) in the triangles of the ball.
/// @throws Error Cancelled
Passage passageAt(const SheetMesh&, const SmoothSheets&, const SheetMeeting&, double radius, double off, const Progress&);

}  // namespace blossom
