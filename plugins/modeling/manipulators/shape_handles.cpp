#include "manipulators/shape_handles.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <functional>
#include <map>
#include <numbers>

namespace blossom::modeling {
namespace {

using std::numbers::pi;

constexpr double smallest = 1e-6;  // mm

double number(const Value& p, const char* name) { return p.at(name).get<double>(); }
double turn(const Value& p) { return number(p, "rotation") * pi / 180; }
Vec2 place(const Value& p, const char* name) { return {p.at(name).at(0).get<double>(), p.at(name).at(1).get<double>()}; }
Vec2 centre(const Value& p) { return place(p, "centre"); }
Vec2 around(double radius, double angle) { return radius * Vec2(std::cos(angle), std::sin(angle)); }
Vec2 turned(const Vec2& v, double angle) {
  const double c = std::cos(angle), s = std::sin(angle);
  return {c * v.x() - s * v.y(), s * v.x() + c * v.y()};
}

void setCentre(Value& p, const Vec2& to) { p["centre"] = Value::array({to.x(), to.y(), p.at("centre").at(2)}); }

/// Degrees without the last digits, in which rounding shows.
void setRotation(Value& p, double angle) { p["rotation"] = std::round(angle * 180 / pi * 1e9) / 1e9; }

bool setLength(Value& p, const char* name, double value) {
  if (!(value > smallest)) return false;
  p[name] = value;
  return true;
}

double angleOf(const Vec2& v) { return std::atan2(v.y(), v.x()); }

/// The handles of one kind of shape after the first, and the effect of dragging them.
struct Behaviour {
  std::function<std::vector<ShapeHandle>(const Value&)> handles;
  std::function<bool(Value&, std::size_t, const Vec2& offset)> drag;  ///< offset from the centre
};

Behaviour circleBehaviour() {
  return {[](const Value& p) -> std::vector<ShapeHandle> {
            return {{centre(p) + Vec2(number(p, "radius"), 0), HandleRole::Size}};
          },
          [](Value& p, std::size_t, const Vec2& offset) { return setLength(p, "radius", offset.norm()); }};
}

Behaviour ellipseBehaviour() {
  return {[](const Value& p) -> std::vector<ShapeHandle> {
            return {{centre(p) + around(number(p, "a"), turn(p)), HandleRole::Corner},
                    {centre(p) + around(number(p, "b"), turn(p) + pi / 2), HandleRole::Size}};
          },
          [](Value& p, std::size_t handle, const Vec2& offset) {
            if (handle == 2) return setLength(p, "b", std::abs(offset.dot(around(1, turn(p) + pi / 2))));
            setRotation(p, angleOf(offset));
            return setLength(p, "a", offset.norm());
          }};
}

double shrink(const Value& p) { return p.at("size") == "circumscribed" ? std::cos(pi / p.at("sides").get<double>()) : 1; }

Behaviour polygonBehaviour() {
  return {[](const Value& p) -> std::vector<ShapeHandle> {
            return {{centre(p) + around(number(p, "radius") / shrink(p), turn(p)), HandleRole::Corner}};
          },
          [](Value& p, std::size_t, const Vec2& offset) {
            setRotation(p, angleOf(offset));
            return setLength(p, "radius", offset.norm() * shrink(p));
          }};
}

Behaviour starBehaviour() {
  const auto half = [](const Value& p) { return pi / p.at("points").get<double>(); };
  return {[half](const Value& p) -> std::vector<ShapeHandle> {
            return {{centre(p) + around(number(p, "outer"), turn(p)), HandleRole::Corner},
                    {centre(p) + around(number(p, "inner"), turn(p) + half(p)), HandleRole::Size}};
          },
          [half](Value& p, std::size_t handle, const Vec2& offset) {
            if (handle == 2) return setLength(p, "inner", offset.dot(around(1, turn(p) + half(p))));
            setRotation(p, angleOf(offset));
            return setLength(p, "outer", offset.norm());
          }};
}

constexpr std::array<std::array<double, 2>, 4> signs{{{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}};

Vec2 halves(const Value& p) { return {number(p, "width") / 2, number(p, "height") / 2}; }

/// The corner opposite to the dragged one stays.
bool dragCorner(Value& p, std::size_t corner, const Vec2& offset) {
  const Vec2 sign(signs.at(corner)[0], signs.at(corner)[1]);
  const Vec2 fixed = -sign.cwiseProduct(halves(p)), grabbed = turned(offset, -turn(p));
  const Vec2 size = (grabbed - fixed).cwiseProduct(sign);
  setCentre(p, centre(p) + turned((grabbed + fixed) / 2, turn(p)));
  p["corner"] = std::clamp(number(p, "corner"), 0.0, std::max(0.0, size.minCoeff() / 2));
  return setLength(p, "width", size.x()) && setLength(p, "height", size.y());
}

Behaviour rectangleBehaviour() {
  return {[](const Value& p) {
            std::vector<ShapeHandle> handles;
            handles.reserve(signs.size() + 1);
            for (const auto& sign : signs)
              handles.push_back(
                  {centre(p) + turned(Vec2(sign[0], sign[1]).cwiseProduct(halves(p)), turn(p)), HandleRole::Corner});
            // At the end of the rounding on the upper side.
            const Vec2 rounding(halves(p).x() - number(p, "corner"), halves(p).y());
            if (number(p, "corner") > 0) handles.push_back({centre(p) + turned(rounding, turn(p)), HandleRole::Rounding});
            return handles;
          },
          [](Value& p, std::size_t handle, const Vec2& offset) {
            if (handle <= signs.size()) return dragCorner(p, handle - 1, offset);
            p["corner"] = std::clamp(halves(p).x() - turned(offset, -turn(p)).x(), 0.0, halves(p).minCoeff());
            return true;
          }};
}

bool dragEnd(Value& p, double side, const Vec2& offset) {
  const Vec2 fixed = around(-side * number(p, "length") / 2, turn(p));
  const Vec2 along = (offset - fixed) * side;
  if (along.norm() < number(p, "width")) return false;
  setCentre(p, centre(p) + (offset + fixed) / 2);
  setRotation(p, angleOf(along));
  return setLength(p, "length", along.norm());
}

Behaviour slotBehaviour() {
  return {[](const Value& p) -> std::vector<ShapeHandle> {
            const Vec2 end = around(number(p, "length") / 2, turn(p));
            return {{centre(p) + end, HandleRole::Corner},
                    {centre(p) - end, HandleRole::Corner},
                    {centre(p) + around(number(p, "width") / 2, turn(p) + pi / 2), HandleRole::Size}};
          },
          [](Value& p, std::size_t handle, const Vec2& offset) {
            if (handle <= 2) return dragEnd(p, handle == 1 ? 1 : -1, offset);
            const double width = 2 * std::abs(offset.dot(around(1, turn(p) + pi / 2)));
            return setLength(p, "width", std::min(width, number(p, "length")));
          }};
}

const std::map<std::string, Behaviour>& behaviours() {
  static const std::map<std::string, Behaviour> all{
      {"modeling.circle", circleBehaviour()},       {"modeling.ellipse", ellipseBehaviour()},
      {"modeling.polygon", polygonBehaviour()},     {"modeling.star", starBehaviour()},
      {"modeling.rectangle", rectangleBehaviour()}, {"modeling.slot", slotBehaviour()}};
  return all;
}

/// Shapes that can be moved and nothing else.
constexpr std::array movedTypes{"modeling.text", "modeling.point"};

bool isOnlyMoved(const std::string& type) {
  return std::find(movedTypes.begin(), movedTypes.end(), type) != movedTypes.end();
}

}  // namespace

const std::vector<std::string>& typesWithHandles() {
  static const std::vector<std::string> types = [] {
    std::vector<std::string> names(movedTypes.begin(), movedTypes.end());
    for (const auto& [name, behaviour] : behaviours()) names.push_back(name);
    return names;
  }();
  return types;
}

std::vector<ShapeHandle> shapeHandles(const std::string& featureType, const Value& parameters) {
  if (isOnlyMoved(featureType)) return {{place(parameters, "at"), HandleRole::Centre}};
  std::vector<ShapeHandle> handles{{centre(parameters), HandleRole::Centre}};
  for (const ShapeHandle& handle : behaviours().at(featureType).handles(parameters)) handles.push_back(handle);
  return handles;
}

std::vector<ShapeDimension> shapeDimensions(const std::string& featureType, const Value& p) {
  const auto beyond = [&](const char* name, double angle, bool radius = true) {
    return ShapeDimension{centre(p) + around(number(p, name), angle), around(1, angle), name, radius};
  };
  const auto side = [&](const char* name, const Vec2& from, const Vec2& outward) {
    return ShapeDimension{centre(p) + turned(from, turn(p)), turned(outward, turn(p)), name, false};
  };
  if (featureType == "modeling.circle") return {beyond("radius", pi / 4)};
  if (featureType == "modeling.ellipse") return {beyond("a", turn(p)), beyond("b", turn(p) + pi / 2)};
  if (featureType == "modeling.polygon") return {beyond("radius", turn(p))};
  if (featureType == "modeling.star")
    return {beyond("outer", turn(p)), beyond("inner", turn(p) + pi / p.at("points").get<double>())};
  if (featureType == "modeling.rectangle")
    return {side("width", {0, halves(p).y()}, Vec2::UnitY()), side("height", {halves(p).x(), 0}, Vec2::UnitX())};
  if (featureType == "modeling.slot")
    return {side("length", {0, number(p, "width") / 2}, Vec2::UnitY()),
            side("width", {number(p, "length") / 2, 0}, Vec2::UnitX())};
  return {};
}

std::optional<Value> draggedHandle(const std::string& featureType, const Value& parameters, std::size_t handle,
                                   const Vec2& to) {
  Value next = parameters;
  if (isOnlyMoved(featureType)) {
    next["at"] = Value::array({to.x(), to.y(), parameters.at("at").at(2)});
    return next;
  }
  if (handle == 0) {
    setCentre(next, to);
    return next;
  }
  if (!behaviours().at(featureType).drag(next, handle, to - centre(parameters))) return std::nullopt;
  return next;
}

}  // namespace blossom::modeling
