#include "exchange/format/frames.h"

#include <fmt/format.h>

#include <algorithm>

namespace blossom {
namespace {

bool goesIntoOneFile(const Format& format, const Shape& shape, const Value& options) {
  if (shape.kind() != ShapeKind::Sequence) return true;
  if (!canStore(format, ShapeKind::Sequence)) return false;
  return !format.inOneFile || format.inOneFile(options);
}

std::filesystem::path framePath(const std::filesystem::path& path, std::size_t number) {
  std::filesystem::path result = path;
  return result.replace_filename(fmt::format("{}-{:04}{}", path.stem().string(), number, path.extension().string()));
}

}  // namespace

std::vector<FileOfShape> filesOf(const Format& format, const Shape& shape, const std::filesystem::path& path,
                                 const Value& options) {
  if (goesIntoOneFile(format, shape, options)) return {{path, shape}};
  std::vector<FileOfShape> files;
  const std::vector<Shape>& frames = shape.get<Sequence>()->frames;
  files.reserve(frames.size());
  for (std::size_t k = 0; k < frames.size(); ++k) files.push_back({framePath(path, k + 1), frames[k]});
  return files;
}

std::vector<ShapeKind> kindsInFiles(const Format& format, const Shape& shape, const Value& options) {
  if (goesIntoOneFile(format, shape, options)) return {shape.kind()};
  std::vector<ShapeKind> kinds;
  for (const Shape& frame : shape.get<Sequence>()->frames)
    if (std::find(kinds.begin(), kinds.end(), frame.kind()) == kinds.end()) kinds.push_back(frame.kind());
  return kinds.empty() ? std::vector{ShapeKind::None} : kinds;
}

ParameterSpec sheetOption() {
  ParameterSpec sheet = count(0, 1000);
  sheet.name = "sheet";
  sheet.help =
      "Put up to so many frames of a sequence, evenly spread, beside each other into one file, each with its time; 0 is a "
      "file for each frame.";
  sheet.fallback = 0;
  return sheet;
}

int sheetCells(const Value& options) { return options.value("sheet", 0); }

}  // namespace blossom
