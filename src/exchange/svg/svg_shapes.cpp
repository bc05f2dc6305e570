#include "exchange/svg/svg_shapes.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "core/error.h"
#include "exchange/format/text.h"
#include "exchange/svg/svg_path.h"
#include "geometry/planar/single_point.h"

namespace blossom::svg {

using namespace parse;

namespace {

using pugi::xml_node;

void checkSize(std::initializer_list<double> values) {
  for (const double v : values)
    if (!(std::abs(v) <= 1e12)) throw Error(ErrorCode::FormatDamaged, "A shape has a coordinate that is too large.");
}

std::vector<Path> polygon(const std::vector<double>& v, bool closed) {
  Path path;
  const std::size_t n = v.size() / 2;
  for (const double x : v) checkSize({x});
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const std::size_t j = (i + 1) % n;
    const Vec2 from(v[2 * i], v[2 * i + 1]), to(v[2 * j], v[2 * j + 1]);
    if (from != to) path.segments.push_back(Line2{from, to});
  }
  if (path.segments.empty()) return n < 2 ? std::vector<Path>{} : pointDrawing({v[0], v[1]}).paths;
  path.closed = closed;
  return {path};
}

/// Clockwise on the page from the end of the upper left corner, as SVG 1.1, 9.2 draws it.
std::vector<Path> rectangle(const xml_node& node, const Lengths& lengths) {
  const double x = lengths.x(node, "x"), y = lengths.y(node, "y"), w = lengths.x(node, "width"),
               h = lengths.y(node, "height");
  if (!(w > 0) || !(h > 0)) return {};
  checkSize({x, y, w, h});
  double rx = lengths.x(node, "rx", -1), ry = lengths.y(node, "ry", -1);
  if (rx < 0) rx = std::max(ry, 0.0);
  if (ry < 0) ry = rx;
  rx = std::min(rx, w / 2);
  ry = std::min(ry, h / 2);
  if (!(rx > 0) || !(ry > 0)) return polygon({x, y, x + w, y, x + w, y + h, x, y + h}, true);
  Path path;
  path.closed = true;
  const std::array<Vec2, 8> p{Vec2(x + rx, y),         Vec2(x + w - rx, y), Vec2(x + w, y + ry), Vec2(x + w, y + h - ry),
                              Vec2(x + w - rx, y + h), Vec2(x + rx, y + h), Vec2(x, y + h - ry), Vec2(x, y + ry)};
  for (std::size_t i = 0; i < 8; i += 2) {
    if (p[i] != p[i + 1]) path.segments.push_back(Line2{p[i], p[i + 1]});
    for (Segment& s : arcSegment(p[i + 1], p[(i + 2) % 8], rx, ry, 0, false, true)) path.segments.push_back(std::move(s));
  }
  return {path};
}

}  // namespace

std::string_view nameOf(const xml_node& node) {
  std::string_view name = node.name();
  if (name.substr(0, 4) == "svg:") name.remove_prefix(4);
  return name;
}

Eigen::Affine2d Lengths::page(const xml_node& root) {
  const auto width = parseLength(root.attribute("width").value()), height = parseLength(root.attribute("height").value());
  const double mmX = width ? millimetresOf(width->unit) * width->value : 0,
               mmY = height ? millimetresOf(height->unit) * height->value : 0;
  const auto box = viewBox(root);
  physical = mmX > 0 || mmY > 0;
  hasViewBox = box.has_value();
  double scaleX = physical ? 25.4 / 96 : 1, scaleY = scaleX, top = 0, tall = 0;
  if (box) {
    viewport = {(*box)[2], (*box)[3]};
    top = (*box)[1];
    tall = (*box)[3];
    if (physical) {
      scaleX = mmX > 0 ? mmX / (*box)[2] : mmY / (*box)[3];
      scaleY = mmY > 0 ? mmY / (*box)[3] : scaleX;
      const std::string_view aspect = root.attribute("preserveAspectRatio").value();
      if (aspect.find("none") == std::string_view::npos)
        scaleX = scaleY =
            aspect.find("slice") != std::string_view::npos ? std::max(scaleX, scaleY) : std::min(scaleX, scaleY);
    }
  } else {
    viewport = {width ? userUnits(*width, 0) : 0, height ? userUnits(*height, 0) : 0};
    tall = viewport.y();
  }
  Eigen::Affine2d result = Eigen::Affine2d::Identity();
  result.affine() << scaleX, 0, 0, 0, -scaleY, scaleY * (2 * top + tall);
  return result;
}

std::size_t Lengths::lineOf(std::ptrdiff_t offset) const {
  const auto end = content_.begin() + std::clamp<std::ptrdiff_t>(offset, 0, static_cast<std::ptrdiff_t>(content_.size()));
  return 1 + static_cast<std::size_t>(std::count(content_.begin(), end, '\n'));
}

std::optional<std::vector<double>> Lengths::viewBox(const xml_node& node) const {
  const std::string_view text = node.attribute("viewBox").value();
  if (trimmed(text).empty()) return {};
  auto numbers = parseNumbers(text);
  if (!numbers || numbers->size() != 4)
    throw damaged(lineOf(node.offset_debug()), fmt::format("the viewBox {} needs four numbers.", shown(text)));
  if (!((*numbers)[2] > 0) || !((*numbers)[3] > 0)) return {};
  return numbers;
}

double Lengths::userUnits(const Length& length, double whole) const {
  if (length.unit == "%") return length.value * whole / 100;
  if (length.unit == "em") return length.value * 16;
  if (length.unit == "ex") return length.value * 8;
  const double mm = millimetresOf(length.unit);
  if (mm == 0) return length.value;
  // Where nothing ties user units to the page, 1 user unit is 1 mm; else 96 make an inch.
  return length.value * mm * (physical || hasViewBox ? 96 / 25.4 : 1);
}

double Lengths::along(const xml_node& node, const char* name, double whole, double fallback) const {
  const pugi::xml_attribute attribute = node.attribute(name);
  if (!attribute || std::string_view(attribute.value()) == "auto") return fallback;
  const auto parsed = parseLength(attribute.value());
  if (!parsed)
    throw damaged(lineOf(node.offset_debug()),
                  fmt::format("{} needs a length, but there is {}.", name, shown(attribute.value())));
  return userUnits(*parsed, whole);
}

std::vector<Path> outlineOf(const xml_node& node, std::string_view name, const Lengths& lengths) {
  if (name == "path") return parsePathData(node.attribute("d").value());
  if (name == "rect") return rectangle(node, lengths);
  if (name == "line")
    return polygon({lengths.x(node, "x1"), lengths.y(node, "y1"), lengths.x(node, "x2"), lengths.y(node, "y2")}, false);
  if (name == "polyline" || name == "polygon") {
    const auto numbers = parseNumbers(node.attribute("points").value());
    if (!numbers || numbers->size() % 2 != 0)
      throw Error(ErrorCode::FormatDamaged,
                  fmt::format("points needs pairs of numbers, but there is {}.", shown(node.attribute("points").value())));
    return polygon(*numbers, name == "polygon");
  }
  const Vec2 center(lengths.x(node, "cx"), lengths.y(node, "cy"));
  const double diagonal = lengths.viewport.norm() / std::sqrt(2.0);
  double rx = name == "circle" ? lengths.along(node, "r", diagonal) : lengths.x(node, "rx", -1);
  double ry = name == "circle" ? rx : lengths.y(node, "ry", -1);
  if (name == "ellipse" && rx < 0) rx = ry;
  if (name == "ellipse" && ry < 0) ry = rx;
  if (!(rx > 0) || !(ry > 0)) return {};
  checkSize({center.x(), center.y(), rx, ry});
  return {Path{{ellipseSegment(center, rx, ry)}, true, {}, {}}};
}

}  // namespace blossom::svg
