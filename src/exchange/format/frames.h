#pragma once
#include <filesystem>
#include <vector>

#include "exchange/format/format.h"

namespace blossom {

/// A file in which a shape, or a frame of it, is stored.
struct FileOfShape {
  std::filesystem::path path;
  Shape shape;
};

/// Name of the write option that stores all frames of a sequence in one file.
inline constexpr std::string_view framesInOneFile = "animate";

/// The files in which a shape is stored. A sequence is stored in one file when the format accepts sequences (and its option
/// "animate", if it has one, is set), else in one file per frame: out-0001.svg, out-0002.svg and so on for out.svg. Any
/// other shape is stored in one file.
std::vector<FileOfShape> filesOf(const Format&, const Shape&, const std::filesystem::path&, const Value& options);

/// The kinds of shapes stored in the files of a shape: its own kind, or those of its frames, each once; None when it is
/// empty.
std::vector<ShapeKind> kindsInFiles(const Format&, const Shape&, const Value& options);

}  // namespace blossom
