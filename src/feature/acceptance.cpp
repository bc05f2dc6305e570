#include "feature/acceptance.h"

#include <fmt/format.h>

#include <TopExp_Explorer.hxx>
#include <algorithm>

#include "core/error.h"
#include "geometry/shape/brep.h"
#include "parameter/wording.h"

namespace blossom {
namespace {

bool mayBoundRegion(const Shape& shape) {
  if (const Brep* brep = shape.get<Brep>()) return !TopExp_Explorer(brep->shape(), TopAbs_SOLID).More();
  return shape.kind() == ShapeKind::Curves;
}

void checkNamedInput(const FeatureType& type, const ParameterSpec& spec, const Value& value) {
  if (spec.kind == ParameterKind::List && value.is_array())
    for (const Value& item : value) checkNamedInput(type, spec.fields.at(0), item);
  if (spec.kind == ParameterKind::Record && value.is_object())
    for (const ParameterSpec& field : spec.fields)
      if (value.contains(field.name)) checkNamedInput(type, field, value.at(field.name));
  if (spec.kind != ParameterKind::SubShape || !value.is_object()) return;
  const auto name = value.value("input", std::string());
  if (name.empty()) return;
  std::vector<std::string> known;
  for (const InputSpec& input : type.inputs) known.push_back('"' + input.name + '"');
  if (std::find(known.begin(), known.end(), '"' + name + '"') != known.end()) return;
  throw Error(ErrorCode::InvalidParameter, fmt::format("\"{}\" names no input of {}.", formatText(spec, value), type.title),
              known.empty() ? "It has no input."
                            : fmt::format("Its {} called {}.", known.size() == 1 ? "input is" : "inputs are",
                                          enumerated(known, "and")));
}

}  // namespace

void checkNamedInputs(const FeatureType& type, const Value& parameters) {
  for (const ParameterSpec& spec : type.parameters)
    if (const auto value = parameters.find(spec.name); value != parameters.end()) checkNamedInput(type, spec, *value);
}

bool accepts(const InputSpec& spec, const Shape& shape) {
  const auto takes = [&](ShapeKind kind) {
    return spec.kinds.empty() || std::find(spec.kinds.begin(), spec.kinds.end(), kind) != spec.kinds.end();
  };
  return !shape.empty() && (takes(shape.kind()) || (takes(ShapeKind::Region) && mayBoundRegion(shape)));
}

}  // namespace blossom
