#include "kernel/offset/offset_trace.h"

#include <algorithm>
#include <cmath>

#include "core/error.h"

namespace blossom::pocket {

namespace {

struct Crossing {
  std::size_t edge;
  int part;
  bool rises;  ///< in the direction of the half-edge
};

class Tracer {
 public:
  Tracer(const Diagram& diagram, Side side)
      : diagram_(diagram),
        wanted_(side == Side::Inside ? Where::Inside : Where::Outside),
        begins_(diagram.graph().edges.size(), atInfinity) {}

  /// Where the part is just twice as wide as the distance, as in a slot, the line of that clearance has no area, and
  /// rounding alone would decide which of its bits belong to it. Then the first clearance after it is taken, with which none
  /// does.
  std::vector<TracedLoop> trace(double d, double slack, const Progress& progress) {
    d_ = d;
    if (const double past = linked(slack, progress); past > d) {
      pieces_.clear();
      std::fill(begins_.begin(), begins_.end(), atInfinity);
      d_ = past;
      linked(0, progress);
    }
    return loops();
  }

 private:
  struct Linked {
    TracedPiece piece;
    std::size_t end = 0;  ///< the crossing where it ends
  };

  /// Links the crossings of every cell. Returns the largest clearance of parts that are level, within the slack.
  double linked(double slack, const Progress& progress) {
    const CellWalks& all = diagram_.walks(wanted_);
    std::size_t count = 0;
    double past = d_;
    for (const CellWalk& walk : all.walks) {
      if (++count % 1024 == 0) progress.check();
      if (walk.low > d_ + slack || walk.high <= d_) continue;
      crossings_.clear();
      for (std::size_t k = walk.first; k < walk.first + walk.count; ++k) {
        const CellStep& step = all.steps[k];
        if (step.low > d_ + slack || step.high <= d_) continue;
        if (step.low >= d_ - slack) past = std::max(past, levelAt(step.half, slack));
        cross(step.half);
      }
      linkCell(diagram_.graph().cells[diagram_.graph().edges[all.steps[walk.first].half].cell]);
    }
    return past;
  }

  /// The larger clearance of a part that has that of the line at both ends, within the slack; else that of the line.
  [[nodiscard]] double levelAt(std::size_t half, double slack) const {
    double level = d_;
    const EdgeParts& parts = diagram_.parts(half / 2);
    for (int i = 0; i < parts.count; ++i) {
      const EdgePart& part = parts.part[static_cast<std::size_t>(i)];
      const bool isLevel = std::abs(part.from - d_) <= slack && std::abs(part.to - d_) <= slack;
      if (isLevel && part.where == wanted_) level = std::max({level, part.from, part.to});
    }
    return level;
  }

  void cross(std::size_t h) {
    const EdgeParts& parts = diagram_.parts(h / 2);
    const bool backwards = h % 2 == 1;
    for (int i = 0; i < parts.count; ++i) {
      const int k = backwards ? parts.count - 1 - i : i;
      const EdgePart& part = parts.part[static_cast<std::size_t>(k)];
      const bool low = (backwards ? part.to : part.from) <= d_;
      if (part.where == wanted_ && low != ((backwards ? part.from : part.to) <= d_)) crossings_.push_back({h / 2, k, low});
    }
  }

  static std::size_t number(const Crossing& c) { return 2 * c.edge + static_cast<std::size_t>(c.part); }

  /// Around its cell the boundary of what lies beyond d rises through d and falls again; the offset closes it.
  void linkCell(const Site& site) {
    const std::size_t count = crossings_.size();
    for (std::size_t i = 0; i < count; ++i) {
      const Crossing& up = crossings_[i];
      if (!up.rises) continue;
      const Crossing& down = crossings_[(i + 1) % count];
      if (down.rises) throw Error(ErrorCode::Internal, "An offset enters a Voronoi cell and does not leave it.");
      const bool inside = wanted_ == Where::Inside;
      const Crossing& first = inside ? down : up;
      const Crossing& last = inside ? up : down;
      begins_[number(first)] = pieces_.size();
      // It begins where the one before ends: a point is found once.
      pieces_.push_back({{site, Vec2::Zero(), diagram_.pointAt(last.edge, last.part, d_)}, number(last)});
    }
  }

  [[nodiscard]] std::vector<TracedLoop> loops() const {
    std::vector<TracedLoop> loops;
    std::vector<bool> taken(pieces_.size(), false);
    for (std::size_t start = 0; start < pieces_.size(); ++start) {
      if (taken[start]) continue;
      TracedLoop& loop = loops.emplace_back();
      for (std::size_t i = start; !taken[i];) {
        taken[i] = true;
        loop.push_back(pieces_[i].piece);
        i = begins_[pieces_[i].end];
        if (i == atInfinity) throw Error(ErrorCode::Internal, "An offset ends inside the Voronoi diagram.");
      }
      for (std::size_t k = 0; k < loop.size(); ++k) loop[k].from = loop[(k > 0 ? k : loop.size()) - 1].to;
    }
    return loops;
  }

  const Diagram& diagram_;
  Where wanted_;
  double d_ = 0;
  std::vector<Crossing> crossings_;  ///< of the cell at hand, counter-clockwise
  std::vector<Linked> pieces_;
  std::vector<std::size_t> begins_;  ///< by crossing: the piece that begins there
};

}  // namespace

std::vector<TracedLoop> traced(const Diagram& diagram, double d, double slack, Side side, const Progress& progress) {
  return Tracer(diagram, side).trace(d, slack, progress);
}

}  // namespace blossom::pocket
