#pragma once
#include <memory>
#include <optional>

#include "geometry/shape/shape.h"
#include "kernel/deform.h"
#include "kernel/limit_surface.h"
#include "scene/picking.h"

namespace blossom::subdivision {

/// A draggable point of a limit surface: the limit point of a vertex, or of an existing pull.
struct Grip {
  Vec3 base = Vec3::Zero();  ///< on the limit surface of the cage as it was
  Vec3 now = Vec3::Zero();   ///< current position
  Foot foot;
  std::optional<std::size_t> pull;  ///< index of its pull
};

/// The limit surface of a cage with everything that does not change during drags.
struct GripSurface {
  Shape cage;   ///< as it was given
  Mesh joined;  ///< its mesh with coincident boundaries joined
  Scheme scheme = Scheme::CatmullClark;
  std::unique_ptr<LimitSurface> surface;
  std::vector<Grip> corners;  ///< one per vertex, without pulls
  std::vector<Row> rows;      ///< of the corners
  std::vector<std::pair<int, int>> edges;

  [[nodiscard]] const Mesh& mesh() const { return joined; }
};

/// @pre the cage is a mesh. O(faces). @throws Error InvalidInput, Cancelled.
std::shared_ptr<const GripSurface> gripSurface(const Shape& cage, Scheme, const Progress&);

/// Whether two points are equal up to rounding.
bool samePlace(const Vec3&, const Vec3&);

/// Distance of a point from the ray of the mouse (a half line).
double distanceTo(const Ray&, const Vec3&);

/// Whether all pulls start at limit points of vertices, so that `gripsOf` needs no search.
bool onVertices(const GripSurface&, const std::vector<Pull>&);

/// All grips: vertices, and pulls that start between them. @param now the control points after the pulls
/// @throws Error Cancelled.
std::vector<Grip> gripsOf(const GripSurface&, const std::vector<Pull>&, std::span<const Vec3> now, const Progress&);

}  // namespace blossom::subdivision
