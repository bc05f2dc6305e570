#pragma once
#include <string>

#include "kernel/outline/text_outline.h"

namespace blossom::modeling {

inline constexpr const char* defaultFont = "DejaVu Sans";

/// The face of an installed font. @throws Error NotFound naming similar installed fonts, or the available styles.
FontFace fontFace(const std::string& family, FontStyle);
/// Differs when another file, or a changed one, is taken for that font; empty when there is none.
std::string fontState(const std::string& family, FontStyle);

}  // namespace blossom::modeling
