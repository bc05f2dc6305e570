#include "naming/segment_finder.h"

#include <cmath>

namespace blossom {

namespace {

std::optional<SegmentPlace> neighbourFrom(const Value& json) {
  return json.is_null() ? std::nullopt : std::optional(segmentPlaceFrom(json));
}

std::optional<int> onlyAt(const PlacedLoop& loop, const std::optional<SegmentPlace>& wanted, double tolerance) {
  std::optional<int> found;
  for (int k = 0; wanted && k < loop.size(); ++k) {
    if (!loop.at(k)->isAt(*wanted, tolerance)) continue;
    if (found) return std::nullopt;
    found = k;
  }
  return found;
}

std::optional<int> stepFrom(const PlacedLoop& loop, std::optional<int> k, int step) {
  if (!k || !loop.at(*k + step)) return std::nullopt;
  return loop.closed ? (*k + step + loop.size()) % loop.size() : *k + step;
}

/// Of an arc: through its ends and its middle.
Vec2 centreOf(const SegmentPlace& arc) {
  const Vec2 ab = arc.points[1] - arc.points[0], ac = arc.points[2] - arc.points[0];
  const double twice = 2 * cross(ab, ac);
  constexpr double closed = 1e-9;
  if (ac.norm() <= closed * ab.norm()) return arc.points[0] + ab / 2;  // a full circle, whose middle lies opposite
  const Vec2 off(ac.y() * ab.squaredNorm() - ab.y() * ac.squaredNorm(),
                 ab.x() * ac.squaredNorm() - ac.x() * ab.squaredNorm());
  return arc.points[0] + off / twice;
}

}  // namespace

SegmentFinder::SegmentFinder(const Value& described, double tolerance)
    : own_(segmentPlaceFrom(described.at("own"))),
      before_(neighbourFrom(described.at("before"))),
      after_(neighbourFrom(described.at("after"))),
      place_(described.at("place").get<int>()),
      count_(described.at("count").get<int>()),
      tolerance_(tolerance) {}

std::vector<int> SegmentFinder::unmoved(const PlacedLoop& loop) const {
  std::vector<int> found;
  for (int k = 0; k < loop.size(); ++k)
    if (loop.at(k)->isAt(own_, tolerance_)) found.push_back(k);
  return found;
}

std::optional<int> SegmentFinder::inItsLoop(const PlacedLoop& loop, bool alone) const {
  const std::optional<int> next = after(loop), previous = ahead(loop);
  if (next && previous && *next == *previous) return next;
  if (loop.size() != count_) return alongIt(loop);
  // It moved, and so did the neighbours that are not where they were. One that others have shifted is not guessed.
  const auto keeps = [&](const std::optional<int>& k) { return !k || *k == place_; };
  if (!keeps(next) || !keeps(previous)) return std::nullopt;
  return alone || next || previous || isMoved(*loop.at(place_)) ? std::optional(place_) : std::nullopt;
}

std::vector<int> SegmentFinder::pieces(const PlacedLoop& loop) const {
  const std::optional<int> next = after(loop), previous = ahead(loop);
  std::vector<int> found;
  for (int k = 0; k < loop.size(); ++k) {
    const SegmentPlace& each = *loop.at(k);
    const auto meets = [&](std::size_t end) { return (each.points.at(end) - own_.points.at(end)).norm() <= tolerance_; };
    constexpr std::size_t start = 0, finish = 2;
    const bool begins = meets(start) && (k == next || overlaps(each));
    const bool ends = meets(finish) && (k == previous || overlaps(each));
    if (each.form == own_.form && (begins || ends)) found.push_back(k);
  }
  return found;
}

/// The only straight segment that runs along it: one that was cut shorter, or lengthened.
std::optional<int> SegmentFinder::alongIt(const PlacedLoop& loop) const {
  std::optional<int> found;
  for (int k = 0; k < loop.size(); ++k) {
    if (!overlaps(*loop.at(k))) continue;
    if (found) return std::nullopt;
    found = k;
  }
  return found;
}

/// Whether it may be this one as a whole: shifted, or, round, of another size about the same centre.
bool SegmentFinder::isMoved(const SegmentPlace& other) const {
  if (other.form != own_.form) return false;
  const auto shift = [&](std::size_t k) -> Vec2 { return other.points.at(k) - own_.points.at(k); };
  const bool shifted = (shift(0) - shift(1)).norm() <= 2 * tolerance_ && (shift(0) - shift(2)).norm() <= 2 * tolerance_;
  constexpr std::size_t arc = 1;
  return shifted || (own_.form == arc && (centreOf(own_) - centreOf(other)).norm() <= 2 * tolerance_);
}

bool SegmentFinder::overlaps(const SegmentPlace& other) const {
  const Vec2 along = own_.points[2] - own_.points[0];
  const double length = along.norm();
  if (own_.form != 0 || other.form != 0 || length <= tolerance_) return false;
  const auto offset = [&](const Vec2& p) { return std::abs(cross(along, p - own_.points[0])) / length; };
  const double from = along.dot(other.points[0] - own_.points[0]) / length,
               to = along.dot(other.points[2] - own_.points[0]) / length;
  return offset(other.points[0]) <= tolerance_ && offset(other.points[2]) <= tolerance_ && from < to &&
         from < length - tolerance_ && to > tolerance_;
}

std::optional<int> SegmentFinder::after(const PlacedLoop& loop) const {
  return stepFrom(loop, onlyAt(loop, before_, tolerance_), 1);
}

std::optional<int> SegmentFinder::ahead(const PlacedLoop& loop) const {
  return stepFrom(loop, onlyAt(loop, after_, tolerance_), -1);
}

}  // namespace blossom
