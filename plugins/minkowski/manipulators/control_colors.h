#pragma once
#include <cstddef>

#include "scene/scene.h"

namespace blossom::minkowski {

/// The colour by which a control shape is told from the others: that of its number in the view and of its influence curve.
/// All stand out from the background by about the same.
Color controlColor(const Look&, std::size_t shape);

}  // namespace blossom::minkowski
