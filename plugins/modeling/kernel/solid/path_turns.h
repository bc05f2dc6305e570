#pragma once
#include <TopoDS_Wire.hxx>
#include <gp_Pnt.hxx>
#include <limits>

namespace blossom::modeling {

/// The tightest bend and the sharpest corner of a path.
struct PathTurns {
  double radius = std::numeric_limits<double>::infinity();  ///< mm, minimum radius of curvature ..
  gp_Pnt bend;                                              ///< .. at this point
  double corner = 0;                                        ///< radians, maximum angle of a corner ..
  gp_Pnt cornerAt;                                          ///< .. at this point
};

/// Curvature is sampled at 33 points per edge.
PathTurns turnsOf(const TopoDS_Wire& path);

}  // namespace blossom::modeling
