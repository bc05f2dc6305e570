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

namespace {

std::optional<BaseKnots> toBase(const Value& v) {
  if (v.is_null()) return std::nullopt;
  const auto knots = [&](const char* factor) { return v.at(factor).get<std::array<std::vector<double>, 2>>(); };
  return BaseKnots{v.at("trajectory").get<std::vector<double>>(), knots("orientation"), knots("scaling")};
}

}  // namespace

Value motionValue(const Motion& m) {
  Value value{{"trajectory", curveValue(m.trajectory)},
              {"orientation", surfaceValue(m.orientation)},
              {"scaling", surfaceValue(m.scaling)},
              {"closed_u", static_cast<int>(m.closedU)},
              {"point", vectorValue(m.point)},
              {"edits", motionEditsValue(m.edits)},
              {"base", nullptr}};
  if (m.base)
    value["base"] = {{"trajectory", m.base->trajectory}, {"orientation", m.base->orientation}, {"scaling", m.base->scaling}};
  return value;
}

Motion toMotion(const Value& v) {
  return {toCurve(v.at("trajectory")),   toSurface(v.at("orientation")),
          toSurface(v.at("scaling")),    static_cast<ClosedU>(v.at("closed_u").get<int>()),
          toVector<Vec3>(v.at("point")), toMotionEdits(v.at("edits")),
          toBase(v.at("base"))};
}

}  // namespace blossom
