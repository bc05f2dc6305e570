#include <fmt/format.h>

#include <algorithm>

#include "core/lower_case.h"
#include "features_outline.h"
#include "features_outline_text.h"

namespace blossom::modeling {
namespace {

constexpr std::array styleNames{"regular", "bold", "italic", "bold-italic"};

struct TextParameters {
  std::string text = "Blossom";
  std::string font = defaultFont;
  FontStyle style = FontStyle::Regular;
  double height = 10;
  TextAlign align = TextAlign::Left;
  Vec3 at = Vec3::Zero();
  double spacing = 1;
};

/// At most five names: first the one that is spelt alike, then those that share a word of it.
std::vector<std::string> similar(const std::string& wanted, const std::vector<std::string>& families) {
  std::vector<std::string> found;
  const auto add = [&](const std::string& family) {
    if (found.size() < 5 && std::find(found.begin(), found.end(), family) == found.end()) found.push_back(family);
  };
  if (const std::string near = nearestName(wanted, families); !near.empty()) add(near);
  for (std::size_t from = 0; from < wanted.size();) {
    const std::size_t to = std::min(wanted.find(' ', from), wanted.size());
    const std::string word = lowerCase(wanted.substr(from, to - from));
    if (word.size() > 2)
      for (const std::string& family : families)
        if (lowerCase(family).find(word) != std::string::npos) add(family);
    from = to + 1;
  }
  for (const std::string& family : families) add(family);
  return found;
}

[[noreturn]] void notInstalled(const std::string& family) {
  const std::vector<std::string> families = installedFamilies();
  throw Error(ErrorCode::NotFound, fmt::format("The font \"{}\" is not installed.", family),
              families.empty() ? "No font with outlines is installed; install one, such as fonts-dejavu-core."
                               : fmt::format("Installed are for example {}.", fmt::join(similar(family, families), ", ")));
}

[[noreturn]] void noSuchStyle(const std::string& family, FontStyle style, const std::vector<FontFace>& faces) {
  std::vector<std::string> styles;
  styles.reserve(faces.size());
  for (const FontFace& face : faces) styles.push_back(face.style);
  throw Error(ErrorCode::NotFound,
              fmt::format("The font {} has no {} style.", family, styleNames.at(static_cast<std::size_t>(style))),
              fmt::format("It has {}.", fmt::join(styles, ", ")));
}

Evaluated evaluateText(const TextParameters& p, const Inputs&, const Progress& progress) {
  const FontFace face = fontFace(p.font, p.style);
  TextResult result =
      textOutline(p.text, face, {.height = p.height, .spacing = p.spacing, .align = p.align, .at = inPlane(p.at)}, progress);
  Evaluated evaluated{std::move(result.region), {{"glyphs", result.glyphs}}, {}};
  if (!result.missing.empty())
    evaluated.warnings.push_back(
        fmt::format("The font {} has no {}; a box stands for it.", face.family, fmt::join(result.missing, " ")));
  return evaluated;
}

}  // namespace

FontFace fontFace(const std::string& family, FontStyle style) {
  if (const auto face = installedFace(family, style)) return *face;
  const std::vector<FontFace> faces = installedFaces(family);
  if (faces.empty()) notInstalled(family);
  noSuchStyle(family, style, faces);
}

std::string fontState(const std::string& family, FontStyle style) {
  const auto face = installedFace(family, style);
  if (!face) return {};
  std::error_code ignored;
  return fmt::format("{} {} {} {}", face->file.string(), face->index, std::filesystem::file_size(face->file, ignored),
                     std::filesystem::last_write_time(face->file, ignored).time_since_epoch().count());
}

FeatureType textFeature() {
  using P = TextParameters;
  return feature<P>("modeling.text", "Text", "A text in an installed font, with the exact outlines of its letters.")
      .icon("text")
      .produces({ShapeKind::Region})
      .inputByFlags({.asks = "text", .plain = {"font"}})
      .parameter("text", &P::text, text(), "The text; it may have several lines.")
      .parameter("font", &P::font, text(), "Family of an installed font.")
      .parameter("style", &P::style, choice({styleNames.begin(), styleNames.end()}), "Weight and slant.")
      .parameter("height", &P::height, positiveLength(), "Height of a capital H.")
      .parameter("align", &P::align, choice({"left", "centre", "right"}), "The end of each line that lies at the point.")
      .parameter("at", &P::at, point(), "The point on the base line of the first line, in the plane z = 0.")
      .parameter("spacing", &P::spacing, number(0.1, 10), "Factor on the distance from letter to letter.")
      .example("blossom text --text Blossom --font \"DejaVu Serif\" --style bold --height 12 -o text.dxf")
      .dependsOn([](const P& p) { return fontState(p.font, p.style); })
      .evaluate(evaluateText);
}

}  // namespace blossom::modeling
