#pragma once
#include <BRepAdaptor_Surface.hxx>
#include <TopoDS_Shape.hxx>
#include <array>
#include <optional>
#include <vector>

#include "geometry/bspline/bspline.h"
#include "geometry/crossing/sheet_mesh.h"

namespace blossom {

/// The smooth faces that a SheetMesh stands for, evaluated by their numbers.
class SmoothSheets {
 public:
  explicit SmoothSheets(const Surface&);
  explicit SmoothSheets(const TopoDS_Shape&);

  /// Whether they belong to a single surface, which is not trimmed.
  [[nodiscard]] bool areOneSurface() const { return surface_ != nullptr; }

  /// Point and first derivatives, mm and mm per unit of the parameters. The surface goes on beyond the border of a face.
  [[nodiscard]] SurfaceFrame frame(int face, const Vec2& at) const;

  /// The same place of a face that is closed, with parameters inside its domain: beyond it, what goes on is another surface,
  /// or the same one run through again. Periodic faces are run through again everywhere and stay as they are.
  [[nodiscard]] Vec2 withinDomain(int face, const Vec2& at) const;
  /// How far apart parameters are, either way the short way round where the face is closed.
  [[nodiscard]] Vec2 apart(int face, const Vec2& a, const Vec2& b) const;
  /// Whether the untrimmed face has that place. One that is closed goes on beyond its ends.
  [[nodiscard]] bool isInDomain(int face, const Vec2& at) const;

 private:
  /// Of a face in one direction.
  struct Closure {
    bool isClosed = false, isPeriodic = false;
    double from = 0, to = 0;
  };
  std::vector<std::array<Closure, 2>> closures_;  ///< of each face, in u and in v
  const Surface* surface_ = nullptr;              ///< or the faces
  std::vector<BRepAdaptor_Surface> faces_;        ///< in the order of TopExp::MapShapes
};

/// A place on one sheet.
struct SheetPlace {
  int face = 0;
  Vec2 at = Vec2::Zero();  ///< parameters on the face
};

/// Where two sheets meet.
struct SheetMeeting {
  Vec3 point = Vec3::Zero();
  SheetPlace first, second;
  double sine = 0;  ///< of the angle between the normals; 0: the sheets are tangent, or one has no normal
};

/// Newton's method for a common point of two sheets, beginning at a place on either: each step is the shortest, measured in
/// space, that closes the gap of the tangent planes.
/// @param reach mm, how far from its start the point may lie  @returns nothing where the sheets do not meet within reach
std::optional<SheetMeeting> meet(const SmoothSheets&, const SheetPlace& first, const SheetPlace& second, double reach,
                                 double size);

}  // namespace blossom
