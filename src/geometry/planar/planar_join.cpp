#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <optional>
#include <unordered_map>

#include "geometry/planar/planar.h"

namespace blossom {
namespace {

struct PathEnd {
  std::size_t path;
  bool atEnd;  ///< the path would be appended backwards
  Vec2 place;
};

/// Ends of open paths in square cells as wide as the joining distance.
class EndIndex {
 public:
  explicit EndIndex(double distance) : distance_(distance) {}

  void add(const PathEnd& end) { cells_[key(cell(end.place.x()), cell(end.place.y()))].push_back(end); }

  /// Nearest end within the distance that `accept` likes; smaller cost first.
  template <class Cost>
  std::optional<PathEnd> nearest(const Vec2& place, const Cost& cost) const {
    std::optional<PathEnd> best;
    double minimum = std::numeric_limits<double>::infinity();
    for (std::int64_t i = -1; i <= 1; ++i) {
      for (std::int64_t j = -1; j <= 1; ++j) {
        const auto found = cells_.find(key(cell(place.x()) + i, cell(place.y()) + j));
        if (found == cells_.end()) continue;
        for (const PathEnd& end : found->second) {
          if ((end.place - place).norm() > distance_) continue;
          const double value = cost(end);
          if (value < minimum) {
            minimum = value;
            best = end;
          }
        }
      }
    }
    return best;
  }

 private:
  std::int64_t cell(double x) const { return static_cast<std::int64_t>(std::floor(std::clamp(x / distance_, -4e18, 4e18))); }
  static std::uint64_t key(std::int64_t i, std::int64_t j) {
    return static_cast<std::uint64_t>(i) * 0x9e3779b97f4a7c15ull ^ static_cast<std::uint64_t>(j) * 0xc2b2ae3d27d4eb4full;
  }

  double distance_;
  std::unordered_map<std::uint64_t, std::vector<PathEnd>> cells_;
};

void moveStart(Segment& segment, const Vec2& to) {
  if (auto* line = std::get_if<Line2>(&segment)) line->from = to;
}

bool moveEnd(Segment& segment, const Vec2& to) {
  auto* line = std::get_if<Line2>(&segment);
  if (line) line->to = to;
  return line != nullptr;
}

/// Ends of lines are moved so that the ends meet exactly; arcs and splines keep their shape and the gap.
void append(Path& path, Path next) {
  if (!moveEnd(path.segments.back(), startPoint(next))) moveStart(next.segments.front(), endPoint(path));
  path.segments.insert(path.segments.end(), next.segments.begin(), next.segments.end());
}

void close(Path& path) {
  path.closed = true;
  if (!moveEnd(path.segments.back(), startPoint(path))) moveStart(path.segments.front(), endPoint(path));
}

class Joiner {
 public:
  Joiner(const std::vector<Path>& paths, double distance)
      : paths_(paths), distance_(distance), ends_(distance), used_(paths.size()) {
    for (std::size_t i = 0; i < paths.size(); ++i) {
      if (paths[i].closed || paths[i].segments.empty()) continue;
      ends_.add({i, false, startPoint(paths[i])});
      ends_.add({i, true, endPoint(paths[i])});
    }
  }

  std::vector<Path> run() {
    std::vector<Path> result;
    for (std::size_t i = 0; i < paths_.size(); ++i) {
      if (used_[i]) continue;
      used_[i] = true;
      result.push_back(paths_[i].closed || paths_[i].segments.empty() ? paths_[i] : grown(paths_[i]));
    }
    return result;
  }

 private:
  /// Follows the ends forwards, then the start backwards (as the end of the reversed path).
  Path grown(Path path) {
    extend(path);
    if (path.closed) return path;
    Path back = reversed(path);
    const std::size_t before = back.segments.size();
    extend(back);
    return back.segments.size() == before && !back.closed ? path : reversed(back);
  }

  void extend(Path& path) {
    while (!comesBack(path)) {
      const Vec2 end = endPoint(path);
      const auto next = ends_.nearest(end, [&](const PathEnd& candidate) {
        if (used_[candidate.path]) return std::numeric_limits<double>::infinity();
        const bool otherLayer = paths_[candidate.path].layer != path.layer;
        return (candidate.place - end).norm() + (otherLayer ? distance_ : 0);
      });
      if (!next) return;
      used_[next->path] = true;
      append(path, next->atEnd ? reversed(paths_[next->path]) : paths_[next->path]);
    }
    close(path);
  }

  /// A speck shorter than the joining distance is not a loop.
  bool comesBack(const Path& path) const {
    if ((startPoint(path) - endPoint(path)).norm() > distance_) return false;
    return path.segments.size() > 2 || length(path) > 2 * distance_;
  }

  const std::vector<Path>& paths_;
  double distance_;
  EndIndex ends_;
  std::vector<bool> used_;
};

}  // namespace

Curves joined(const Curves& curves, const Tolerance& tolerance) {
  return {Joiner(curves.paths, tolerance.joining).run(), curves.fillRule};
}

}  // namespace blossom
