#pragma once
#include <cstddef>
#include <optional>
#include <pugixml.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "core/vector.h"
#include "exchange/svg/svg_values.h"
#include "geometry/planar/region.h"

/// The basic shapes of SVG (W3C SVG 1.1, chapters 7 and 9) and the lengths in their attributes.
namespace blossom::svg {

/// Name without the SVG namespace prefix.
std::string_view nameOf(const pugi::xml_node&);

/// Lengths of attributes in user units, and line numbers of elements for messages.
class Lengths {
 public:
  explicit Lengths(const std::string& content) : content_(content) {}

  /// Takes the size of the page from the root element. Returns the transformation from its user units to mm with y up.
  Eigen::Affine2d page(const pugi::xml_node& root);

  /// Number of the line, from 1, that contains a byte of the text.
  [[nodiscard]] std::size_t lineOf(std::ptrdiff_t offset) const;
  /// Empty when there is none or its size is zero. @throws Error FormatDamaged.
  [[nodiscard]] std::optional<std::vector<double>> viewBox(const pugi::xml_node&) const;
  /// A length in user units; `whole` corresponds to 100 %.
  [[nodiscard]] double userUnits(const Length&, double whole) const;
  /// An attribute as a length in user units; `fallback` when it is missing. @throws Error FormatDamaged.
  [[nodiscard]] double along(const pugi::xml_node&, const char* name, double whole, double fallback = 0) const;
  [[nodiscard]] double x(const pugi::xml_node& node, const char* name, double fallback = 0) const {
    return along(node, name, viewport.x(), fallback);
  }
  [[nodiscard]] double y(const pugi::xml_node& node, const char* name, double fallback = 0) const {
    return along(node, name, viewport.y(), fallback);
  }

  bool physical = false;    ///< the page has a size
  bool hasViewBox = false;  ///< the page has a viewBox
  Vec2 viewport{0, 0};      ///< size of the enclosing svg element, in user units

 private:
  const std::string& content_;
};

/// The outlines of an element path, rect, line, polyline, polygon, circle or ellipse, in user units. @throws Error
/// FormatDamaged.
std::vector<Path> outlineOf(const pugi::xml_node&, std::string_view name, const Lengths&);

}  // namespace blossom::svg
