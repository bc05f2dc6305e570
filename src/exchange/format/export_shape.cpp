#include "exchange/format/export_shape.h"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

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

}  // namespace

ExportReport exportShape(const FormatRegistry& registry, const Shape& shape, const std::filesystem::path& path,
                         const Value& options, bool chordGiven, const Progress& progress) {
  ExportReport report;
  const auto tell = [&](std::optional<std::string> warning) {
    if (warning) report.warnings.push_back(std::move(*warning));
  };
  const Format* format = registry.find(path.extension().string());
  Value all = format ? completed(format->writeOptions, options) : options;
  if (!chordGiven) tell(boundChord(shape, all, progress.part(0, 0.2)));
  writeShape(registry, shape, path, all, progress.part(0.2, 0.7));
  if (const auto check = checkWritten(registry, shape, path, progress.part(0.7, 1))) {
    report.gouge = check->gouge;
    report.warnings.insert(report.warnings.end(), check->warnings.begin(), check->warnings.end());
  }
  if (format && format->id == "stl") tell(roundingOfStl(shape, all));
  return report;
}

}  // namespace blossom
