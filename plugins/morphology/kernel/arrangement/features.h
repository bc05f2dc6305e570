#pragma once
#include <optional>
#include <span>
#include <vector>

#include "geometry/mesh/mesh.h"
#include "kernel/arrangement/numbers.h"

namespace blossom::morphology::arrangement {

/// Corners, edges and faces of a shape on the grid that can bound a sum: those that a plane touches from outside.
struct Features {
  struct Face {
    std::array<int, 3> corners{};  ///< counter-clockwise from outside
    Normal3 normal{};              ///< outward
    Bounded3 about;                ///< the same in doubles
  };
  static constexpr int none = -1;
  struct Edge {
    int from = 0, to = 0;           ///< corners
    int left = none, right = none;  ///< faces; a segment has none
    bool isConvex = true;           ///< only then it can bound a sum
  };
  struct Corner {
    bool isTouched = false;     ///< false between reflex edges alone, which no plane touches
    std::vector<Grid3> around;  ///< directions of all its edges
  };
  std::vector<Grid3> points;
  std::vector<Corner> corners;  ///< of the points
  std::vector<Face> faces;
  std::vector<Edge> edges;
  std::vector<int> parts;  ///< a point of each connected part
};

inline Eigen::Vector3d inDoubles(const Grid3& p) {
  return {static_cast<double>(p[0]), static_cast<double>(p[1]), static_cast<double>(p[2])};
}

inline Eigen::Vector3d inDoubles(const Normal3& n) {
  return {static_cast<double>(n[0]), static_cast<double>(n[1]), static_cast<double>(n[2])};
}

/// Of a solid. Points are scaled, then rounded to multiples of `step`, of `usualSteps` where that scales them; a factor
/// below 0 mirrors the solid in the origin. The solid `insideOut` is its complement. Nothing when rounding leaves a triangle
/// without area, and where an edge has not two faces. @pre oriented triangles with coordinates below 2^59 steps once they
/// are scaled
std::optional<Features> featuresOf(const Mesh& triangles, double factor, double step, bool insideOut = false);

/// Of triangles (which have two faces each), segments or points.
Features featuresOf(std::span<const std::vector<Vec3>> pieces, double factor, double step);

/// Whether the faces of an edge turn towards each other there, to the inside of the solid less than to the outside.
bool isReflex(const Features&, const Features::Edge&);

/// The sign of n . d.
int slope(const Normal3& n, const Bounded3& about, const Grid3& d);

}  // namespace blossom::morphology::arrangement
