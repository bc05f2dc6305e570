#pragma once
#include <memory>
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

/// Judges meetings in balls around them. The triangles there are divided on the smooth faces until their sides are a quarter
/// of the radius and within `off` of the face; what hangs together over their sides is a sheet. Of the points of one sheet
/// those count whose nearest point of the other is not on its rim, by their height over its smooth face. So what ends at a
/// sheet, lies against it, passes beside it or goes on in its plane where it folds back has no lesser reach beyond about
/// twice `off`: a sheet that has points on both sides of another has passed through it. The last few balls are kept, for
/// many meetings at one place.
class SheetSurroundings {
 public:
  SheetSurroundings(const SheetMesh&, const SmoothSheets&);
  ~SheetSurroundings();
  SheetSurroundings(const SheetSurroundings&) = delete;
  SheetSurroundings& operator=(const SheetSurroundings&) = delete;

  /// O(n log n) in the triangles of the ball. @throws Error Cancelled
  Passage passageAt(const SheetMeeting&, double radius, double off, const Progress&);

  /// Whether the triangles of the mesh that lie in the ball join both sheets, so that they are one in any division of it.
  [[nodiscard]] bool hangTogether(const SheetMeeting&, double radius) const;

  /// Bounds of a passage without dividing triangles until they are near to the faces: heights over these are found by
  /// projection. For most meetings of sheets that do not pass through one another that is enough.
  struct Sketch {
    bool apart = false;
    double lesser = 0;               ///< mm, no sheet reaches farther on both sides of the other
    double least = 0, greatest = 0;  ///< mm, how far either leaves the other: the sheet that leaves it less, and more
  };
  Sketch sketchAt(const SheetMeeting&, double radius, const Progress&);

  /// Triangles of all balls so far.
  [[nodiscard]] std::size_t trianglesDivided() const { return trianglesDivided_; }

 private:
  struct Divided;
  const Divided& around(const Vec3& middle, double radius, double off, const Progress&);

  const SheetMesh& mesh_;
  const SmoothSheets& smooth_;
  std::vector<std::unique_ptr<Divided>> divided_;  ///< the latest last
  std::size_t trianglesDivided_ = 0;
};

}  // namespace blossom
