#pragma once
#include <filesystem>
#include <vector>

#include "exchange/format/format.h"

namespace blossom {

/// One of the files that a shape becomes.
struct FileOfShape {
  std::filesystem::path path;
  Shape shape;
};

/// The flag among a format's write options that puts all frames of a sequence into one file.
inline constexpr std::string_view framesInOneFile = "animate";

/// A sequence goes into one file where the format takes sequences (and its flag "animate", when it has one, is on). Else
/// every frame has a file of its own: out.svg stands for out-0001.svg, out-0002.svg and so on. Everything else is one file.
std::vector<FileOfShape> filesOf(const Format&, const Shape&, const std::filesystem::path&, const Value& options);

/// The kinds of shape that the files of a shape hold: its own, or those of its frames, each once; None where
/// there is nothing.
std::vector<ShapeKind> kindsInFiles(const Format&, const Shape&, const Value& options);

}  // namespace blossom
