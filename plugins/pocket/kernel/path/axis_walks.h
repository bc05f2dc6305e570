#pragma once
#include <functional>
#include <map>
#include <optional>
#include <vector>

#include "geometry/planar/medial_axis.h"

namespace blossom::pocket {

/// Ways along the pieces of a medial axis that lie between two clearances.
class AxisWalks {
 public:
  /// Whether a piece, given by points (x, y, clearance), or a single point is to be walked.
  using Wanted = std::function<bool(const std::vector<Vec3>&)>;

  AxisWalks(double low, double high, Wanted wanted) : low_(low), high_(high), wanted_(std::move(wanted)) {}

  void add(const MedialAxis&);
  void addPoint(const Vec2&, double clearance);

  /// A way along every piece of each connected part and back to where it began; single points alone.
  [[nodiscard]] std::vector<std::vector<Vec2>> walks() const;

 private:
  /// A piece of the axis, between two ends that other pieces may share.
  struct Piece {
    std::size_t from = 0, to = 0;
    std::vector<Vec2> points;
  };
  using PiecesAt = std::map<std::size_t, std::vector<std::size_t>>;  ///< by end

  [[nodiscard]] bool holds(double clearance) const { return clearance > low_ && clearance < high_; }
  void add(const MedialEdge&);
  [[nodiscard]] bool clip(double from, double to, double& first, double& last) const;
  void keep(const std::vector<Vec3>& run, std::optional<std::size_t> from, std::optional<std::size_t> to);
  void walkFrom(std::size_t start, const PiecesAt& at, std::vector<bool>& used, std::vector<Vec2>& walk) const;

  double low_, high_;
  Wanted wanted_;
  std::vector<Piece> pieces_;
  std::vector<Vec2> single_;
};

}  // namespace blossom::pocket
