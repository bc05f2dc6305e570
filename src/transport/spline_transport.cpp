#include "transport/spline_transport.h"

#include "transport/motion_edit_transport.h"
#include "transport/numbers.h"

namespace blossom {

Value curveValue(const Curve& c) { return Value::array({c.degree, c.knots, vectorsValue(c.poles)}); }

Curve toCurve(const Value& v) { return {v.at(0), v.at(1).get<std::vector<double>>(), toVectors<Vec4>(v.at(2))}; }

Value surfaceValue(const Surface& s) {
  return Value::array({s.degreeU, s.degreeV, s.knotsU, s.knotsV, vectorsValue(s.poles)});
}

Surface toSurface(const Value& v) {
  return {v.at(0), v.at(1), v.at(2).get<std::vector<double>>(), v.at(3).get<std::vector<double>>(),
          toVectors<Vec4>(v.at(4))};
}

Value motionValue(const Motion& m) {
  return {{"trajectory", curveValue(m.trajectory)}, {"orientation", surfaceValue(m.orientation)},
          {"scaling", surfaceValue(m.scaling)},     {"closed_u", static_cast<int>(m.closedU)},
          {"point", vectorValue(m.point)},          {"edits", motionEditsValue(m.edits)}};
}

Motion toMotion(const Value& v) {
  return {toCurve(v.at("trajectory")),   toSurface(v.at("orientation")),
          toSurface(v.at("scaling")),    static_cast<ClosedU>(v.at("closed_u").get<int>()),
          toVector<Vec3>(v.at("point")), toMotionEdits(v.at("edits"))};
}

}  // namespace blossom
