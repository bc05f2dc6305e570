#pragma once
#include <TopoDS_Face.hxx>
#include <string>
#include <vector>

#include "core/error.h"
#include "core/progress.h"
#include "kernel/solid.h"

namespace blossom::sweep {

/// What closes an end in v of a swept tube.
struct Cap {
  EndCap kind = EndCap::None;
  std::vector<TopoDS_Face> faces;
};

/// One part of the side, as long as the tube.
struct SidePart {
  Surface surface;
  TopoDS_Face face;
};

/// How an end is closed that is an edge: along it, or by a planar face without area.
enum class SharpEnds { Sewn, Capped };

/// @param sides the surface, or its parts, one after the other around it
/// @param near points of the ends closer to each other than this are one  @param size of the surface
/// @throws Error Degenerate when the end cannot be closed; Cancelled
Cap makeCap(const Surface&, const std::vector<SidePart>& sides, bool atEnd, SharpEnds, double near, double size,
            const Progress&);

/// @param why follows the place: "."
Error crossingAt(const Vec3& at, double size, const std::string& why, const char* remedy);

}  // namespace blossom::sweep
