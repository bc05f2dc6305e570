#include "manipulators/side_writing.h"

#include <cmath>
#include <vector>

#include "core/error.h"
#include "core/units.h"
#include "features_outline_value.h"

namespace blossom::modeling {
namespace {

constexpr double nothing = 1e-9;  // mm: no more than rounding

/// A point of an outline: its start (segment -1), the end of a segment, or a point that the segment passes.
struct Place {
  int segment = -1;
  int through = -1;
};

std::vector<Place> placesOf(const DrawnOutline& outline) {
  std::vector<Place> places{{}};
  for (int k = 0; k < static_cast<int>(outline.segments.size()); ++k) {
    places.push_back({k, -1});
    const auto count = outline.segments[static_cast<std::size_t>(k)].through.size();
    for (int t = 0; t < static_cast<int>(count); ++t) places.push_back({k, t});
  }
  return places;
}

Place beginOf(const StraightSide& side) { return {side.segment - 1, -1}; }
Place endOf(const StraightSide& side, const DrawnOutline& outline) {
  return side.segment < static_cast<int>(outline.segments.size()) ? Place{side.segment, -1} : Place{};
}

double coordinate(const DrawnOutline& outline, const Place& place, int axis) {
  if (place.segment < 0) return outline.start[axis];
  const DrawnSegment& segment = outline.segments.at(static_cast<std::size_t>(place.segment));
  return (place.through < 0 ? segment.to : segment.through.at(static_cast<std::size_t>(place.through)))[axis];
}

template <class V>
V* fieldOf(V* value, const char* name) {
  return value && value->is_object() && value->contains(name) ? &value->at(name) : nullptr;
}
template <class V>
V* itemOf(V* value, int index) {
  return value && value->is_array() && static_cast<int>(value->size()) > index ? &value->at(static_cast<std::size_t>(index))
                                                                               : nullptr;
}

/// Where a coordinate is written; nullptr: it has its default, or the whole point is a text.
template <class V>
V* writtenAt(V& parameters, const Place& place, int axis) {
  if (place.segment < 0) return itemOf(fieldOf(&parameters, "start"), axis);
  V* record = itemOf(fieldOf(&parameters, "segments"), place.segment);
  if (place.through < 0) return itemOf(fieldOf(record, "to"), axis);
  return itemOf(itemOf(fieldOf(record, "through"), place.through), axis);
}

bool isText(const Value* written) { return written && (written->is_string() || isNamedExpression(*written)); }

/// The coordinates of an outline as texts: expressions as they were written, else numbers in mm.
struct Texts {
  const Value& written;
  const DrawnOutline& outline;

  [[nodiscard]] bool expressed(const Place& place, int axis) const { return isText(writtenAt(written, place, axis)); }
  [[nodiscard]] std::string at(const Place& place, int axis) const {
    const Value* value = writtenAt(written, place, axis);
    if (!isText(value)) return formatNumber(coordinate(outline, place, axis) + 0.0);
    return value->is_string() ? value->get<std::string>() : value->at("expression").get<std::string>();
  }
};

std::string stepped(const std::string& text, double by) {
  const double shown = std::round(std::abs(by) * 1e9) / 1e9;
  return shown < nothing ? text : text + (by < 0 ? "-" : "+") + formatNumber(shown);
}

std::string farEnd(const std::string& nearEnd, bool forwards, const std::string& length) {
  if (nearEnd == "0") return forwards ? length : "-(" + length + ")";
  return nearEnd + (forwards ? "+(" : "-(") + length + ")";
}

bool balanced(const std::string& text) {
  int depth = 0;
  for (const char c : text) {
    if (c == '(') ++depth;
    if (c == ')' && --depth < 0) return false;
  }
  return depth == 0;
}

/// The inverse of farEnd; empty when the far end is not written so.
std::string lengthBetween(const std::string& nearEnd, bool forwards, const std::string& farText) {
  if (nearEnd == "0" && forwards) return farText;
  const std::string front = farEnd(nearEnd, forwards, {});  // ends in "()"
  const std::size_t from = front.size() - 1;
  if (farText.size() <= from || farText.compare(0, from, front, 0, from) != 0 || farText.back() != ')') return {};
  const std::string inner = farText.substr(from, farText.size() - from - 1);
  return balanced(inner) ? inner : std::string();
}

bool goesOn(const std::string& text, const std::string& front) {
  return text.size() > front.size() && text.starts_with(front) && (text[front.size()] == '+' || text[front.size()] == '-');
}

bool runsForwards(const StraightSide& side, int axis) { return side.to[axis] > side.from[axis]; }

/// What a coordinate that goes with the end of the side becomes.
std::string following(const SideEdit& edit, const Texts& before, const Texts& after, const Place& place, int axis) {
  const Place end = endOf(edit.side, edit.before);
  std::string next = farEnd(after.at(beginOf(edit.side), axis), runsForwards(edit.side, axis), edit.length);
  const std::string was = before.at(end, axis), text = before.at(place, axis);
  if (text == was) return next;
  if (!before.expressed(end, axis) && !before.expressed(place, axis))
    return stepped(next, coordinate(edit.before, place, axis) - coordinate(edit.before, end, axis));
  if (goesOn(text, was)) return next + text.substr(was.size());
  return text + "+(" + next + ")-(" + was + ")";
}

/// A coordinate as the document keeps it; the plain number where the text comes to something else.
Value keptCoordinate(const std::string& text, double value, const NamedNumbers& names) {
  try {
    ParameterSpec spec = length();
    spec.name = "coordinate";
    const Value written = writtenText(spec, text, names);
    const bool named = isNamedExpression(written);
    const double comesTo = (named ? written.at("value") : written).get<double>();
    if (std::abs(comesTo - value) > 1e-6 * (1 + std::abs(value))) return value;
    return named ? written : Value(text);
  } catch (const Error&) {
    return value;
  }
}

}  // namespace

std::optional<int> axisOf(const StraightSide& side) {
  const Vec2 along = (side.to - side.from).normalized();
  if (std::abs(along.y()) <= nothing) return 0;
  if (std::abs(along.x()) <= nothing) return 1;
  return std::nullopt;
}

std::string writtenLength(const Value& written, const DrawnOutline& outline, const StraightSide& side) {
  const auto axis = axisOf(side);
  if (!axis) return {};
  const Texts texts{written, outline};
  const Place begin = beginOf(side), end = endOf(side, outline);
  const bool forwards = runsForwards(side, *axis);
  const std::string from = texts.at(begin, *axis), to = texts.at(end, *axis);
  if (texts.expressed(end, *axis))
    if (std::string found = lengthBetween(from, forwards, to); !found.empty()) return found;
  return texts.expressed(begin, *axis) ? lengthBetween(to, !forwards, from) : std::string();
}

Value withExpressions(Value next, const Value& written, const SideEdit& edit, const NamedNumbers& names) {
  if (!next.contains("start")) next["start"] = pointValue(edit.after.start);
  const Texts before{written, edit.before}, after{next, edit.after};
  const std::optional<int> along = edit.length.empty() ? std::nullopt : axisOf(edit.side);
  Value result = next;
  for (const Place& place : placesOf(edit.before)) {
    for (const int axis : {0, 1}) {
      const double was = coordinate(edit.before, place, axis), is = coordinate(edit.after, place, axis);
      const bool moves = std::abs(coordinate(edit.moved, place, axis) - was) > nothing;
      Value* target = writtenAt(result, place, axis);
      if (!target) continue;
      if (moves && along == axis) {
        *target = keptCoordinate(following(edit, before, after, place, axis), is, names);
      } else if (before.expressed(place, axis)) {
        *target =
            moves ? keptCoordinate(stepped(before.at(place, axis), is - was), is, names) : *writtenAt(written, place, axis);
      }
    }
  }
  return result;
}

}  // namespace blossom::modeling
