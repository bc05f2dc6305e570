#pragma once
#include <memory>
#include <vector>

#include "geometry/planar/region.h"
#include "kernel/outline/text_font.h"

namespace blossom::modeling {

/// An open font file; measures are in font units. Not thread-safe: open one per thread.
class GlyphSource {
 public:
  /// @throws Error FileUnreadable.
  explicit GlyphSource(const FontFace&);
  ~GlyphSource();
  GlyphSource(const GlyphSource&) = delete;
  GlyphSource& operator=(const GlyphSource&) = delete;

  /// Index of the glyph of a character; 0 when the font has none.
  [[nodiscard]] unsigned glyphOf(char32_t character) const;
  [[nodiscard]] double advance(unsigned glyph) const;
  [[nodiscard]] double kerning(unsigned left, unsigned right) const;
  [[nodiscard]] double lineHeight() const;
  /// Height of a capital H.
  [[nodiscard]] double capitalHeight() const;
  /// Closed contours as in the file, to be filled by the non-zero rule.
  [[nodiscard]] std::vector<Path> contours(unsigned glyph) const;

 private:
  struct Library;
  std::unique_ptr<Library> library_;
};

}  // namespace blossom::modeling
