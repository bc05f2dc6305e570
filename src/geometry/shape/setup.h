#pragma once
#include <gp_Trsf.hxx>

#include <vector>

#include "geometry/values/box.h"

namespace blossom {

class Shape;

/// How a part is held on a milling machine: all of it in mm from the work's zero, z up.
struct Setup {
  std::vector<Shape> part;   ///< the solid that is to be made; empty: only an outline is known
  std::vector<Shape> stock;  ///< one solid, what the part is cut from
  std::vector<Bounds> clamps;
  Bounds travel;    ///< where the tip of the tool can go; empty: not known
  gp_Trsf drawing;  ///< from the setup to where the part was drawn
};

}  // namespace blossom
