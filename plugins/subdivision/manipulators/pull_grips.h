#pragma once
#include <memory>
#include <optional>

#include "geometry/shape/shape.h"
#include "kernel/deform.h"
#include "kernel/limit_surface.h"
#include "scene/picking.h"

namespace blossom::subdivision {

/// A place of a limit surface that can be taken hold of: the limit point of a vertex, or of a pull that there is.
struct Grip {
  Vec3 base = Vec3::Zero();  ///< on the limit surface of the cage as it was
  Vec3 now = Vec3::Zero();   ///< where it has been pulled to
  Foot foot;
  std::optional<std::size_t> pull;  ///< its number
};

/// The limit surface of a cage and what is known of it once and for all.
struct GripSurface {
  Shape cage;   ///< as it was given
  Mesh joined;  ///< its mesh, rims that lie on each other joined
  Scheme scheme = Scheme::CatmullClark;
  std::unique_ptr<LimitSurface> surface;
  std::vector<Grip> corners;  ///< one for each vertex, where it has not been pulled
  std::vector<Row> rows;      ///< of the corners
  std::vector<std::pair<int, int>> edges;

  [[nodiscard]] const Mesh& mesh() const { return joined; }
};

/// @pre the cage is a mesh. O(faces). @throws Error InvalidInput, Cancelled.
std::shared_ptr<const GripSurface> gripSurface(const Shape& cage, Scheme, const Progress&);

/// Whether a pull took hold there: the same but for rounding.
bool samePlace(const Vec3&, const Vec3&);

/// From a point to the nearest one in front of the viewer that is seen under the mouse.
double distanceTo(const Ray&, const Vec3&);

/// Whether all places lie on limit points of vertices, so that `gripsOf` has nothing to search for.
bool onVertices(const GripSurface&, const std::vector<Pull>&);

/// All grips: the vertices, and pulls that took hold between them. @param now the control points after the pulls
/// @throws Error Cancelled.
std::vector<Grip> gripsOf(const GripSurface&, const std::vector<Pull>&, std::span<const Vec3> now, const Progress&);

}  // namespace blossom::subdivision
