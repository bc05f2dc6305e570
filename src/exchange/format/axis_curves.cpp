#include "exchange/format/axis_curves.h"

namespace blossom {

ParameterSpec heightsOption(bool fallback) {
  ParameterSpec spec = flag();
  spec.name = "heights";
  spec.help = "A medial axis is written in space, the radius of its discs as height; off: flat.";
  spec.fallback = fallback;
  return spec;
}

std::vector<Curve> spaceCurvesOf(const MedialAxis& axis) {
  std::vector<Curve> curves;
  for (const MedialEdge& edge : axis.edges) {
    Curve curve{1, {}, {}};
    for (const Vec3& point : edge.points)
      if (const Vec4 pole(point.x(), point.y(), point.z(), 1); curve.poles.empty() || pole != curve.poles.back())
        curve.poles.push_back(pole);
    if (curve.poles.size() < 2) continue;
    curve.knots.push_back(0);
    for (std::size_t i = 0; i < curve.poles.size(); ++i) curve.knots.push_back(static_cast<double>(i));
    curve.knots.push_back(curve.knots.back());
    curves.push_back(std::move(curve));
  }
  return curves;
}

}  // namespace blossom
