#include "exchange/format/written_check.h"

#include <fmt/format.h>

#include "core/error.h"

namespace blossom {

std::optional<WrittenCheck> checkWritten(const FormatRegistry& registry, const Shape& shape,
                                         const std::filesystem::path& file, const Progress& progress) {
  const auto* planned = shape.get<Toolpath>();
  const Format* format = registry.find(file.extension().string());
  if (!planned || !planned->gougeOf || !format || format->id != "gcode") return std::nullopt;
  const Imported read = readShape(registry, file, {{"as", "toolpath"}}, progress.part(0, 0.3));
  const auto* written = read.shape.get<Toolpath>();
  if (!written) throw Error(ErrorCode::Internal, "The program that was written is none when it is read back.");
  WrittenCheck check;
  check.gouge = planned->gougeOf(*written, progress.part(0.3, 1));
  // What rounding to thousandths of a millimetre adds is no surprise.
  constexpr double rounding = 1e-3;
  const double meant = planned->gouge.value_or(0);
  if (check.gouge > meant + rounding)
    check.warnings.push_back(
        fmt::format("As written, {} cuts {:.4f} mm into the part, {:.4f} mm more than planned: its numbers are rounded "
                    "coarsely. More decimals (--gcode.decimals) bring it back.",
                    file.filename().string(), check.gouge, check.gouge - meant));
  return check;
}

}  // namespace blossom
