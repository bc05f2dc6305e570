#include "exchange/format/export_shape.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "exchange/format/frames.h"
#include "exchange/format/mesh_chord.h"
#include "exchange/format/written_check.h"
#include "geometry/shape/bounds.h"

namespace blossom {
namespace {

/// Binary STL stores single-precision numbers: far from the origin a small shape loses its digits.
std::optional<std::string> roundingOfStl(const Shape& shape, const Value& options) {
  if (options.value("ascii", false)) return std::nullopt;
  const Bounds box = bounds(shape);
  if (box.empty) return std::nullopt;
  const double reach = std::max(box.low.cwiseAbs().maxCoeff(), box.high.cwiseAbs().maxCoeff());
  const double rounding = std::ldexp(reach, -24);
  constexpr double harmless = 1e-5;  // of the size
  if (!(rounding > harmless * box.diagonal())) return std::nullopt;
  return fmt::format(
      "Binary STL keeps seven digits of a coordinate: as far from the origin as this shape lies ({:.6g} mm), its "
      "corners move by up to {:.2g} mm. Move it to the origin, or write text (ascii).",
      reach, std::numbers::sqrt3 * rounding);
}

/// Keeps meshes of large shapes from filling the disk because of the default chord.
std::optional<std::string> boundChord(const Shape& shape, Value& options, const Progress& progress) {
  const auto chord = options.find("chord");
  if (chord == options.end() || !chord->is_number()) return std::nullopt;
  MeshChord bounded = affordableChord(shape, chord->get<double>(), progress);
  *chord = bounded.chord;
  return bounded.note.empty() ? std::nullopt : std::optional(std::move(bounded.note));
}

/// Frames of a sequence have the same to say.
void addNew(std::vector<std::string>& warnings, std::string warning) {
  if (std::find(warnings.begin(), warnings.end(), warning) == warnings.end()) warnings.push_back(std::move(warning));
}

void exportFile(const FormatRegistry& registry, const PlannedFiles& planned, const FileOfShape& file, bool chordGiven,
                const Progress& progress, ExportReport& report) {
  Value options = planned.options;
  if (!chordGiven)
    if (auto note = boundChord(file.shape, options, progress.part(0, 0.2))) addNew(report.warnings, std::move(*note));
  writeFile(planned, file, options, progress.part(0.2, 0.7));
  if (const auto check = checkWritten(registry, file.shape, file.path, progress.part(0.7, 1))) {
    report.gouge = std::max(report.gouge.value_or(check->gouge), check->gouge);
    for (const std::string& warning : check->warnings) addNew(report.warnings, warning);
  }
  if (planned.format->id == "stl")
    if (auto note = roundingOfStl(file.shape, options)) addNew(report.warnings, std::move(*note));
}

}  // namespace

ExportReport exportShape(const FormatRegistry& registry, const Shape& shape, const std::filesystem::path& path,
                         const Value& options, bool chordGiven, const Progress& progress) {
  ExportReport report;
  const bool frames = shape.kind() == ShapeKind::Sequence;
  const double begin = frames ? 0.2 : 0;
  const PlannedFiles planned = plannedFiles(registry, shape, path, options, progress.part(0, begin));
  const double count = static_cast<double>(planned.files.size());
  for (std::size_t i = 0; i < planned.files.size(); ++i) {
    const auto at = [&](std::size_t k) { return begin + (1 - begin) * static_cast<double>(k) / count; };
    exportFile(registry, planned, planned.files[i], chordGiven, progress.part(at(i), at(i + 1)), report);
  }
  return report;
}

}  // namespace blossom
