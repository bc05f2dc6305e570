#include "kernel/outline/text_glyph.h"

#include <fmt/format.h>
#include <ft2build.h>
#include FT_FREETYPE_H
#include FT_OUTLINE_H

#include <Eigen/Geometry>
#include <algorithm>

#include "core/error.h"

namespace blossom::modeling {

struct GlyphSource::Library {
  FT_Library library = nullptr;
  FT_Face face = nullptr;
  Library() = default;
  Library(const Library&) = delete;
  Library& operator=(const Library&) = delete;
  ~Library() {
    if (face) FT_Done_Face(face);
    if (library) FT_Done_FreeType(library);
  }
};

namespace {

Vec2 flat(const FT_Vector* p) { return {static_cast<double>(p->x), static_cast<double>(p->y)}; }

/// Takes down what FreeType calls out: contours of lines and Bézier curves.
class Contours {
 public:
  std::vector<Path> take() {
    close();
    return std::move(paths_);
  }
  void moveTo(const Vec2& to) {
    close();
    at_ = start_ = to;
  }
  void lineTo(const Vec2& to) {
    if (to != at_) segments_.emplace_back(Line2{at_, to});
    at_ = to;
  }
  void curveTo(std::vector<Vec2> controls) {
    const auto degree = static_cast<int>(controls.size());
    Spline2 spline{degree, {}, {at_.homogeneous()}};
    for (const Vec2& control : controls) spline.poles.push_back(control.homogeneous());
    spline.knots.assign(controls.size() + 1, 0.0);
    spline.knots.resize(2 * controls.size() + 2, 1.0);
    const bool moves = std::any_of(controls.begin(), controls.end(), [&](const Vec2& p) { return p != at_; });
    if (moves) segments_.emplace_back(std::move(spline));
    at_ = controls.back();
  }

 private:
  void close() {
    lineTo(start_);
    if (!segments_.empty()) paths_.push_back({std::move(segments_), true, {}, {}});
    segments_.clear();
  }

  std::vector<Path> paths_;
  std::vector<Segment> segments_;
  Vec2 start_ = Vec2::Zero(), at_ = Vec2::Zero();
};

Contours& contoursOf(void* user) { return *static_cast<Contours*>(user); }

FT_Outline_Funcs callbacks() {
  FT_Outline_Funcs functions{};
  functions.move_to = [](const FT_Vector* to, void* user) { return contoursOf(user).moveTo(flat(to)), 0; };
  functions.line_to = [](const FT_Vector* to, void* user) { return contoursOf(user).lineTo(flat(to)), 0; };
  functions.conic_to = [](const FT_Vector* control, const FT_Vector* to, void* user) {
    return contoursOf(user).curveTo({flat(control), flat(to)}), 0;
  };
  functions.cubic_to = [](const FT_Vector* a, const FT_Vector* b, const FT_Vector* to, void* user) {
    return contoursOf(user).curveTo({flat(a), flat(b), flat(to)}), 0;
  };
  return functions;
}

[[noreturn]] void unreadable(const FontFace& font, const char* why) {
  throw Error(ErrorCode::FileUnreadable, fmt::format("The font {} {} {}.", font.family, font.style, why),
              fmt::format("Its file is {}.", font.file.string()));
}

}  // namespace

GlyphSource::GlyphSource(const FontFace& font) : library_(std::make_unique<Library>()) {
  if (FT_Init_FreeType(&library_->library) != 0) throw Error(ErrorCode::Internal, "FreeType does not start.");
  if (FT_New_Face(library_->library, font.file.c_str(), font.index, &library_->face) != 0)
    unreadable(font, "cannot be read");
  if (!FT_IS_SCALABLE(library_->face)) unreadable(font, "has no outlines");
}

GlyphSource::~GlyphSource() = default;

unsigned GlyphSource::glyphOf(char32_t character) const { return FT_Get_Char_Index(library_->face, character); }

double GlyphSource::advance(unsigned glyph) const {
  if (FT_Load_Glyph(library_->face, glyph, FT_LOAD_NO_SCALE) != 0) return 0;
  return static_cast<double>(library_->face->glyph->metrics.horiAdvance);
}

double GlyphSource::kerning(unsigned left, unsigned right) const {
  FT_Vector offset{};
  if (!left || !right || FT_Get_Kerning(library_->face, left, right, FT_KERNING_UNSCALED, &offset) != 0) return 0;
  return static_cast<double>(offset.x);
}

double GlyphSource::lineHeight() const { return library_->face->height; }

double GlyphSource::capitalHeight() const {
  const unsigned glyph = glyphOf(U'H');
  const bool loaded = glyph != 0 && FT_Load_Glyph(library_->face, glyph, FT_LOAD_NO_SCALE) == 0;
  const auto top = loaded ? static_cast<double>(library_->face->glyph->metrics.horiBearingY) : 0.0;
  // Fonts without Latin letters: the usual share of the em.
  return top > 0 ? top : 0.7 * library_->face->units_per_EM;
}

std::vector<Path> GlyphSource::contours(unsigned glyph) const {
  if (FT_Load_Glyph(library_->face, glyph, FT_LOAD_NO_SCALE) != 0) return {};
  if (library_->face->glyph->format != FT_GLYPH_FORMAT_OUTLINE) return {};
  static const FT_Outline_Funcs functions = callbacks();
  Contours contours;
  if (FT_Outline_Decompose(&library_->face->glyph->outline, &functions, &contours) != 0) return {};
  return contours.take();
}

}  // namespace blossom::modeling
