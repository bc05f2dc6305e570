#include "kernel/compare/matched_outlines.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <limits>

#include "geometry/numeric/box_tree.h"

namespace blossom::minkowski {
namespace {

constexpr int startsTried = 512;
constexpr double sameShare = 1e-9;  // of the length of an outline: corners closer than this are matched with each other

/// An outline by the share of its length.
class ByLength {
 public:
  explicit ByLength(const Loop& loop) : points_(loop) {
    for (std::size_t i = 0; i < loop.size(); ++i) {
      at_.push_back(length_);
      length_ += (loop[(i + 1) % loop.size()] - loop[i]).norm();
    }
    for (double& share : at_) share /= length_;
  }

  [[nodiscard]] const std::vector<double>& corners() const { return at_; }
  [[nodiscard]] double length() const { return length_; }
  [[nodiscard]] const Vec2& corner(std::size_t i) const { return points_[i]; }
  /// @param share 0 up to 1, 1 excluded
  [[nodiscard]] Vec2 point(double share) const {
    const std::size_t i = edgeAt(share);
    const double from = at_[i], to = i + 1 < at_.size() ? at_[i + 1] : 1;
    const double part = to > from ? std::clamp((share - from) / (to - from), 0.0, 1.0) : 0;
    return points_[i] + part * (points_[(i + 1) % points_.size()] - points_[i]);
  }

 private:
  [[nodiscard]] std::size_t edgeAt(double share) const {
    const auto after = std::upper_bound(at_.begin(), at_.end(), share);
    return static_cast<std::size_t>(std::max<std::ptrdiff_t>(after - at_.begin() - 1, 0));
  }

  const Loop& points_;
  std::vector<double> at_;
  double length_ = 0;
};

double fractionOf(double share) { return share - std::floor(share); }

/// Where an outline is followed: its point and, of the other one, the point that belongs to it.
struct MatchedPoint {
  Vec2 first, second;
};

/// A corner of one outline, or of both when they lie together; -1: none.
struct CornerEvent {
  double share = 0;  ///< of the first outline
  std::ptrdiff_t first = -1, second = -1;
};

std::vector<CornerEvent> cornerEvents(const ByLength& first, const ByLength& second, double start) {
  std::vector<CornerEvent> all;
  for (std::size_t i = 0; i < first.corners().size(); ++i)
    all.push_back({first.corners()[i], static_cast<std::ptrdiff_t>(i), -1});
  for (std::size_t k = 0; k < second.corners().size(); ++k) {
    double share = fractionOf(second.corners()[k] - start);
    if (share > 1 - sameShare) share = 0;
    all.push_back({share, -1, static_cast<std::ptrdiff_t>(k)});
  }
  std::stable_sort(all.begin(), all.end(), [](const CornerEvent& a, const CornerEvent& b) { return a.share < b.share; });
  std::vector<CornerEvent> events;
  for (const CornerEvent& event : all) {
    CornerEvent* const last = events.empty() ? nullptr : &events.back();
    if (last && event.share - last->share <= sameShare && (last->first < 0) != (event.first < 0) &&
        (last->second < 0) != (event.second < 0)) {
      last->first = std::max(last->first, event.first);
      last->second = std::max(last->second, event.second);
    } else {
      events.push_back(event);
    }
  }
  return events;
}

/// @param start share of the second outline that belongs to the start of the first
std::vector<MatchedPoint> matchedPoints(const ByLength& first, const ByLength& second, double start) {
  std::vector<MatchedPoint> points;
  for (const CornerEvent& event : cornerEvents(first, second, start)) {
    const Vec2 a = event.first >= 0 ? first.corner(static_cast<std::size_t>(event.first)) : first.point(event.share);
    const Vec2 b = event.second >= 0 ? second.corner(static_cast<std::size_t>(event.second))
                                     : second.point(std::min(fractionOf(event.share + start), std::nextafter(1.0, 0.0)));
    points.push_back({a, b});
  }
  return points;
}

/// Mean along the length.
Vec2 meanAlong(const Loop& loop) {
  Vec2 sum = Vec2::Zero();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 &a = loop[i], &b = loop[(i + 1) % loop.size()];
    sum += (b - a).norm() * (a + b) / 2;
  }
  return sum / perimeter(loop);
}

/// The integral of first . second along the outlines, the first one about its mean, and how fast it grows with the start.
/// Exact: the integrand is a product of linear functions between corners of either.
struct MatchIntegral {
  double value = 0, slope = 0;
};

MatchIntegral matchIntegral(const ByLength& first, const ByLength& second, const Vec2& mean, double start) {
  MatchIntegral integral;
  const std::vector<MatchedPoint> points = matchedPoints(first, second, start);
  for (std::size_t i = 0; i < points.size(); ++i) {
    const MatchedPoint &from = points[i], &to = points[(i + 1) % points.size()];
    const Vec2 a = from.first - mean, b = to.first - mean;
    const double share = (to.first - from.first).norm() / first.length();
    integral.slope += (a + b).dot(to.second - from.second) / 2;
    integral.value += share * (2 * a.dot(from.second) + a.dot(to.second) + b.dot(from.second) + 2 * b.dot(to.second)) / 6;
  }
  return integral;
}

/// The zero of the slope between a start of those tried and its neighbours.
double refinedStart(const ByLength& first, const ByLength& second, const Vec2& mean, int tried, const Progress& progress) {
  double low = (tried - 1.0) / startsTried, high = (tried + 1.0) / startsTried;
  if (!(matchIntegral(first, second, mean, low).slope > 0 && matchIntegral(first, second, mean, high).slope < 0))
    return static_cast<double>(tried) / startsTried;
  constexpr int halvings = 50;
  for (int k = 0; k < halvings; ++k) {
    progress.check();
    const double half = (low + high) / 2;
    (matchIntegral(first, second, mean, half).slope > 0 ? low : high) = half;
  }
  return fractionOf((low + high) / 2);
}

/// The starts tried that are better than their neighbours and nearly as good as the best, the best first.
std::vector<int> promisingStarts(const ByLength& first, const ByLength& second, const Vec2& mean, const Progress& progress) {
  std::vector<Vec2> a, b;
  for (int k = 0; k < startsTried; ++k) {
    const double share = static_cast<double>(k) / startsTried;
    a.push_back(first.point(share) - mean);
    b.push_back(second.point(share));
  }
  std::vector<double> match(startsTried, 0);
  for (std::size_t start = 0; start < match.size(); ++start) {
    progress.check();
    for (std::size_t k = 0; k < match.size(); ++k) match[start] += a[k].dot(b[(k + start) % match.size()]);
  }
  constexpr double nearly = 0.98;
  constexpr std::size_t mostRefined = 4;
  const double enough = nearly * *std::max_element(match.begin(), match.end());
  std::vector<int> starts;
  for (std::size_t start = 0; start < match.size(); ++start) {
    const double before = match[(start + match.size() - 1) % match.size()], after = match[(start + 1) % match.size()];
    if (match[start] >= enough && match[start] >= before && match[start] >= after) starts.push_back(static_cast<int>(start));
  }
  std::stable_sort(starts.begin(), starts.end(),
                   [&](int i, int k) { return match[static_cast<std::size_t>(i)] > match[static_cast<std::size_t>(k)]; });
  if (starts.size() > mostRefined) starts.resize(mostRefined);
  return starts;
}

/// The least mean square distance is the greatest mean of first . second, one of them about its mean.
double bestStart(const ByLength& first, const ByLength& second, const Vec2& mean, const Progress& progress) {
  double best = 0, most = -std::numeric_limits<double>::infinity();
  for (const int tried : promisingStarts(first, second, mean, progress)) {
    const double start = refinedStart(first, second, mean, tried, progress);
    const double value = matchIntegral(first, second, mean, start).value;
    if (value > most) {
      most = value;
      best = start;
    }
  }
  return best;
}

Vec2 centroidOf(const Loop& loop) {
  double twice = 0;
  Vec2 moment = Vec2::Zero();
  const Vec2& about = loop.front();
  for (std::size_t i = 0; i < loop.size(); ++i) {
    const Vec2 a = loop[i] - about, b = loop[(i + 1) % loop.size()] - about;
    moment += cross(a, b) * (a + b);
    twice += cross(a, b);
  }
  return about + moment / (3 * twice);
}

/// For each part of the first shape the one of the second.
std::vector<std::size_t> pairedParts(const Polygons& first, const Polygons& second) {
  struct Pair {
    double distance;
    std::size_t first, second;
  };
  std::vector<Pair> pairs;
  for (std::size_t i = 0; i < first.size(); ++i)
    for (std::size_t k = 0; k < second.size(); ++k)
      pairs.push_back({(centroidOf(first[i].outer) - centroidOf(second[k].outer)).norm(), i, k});
  std::stable_sort(pairs.begin(), pairs.end(), [](const Pair& a, const Pair& b) { return a.distance < b.distance; });
  std::vector<std::size_t> partner(first.size(), second.size());
  std::vector<bool> taken(second.size(), false);
  for (const Pair& pair : pairs) {
    if (partner[pair.first] < second.size() || taken[pair.second]) continue;
    partner[pair.first] = pair.second;
    taken[pair.second] = true;
  }
  return partner;
}

struct LoopEdge {
  Vec2 from, to;
  std::size_t loop, place;
};

std::vector<LoopEdge> loopEdges(const std::vector<Loop>& loops) {
  std::vector<LoopEdge> edges;
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t i = 0; i < loops[l].size(); ++i)
      edges.push_back({loops[l][i], loops[l][(i + 1) % loops[l].size()], l, i});
  return edges;
}

bool edgesCross(const LoopEdge& a, const LoopEdge& b) {
  // A corner on the other edge counts as left of it, so that what passes through it crosses once.
  const auto left = [](const LoopEdge& edge, const Vec2& p) { return cross(edge.to - edge.from, p - edge.from) >= 0; };
  return left(a, b.from) != left(a, b.to) && left(b, a.from) != left(b, a.to);
}

}  // namespace

std::string whyUnmatched(const Polygons& first, const Polygons& second) {
  const auto hasHoles = [](const Polygons& shape) {
    return std::any_of(shape.begin(), shape.end(), [](const Polygon& part) { return !part.holes.empty(); });
  };
  if (hasHoles(first) || hasHoles(second))
    return fmt::format("The {} shape has holes, which matching of vertices has no counterpart for.",
                       hasHoles(first) ? "first" : "second");
  if (first.size() == second.size()) return {};
  return fmt::format("The first shape has {} and the second {}, so their vertices cannot be matched.",
                     first.size() == 1 ? "one outline" : fmt::format("{} outlines", first.size()), second.size());
}

MatchedOutlines matchedOutlines(const Polygons& first, const Polygons& second, const Progress& progress) {
  MatchedOutlines matched;
  const std::vector<std::size_t> partner = pairedParts(first, second);
  for (std::size_t i = 0; i < first.size(); ++i) {
    const Loop &a = first[i].outer, &b = second[partner[i]].outer;
    const ByLength along(a), beside(b);
    const double start = bestStart(along, beside, meanAlong(a), progress);
    Loop& from = matched.first.emplace_back();
    Loop& to = matched.second.emplace_back();
    for (const MatchedPoint& point : matchedPoints(along, beside, start)) {
      from.push_back(point.first);
      to.push_back(point.second);
    }
  }
  return matched;
}

std::vector<Loop> inBetween(const MatchedOutlines& matched, double t) {
  std::vector<Loop> loops = matched.first;
  for (std::size_t l = 0; l < loops.size(); ++l)
    for (std::size_t i = 0; i < loops[l].size(); ++i) loops[l][i] = (1 - t) * loops[l][i] + t * matched.second[l][i];
  return loops;
}

std::size_t crossingsOf(const std::vector<Loop>& loops, const Progress& progress) {
  const std::vector<LoopEdge> edges = loopEdges(loops);
  std::vector<Box2> boxes;
  for (const LoopEdge& edge : edges) boxes.emplace_back(edge.from.cwiseMin(edge.to), edge.from.cwiseMax(edge.to));
  std::size_t count = 0;
  forEachNearPair<2>(boxes, 0, progress, [&](std::size_t i, std::size_t j) {
    const LoopEdge &a = edges[i], &b = edges[j];
    const std::size_t size = loops[a.loop].size();
    const bool neighbours = a.loop == b.loop && ((a.place + 1) % size == b.place || (b.place + 1) % size == a.place);
    if (!neighbours && edgesCross(a, b)) ++count;
    return true;
  });
  return count;
}

}  // namespace blossom::minkowski
