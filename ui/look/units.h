#pragma once
#include <QString>

#include "core/units.h"

namespace blossom::ui {

/// The unit that the user prefers for lengths; shown in fields, results and the view, and meant by numbers without a unit.
/// Documents and files are in mm whatever it is.
[[nodiscard]] const LengthUnit& lengthUnit();

/// "12.5 mm" as people read it, in the unit preferred.
[[nodiscard]] QString readableLength(double millimetres, int digits = 6);

}  // namespace blossom::ui
