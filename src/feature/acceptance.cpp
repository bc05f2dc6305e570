#include "feature/acceptance.h"

#include <fmt/format.h>

#include <TopExp_Explorer.hxx>
#include <algorithm>

#include "core/error.h"
#include "geometry/shape/brep.h"
#include "parameter/wording.h"

namespace blossom {
namespace {

bool hasSolid(const Brep& brep) { return TopExp_Explorer(brep.shape(), TopAbs_SOLID).More(); }

bool mayBoundRegion(const Shape& shape) {
  if (const Brep* brep = shape.get<Brep>()) return !hasSolid(*brep);
  return shape.kind() == ShapeKind::Curves;
}

bool takesKind(const InputSpec& spec, ShapeKind kind) {
  return spec.kinds.empty() || std::find(spec.kinds.begin(), spec.kinds.end(), kind) != spec.kinds.end();
}

bool acceptsAsOne(const InputSpec& spec, const Shape& shape) {
  return !shape.empty() && (takesKind(spec, shape.kind()) || (takesKind(spec, ShapeKind::Region) && mayBoundRegion(shape)));
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

bool takenByFrames(const InputSpec& spec, const Shape& shape) {
  return shape.kind() == ShapeKind::Sequence && !takesKind(spec, ShapeKind::Sequence);
}

bool accepts(const InputSpec& spec, const Shape& shape) {
  if (!takenByFrames(spec, shape)) return acceptsAsOne(spec, shape);
  const auto& frames = shape.get<Sequence>()->frames;
  return !frames.empty() &&
         std::all_of(frames.begin(), frames.end(), [&](const Shape& frame) { return acceptsAsOne(spec, frame); });
}

bool consumes(const InputSpec& spec, const Shape& shape) {
  if (const auto* sequence = shape.get<Sequence>(); sequence && takenByFrames(spec, shape))
    return !sequence->frames.empty() && consumes(spec, sequence->frames.front());
  const Brep* brep = shape.get<Brep>();
  const bool whole = spec.use == InputUse::Consumed || spec.use == InputUse::Edited || spec.use == InputUse::Step;
  return whole || (spec.use == InputUse::Outline && !(brep && hasSolid(*brep)));
}

std::vector<std::size_t> inputCounts(const FeatureType& type, std::size_t given,
                                     const std::function<bool(std::size_t, std::size_t)>& accepts) {
  std::vector<std::size_t> counts(type.inputs.size(), 0);
  std::size_t minimumLater = 0, next = 0;
  for (const InputSpec& spec : type.inputs) minimumLater += spec.minimum;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const InputSpec& spec = type.inputs[k];
    minimumLater -= spec.minimum;
    const bool last = k + 1 == counts.size();
    while (counts[k] < spec.maximum && next + minimumLater < given) {
      if (!last && counts[k] >= spec.minimum && !accepts(k, next)) break;
      ++counts[k];
      ++next;
    }
  }
  if (!counts.empty()) counts.back() += given - next;
  return counts;
}

}  // namespace blossom
