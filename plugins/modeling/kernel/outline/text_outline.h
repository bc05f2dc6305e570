#pragma once
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/outline/text_font.h"

namespace blossom::modeling {

enum class TextAlign { Left, Centre, Right };

struct TextOptions {
  double height = 10;  ///< mm, height of a capital H
  double spacing = 1;  ///< factor on the advance widths
  TextAlign align = TextAlign::Left;
  Vec2 at = Vec2::Zero();  ///< left end, middle or right end (by `align`) of the base line of the first line
};

struct TextResult {
  Region region;
  std::size_t glyphs = 0;  ///< number of glyphs with an outline
  std::vector<std::string>
      missing;  ///< characters that the font lacks, once each; drawn with its glyph for missing characters
};

/// The outlines of a text in a font: lines and Bézier splines of degree 2 (TrueType) or 3 (CFF), exactly as in the file
/// (FreeType without hinting). Line spacing is that of the font, pairs are kerned by its kern table, overlapping contours
/// are united. @param utf8 lines are separated by "\n".
/// @throws Error FileUnreadable (the font), InvalidParameter (no visible characters, text that is not UTF-8).
TextResult textOutline(const std::string& utf8, const FontFace&, const TextOptions&, const Progress& = Progress::none());

}  // namespace blossom::modeling
