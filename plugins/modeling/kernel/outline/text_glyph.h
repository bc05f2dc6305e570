#pragma once
#include <memory>
#include <vector>

#include "geometry/planar/region.h"
#include "kernel/outline/text_font.h"

namespace blossom::modeling {

/// An open font file; measures in font units. Not thread-safe, so each caller opens its own.
class GlyphSource {
 public:
  /// @throws Error FileUnreadable.
  explicit GlyphSource(const FontFace&);
  ~GlyphSource();
  GlyphSource(const GlyphSource&) = delete;
  GlyphSource& operator=(const GlyphSource&) = delete;

  /// 0: the font has no such character.
  [[nodiscard]] unsigned glyphOf(char32_t character) const;
  [[nodiscard]] double advance(unsigned glyph) const;
  [[nodiscard]] double kerning(unsigned left, unsigned right) const;
  [[nodiscard]] double lineHeight() const;
  /// Height of a capital H.
  [[nodiscard]] double capitalHeight() const;
  /// Closed contours as they stand in the file, filled by the non-zero rule.
  [[nodiscard]] std::vector<Path> contours(unsigned glyph) const;

 private:
  struct Library;
  std::unique_ptr<Library> library_;
};

}  // namespace blossom::modeling
