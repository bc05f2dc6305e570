#pragma once
#include <TopoDS_Wire.hxx>
#include <gp_Pnt.hxx>
#include <limits>

namespace blossom::modeling {

/// Where a path turns the most.
struct PathTurns {
  double radius = std::numeric_limits<double>::infinity();  ///< mm, of its tightest bend ..
  gp_Pnt bend;                                              ///< .. which is here
  double corner = 0;                                        ///< radians, of its sharpest corner ..
  gp_Pnt cornerAt;                                          ///< .. which is here
};

/// Bends are sampled at 33 places of each edge.
PathTurns turnsOf(const TopoDS_Wire& path);

}  // namespace blossom::modeling
