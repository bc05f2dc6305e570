#pragma once
#include <array>
#include <cstdint>
#include <string>
#include <vector>

#include "kernel/medial/voronoi_graph.h"

namespace blossom::pocket {

enum class Where : std::uint8_t { Unknown, Inside, Outside };

/// A Voronoi edge is cut where its clearance is least, so that the clearance only rises or only falls along each part.
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

/// A checked Voronoi diagram of a boundary with the clearance of everything in it. Immutable.
class Diagram {
 public:
  /// Builds sweep-line diagrams on turned grids until one passes all checks, then tries exact predicates (or
  /// these at once).
  /// @throws Error Degenerate when none passes (with what failed), Cancelled.
  Diagram(const Boundary&, bool exactPredicates, const Progress&);

  [[nodiscard]] const VoronoiGraph& graph() const { return graph_; }
  [[nodiscard]] double clearance(std::size_t vertex) const { return clearance_[vertex]; }
  [[nodiscard]] Where where(std::size_t vertex) const { return where_[vertex]; }
  [[nodiscard]] const EdgeParts& parts(std::size_t edge) const { return parts_[edge]; }
  /// The point of a part with clearance d, which lies between those of its ends.
  [[nodiscard]] Vec2 pointAt(std::size_t edge, int part, double d) const;
  /// A bounded half-edge from its origin to its target as (x, y, clearance), straight in between within `chord`.
  [[nodiscard]] std::vector<Vec3> polyline(std::size_t half, double chord) const;
  /// Inner vertex with the largest clearance.
  [[nodiscard]] std::size_t deepest() const { return deepest_; }
  [[nodiscard]] std::size_t attempts() const { return attempts_; }
  [[nodiscard]] bool exactPredicates() const { return exact_; }

 private:
  void accept(VoronoiGraph, const Boundary&, const Progress&);
  void findClearances(const Boundary&);
  void findSides(const Boundary&);
  void findParts();
  void markParts();
  /// mm by which rounding to the grid may move things at clearance r.
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
  std::size_t deepest_ = 0, attempts_ = 0;
  double slack_ = 0, size_ = 1;
  bool exact_ = false;
};

}  // namespace blossom::pocket
