#include "exchange/svg/svg_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <pugixml.hpp>
#include <set>
#include <span>
#include <unordered_map>

#include "exchange/format/finite.h"
#include "exchange/format/text.h"
#include "exchange/svg/crop_window.h"
#include "exchange/svg/svg_shapes.h"
#include "exchange/svg/svg_values.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/single_point.h"

namespace blossom::svg {

using namespace parse;

namespace {

using Affine = Eigen::Affine2d;
using pugi::xml_node;

constexpr std::size_t maximumElements = 500'000, maximumSegments = 2'000'000;
constexpr int deepestNesting = 200;

bool isShape(std::string_view name) {
  static constexpr std::array<std::string_view, 7> shapes{"path", "rect",     "circle", "ellipse",
                                                          "line", "polyline", "polygon"};
  return std::find(shapes.begin(), shapes.end(), name) != shapes.end();
}

/// Attributes inherited from the parent.
struct Style {
  std::string fill = "black", stroke = "none", color;
  bool paintGiven = false;  ///< fill or stroke stand in the file; a default black is no colour of its own
  bool evenOdd = false, visible = true, displayed = true;
  bool cropped = false;           ///< by a clip-path or mask of its own
  bool croppedFromAbove = false;  ///< by that of what it stands in
  bool overflows = false;         ///< a nested svg or symbol shows what lies outside its window
  std::string layer;
};

class Reader {
 public:
  Reader(const std::string& content, const Progress& progress) : content_(content), progress_(progress), lengths_(content) {}

  Imported read() {
    const pugi::xml_parse_result result = document_.load_buffer(content_.data(), content_.size(), pugi::parse_default);
    if (!result) throw damaged(lengths_.lineOf(result.offset), fmt::format("the XML is broken ({}).", result.description()));
    const xml_node root = document_.document_element();
    if (nameOf(root) != "svg")
      throw damaged(1, fmt::format("the element svg is expected, but there is {}.", shown(root.name())));
    collectNames(root);
    children(root, lengths_.page(root), styled(root, Style()), 1);
    return finished();
  }

 private:
  /// All elements with an id, and the style sheets.
  void collectNames(const xml_node& root) {
    for (xml_node node = root; node;) {
      if (const auto id = node.attribute("id")) names_.emplace(id.value(), node);
      if (nameOf(node) == "style") rules_ = parseStyleSheet(node.text().get());
      // Iterative, so that deep nesting cannot use up the stack.
      if (node.first_child()) {
        node = node.first_child();
        continue;
      }
      while (node && node != root && !node.next_sibling()) node = node.parent();
      node = node == root ? xml_node() : node.next_sibling();
    }
  }

  /// "url(#id)" of an element of this file; what is not there crops nothing.
  [[nodiscard]] bool namesElement(std::string_view value) const {
    const std::size_t begin = value.find('#'), end = value.find_first_of(")\"'", begin);
    return value.starts_with("url(") && begin != std::string_view::npos && end != std::string_view::npos &&
           names_.contains(std::string(value.substr(begin + 1, end - begin - 1)));
  }

  void apply(const Declarations& declarations, Style& style) const {
    for (const auto& [name, value] : declarations) {
      if (value == "inherit") continue;
      if (name == "fill")
        style.fill = value, style.paintGiven = true;
      else if (name == "stroke")
        style.stroke = value, style.paintGiven = true;
      else if (name == "color")
        style.color = value;
      else if (name == "fill-rule")
        style.evenOdd = value == "evenodd";
      else if (name == "visibility")
        style.visible = value == "visible";
      else if (name == "display")
        style.displayed = value != "none";
      else if (name == "clip-path" || name == "mask")
        style.cropped = namesElement(value);
      else if (name == "overflow")
        style.overflows = value == "visible" || value == "auto";
    }
  }

  /// Attributes, then the style sheet, then the style attribute (SVG 1.1, 6.4).
  Style styled(const xml_node& node, Style style) const {
    style.croppedFromAbove = style.croppedFromAbove || style.cropped;
    style.cropped = style.overflows = false;
    Declarations attributes;
    for (const char* name :
         {"fill", "stroke", "color", "fill-rule", "visibility", "display", "clip-path", "mask", "overflow"})
      if (const auto a = node.attribute(name)) attributes.emplace(name, trimmed(a.value()));
    apply(attributes, style);
    if (!rules_.empty()) {
      const auto applyRule = [&](const std::string& selector) {
        if (const auto it = rules_.find(selector); it != rules_.end()) apply(it->second, style);
      };
      applyRule(std::string(nameOf(node)));
      std::string_view classes = node.attribute("class").value();
      for (std::string_view word = takeWord(classes); !word.empty(); word = takeWord(classes))
        applyRule("." + std::string(word));
      applyRule("#" + std::string(node.attribute("id").value()));
    }
    if (const auto a = node.attribute("style")) apply(parseDeclarations(a.value()), style);
    if (nameOf(node) == "g") {
      const std::string_view label = node.attribute("inkscape:label").value(), id = node.attribute("id").value();
      if (!label.empty() || !id.empty()) style.layer = utf8(label.empty() ? id : label);
    }
    return style;
  }

  void children(const xml_node& parent, const Affine& place, const Style& style, int depth) {
    if (depth > deepestNesting)
      throw Error(ErrorCode::LimitExceeded, fmt::format("Its elements are nested more than {} deep.", deepestNesting));
    for (const xml_node& node : parent.children())
      if (node.type() == pugi::node_element) element(node, place, style, depth);
  }

  void element(const xml_node& node, const Affine& outer, const Style& inherited, int depth) {
    if (++elements_ > maximumElements)
      throw Error(ErrorCode::LimitExceeded, fmt::format("It unfolds into more than {} elements.", maximumElements));
    if (elements_ % 1024 == 0) progress_.check();
    const std::string_view name = nameOf(node);
    const bool isContainer = name == "g" || name == "a" || name == "switch" || name == "svg" || name == "use";
    if (!isContainer && !isShape(name)) {
      if (name == "text" || name == "image" || name == "foreignObject") skipped_.add(name);
      return;
    }
    const Style style = styled(node, inherited);
    if (!style.displayed) return;
    Affine place = outer;
    if (const auto a = node.attribute("transform")) place = place * transformOf(node, a.value());
    if (!place.matrix().allFinite() || place.matrix().cwiseAbs().maxCoeff() > 1e15)
      throw damaged(lengths_.lineOf(node.offset_debug()), "its transforms scale beyond every measure.");
    if (name == "use")
      use(node, place, style, depth);
    else if (name == "svg")
      viewport(node, node, place, style, depth);
    else if (isContainer)
      children(node, place, style, depth + 1);
    else
      shape(node, name, place, style);
  }

  Affine transformOf(const xml_node& node, const char* text) const {
    try {
      return parseTransform(text);
    } catch (const Error& error) {
      throw damaged(lengths_.lineOf(node.offset_debug()), error.message());
    }
  }

  void use(const xml_node& node, const Affine& outer, const Style& style, int depth) {
    if (useDepth_ == 0) entities_.add("use");
    std::string_view reference = node.attribute("href").value();
    if (reference.empty()) reference = node.attribute("xlink:href").value();
    reference = trimmed(reference);
    if (reference.empty() || reference.front() != '#') return;
    const auto target = names_.find(std::string(reference.substr(1)));
    if (target == names_.end()) {
      ++lost_;
      return;
    }
    if (!open_.insert(target->first).second)
      throw damaged(lengths_.lineOf(node.offset_debug()), fmt::format("{} uses itself.", shown(target->first)));
    if (depth > deepestNesting)
      throw Error(ErrorCode::LimitExceeded, fmt::format("Its elements are nested more than {} deep.", deepestNesting));
    const Affine place = outer * Eigen::Translation2d(lengths_.x(node, "x"), lengths_.y(node, "y"));
    ++useDepth_;
    const std::string_view name = nameOf(target->second);
    if (name == "symbol")
      viewport(target->second, node, place, styled(target->second, style), depth);
    else
      element(target->second, place, style, depth + 1);
    --useDepth_;
    open_.erase(target->first);
  }

  /// A nested svg, or a symbol sized by the `use` that places it.
  void viewport(const xml_node& node, const xml_node& sized, const Affine& outer, const Style& style, int depth) {
    const Vec2 saved = lengths_.viewport;
    const bool isSymbol = nameOf(node) == "symbol";
    const double width = lengths_.x(sized, "width", lengths_.viewport.x()),
                 height = lengths_.y(sized, "height", lengths_.viewport.y());
    Affine place = isSymbol ? outer : Affine(outer * Eigen::Translation2d(lengths_.x(node, "x"), lengths_.y(node, "y")));
    const bool hasWindow = width > 0 && height > 0;
    const bool crops = hasWindow && !style.overflows && std::abs(place.linear().determinant()) >= 1e-18;
    if (crops) windows_.push_back({place, {width, height}});
    if (hasWindow) lengths_.viewport = {width, height};
    if (const auto box = lengths_.viewBox(node); box && hasWindow) {
      place = place * fitViewBox(*box, width, height, node.attribute("preserveAspectRatio").value());
      lengths_.viewport = {(*box)[2], (*box)[3]};
    }
    children(node, place, style, depth + 1);
    lengths_.viewport = saved;
    if (crops) windows_.pop_back();
  }

  void shape(const xml_node& node, std::string_view name, const Affine& place, const Style& style) {
    if (useDepth_ == 0) entities_.add(name);
    if (!style.visible) return;
    std::vector<Path> paths;
    try {
      paths = outlineOf(node, name, lengths_);
    } catch (const Error& error) {
      throw error.message().substr(0, 5) == "Line " ? error : damaged(lengths_.lineOf(node.offset_debug()), error.message());
    }
    if (std::abs(place.linear().determinant()) < 1e-18) {
      ++collapsed_;
      return;
    }
    const bool filled = style.fill != "none" && style.fill != "transparent" && name != "line";
    if (!filled && style.stroke == "none") ++unpainted_;
    if (style.cropped || style.croppedFromAbove) ++cropped_;
    if (filled) (style.evenOdd ? evenOdd_ : nonZero_) += paths.size();
    const std::size_t first = curves_.paths.size();
    for (Path& path : paths) add(std::move(path), place, style, filled);
    countOutside(first);
  }

  /// Whether any window crops a shape, whose paths begin with the given one.
  void countOutside(std::size_t first) {
    if (windows_.empty()) return;
    const std::span paths = std::span<const Path>(curves_.paths).subspan(first);
    const auto holds = [&](const CropWindow& window) { return window.holds(paths); };
    if (!std::all_of(windows_.begin(), windows_.end(), holds)) ++outside_;
  }

  void add(Path path, const Affine& place, const Style& style, bool filled) {
    segments_ += path.segments.size();
    if (segments_ > maximumSegments)
      throw Error(ErrorCode::LimitExceeded, fmt::format("It unfolds into more than {} lines and curves.", maximumSegments));
    if (const auto point = singlePoint({&path, 1})) {
      points_.emplace_back(place * *point);
      return;
    }
    if (filled && !path.closed) close(path);
    Path placed = transformed(std::move(path), Eigen::Matrix<double, 2, 3>(place.affine()));
    if (!allFinite(placed)) throw Error(ErrorCode::FormatDamaged, "A shape has a coordinate that is not a number.");
    placed.layer = style.layer;
    if (style.paintGiven) {
      const std::string& paint = filled ? style.fill : style.stroke;
      placed.color = parsePaint(paint == "currentColor" ? style.color : paint);
    }
    curves_.paths.push_back(std::move(placed));
  }

  /// Filling closes a path with a line. A single line encloses nothing and stays open.
  static void close(Path& path) {
    if (path.segments.size() == 1 && std::holds_alternative<Line2>(path.segments.front())) return;
    const Vec2 start = startPoint(path.segments.front()), end = endPoint(path.segments.back());
    if ((start - end).norm() > 1e-9) path.segments.push_back(Line2{end, start});
    path.closed = true;
  }

  Imported finished() {
    Imported imported;
    const auto warn = [&](bool when, std::string sentence) {
      if (when) imported.warnings.push_back(std::move(sentence));
    };
    std::string list;
    for (const auto& [name, count] : skipped_.counts())
      list += fmt::format("{}{} {}", list.empty() ? "" : ", ", count, name);
    warn(!skipped_.empty(), fmt::format("Left out, because a drawing of curves has no place for them: {}.", list));
    warn(lost_ > 0, fmt::format("{} elements use others that are not in the file.", lost_));
    warn(collapsed_ > 0, fmt::format("{} shapes are scaled to nothing and were left out.", collapsed_));
    warn(unpainted_ > 0, fmt::format("{} shapes have neither fill nor stroke; they were read all the same.", unpainted_));
    warn(cropped_ > 0, fmt::format("Read whole, although a clip-path or a mask may crop them: {} of its shapes.", cropped_));
    warn(
        outside_ > 0,
        fmt::format("Read whole, although the window of a nested svg or symbol may crop them: {} of its shapes.", outside_));
    const bool isPoint = curves_.paths.empty() && points_.size() == 1 && points_.front().allFinite();
    if (isPoint) curves_ = pointDrawing(points_.front());
    warn(!isPoint && !points_.empty(), fmt::format("{} paths without length were left out.", points_.size()));
    warn(evenOdd_ > 0 && nonZero_ > 0, "Its shapes use both fill rules; all are read with the rule nonzero.");
    curves_.fillRule = evenOdd_ > 0 && nonZero_ == 0 ? FillRule::EvenOdd : FillRule::NonZero;
    imported.entities = entities_.toValue();
    imported.skipped = skipped_.toValue();
    imported.shape = Shape(std::move(curves_));
    return imported;
  }

  const std::string& content_;
  const Progress& progress_;
  pugi::xml_document document_;
  std::unordered_map<std::string, xml_node> names_;
  std::map<std::string, Declarations, std::less<>> rules_;
  Lengths lengths_;
  Curves curves_;
  std::vector<Vec2> points_;  ///< paths without length
  Counter entities_, skipped_;
  std::set<std::string> open_;
  std::vector<CropWindow> windows_;  ///< that the element being read lies in
  std::size_t elements_ = 0, segments_ = 0, lost_ = 0, collapsed_ = 0, unpainted_ = 0, cropped_ = 0, outside_ = 0,
              evenOdd_ = 0, nonZero_ = 0;
  int useDepth_ = 0;
};

}  // namespace

Imported readDocument(const std::string& content, const Progress& progress) { return Reader(content, progress).read(); }

}  // namespace blossom::svg
