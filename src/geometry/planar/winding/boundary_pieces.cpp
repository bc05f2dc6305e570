#include "geometry/planar/winding/boundary_pieces.h"

#include <algorithm>
#include <memory>
#include <mutex>
#include <optional>
#include <tuple>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/planar/winding/anchored_edge.h"

namespace blossom::planar {
namespace {

using Cell = WindingCells::Cell;

/// Something that meets an edge strictly between its ends.
struct Meeting {
  double t = 0;      ///< along the edge, rounded
  Fraction exact;    ///< the same
  int left = 0;      ///< by how much the winding number to the left changes
  int covering = 0;  ///< by how much the edges that lie on this one change
  int before = 0;    ///< by how much edges on this one change that are reported instead of it
  std::uint32_t edge = 0;
  std::optional<GridPoint> end;  ///< the other edge ends here
};

[[noreturn]] void notClosed() {
  throw Error(ErrorCode::Internal, "The edges of a sum do not close.", "Please report this with the shapes.");
}

class EdgeWalker {
 public:
  EdgeWalker(std::span<const CountedEdge> edges, const WindingCells& cells, WindingRule rule)
      : edges_(edges), cells_(cells), rule_(rule), seen_(edges.size(), 0) {}

  void walk(std::uint32_t number, std::vector<BoundaryPiece>& out) {
    number_ = number;
    edge_ = edges_[number];
    by_ = edge_.to - edge_.from;
    std::tie(lowest_, highest_) = std::minmax(edge_.from.y, edge_.to.y);
    run_.clear();
    bool fromStart = true;
    Cell previous{};
    cells_.forEachCell(edge_, [&](const Cell& cell) {
      if (cells_.certified(cell)) {
        if (!run_.empty()) finishRun(fromStart, cell, out);
        run_.clear();
        fromStart = false;
      } else {
        if (run_.empty()) before_ = previous;
        run_.push_back(cell);
      }
      previous = cell;
    });
    if (!run_.empty()) finishRun(fromStart, std::nullopt, out);
  }

 private:
  void finishRun(bool fromStart, std::optional<Cell> after, std::vector<BoundaryPiece>& out) {
    const AnchoredEdge anchored(edges_, cells_, number_);
    const Anchor anchor = fromStart ? anchored.atStart(run_.front()) : anchored.between(before_, run_.front());
    // Half a unit beyond a run on either side, which its neighbours certify.
    const double slack = 0.5 / static_cast<double>(std::max(by_.x, std::abs(by_.y)));
    const double first = fromStart ? -1 : shareOf(anchor.t) - slack;
    const double last = after ? shareOf(anchored.between(run_.back(), *after).t) + slack : 2;
    gather(first, last);
    // What lies on the edge at the anchor, and what is to its left just after it.
    int covering = edge_.count, hidden = 0;
    for (const Cover& cover : covers_) {
      if (compare(cover.from, anchor.t) > 0 || compare(cover.to, anchor.t) <= 0) continue;
      covering += cover.count;
      hidden += cover.hides;
    }
    int left = anchored.windingToLeft(anchor, run_.front(), covering);
    sortMeetings();
    const double start = shareOf(anchor.t);
    std::size_t next = 0;
    while (next < sorted_.size() && inOrder(sorted_[next].t, meeting(next).exact, start, anchor.t) <= 0) ++next;
    if (fromStart) {  // back to the start of the edge
      for (std::size_t i = 0; i < next; ++i) {
        left -= meeting(i).left;
        covering -= meeting(i).covering;
        hidden -= meeting(i).before;
      }
      next = 0;
    }
    emit(fromStart, !after, next, left, covering, hidden, out);
  }

  /// Sign of a - b, which are rounded and exact.
  static int inOrder(double a, const Fraction& exactA, double b, const Fraction& exactB) {
    constexpr double rounding = 1e-14;  // of shares of an edge, with room
    if (a - b > rounding) return 1;
    if (b - a > rounding) return -1;
    return compare(exactA, exactB);
  }

  /// Their places are sorted: a meeting is six times as large.
  void sortMeetings() {
    sorted_.clear();
    for (std::uint32_t k = 0; k < meetings_.size(); ++k) sorted_.push_back({meetings_[k].t, k});
    std::sort(sorted_.begin(), sorted_.end(), [this](const Place& a, const Place& b) {
      return inOrder(a.t, meetings_[a.number].exact, b.t, meetings_[b.number].exact) < 0;
    });
  }
  [[nodiscard]] const Meeting& meeting(std::size_t along) const { return meetings_[sorted_[along].number]; }

  static double shareOf(const Fraction& t) { return static_cast<double>(t.over) / static_cast<double>(t.under); }

  struct Cover {
    Fraction from, to;
    int count = 0, hides = 0;
    std::uint32_t edge = 0;
  };

  void gather(double first, double last) {
    meetings_.clear();
    covers_.clear();
    if (++round_ == 0) {
      std::fill(seen_.begin(), seen_.end(), 0);
      round_ = 1;
    }
    seen_[number_] = round_;
    for (const Cell& cell : run_)
      for (const std::uint32_t k : cells_.edgesNear(cell)) {
        if (seen_[k] == round_) continue;
        seen_[k] = round_;
        meet(k, first, last);
      }
  }

  /// Whether the boxes around both edges have no point in common: most of them, told without products.
  [[nodiscard]] bool liesBeyond(const CountedEdge& d) const {
    const auto [low, high] = std::minmax(d.from.y, d.to.y);
    return d.to.x < edge_.from.x || d.from.x > edge_.to.x || high < lowest_ || low > highest_;
  }

  void meet(std::uint32_t k, double first, double last) {
    const CountedEdge& d = edges_[k];
    if (liesBeyond(d)) return;
    const GridPoint toFrom = d.from - edge_.from, along = d.to - d.from;
    const int from = signOf(cross(by_, toFrom)), to = signOf(cross(by_, d.to - edge_.from));
    if (from * to > 0) return;
    if (from == 0 && to == 0) return meetAlong(k, d);
    const Wide over = cross(toFrom, along), under = cross(by_, along);
    // The start and the end of this edge lie on different sides of the other: 0 < over / under < 1.
    if (under > 0 ? over <= 0 || over >= under : over >= 0 || over <= under) return;
    Meeting m;
    m.exact = fraction(over, under);
    m.t = shareOf(m.exact);
    if (m.t < first || m.t > last) return;
    if (from > 0) m.left = d.count;
    if (to > 0) m.left = -d.count;
    m.edge = k;
    if (from == 0) m.end = d.from;
    if (to == 0) m.end = d.to;
    meetings_.push_back(m);
  }

  /// The other edge lies on the line of this one, and runs the same way.
  void meetAlong(std::uint32_t k, const CountedEdge& d) {
    if (d.to <= edge_.from || edge_.to <= d.from) return;
    const auto share = [&](const GridPoint& p) {
      const bool flat = by_.x >= std::abs(by_.y);
      return flat ? fraction(p.x - edge_.from.x, by_.x) : fraction(p.y - edge_.from.y, by_.y);
    };
    const int hides = k < number_ && d.mayBound ? 1 : 0;
    covers_.push_back({share(d.from), share(d.to), d.count, hides, k});
    const auto add = [&](const GridPoint& p, int sign) {
      if (p <= edge_.from || p >= edge_.to) return;
      Meeting m;
      m.exact = share(p);
      m.t = shareOf(m.exact);
      m.covering = sign * d.count;
      m.before = sign * hides;
      m.edge = k;
      m.end = p;
      meetings_.push_back(m);
    };
    add(d.from, 1);
    add(d.to, -1);
  }

  struct Corner {
    CornerName name;
    Vec2 at;
  };
  static Corner cornerAt(const GridPoint& p) {
    return {{p.x, p.y, false}, Vec2(static_cast<double>(p.x), static_cast<double>(p.y))};
  }

  /// Of all that pass one point of the edge: named by an end there, else by the first two edges that are not parallel.
  [[nodiscard]] Corner cornerOf(std::size_t first, std::size_t last) {
    through_.assign(1, number_);
    for (std::size_t i = first; i < last; ++i) {
      if (meeting(i).end) return cornerAt(*meeting(i).end);
      through_.push_back(meeting(i).edge);
    }
    const Fraction& t = meeting(first).exact;
    for (const Cover& cover : covers_)
      if (compare(cover.from, t) < 0 && compare(t, cover.to) < 0) through_.push_back(cover.edge);
    const std::uint32_t least = *std::min_element(through_.begin(), through_.end());
    const GridPoint along = edges_[least].to - edges_[least].from;
    std::uint32_t second = ~std::uint32_t(0);
    for (const std::uint32_t k : through_)
      if (cross(along, edges_[k].to - edges_[k].from) != 0) second = std::min(second, k);
    const Vec2 from(static_cast<double>(edge_.from.x), static_cast<double>(edge_.from.y)),
        by(static_cast<double>(by_.x), static_cast<double>(by_.y));
    return {{least, second, true}, from + sorted_[first].t * by};
  }

  /// 1: the inside is to the left only; -1: to the right only; 0: no boundary, or another edge that lies here tells it.
  [[nodiscard]] int statusOf(int left, int covering, int hidden) const {
    if (hidden > 0) return 0;
    return int{rule_.inside(left)} - int{rule_.inside(left - covering)};
  }

  void emit(bool fromStart, bool toEnd, std::size_t next, int left, int covering, int hidden,
            std::vector<BoundaryPiece>& out) {
    int status = statusOf(left, covering, hidden);
    if (status != 0 && !fromStart) notClosed();
    Corner begin = cornerAt(edge_.from);
    const auto close = [&](const Corner& corner) {
      if (status > 0) out.push_back({begin.name, corner.name, begin.at, corner.at, number_, true});
      if (status < 0) out.push_back({corner.name, begin.name, corner.at, begin.at, number_, false});
      begin = corner;
    };
    while (next < sorted_.size()) {
      const std::size_t first = next;
      do {
        left += meeting(next).left;
        covering += meeting(next).covering;
        hidden += meeting(next).before;
        ++next;
      } while (next < sorted_.size() &&
               inOrder(sorted_[next].t, meeting(next).exact, sorted_[first].t, meeting(first).exact) == 0);
      const int changed = statusOf(left, covering, hidden);
      // Also where the boundary runs straight on: others may turn there, and are joined around that corner in order.
      if (changed == 0 && status == 0) continue;
      close(cornerOf(first, next));
      status = changed;
    }
    if (status != 0 && !toEnd) notClosed();
    close(cornerAt(edge_.to));
  }

  std::span<const CountedEdge> edges_;
  const WindingCells& cells_;
  WindingRule rule_;
  std::vector<std::uint32_t> seen_;
  std::uint32_t round_ = 0, number_ = 0;
  CountedEdge edge_;
  GridPoint by_;
  std::int64_t lowest_ = 0, highest_ = 0;  ///< of its ends
  Cell before_{};
  std::vector<Cell> run_;
  struct Place {
    double t = 0;  ///< along the edge, rounded
    std::uint32_t number = 0;
  };
  std::vector<Meeting> meetings_;
  std::vector<Place> sorted_;  ///< of the meetings, along the edge
  std::vector<Cover> covers_;
  std::vector<std::uint32_t> through_;
};

}  // namespace

namespace {

/// There are millions of them in sums of many parts.
std::vector<BoundaryPiece> inARow(std::vector<std::vector<BoundaryPiece>> parts, const Progress& progress) {
  std::size_t count = 0;
  for (const auto& part : parts) count += part.size();
  std::vector<BoundaryPiece> all;
  all.reserve(count);
  for (auto& part : parts) {
    progress.check();
    all.insert(all.end(), part.begin(), part.end());
    part = {};
  }
  return all;
}

}  // namespace

std::vector<BoundaryPiece> boundaryPieces(std::span<const CountedEdge> edges, const WindingCells& cells, WindingRule rule,
                                          const Progress& progress) {
  constexpr std::size_t grain = 64;
  std::vector<std::vector<BoundaryPiece>> parts((edges.size() + grain - 1) / grain);
  std::size_t done = 0;
  std::mutex mutex;
  std::vector<std::unique_ptr<EdgeWalker>> idle;
  parallelFor(parts.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    std::unique_ptr<EdgeWalker> walker;
    {
      const std::scoped_lock lock(mutex);
      if (!idle.empty()) {
        walker = std::move(idle.back());
        idle.pop_back();
      }
    }
    if (!walker) walker = std::make_unique<EdgeWalker>(edges, cells, rule);
    for (std::size_t part = begin; part < end; ++part) {
      {
        const std::scoped_lock lock(mutex);  // in order
        progress.report(static_cast<double>(++done) / static_cast<double>(parts.size()), "Finding the boundary");
      }
      for (std::size_t k = part * grain; k < std::min(edges.size(), (part + 1) * grain); ++k) {
        progress.check();
        if (edges[k].mayBound) walker->walk(static_cast<std::uint32_t>(k), parts[part]);
      }
    }
    const std::scoped_lock lock(mutex);
    idle.push_back(std::move(walker));
  });
  return inARow(std::move(parts), progress);
}

}  // namespace blossom::planar
