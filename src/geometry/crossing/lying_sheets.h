#pragma once
#include "geometry/crossing/smooth_sheets.h"

namespace blossom {

/// Whether both sheets of a meeting are one surface around it: on one side of it along u and v, at least, places of the
/// first sheet `radius` away lie on the second, within 1e-8 of the size. Sheets that are only tangent leave one another, and
/// those that go on from a common border do not cover one another. For faces whose domain is not trimmed.
bool lieOnEachOther(const SmoothSheets&, const SheetMeeting&, double radius, double size);

}  // namespace blossom
