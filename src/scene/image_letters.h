#pragma once
#include <string_view>

#include "geometry/values/color.h"
#include "scene/offscreen.h"

namespace blossom {

/// Letters of five by seven pixels, and a column between them.
inline constexpr int letterWidth = 6, letterHeight = 7;

/// Makes a pixel opaque; one outside of the image is left out.
void setPixel(Image&, int x, int y, const Color&);

/// Writes digits and the few other signs that numbers and units need; others are spaces. @param x, y upper left
/// @param pixel size of a letter's pixel in pixels of the image
void writeLetters(Image&, int x, int y, int pixel, std::string_view text, const Color& ink);

}  // namespace blossom
