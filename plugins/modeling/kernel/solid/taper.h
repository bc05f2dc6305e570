#pragma once
#include <TopoDS_Face.hxx>
#include <gp_Pln.hxx>

#include "core/progress.h"
#include "kernel/parts/finished_solid.h"

namespace blossom::modeling {

/// The solid from a planar face along its normal by `height` mm (which may be negative), with sides inclined inward by
/// `taper` degrees (outward when negative).
/// @throws Error Degenerate with height and place where the sides meet below the height; InvalidInput for outlines other
/// than lines and arcs; Cancelled.
TopoDS_Shape taperedSolid(const TopoDS_Face&, const gp_Pln&, double height, double taper, const Progress&);

/// Message for a taper whose sides meet too early.
Complaint tooSteep(double taper);

}  // namespace blossom::modeling
