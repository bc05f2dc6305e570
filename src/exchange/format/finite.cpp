#include "exchange/format/finite.h"

#include <algorithm>
#include <cmath>

namespace blossom {
namespace {

struct IsFinite {
  bool operator()(const Line2& s) const { return s.from.allFinite() && s.to.allFinite(); }
  bool operator()(const Arc2& s) const {
    return s.center.allFinite() && std::isfinite(s.radius) && std::isfinite(s.start) && std::isfinite(s.sweep);
  }
  bool operator()(const Spline2& s) const {
    return std::all_of(s.poles.begin(), s.poles.end(), [](const Vec3& pole) { return pole.allFinite(); }) &&
           std::all_of(s.knots.begin(), s.knots.end(), [](double knot) { return std::isfinite(knot); });
  }
};

}  // namespace

bool allFinite(const Path& path) {
  return std::all_of(path.segments.begin(), path.segments.end(), [](const Segment& s) { return std::visit(IsFinite(), s); });
}

}  // namespace blossom
