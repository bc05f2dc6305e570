#pragma once
#include <cstdint>
#include <string>
#include <variant>
#include <vector>

#include "core/progress.h"
#include "geometry/shape/shape.h"

namespace blossom {

enum class MeasureUnit { None, Length, Area, Volume, Angle, Time };

struct Measure {
  std::string name;  ///< as `--json` prints it: "area", "poles_u", ..
  std::variant<bool, std::int64_t, double, std::string> value;
  MeasureUnit unit = MeasureUnit::None;
};

/// Measures printed by `info` and shown in the result panel, with the same names for all shapes of a kind.
/// region: area perimeter loops holes components vertices lines arcs splines;
/// mesh, solid: volume area faces vertices genus components closed; surface: degree_u degree_v poles_u poles_v min_weight
/// area; sequence: frames; curves: curves length; medial axis: edges vertices certified uncertified length;
/// toolpath: length_mm time_s gouge_mm residue_mm2 passes.
struct Measures {
  std::string kind;
  std::vector<Measure> values;
};

/// Measures of any shape. A Brep with a solid is of kind "solid", a single B-spline face "surface", other faces "faces",
/// wires and edges "curves". An open mesh has no `volume`. Areas and volumes of free-form shapes are integrals with a
/// relative error of at most 1e-6; those of meshes are exact up to rounding.
/// @throws Error Cancelled.
Measures measure(const Shape&, const Progress& = Progress::none());

}  // namespace blossom
