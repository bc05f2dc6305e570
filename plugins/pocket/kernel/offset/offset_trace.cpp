#include "kernel/offset/offset_trace.h"

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
  Tracer(const Diagram& diagram, double d, Side side)
      : diagram_(diagram), d_(d), side_(side), begins_(diagram.graph().edges.size(), atInfinity) {}

  std::vector<TracedLoop> trace(const Progress& progress) {
    const auto& edges = diagram_.graph().edges;
    std::vector<bool> seen(edges.size(), false);
    for (std::size_t start = 0; start < edges.size(); ++start) {
      if (seen[start]) continue;
      if (start % 1024 == 0) progress.check();
      crossings_.clear();
      std::size_t h = start;
      do {
        seen[h] = true;
        cross(h);
        h = edges[h].next;
      } while (h != start);
      linkCell(diagram_.graph().cells[edges[start].cell]);
    }
    return loops();
  }

 private:
  struct Linked {
    TracedPiece piece;
    std::size_t end = 0;  ///< the crossing where it ends
  };

  void cross(std::size_t h) {
    const EdgeParts& parts = diagram_.parts(h / 2);
    const bool backwards = h % 2 == 1;
    for (int i = 0; i < parts.count; ++i) {
      const int k = backwards ? parts.count - 1 - i : i;
      const EdgePart& part = parts.part[static_cast<std::size_t>(k)];
      const bool low = (backwards ? part.to : part.from) <= d_;
      const bool wanted = part.where == (side_ == Side::Inside ? Where::Inside : Where::Outside);
      if (wanted && low != ((backwards ? part.from : part.to) <= d_)) crossings_.push_back({h / 2, k, low});
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
      const bool inside = side_ == Side::Inside;
      const Crossing& first = inside ? down : up;
      const Crossing& last = inside ? up : down;
      begins_[number(first)] = pieces_.size();
      pieces_.push_back(
          {{site, diagram_.pointAt(first.edge, first.part, d_), diagram_.pointAt(last.edge, last.part, d_)}, number(last)});
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
    }
    return loops;
  }

  const Diagram& diagram_;
  double d_;
  Side side_;
  std::vector<Crossing> crossings_;  ///< of the cell at hand, counter-clockwise
  std::vector<Linked> pieces_;
  std::vector<std::size_t> begins_;  ///< by crossing: the piece that begins there
};

}  // namespace

std::vector<TracedLoop> traced(const Diagram& diagram, double d, Side side, const Progress& progress) {
  return Tracer(diagram, d, side).trace(progress);
}

}  // namespace blossom::pocket
