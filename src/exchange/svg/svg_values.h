#pragma once
#include <Eigen/Geometry>
#include <map>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "geometry/values/color.h"

/// Attribute values of SVG (W3C SVG 1.1, chapters 4, 7 and 11), parsed independently of the locale.
namespace blossom::svg {

/// Numbers with any separators that SVG allows ("1-2.5.5,3"). Empty when the text contains anything else.
std::optional<std::vector<double>> parseNumbers(std::string_view text);

/// A length and its unit ("12.5", "mm").
struct Length {
  double value = 0;
  std::string unit;
};
/// Empty when the text is no length.
std::optional<Length> parseLength(std::string_view text);
/// mm per physical unit (mm cm in pt pc Q); 0 for px, % and the rest.
double millimetresOf(std::string_view unit);

/// `transform="translate(..) rotate(..)"`. @throws Error FormatDamaged.
Eigen::Affine2d parseTransform(std::string_view text);

/// Transformation from a viewBox to a viewport of the given size, by preserveAspectRatio.
Eigen::Affine2d fitViewBox(const std::vector<double>& viewBox, double width, double height, std::string_view aspect);

/// "#f80", "orange", "rgb(255, 128, 0)"; empty for "none", gradients and unknown names.
std::optional<Color> parsePaint(std::string_view text);

using Declarations = std::map<std::string, std::string, std::less<>>;
/// "fill:none; stroke:#000"
Declarations parseDeclarations(std::string_view text);
/// Rules of a <style> with simple selectors ("path", ".cut", "#outline"); others are ignored.
std::map<std::string, Declarations, std::less<>> parseStyleSheet(std::string_view text);

}  // namespace blossom::svg
