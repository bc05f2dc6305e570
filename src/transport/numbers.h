#pragma once
#include <optional>
#include <vector>

#include "core/vector.h"
#include "geometry/values/box.h"
#include "geometry/values/color.h"
#include "parameter/value.h"

/// Vectors, boxes and colours as JSON, every number exact.
namespace blossom {

template <class Vector>
Value vectorValue(const Vector& v) {
  Value list = Value::array();
  for (Eigen::Index i = 0; i < v.size(); ++i) list.push_back(v[i]);
  return list;
}

template <class Vector>
Vector toVector(const Value& list) {
  Vector v;
  for (Eigen::Index i = 0; i < v.size(); ++i) v[i] = list.at(static_cast<std::size_t>(i)).template get<double>();
  return v;
}

template <class Vector>
Value vectorsValue(const std::vector<Vector>& vectors) {
  Value all = Value::array();
  for (const Vector& each : vectors) all.push_back(vectorValue(each));
  return all;
}

template <class Vector>
std::vector<Vector> toVectors(const Value& all) {
  std::vector<Vector> vectors;
  vectors.reserve(all.size());
  for (const Value& each : all) vectors.push_back(toVector<Vector>(each));
  return vectors;
}

inline Value colorValue(const std::optional<Color>& color) {
  return color ? Value::array({color->red, color->green, color->blue}) : Value();
}

inline std::optional<Color> toColor(const Value& value) {
  if (value.is_null()) return {};
  return Color{value.at(0), value.at(1), value.at(2)};
}

inline Value boundsValue(const Bounds& box) {
  return box.empty ? Value() : Value::array({vectorValue(box.low), vectorValue(box.high)});
}

inline Bounds toBounds(const Value& v) {
  Bounds box;
  if (v.is_null()) return box;
  box.add(toVector<Vec3>(v.at(0)));
  box.add(toVector<Vec3>(v.at(1)));
  return box;
}

}  // namespace blossom
