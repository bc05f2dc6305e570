#pragma once
#include <functional>
#include <vector>

#include "geometry/tessellate/iso_curves.h"

/// The parts of `isoCurves` for single kinds of shapes. `options.chord` is positive here.
namespace blossom {

std::vector<IsoCurve> isoCurvesOfFaces(const Brep&, const IsoCurveOptions&, const Progress&);

/// Parameters of `count` curves between two ends: halfway between equal steps when the ends are one place.
std::vector<double> isoParameters(double from, double to, int count, bool closed);

/// Points on a smooth curve from a to b whose polyline is within `chord` of it, judged at the quarters of each piece.
std::vector<Vec3> chordPolyline(const std::function<Vec3(double)>& curve, double a, double b, double chord);

}  // namespace blossom
