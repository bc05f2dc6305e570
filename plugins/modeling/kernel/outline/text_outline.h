#pragma once
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/planar/region.h"
#include "kernel/outline/text_font.h"

namespace blossom::modeling {

enum class TextAlign { Left, Centre, Right };

struct TextOptions {
  double height = 10;  ///< mm: of a capital H
  double spacing = 1;  ///< factor on the advance from glyph to glyph
  TextAlign align = TextAlign::Left;
  Vec2 at = Vec2::Zero();  ///< on the base line of the first line: its left end, middle or right end by `align`
};

struct TextResult {
  Region region;
  std::size_t glyphs = 0;            ///< with an outline
  std::vector<std::string> missing;  ///< characters that the font lacks, once each; its own empty box stands for them
};

/// A text as its font draws it: straight sides are lines, round ones Bézier splines of degree 2 (TrueType) or 3 (CFF),
/// exactly as they stand in the file (FreeType, no hinting). Lines are apart as the font says; pairs are kerned by its kern
/// table. What a font fills twice is one area. @param utf8 with "\n" between lines.
/// @throws Error FileUnreadable (the font), InvalidParameter (no characters that can be seen, text that is not UTF-8).
TextResult textOutline(const std::string& utf8, const FontFace&, const TextOptions&, const Progress& = Progress::none());

}  // namespace blossom::modeling
