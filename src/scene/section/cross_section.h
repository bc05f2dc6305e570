#pragma once
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

#include "core/progress.h"
#include "scene/picking.h"

namespace blossom {

/// The section of a solid by a plane. Both are null where the plane does not meet the solid.
struct CrossSection {
  vtkSmartPointer<vtkPolyData> outline;  ///< closed polylines
  vtkSmartPointer<vtkPolyData> area;     ///< triangles; null, too, when there was no time to make them
};

/// Cuts closed triangles, which face outwards, by a plane. Bodies may overlap: what lies in any of them is filled. Triangles
/// meet where their corners have the same coordinates; gaps between others are closed by straight lines.
/// O(points + triangles + k log k) for k triangles that cross the plane, where not many bodies overlap.
/// @param whileFilling the area is left out when it is cancelled
CrossSection crossSection(vtkPolyData& faces, const CutPlane&, const Progress& whileFilling = Progress::none());

}  // namespace blossom
