#pragma once
#include <QPointF>
#include <array>

#include "kernel/edit/factor_changes.h"
#include "manipulators/factors/factor_net.h"

namespace blossom::sweep {

/// What drags and numbers mean as changes of all chosen poles.

/// Of a drag in the net: a factor that doubles every 70 pixels upwards, on three digits; degrees, half a one for each pixel
/// to the right.
double draggedFactor(const QPointF& pixels);
double draggedDegrees(const QPointF& pixels);

FactorChanges movedPoles(const FactorNet::Chosen&, const Vec3& by);
FactorChanges weightedPoles(const Motion&, Factor, const FactorNet::Chosen&, double factor);
FactorChanges scaledPoles(const FactorNet::Chosen&, const Vec3& factors);
FactorChanges turnedPoles(const FactorNet::Chosen&, const Vec3& axis, double degrees, bool absolute);
/// A coordinate of the trajectory, or a factor of the scaling, set to a number; the others stay.
FactorChanges placedPoles(const Motion&, Factor, const FactorNet::Chosen&, int coordinate, double to);
/// @param to above 0, or the kernel refuses it
FactorChanges weightSet(const Motion&, Factor, const FactorNet::Chosen&, double to);

}  // namespace blossom::sweep
