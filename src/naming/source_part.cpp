#include "naming/source_part.h"

#include <algorithm>
#include <array>

#include "geometry/planar/planar.h"

namespace blossom {

namespace {

/// Where a segment of a drawing lies.
struct SegmentPlace {
  std::size_t form = 0;
  std::array<Vec2, 3> points;  ///< its start, a point that its bulge moves, its end

  [[nodiscard]] bool isAt(const SegmentPlace& other, double tolerance) const {
    return form == other.form && std::equal(points.begin(), points.end(), other.points.begin(),
                                            [&](const Vec2& a, const Vec2& b) { return (a - b).norm() <= tolerance; });
  }
};

Vec2 bulgeOf(const Segment& segment) {
  if (const auto* line = std::get_if<Line2>(&segment)) return (line->from + line->to) / 2;
  if (const auto* arc = std::get_if<Arc2>(&segment)) {
    const double middle = arc->start + arc->sweep / 2;
    return arc->center + arc->radius * Vec2(std::cos(middle), std::sin(middle));
  }
  Vec2 sum = Vec2::Zero();
  const auto& poles = std::get<Spline2>(segment).poles;
  for (const Vec3& pole : poles) sum += pole.head<2>() / pole.z();
  return sum / static_cast<double>(std::max<std::size_t>(1, poles.size()));
}

SegmentPlace placeOf(const Segment& segment) {
  return {segment.index(), {startPoint(segment), bulgeOf(segment), endPoint(segment)}};
}

const std::vector<Path>* pathsOf(const Shape& shape) {
  if (const auto* region = shape.get<Region>()) return &region->loops;
  const auto* curves = shape.get<Curves>();
  return curves ? &curves->paths : nullptr;
}

/// A loop of a drawing as the places of its segments.
struct Loop {
  std::vector<SegmentPlace> segments;
  bool closed = false;
  int first = 0;  ///< number of its first segment

  [[nodiscard]] int size() const { return static_cast<int>(segments.size()); }
  /// nullptr beyond the ends of an open one.
  [[nodiscard]] const SegmentPlace* at(int k) const {
    if (closed) return &segments[static_cast<std::size_t>((k % size() + size()) % size())];
    return k >= 0 && k < size() ? &segments[static_cast<std::size_t>(k)] : nullptr;
  }
};

std::vector<Loop> loopsOf(const std::vector<Path>& paths) {
  std::vector<Loop> loops;
  int number = 0;
  for (const Path& path : paths) {
    Loop& loop = loops.emplace_back();
    loop.closed = path.closed;
    loop.first = number;
    for (const Segment& segment : path.segments) loop.segments.push_back(placeOf(segment));
    number += loop.size();
  }
  return loops;
}

Value toJson(const SegmentPlace* place) {
  if (!place) return {};
  Value json = Value::array({place->form});
  for (const Vec2& p : place->points) {
    json.push_back(p.x());
    json.push_back(p.y());
  }
  return json;
}

SegmentPlace placeFrom(const Value& json) {
  SegmentPlace place;
  place.form = json.at(0).get<std::size_t>();
  for (std::size_t k = 0; k < 3; ++k)
    place.points.at(k) = {json.at(1 + 2 * k).get<double>(), json.at(2 + 2 * k).get<double>()};
  return place;
}

std::optional<SegmentPlace> segmentFrom(const Value& json) {
  return json.is_null() ? std::nullopt : std::optional(placeFrom(json));
}

/// The middle of the corners of a loop.
Vec2 middleOf(const Loop& loop) {
  Vec2 sum = Vec2::Zero();
  for (const SegmentPlace& segment : loop.segments) sum += segment.points[0] + segment.points[1];
  return sum / std::max(1.0, 2.0 * static_cast<double>(loop.size()));
}

Value middlesOf(const std::vector<Loop>& loops) {
  Value middles = Value::array();
  for (const Loop& loop : loops) {
    const Vec2 middle = middleOf(loop);
    middles.push_back({middle.x(), middle.y()});
  }
  return middles;
}

Value describedSegment(const std::vector<Path>& paths, int index) {
  const std::vector<Loop> loops = loopsOf(paths);
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const Loop& loop = loops[l];
    const int k = index - loop.first;
    if (k < 0 || k >= loop.size()) continue;
    return {{"loop", l},
            {"loops", loops.size()},
            {"middles", middlesOf(loops)},
            {"place", k},
            {"count", loop.size()},
            {"own", toJson(loop.at(k))},
            {"before", toJson(loop.at(k - 1))},
            {"after", toJson(loop.at(k + 1))}};
  }
  return Value::object();
}

/// Looks for a segment of old in a loop of now.
class SegmentFinder {
 public:
  SegmentFinder(const Value& described, double tolerance)
      : own_(placeFrom(described.at("own"))),
        before_(segmentFrom(described.at("before"))),
        after_(segmentFrom(described.at("after"))),
        place_(described.at("place").get<int>()),
        count_(described.at("count").get<int>()),
        tolerance_(tolerance) {}

  /// Segments that lie where it lay.
  [[nodiscard]] std::vector<int> unmoved(const Loop& loop) const {
    std::vector<int> found;
    for (int k = 0; k < loop.size(); ++k)
      if (loop.at(k)->isAt(own_, tolerance_)) found.push_back(k);
    return found;
  }

  /// In the loop that it belonged to, where it does not lie any more.
  /// @param alone the drawing has no other loops
  [[nodiscard]] std::optional<int> inItsLoop(const Loop& loop, bool alone) const {
    const std::optional<int> next = after(loop), previous = ahead(loop);
    if (next && previous && *next == *previous) return next;
    if (loop.size() != count_) return alongIt(loop);
    // It moved, and so did the neighbours that are not where they were. One that others have shifted is not guessed.
    const auto keeps = [&](const std::optional<int>& k) { return !k || *k == place_; };
    if (!keeps(next) || !keeps(previous)) return std::nullopt;
    return alone || next || previous || isMoved(*loop.at(place_)) ? std::optional(place_) : std::nullopt;
  }

 private:
  static std::optional<int> only(const Loop& loop, const std::optional<SegmentPlace>& wanted, double tolerance) {
    std::optional<int> found;
    for (int k = 0; wanted && k < loop.size(); ++k) {
      if (!loop.at(k)->isAt(*wanted, tolerance)) continue;
      if (found) return std::nullopt;
      found = k;
    }
    return found;
  }
  static std::optional<int> beside(const Loop& loop, std::optional<int> k, int step) {
    if (!k || !loop.at(*k + step)) return std::nullopt;
    return loop.closed ? (*k + step + loop.size()) % loop.size() : *k + step;
  }
  /// The only straight segment that runs along it: one that was cut shorter, or lengthened.
  [[nodiscard]] std::optional<int> alongIt(const Loop& loop) const {
    std::optional<int> found;
    for (int k = 0; k < loop.size(); ++k) {
      if (!overlaps(*loop.at(k))) continue;
      if (found) return std::nullopt;
      found = k;
    }
    return found;
  }
  /// Of an arc: through its ends and its middle.
  static Vec2 centreOf(const SegmentPlace& arc) {
    const Vec2 ab = arc.points[1] - arc.points[0], ac = arc.points[2] - arc.points[0];
    const double twice = 2 * cross(ab, ac);
    constexpr double closed = 1e-9;
    if (ac.norm() <= closed * ab.norm()) return arc.points[0] + ab / 2;  // a full circle, whose middle lies opposite
    const Vec2 off(ac.y() * ab.squaredNorm() - ab.y() * ac.squaredNorm(),
                   ab.x() * ac.squaredNorm() - ac.x() * ab.squaredNorm());
    return arc.points[0] + off / twice;
  }
  /// Whether it may be this one as a whole: shifted, or, round, of another size about the same centre.
  [[nodiscard]] bool isMoved(const SegmentPlace& other) const {
    if (other.form != own_.form) return false;
    const auto shift = [&](std::size_t k) -> Vec2 { return other.points.at(k) - own_.points.at(k); };
    const bool shifted = (shift(0) - shift(1)).norm() <= 2 * tolerance_ && (shift(0) - shift(2)).norm() <= 2 * tolerance_;
    constexpr std::size_t arc = 1;
    return shifted || (own_.form == arc && (centreOf(own_) - centreOf(other)).norm() <= 2 * tolerance_);
  }
  [[nodiscard]] bool overlaps(const SegmentPlace& other) const {
    const Vec2 along = own_.points[2] - own_.points[0];
    const double length = along.norm();
    if (own_.form != 0 || other.form != 0 || length <= tolerance_) return false;
    const auto offset = [&](const Vec2& p) { return std::abs(cross(along, p - own_.points[0])) / length; };
    const double from = along.dot(other.points[0] - own_.points[0]) / length,
                 to = along.dot(other.points[2] - own_.points[0]) / length;
    return offset(other.points[0]) <= tolerance_ && offset(other.points[2]) <= tolerance_ && from < to &&
           from < length - tolerance_ && to > tolerance_;
  }
  [[nodiscard]] std::optional<int> after(const Loop& loop) const { return beside(loop, only(loop, before_, tolerance_), 1); }
  [[nodiscard]] std::optional<int> ahead(const Loop& loop) const { return beside(loop, only(loop, after_, tolerance_), -1); }

  SegmentPlace own_;
  std::optional<SegmentPlace> before_, after_;
  int place_, count_;
  double tolerance_;
};

/// Whether a loop lies where another one lay when the part was described.
bool liesInPlaceOfAnother(const Value& described, const std::vector<Loop>& loops, std::size_t loop, double tolerance) {
  const Value& middles = described.at("middles");
  const Vec2 now = middleOf(loops[loop]);
  for (std::size_t k = 0; k < middles.size(); ++k) {
    const Vec2 then(middles[k].at(0).get<double>(), middles[k].at(1).get<double>());
    if (k != loop && (now - then).norm() <= tolerance) return true;
  }
  return false;
}

// It is where it lay; or, while no loops were added or removed, which may have shifted the others, in the one with its
// number.
std::optional<int> foundSegment(const Value& described, const std::vector<Path>& paths, double tolerance) {
  if (!described.contains("own")) return std::nullopt;
  const std::vector<Loop> loops = loopsOf(paths);
  const SegmentFinder finder(described, tolerance);
  std::optional<int> unmoved;
  for (const Loop& each : loops)
    for (const int k : finder.unmoved(each)) {
      if (unmoved) return std::nullopt;
      unmoved = each.first + k;
    }
  const auto loop = described.at("loop").get<std::size_t>();
  if (unmoved || loops.size() != described.at("loops").get<std::size_t>() || loop >= loops.size()) return unmoved;
  if (loops.size() > 1 && liesInPlaceOfAnother(described, loops, loop, tolerance)) return std::nullopt;
  const auto k = finder.inItsLoop(loops[loop], loops.size() == 1);
  return k ? std::optional(loops[loop].first + *k) : std::nullopt;
}

std::optional<int> foundByLikeness(const Value& described, const Shape& now, SubShapeKind kind) {
  const int index = described.at("index").get<int>();
  const std::vector<Likeness> all = likenesses(now, kind);
  const Likeness wanted = likenessFrom(described.at("likeness"));
  if (described.at("structure") == structureOf(now)) {
    // Unless another part lies where it lay: then the parts have got other numbers.
    const auto lies = [&](std::size_t k) { return all[k].isLike(wanted, samePlace(now)); };
    bool other = false;
    for (std::size_t k = 0; k < all.size(); ++k) other = other || (static_cast<int>(k) != index && lies(k));
    const bool there = index >= 0 && static_cast<std::size_t>(index) < all.size();
    return there && (!other || lies(static_cast<std::size_t>(index))) ? std::optional(index) : std::nullopt;
  }
  std::optional<int> found;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (!all[k].isLike(wanted, samePlace(now))) continue;
    if (found) return std::nullopt;
    found = static_cast<int>(k);
  }
  return found;
}

}  // namespace

Value describedSourcePart(const Shape& shape, SubShapeKind kind, int index) {
  Value described{{"index", index}};
  const std::vector<Path>* paths = pathsOf(shape);
  if (paths && kind == SubShapeKind::Edge) {
    described.update(describedSegment(*paths, index));
  } else if (!paths) {
    described["structure"] = structureOf(shape);
    described["likeness"] = toJson(likenessOf(shape, kind, index));
  }
  return described;
}

std::optional<int> foundSourcePart(const Value& described, const Shape& now, SubShapeKind kind) {
  const std::vector<Path>* paths = pathsOf(now);
  if (paths && kind == SubShapeKind::Edge) return foundSegment(described, *paths, samePlace(now));
  if (paths) return kind == SubShapeKind::Face ? std::optional(0) : std::nullopt;
  return described.contains("structure") ? foundByLikeness(described, now, kind) : std::nullopt;
}

}  // namespace blossom
