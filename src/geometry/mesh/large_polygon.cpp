#include "geometry/mesh/large_polygon.h"

#include <algorithm>
#include <cmath>
#include <queue>
#include <utility>

namespace blossom {
namespace {

/// Twice the signed area of a triangle.
double doubleArea(const Vec2& a, const Vec2& b, const Vec2& c) {
  return (b.x() - a.x()) * (c.y() - a.y()) - (b.y() - a.y()) * (c.x() - a.x());
}

/// Points by the square cell they lie in, about one to a cell.
class PlanarCells {
 public:
  PlanarCells(const std::vector<Vec2>& points, const std::vector<int>& chosen) : low_(points[0]), high_(points[0]) {
    for (const Vec2& p : points) {
      low_ = low_.cwiseMin(p);
      high_ = high_.cwiseMax(p);
    }
    side_ = std::clamp(static_cast<int>(std::sqrt(static_cast<double>(chosen.size()))), 1, 4096);
    starts_.assign(static_cast<std::size_t>(side_) * static_cast<std::size_t>(side_) + 1, 0);
    for (const int i : chosen) ++starts_[cell(points[static_cast<std::size_t>(i)]) + 1];
    for (std::size_t c = 1; c < starts_.size(); ++c) starts_[c] += starts_[c - 1];
    indices_.resize(chosen.size());
    std::vector<std::size_t> next(starts_.begin(), starts_.end() - 1);
    for (const int i : chosen) indices_[next[cell(points[static_cast<std::size_t>(i)])]++] = i;
  }

  /// Whether `test` is true of a point in the box, or of one in a cell that the box touches.
  template <class Test>
  bool any(const Vec2& low, const Vec2& high, const Test& test) const {
    const int x0 = column(low.x(), 0), x1 = column(high.x(), 0);
    const int y0 = column(low.y(), 1), y1 = column(high.y(), 1);
    for (int y = y0; y <= y1; ++y)
      for (std::size_t k = starts_[at(x0, y)]; k < starts_[at(x1, y) + 1]; ++k)
        if (test(indices_[k])) return true;
    return false;
  }

 private:
  int column(double value, int axis) const {
    const double width = (high_[axis] - low_[axis]) / side_;
    const double place = width > 0 ? (value - low_[axis]) / width : 0;
    return place > 0 ? static_cast<int>(std::min(place, static_cast<double>(side_ - 1))) : 0;
  }
  std::size_t at(int x, int y) const {
    return static_cast<std::size_t>(y) * static_cast<std::size_t>(side_) + static_cast<std::size_t>(x);
  }
  std::size_t cell(const Vec2& p) const { return at(column(p.x(), 0), column(p.y(), 1)); }

  Vec2 low_, high_;
  int side_ = 1;
  std::vector<std::size_t> starts_;
  std::vector<int> indices_;
};

class LargeClipper {
 public:
  LargeClipper(const std::vector<Vec2>& corners, double nothing, const Progress& progress)
      : points_(corners), nothing_(nothing), progress_(progress), left_(corners.size()), links_(corners.size()) {
    const int count = static_cast<int>(corners.size());
    for (int i = 0; i < count; ++i) links_[index(i)] = {(i + count - 1) % count, (i + 1) % count};
    triangles_.reserve(corners.size() - 2);
  }

  std::vector<std::array<int, 3>> run(bool spikesFirst) {
    if (spikesFirst) clipSpikes();
    clipEars(nothing_);
    if (left_ > 3) clipEars(0);
    for (const double depth : {nothing_, 16 * nothing_, 256 * nothing_})
      if (left_ > 3) clipEars(-depth);
    if (left_ > 3) clipMostConvex();
    int first = cursor_;
    for (int i = links_[index(cursor_)].next; i != cursor_; i = links_[index(i)].next) first = std::min(first, i);
    const int second = links_[index(first)].next;
    triangles_.push_back({first, second, links_[index(second)].next});
    return std::move(triangles_);
  }

 private:
  struct Links {
    int previous = 0, next = 0;  ///< next is -1 once the corner is clipped
  };

  static std::size_t index(int i) { return static_cast<std::size_t>(i); }
  const Vec2& at(int i) const { return points_[index(i)]; }
  bool isClipped(int i) const { return links_[index(i)].next < 0; }
  double turnAt(int i) const { return doubleArea(at(links_[index(i)].previous), at(i), at(links_[index(i)].next)); }

  /// Straight on or to the right, but for a width of `nothing`.
  bool isReflex(int i, double nothing) const {
    const auto [before, after] = links_[index(i)];
    return !(turnAt(i) > nothing * (at(after) - at(before)).norm());
  }

  std::vector<int> reflexCorners(double nothing) const {
    std::vector<int> reflex;
    for (int i = 0; i < static_cast<int>(points_.size()); ++i)
      if (!isClipped(i) && isReflex(i, nothing)) reflex.push_back(i);
    return reflex;
  }

  /// Of a polygon that does not cross itself, a corner within the ear means that a reflex one is.
  bool isEar(int i, const PlanarCells& reflex, double nothing) const {
    const auto [before, after] = links_[index(i)];
    const Vec2 &a = at(before), &b = at(i), &c = at(after);
    const double ab = nothing * (b - a).norm(), bc = nothing * (c - b).norm(), ca = nothing * (a - c).norm();
    if (!(doubleArea(a, b, c) > std::max({ab, bc, ca, 0.0}))) return false;
    const Vec2 low = a.cwiseMin(b).cwiseMin(c).array() - nothing, high = a.cwiseMax(b).cwiseMax(c).array() + nothing;
    return !reflex.any(low, high, [&](int k) {
      const Vec2& p = at(k);
      if (p == a || p == b || p == c || isClipped(k) || !isReflex(k, nothing)) return false;
      return doubleArea(a, b, p) >= -ab && doubleArea(b, c, p) >= -bc && doubleArea(c, a, p) >= -ca;
    });
  }

  void clip(int i) {
    const auto [before, after] = links_[index(i)];
    triangles_.push_back({before, i, after});
    links_[index(before)].next = after;
    links_[index(after)].previous = before;
    links_[index(i)].next = -1;
    --left_;
  }

  /// Round and round until three corners are left or a whole round finds no ear.
  void clipEars(double nothing) {
    const PlanarCells reflex(points_, reflexCorners(nothing));
    for (std::size_t inVain = 0; left_ > 3 && inVain < left_;) {
      progress_.check();
      const int after = links_[index(cursor_)].next;
      if (isEar(cursor_, reflex, nothing)) {
        clip(cursor_);
        // Going on with the corner after next makes fewer slivers than a fan around one corner. Along many corners in line
        // there is none to go on with: each would take a round of its own.
        const int second = links_[index(after)].next;
        cursor_ = isReflex(second, nothing) ? after : second;
        inVain = 0;
      } else {
        cursor_ = after;
        ++inVain;
      }
    }
  }

  void clipSpikes() {
    for (std::size_t inVain = 0; left_ > 3 && inVain < left_; ++inVain) {
      const auto [previous, next] = links_[index(cursor_)];
      const bool isClippedNow = isSpike(at(previous), at(cursor_), at(next), nothing_);
      if (isClippedNow) {
        clip(cursor_);
        inVain = 0;
      }
      cursor_ = isClippedNow ? previous : next;
    }
  }

  void clipMostConvex() {
    std::priority_queue<std::pair<double, int>> corners;
    std::vector<double> turns(points_.size());
    const auto enter = [&](int i) {
      const double turn = turnAt(i);
      turns[index(i)] = std::isnan(turn) ? 0 : turn;
      corners.emplace(turns[index(i)], i);
    };
    int i = cursor_;
    do {
      enter(i);
      i = links_[index(i)].next;
    } while (i != cursor_);
    while (left_ > 3) {
      progress_.check();
      const auto [turn, corner] = corners.top();
      corners.pop();
      if (isClipped(corner) || turns[index(corner)] != turn) continue;
      const auto [before, after] = links_[index(corner)];
      clip(corner);
      enter(before);
      enter(after);
      cursor_ = before;
    }
  }

  const std::vector<Vec2>& points_;
  double nothing_;
  const Progress& progress_;
  std::size_t left_;
  std::vector<Links> links_;
  int cursor_ = 0;
  std::vector<std::array<int, 3>> triangles_;
};

}  // namespace

bool isSpike(const Vec2& a, const Vec2& b, const Vec2& c, double nothing) {
  constexpr double crossings = 16;  // rounding of both ways adds up
  const Vec2 back = a - b, on = c - b;
  return back.dot(on) > 0 && std::abs(doubleArea(a, b, c)) <= crossings * nothing * std::max(back.norm(), on.norm());
}

std::vector<std::array<int, 3>> triangulateLarge(const std::vector<Vec2>& corners, double nothing, bool spikesFirst,
                                                 const Progress& progress) {
  return LargeClipper(corners, nothing, progress).run(spikesFirst);
}

}  // namespace blossom
