#pragma once
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "exchange/format/text.h"

namespace blossom {

/// A group of a DXF file: the lines of its code and value.
struct DxfGroup {
  int code = 0;
  std::string_view value;  ///< trimmed
  std::size_t line = 0;    ///< of the value
};

/// All groups of an ASCII DXF file. The views point into `content`.
/// @throws Error FormatDamaged for binary DXF, a group code that is no number, a missing EOF.
std::vector<DxfGroup> scanDxf(std::string_view content, const Progress&);

/// Position in the file and type of an object of the cleaned text.
struct DxfOrigin {
  std::size_t line = 0;
  std::string type;
};

/// The part of a drawing that is read, without anything unsafe for dxflib, and the counts made while scanning.
struct CleanDxf {
  std::string text;                ///< DXF text with layers, blocks and the known entities
  std::vector<DxfOrigin> objects;  ///< one for each group 0 or 9 of `text`, in order
  parse::Counter entities;         ///< entities read from the ENTITIES section, by type; a POLYLINE with its vertices is one
  parse::Counter skipped;          ///< entities of that section which are left out
  std::size_t inPaperSpace = 0;
  std::size_t points = 0;
};

/// Checks the sections, the numbers of the known entities and the counts in them. dxflib trusts the counts written before
/// vertices, knots and poles and writes to buffers of that size; here they are replaced by the true ones.
/// @throws Error FormatDamaged with the line.
CleanDxf cleanDxf(const std::vector<DxfGroup>&, const Progress&);

}  // namespace blossom
