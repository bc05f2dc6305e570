#include "naming/source_part.h"

#include <algorithm>

#include "naming/segment_finder.h"

namespace blossom {

namespace {

const std::vector<Path>* pathsOf(const Shape& shape) {
  if (const auto* region = shape.get<Region>()) return &region->loops;
  const auto* curves = shape.get<Curves>();
  return curves ? &curves->paths : nullptr;
}

/// The middle of the corners of a loop.
Vec2 middleOf(const PlacedLoop& loop) {
  Vec2 sum = Vec2::Zero();
  for (const SegmentPlace& segment : loop.segments) sum += segment.points[0] + segment.points[1];
  return sum / std::max(1.0, 2.0 * static_cast<double>(loop.size()));
}

Value middlesOf(const std::vector<PlacedLoop>& loops) {
  Value middles = Value::array();
  for (const PlacedLoop& loop : loops) {
    const Vec2 middle = middleOf(loop);
    middles.push_back({middle.x(), middle.y()});
  }
  return middles;
}

Value describedSegment(const std::vector<Path>& paths, int index) {
  const std::vector<PlacedLoop> loops = placedLoopsOf(paths);
  for (std::size_t l = 0; l < loops.size(); ++l) {
    const PlacedLoop& loop = loops[l];
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

/// Whether a loop lies where another one lay when the part was described.
bool liesInPlaceOfAnother(const Value& described, const std::vector<PlacedLoop>& loops, std::size_t loop, double tolerance) {
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
  const std::vector<PlacedLoop> loops = placedLoopsOf(paths);
  const SegmentFinder finder(described, tolerance);
  std::optional<int> unmoved;
  for (const PlacedLoop& each : loops)
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

std::vector<int> piecesOfSourcePart(const Value& described, const Shape& now, SubShapeKind kind) {
  std::vector<int> pieces;
  const std::vector<Path>* paths = pathsOf(now);
  if (!paths || kind != SubShapeKind::Edge || !described.contains("own")) return pieces;
  const SegmentFinder finder(described, samePlace(now));
  for (const PlacedLoop& loop : placedLoopsOf(*paths))
    for (const int k : finder.pieces(loop)) pieces.push_back(loop.first + k);
  return pieces;
}

}  // namespace blossom
