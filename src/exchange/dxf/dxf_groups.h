#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "exchange/format/text.h"

namespace blossom {

/// A pair of lines of a DXF file: group code and value.
struct DxfGroup {
  int code = 0;
  std::string_view value;  ///< trimmed
  std::size_t line = 0;    ///< of the value
};

/// All groups of a text DXF file. The views point into `content`.
/// @throws Error FormatDamaged: binary DXF, a group code that is no number, the end before EOF.
std::vector<DxfGroup> scanDxf(std::string_view content, const Progress&);

/// Where an object of the cleaned text began in the file.
struct DxfOrigin {
  std::size_t line = 0;
  std::string type;
};

/// The part of a drawing that is read, freed of everything that could harm its reader, and what was counted on the way.
struct CleanDxf {
  std::string text;                ///< DXF text with layers, blocks and the known entities
  std::vector<DxfOrigin> objects;  ///< one for each group 0 or 9 of `text`, in order
  parse::Counter entities;         ///< entities read from the ENTITIES section, by type; a POLYLINE with its vertices is one
  parse::Counter skipped;          ///< entities of that section which are left out
  std::size_t inPaperSpace = 0;
  std::size_t points = 0;
};

/// Checks the sections, the numbers of the known entities and the counts in them. dxflib trusts the counts that stand before
/// vertices, knots and poles and writes to fixed places: here they are replaced by the true ones.
/// @throws Error FormatDamaged with the line.
CleanDxf cleanDxf(const std::vector<DxfGroup>&, const Progress&);

}  // namespace blossom
