#pragma once
#include <TopoDS_Face.hxx>
#include <gp_Pln.hxx>

#include "core/progress.h"
#include "kernel/parts/finished_solid.h"

namespace blossom::modeling {

/// The solid from a flat face along the normal of its plane by `height` mm, which may be negative. Its sides lean inwards by
/// `taper` degrees, outwards where that is negative.
/// @throws Error Degenerate, with the height and the place, where the sides meet below the height; InvalidInput for outlines
/// that are not of lines and arcs; Cancelled.
TopoDS_Shape taperedSolid(const TopoDS_Face&, const gp_Pln&, double height, double taper, const Progress&);

/// What is said of a taper whose sides meet too early.
Complaint tooSteep(double taper);

}  // namespace blossom::modeling
