#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/numeric/box_tree.h"
#include "geometry/planar/region.h"
#include "kernel/medial/true_curve.h"

namespace blossom::pocket {

/// Continuation of the boundary at the end of a piece.
enum class Joint {
  Inner,   ///< a vertex added by the flattening
  Smooth,  ///< another curve follows in the same direction
  Corner
};

/// A straight piece of the flattened boundary; the region lies to its left.
struct Piece {
  Vec2 from, to;
  std::size_t curve = 0;  ///< the curve that it approximates ..
  double t0 = 0, t1 = 1;  ///< .. between these parameters
  std::size_t previous = 0, next = 0;
  Joint end = Joint::Corner;

  [[nodiscard]] Vec2 along() const { return to - from; }
  /// Around it, and `margin` mm more.
  [[nodiscard]] Box2 box(double margin = 0) const {
    return {from.cwiseMin(to).array() - margin, from.cwiseMax(to).array() + margin};
  }
};

/// Where a curve of a boundary lies in its region.
struct CurveSource {
  std::size_t loop = 0, segment = 0;
  double from = 0, to = 1;  ///< parameters of the segment at its ends: 0 and 1 of lines and arcs, of a spline its own
};

/// The boundary of a region, flattened, with references to its curves. Immutable.
class Boundary {
 public:
  /// @param chord mm between a curve and its pieces
  /// @throws Error InvalidInput naming the place: empty, open, not finite, crossing or touching along a line; LimitExceeded.
  Boundary(const Region&, double chord, const Progress&);

  [[nodiscard]] const Region& region() const { return region_; }
  [[nodiscard]] const std::vector<TrueCurve>& curves() const { return curves_; }
  /// Of each curve.
  [[nodiscard]] const std::vector<CurveSource>& sources() const { return sources_; }
  [[nodiscard]] const std::vector<Piece>& pieces() const { return pieces_; }
  [[nodiscard]] double chord() const { return chord_; }
  [[nodiscard]] double size() const { return size_; }  ///< mm, the larger side of its box
  [[nodiscard]] const Vec2& middle() const { return middle_; }
  /// mm; vertices closer than this are merged. The grid of the diagram is finer.
  [[nodiscard]] double weld() const { return weld_; }

  struct Nearest {
    double distance = 0;
    std::size_t piece = 0;
    double parameter = 0;  ///< on the piece's curve
    Vec2 foot = Vec2::Zero();
  };
  /// The nearest point of the true boundary. O(log n).
  [[nodiscard]] Nearest nearest(const Vec2&) const;
  /// Distance to the flattened boundary. O(log n).
  [[nodiscard]] double flatDistance(const Vec2&) const;
  /// Whether x lies in the region, given its nearest boundary point.
  [[nodiscard]] bool contains(const Vec2& x, const Nearest&) const;

 private:
  void take(const Region&, const Progress&);
  void take(const Path&, std::size_t loop);
  struct Trouble {
    Vec2 at;
    bool along;  ///< pieces overlap
  };
  void splitWhereTouched(const Progress&);
  [[nodiscard]] std::optional<Trouble> crossing(const Progress&) const;
  void takeWithoutCrossing(const Region&, const Progress&);
  void makeTree();

  Region region_;
  std::vector<TrueCurve> curves_;
  std::vector<CurveSource> sources_;
  std::vector<Piece> pieces_;
  BoxTree<2> tree_;
  double chord_, size_ = 0, weld_ = 0;
  Vec2 middle_ = Vec2::Zero();
};

/// Radians, maximum turn of the boundary at a smooth joint.
inline constexpr double smoothTurn = 1e-3;
/// Angle between two directions, 0 to pi.
double turnBetween(const Vec2& a, const Vec2& b);

/// "(12.5, 3)", for messages.
std::string placeText(const Vec2&);

}  // namespace blossom::pocket
