#include <fmt/format.h>

#include <numeric>

#include "core/file.h"
#include "exchange/dxf/dxf_drawing.h"
#include "exchange/dxf/dxf_write.h"
#include "exchange/format/axis_curves.h"
#include "exchange/format/format.h"

namespace blossom {
namespace {

std::string skippedSentence(const parse::Counter& skipped) {
  std::string list;
  for (const auto& [type, count] : skipped.counts()) list += fmt::format("{}{} {}", list.empty() ? "" : ", ", count, type);
  return fmt::format("Left out, because a drawing of curves has no place for them: {}.", list);
}

Imported readDxf(const std::filesystem::path& path, const Value&, const Progress& progress) {
  const std::string content = readFile(path);
  const CleanDxf clean = cleanDxf(scanDxf(content, progress), progress);
  progress.report(0.4, "Reading DXF");
  const DxfDrawing drawing = readDxfDrawing(clean, progress);
  progress.report(0.7, "Placing blocks");

  Imported imported;
  imported.shape = Shape(expandDxf(drawing, imported.warnings, progress));
  imported.entities = clean.entities.toValue();
  imported.skipped = clean.skipped.toValue();
  const auto warn = [&](std::size_t count, const char* sentence) {
    if (count > 0) imported.warnings.push_back(fmt::format(fmt::runtime(sentence), count));
  };
  if (!clean.skipped.empty()) imported.warnings.push_back(skippedSentence(clean.skipped));
  warn(clean.inPaperSpace, "{} of the entities left out lie on a page layout (paper space).");
  warn(clean.points, "{} points were counted, but a drawing of curves does not keep them.");
  warn(drawing.flattened, "{} entities are not parallel to the drawing plane and were flattened into it.");
  warn(drawing.interpolated, "{} splines are given by fit points only; a cubic spline was laid through them.");
  if (!isPoint(drawing)) warn(drawing.degenerate, "{} entities have no extent and were left out.");
  return imported;
}

}  // namespace

Format dxfFormat() {
  Format format;
  format.id = "dxf";
  format.title = "DXF (AutoCAD drawing exchange)";
  format.extensions = {"dxf"};
  format.read = readDxf;
  format.write = writeDxf;
  format.writeOptions = {heightsOption(false)};
  format.writes = {ShapeKind::Curves, ShapeKind::Curve, ShapeKind::Region, ShapeKind::MedialAxis, ShapeKind::Toolpath};
  return format;
}

}  // namespace blossom
