#pragma once
#include "exchange/format/format.h"

/// The formats of this room in the order of lists and dialogs, a line for each: NAME stands for `Format NAMEFormat()`, which
/// is defined in a file of its own.
#define BLOSSOM_FORMATS(NAME) \
  NAME(step)                  \
  NAME(iges)                  \
  NAME(brep)                  \
  NAME(stl)                   \
  NAME(obj)                   \
  NAME(off)                   \
  NAME(ply)                   \
  NAME(threeMf)               \
  NAME(xyz)                   \
  NAME(dxf)                   \
  NAME(svg)                   \
  NAME(pdf)                   \
  NAME(ps)                    \
  NAME(motion)                \
  NAME(gcode)                 \
  NAME(controlPoints)         \
  NAME(outlines)

namespace blossom {

#define BLOSSOM_DECLARE_FORMAT(NAME) Format NAME##Format();
BLOSSOM_FORMATS(BLOSSOM_DECLARE_FORMAT)
#undef BLOSSOM_DECLARE_FORMAT

/// Every format of this room. `app` adds those that need drawing.
FormatRegistry standardFormats();

}  // namespace blossom
