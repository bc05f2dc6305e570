#pragma once
#include <vector>

#include "kernel/limit_curve.h"

namespace blossom::subdivision {

/// The limit curve of the interpolatory four-point scheme (Dyn, Levin & Gregory, CAGD 4, 1987). It has no closed form: a
/// point is computed by refining the six points that determine it forty times; the tangent, (1, -8, 0, 8, -1)/12, twelve
/// times. There is no second derivative. O(1) per point.
class FourPointCurve final : public LimitShape {
 public:
  /// @throws Error InvalidInput, as `refined`.
  explicit FourPointCurve(const ControlPolygon&);

  [[nodiscard]] Domain domain(int) const override { return closed_ ? Domain::Circle : Domain::Interval; }
  [[nodiscard]] Row row(const Foot&) const override;
  [[nodiscard]] Frame frame(const Foot&, std::span<const Vec3> points) const override;
  [[nodiscard]] std::vector<Foot> seeds() const override;
  [[nodiscard]] std::vector<std::pair<int, int>> edges() const override;
  [[nodiscard]] bool isCurve() const override { return true; }

 private:
  struct Rows {
    Row at, tangent;
  };
  [[nodiscard]] Rows rows(double u) const;

  long count_ = 0, spans_ = 0;
  bool closed_ = false;
};

}  // namespace blossom::subdivision
