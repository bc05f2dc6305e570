#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/medial/voronoi_graph.h"

namespace blossom::pocket {

enum class Where : std::uint8_t { Unknown, Inside, Outside };

/// Part of a Voronoi edge; edges are divided at their minimum clearance, so that the clearance is monotone along each part.
struct EdgePart {
  double from = 0, to = 0;  ///< clearances in the direction of the even half-edge; infinite at infinity
  Where where = Where::Unknown;
  Vec2 high = Vec2::Zero();  ///< position of the end with the larger clearance; a direction when that is infinite
};

struct EdgeParts {
  std::array<EdgePart, 2> part;
  int count = 0;
  bool primary = true;  ///< not between a piece and its own end
};

/// The half-edges of a cell on one side of the boundary, in order, with the clearances that their parts pass through.
struct CellStep {
  std::size_t half = 0;
  double low = 0, high = 0;
};
struct CellWalk {
  std::size_t first = 0, count = 0;  ///< of the steps
  double low = 0, high = 0;          ///< of all of them
};
struct CellWalks {
  std::vector<CellWalk> walks;
  std::vector<CellStep> steps;
};

/// A verified Voronoi diagram of a boundary, with the clearance of its vertices and edges. Immutable.
class Diagram {
 public:
  /// Builds sweep-line diagrams on rotated grids until one passes all checks, then tries exact predicates (or
  /// these at once).
  /// @throws Error Degenerate with the failed check when none passes, Cancelled.
  Diagram(const Boundary&, bool exactPredicates, const Progress&);

  [[nodiscard]] const VoronoiGraph& graph() const { return graph_; }
  [[nodiscard]] double clearance(std::size_t vertex) const { return clearance_[vertex]; }
  [[nodiscard]] Where where(std::size_t vertex) const { return where_[vertex]; }
  [[nodiscard]] const EdgeParts& parts(std::size_t edge) const { return parts_[edge]; }
  /// Around all cells that have edges on that side, which is not Unknown.
  [[nodiscard]] const CellWalks& walks(Where side) const { return walks_[side == Where::Inside ? 0 : 1]; }
  /// The point of a part with clearance d, which must lie between the clearances of its ends.
  [[nodiscard]] Vec2 pointAt(std::size_t edge, int part, double d) const;
  /// A bounded half-edge from its origin to its target as (x, y, clearance), a polyline within `chord`.
  [[nodiscard]] std::vector<Vec3> polyline(std::size_t half, double chord) const;
  /// The inner vertex with the maximum clearance.
  [[nodiscard]] std::size_t deepest() const { return deepest_; }
  [[nodiscard]] std::size_t attempts() const { return attempts_; }
  [[nodiscard]] bool exactPredicates() const { return exact_; }

 private:
  void accept(VoronoiGraph, const Boundary&, const Progress&);
  void findClearances(const Boundary&);
  void findSides(const Boundary&);
  void findParts();
  void markParts();
  void findWalks();
  /// mm, error at clearance r caused by rounding to the grid.
  [[nodiscard]] double slackAt(double r) const { return slack_ * (1 + r / size_); }
  void certify(const Boundary&, const Progress&) const;
  [[nodiscard]] EdgeParts partsOf(std::size_t edge) const;
  [[nodiscard]] Vec2 towardsInfinity(std::size_t half) const;
  [[nodiscard]] double distance(const Site&, const Vec2&) const;
  [[nodiscard]] Vec2 pointOf(const Site& site) const { return (*pieces_)[site.piece].from; }

  VoronoiGraph graph_;
  const std::vector<Piece>* pieces_ = nullptr;
  std::vector<double> clearance_;
  std::vector<Where> where_;
  std::vector<EdgeParts> parts_;
  std::array<CellWalks, 2> walks_;  ///< inside, outside
  std::size_t deepest_ = 0, attempts_ = 0;
  double slack_ = 0, size_ = 1;
  bool exact_ = false;
};

}  // namespace blossom::pocket
