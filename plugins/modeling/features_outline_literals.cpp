#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "core/units.h"
#include "features_outline.h"
#include "features_outline_text.h"
#include "geometry/planar/single_point.h"
#include "kernel/outline/outline_shapes.h"

namespace blossom::modeling {
namespace {

/// The measures of a literal form, each between colons.
class Measures {
 public:
  Measures(const LiteralForm& form, std::string_view text) : form_(form) {
    for (std::size_t from = 0; from <= text.size();) {
      const std::size_t to = std::min(text.find(':', from), text.size());
      parts_.push_back(text.substr(from, to - from));
      from = to + 1;
    }
  }
  void expect(std::size_t count) const {
    if (parts_.size() != count) refuse(fmt::format("{} measures are wanted, {} are given.", count, parts_.size()));
  }
  [[nodiscard]] double length(std::size_t k) const {
    try {
      return parseLength(parts_.at(k));
    } catch (const Error& e) {
      refuse(e.message());
    }
  }
  [[nodiscard]] int count(std::size_t k) const {
    const double number = length(k);
    if (number != std::floor(number) || number < 0 || number > 10000)
      refuse(fmt::format("{} must be a whole number up to 10000.", formatNumber(number)));
    return static_cast<int>(number);
  }

 private:
  [[noreturn]] void refuse(const std::string& why) const {
    throw Error(ErrorCode::InvalidParameter, fmt::format("This is not a proper {}: {}", form_.name, why),
                fmt::format("Write {}, with lengths in mm.", form_.syntax));
  }
  const LiteralForm& form_;
  std::vector<std::string_view> parts_;
};

/// A form whose measures are lengths and counts, made about the origin.
template <class Make>
LiteralForm measured(std::string name, std::string syntax, std::string summary, std::size_t count, Make make) {
  LiteralForm form{std::move(name), std::move(syntax), std::move(summary), {}};
  form.parse = [declared = form, count, make](std::string_view text) -> Shape {
    const Measures measures(declared, text);
    measures.expect(count);
    return make(measures);
  };
  return form;
}

LiteralForm textLiteral() {
  return {"text", "text:WORDS", "A text 10 mm high in the standard font.",
          [](std::string_view words) -> Shape {
            return textOutline(std::string(words), fontFace(defaultFont, FontStyle::Regular), {}).region;
          },
          [] { return fontState(defaultFont, FontStyle::Regular); }};
}

}  // namespace

void addOutlineLiterals(Registry& registry) {
  const Vec2 origin = Vec2::Zero();
  using M = Measures;
  registry.add(measured("circle", "circle:RADIUS", "A circle about the origin.", 1,
                        [=](const M& m) { return circle(m.length(0), origin); }));
  registry.add(measured("ellipse", "ellipse:A:B", "An ellipse with half-axes along x and y.", 2,
                        [=](const M& m) { return ellipse(m.length(0), m.length(1), origin, 0); }));
  registry.add(measured("polygon", "polygon:SIDES:RADIUS", "A regular polygon with a corner on the x axis.", 2,
                        [=](const M& m) { return regularPolygon(m.count(0), m.length(1), origin, 0); }));
  registry.add(measured("star", "star:POINTS:OUTER:INNER", "A star with a point upwards.", 3, [=](const M& m) {
    return star(m.count(0), m.length(1), m.length(2), origin, std::numbers::pi / 2);
  }));
  registry.add(measured("rectangle", "rectangle:WIDTH:HEIGHT", "A rectangle about the origin.", 2,
                        [=](const M& m) { return rectangle(m.length(0), m.length(1), 0, origin, 0); }));
  registry.add(
      measured("point", "point:X:Y", "A point of the plane, a line without length in a drawing.", 2, [](const M& m) {
        return Shape(pointDrawing({m.length(0), m.length(1)}));
      }));
  registry.add(textLiteral());
}

}  // namespace blossom::modeling
