#include "kernel/outline/text_outline.h"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <set>

#include "core/error.h"
#include "geometry/planar/planar.h"
#include "kernel/outline/text_glyph.h"
#include "kernel/outline/text_union.h"

namespace blossom::modeling {
namespace {

[[noreturn]] void notUtf8() {
  throw Error(ErrorCode::InvalidParameter, "The text is not UTF-8.", "Type it anew, or convert the file that it came from.");
}

/// @throws Error InvalidParameter on anything that is not well-formed (RFC 3629).
std::u32string decoded(const std::string& utf8) {
  std::u32string text;
  for (std::size_t k = 0; k < utf8.size();) {
    const auto lead = static_cast<unsigned char>(utf8[k++]);
    const int more = lead < 0x80 ? 0 : lead >> 5 == 6 ? 1 : lead >> 4 == 14 ? 2 : lead >> 3 == 30 ? 3 : -1;
    if (more < 0) notUtf8();
    char32_t character = more == 0 ? lead : lead & (0x3fU >> more);
    for (int i = 0; i < more; ++i, ++k) {
      if (k >= utf8.size() || (static_cast<unsigned char>(utf8[k]) >> 6) != 2) notUtf8();
      character = character << 6 | (static_cast<unsigned char>(utf8[k]) & 0x3fU);
    }
    constexpr char32_t smallest[] = {0, 0x80, 0x800, 0x10000};
    if (character < smallest[more] || character > 0x10ffff || (character >= 0xd800 && character < 0xe000)) notUtf8();
    text.push_back(character);
  }
  return text;
}

std::string encoded(char32_t c) {
  if (c < 0x80) return {static_cast<char>(c)};
  if (c < 0x800) return {static_cast<char>(0xc0 | c >> 6), static_cast<char>(0x80 | (c & 0x3f))};
  const auto last = [&](int shift) { return static_cast<char>(0x80 | (c >> shift & 0x3f)); };
  if (c < 0x10000) return {static_cast<char>(0xe0 | c >> 12), last(6), last(0)};
  return {static_cast<char>(0xf0 | c >> 18), last(12), last(6), last(0)};
}

/// A glyph and where its origin lies, in font units.
struct Placed {
  unsigned glyph = 0;
  Vec2 at = Vec2::Zero();
};

class Setter {
 public:
  Setter(const GlyphSource& font, const TextOptions& options) : font_(font), options_(options) {}

  std::vector<Placed> set(const std::u32string& text) {
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t to = std::min(text.find(U'\n', from), text.size());
      line(text.substr(from, to - from));
      from = to + 1;
      y_ -= font_.lineHeight();
    }
    return std::move(placed_);
  }
  std::vector<std::string> missing;

 private:
  void line(const std::u32string& characters) {
    const std::size_t first = placed_.size();
    double x = 0;
    unsigned before = 0;
    for (const char32_t character : characters) {
      if (character == U'\r') continue;
      const unsigned glyph = font_.glyphOf(character == U'\t' ? U' ' : character);
      if (glyph == 0 && known_.insert(character).second) missing.push_back(encoded(character));
      x += font_.kerning(before, glyph);
      placed_.push_back({glyph, {x, y_}});
      x += font_.advance(glyph) * options_.spacing;
      before = glyph;
    }
    const double back = options_.align == TextAlign::Left ? 0 : options_.align == TextAlign::Centre ? x / 2 : x;
    for (std::size_t k = first; k < placed_.size(); ++k) placed_[k].at.x() -= back;
  }

  const GlyphSource& font_;
  const TextOptions& options_;
  std::vector<Placed> placed_;
  std::set<char32_t> known_;
  double y_ = 0;
};

}  // namespace

TextResult textOutline(const std::string& utf8, const FontFace& face, const TextOptions& options, const Progress& progress) {
  const GlyphSource font(face);
  Setter setter(font, options);
  const double scale = options.height / font.capitalHeight();
  std::map<unsigned, Region> shapes;
  std::vector<Region> regions;
  for (const Placed& placed : setter.set(decoded(utf8))) {
    progress.check();
    if (!shapes.contains(placed.glyph)) {
      const std::vector<Path> contours = font.contours(placed.glyph);
      shapes[placed.glyph] = contours.empty() ? Region() : nonZeroArea(contours, progress);
    }
    if (shapes[placed.glyph].loops.empty()) continue;
    Eigen::Matrix<double, 2, 3> affine;
    affine << scale, 0, options.at.x() + scale * placed.at.x(), 0, scale, options.at.y() + scale * placed.at.y();
    Region region;
    for (const Path& loop : shapes[placed.glyph].loops) region.loops.push_back(transformed(loop, affine));
    regions.push_back(std::move(region));
  }
  if (regions.empty())
    throw Error(ErrorCode::InvalidParameter, "The text has no characters that can be seen.", "Type at least one letter.");
  const std::size_t glyphs = regions.size();
  return {united(std::move(regions), progress), glyphs, std::move(setter.missing)};
}

}  // namespace blossom::modeling
