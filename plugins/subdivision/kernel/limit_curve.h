#pragma once
#include <span>
#include <vector>

#include "geometry/bspline/curve.h"
#include "kernel/limit_shape.h"
#include "kernel/scheme.h"

namespace blossom::subdivision {

/// A polygon that is refined to a cubic B-spline curve.
struct ControlPolygon {
  std::vector<Vec3> points;
  bool closed = false;  ///< the last point is joined to the first, which is not repeated
};

/// One step of the scheme; the ends of an open polygon stay. O(n). Hand-written because OpenSubdiv knows surfaces only.
/// Cubic, Lane & Riesenfeld (1980): edges get their middle, points (1, 6, 1)/8. Quadratic, Chaikin (1974): edges are cut at
/// (3, 1)/4 and (1, 3)/4. Four-point, Dyn, Levin & Gregory (1987): points stay, edges get (-1, 9, 9, -1)/16, where a point
/// beyond an end mirrors the neighbour of the end.
/// @throws Error InvalidInput for fewer than 2 points (3 when closed) or points that are not finite.
ControlPolygon refined(const ControlPolygon&, CurveScheme = CurveScheme::Cubic);

/// Points of the limit curve: (1, 4, 1)/6 for each point of a cubic, (1, 1)/2 for each edge of a quadratic (the ends of open
/// polygons stay), the points themselves for four-point.
ControlPolygon onLimit(const ControlPolygon&, CurveScheme = CurveScheme::Cubic);

/// The limit curve of a polygon as a B-spline. @pre the scheme is cubic or quadratic. @throws Error InvalidInput as
/// `refined`.
Curve splineOfPolygon(const ControlPolygon&, CurveScheme);

/// The limit curve of a polygon, or any B-spline curve without weights. Each of its points is one row of basis functions.
class LimitCurve final : public LimitShape {
 public:
  /// Ends are those of the polygon: a point beyond each mirrors its neighbour (cubic), or repeats the end (quadratic).
  /// @pre the scheme is cubic or quadratic. @throws Error InvalidInput, as `refined`.
  explicit LimitCurve(const ControlPolygon&, CurveScheme = CurveScheme::Cubic);
  /// @pre `validate` accepts the curve and all weights are equal.
  explicit LimitCurve(Curve);

  [[nodiscard]] Domain domain(int) const override { return closed_ ? Domain::Circle : Domain::Interval; }
  [[nodiscard]] Row row(const Foot&) const override;
  [[nodiscard]] Frame frame(const Foot&, std::span<const Vec3> points) const override;
  [[nodiscard]] std::vector<Foot> seeds() const override;
  [[nodiscard]] std::vector<std::pair<int, int>> edges() const override;
  [[nodiscard]] bool isCurve() const override { return true; }

 private:
  [[nodiscard]] Row derivative(double u, int order) const;

  int degree_ = 3;
  std::vector<double> knots_;
  std::vector<Row> poles_;  ///< of the control points
  std::size_t count_ = 0;
  bool closed_ = false;
};

}  // namespace blossom::subdivision
