#include "feature/feature_type.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "feature/acceptance.h"
#include "feature/frame_by_frame.h"
#include "geometry/occt/face_region.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/single_point.h"
#include "geometry/shape/kind_names.h"
#include "geometry/shape/soundness.h"

namespace blossom {
namespace {

std::string acceptedKinds(const InputSpec& spec) { return spec.kinds.empty() ? "any shape" : kindNames(spec.kinds, true); }

/// Of a sequence the frame that does not fit.
std::string givenKind(const InputSpec& spec, const Shape& shape) {
  const auto* sequence = shape.get<Sequence>();
  if (!sequence || !takenByFrames(spec, shape)) return withArticle(shape.kind());
  if (sequence->frames.empty()) return "a sequence without frames";
  const auto fits = [&](const Shape& frame) { return !takenByFrames(spec, frame) && accepts(spec, frame); };
  const auto odd = std::find_if_not(sequence->frames.begin(), sequence->frames.end(), fits);
  const auto& frame = odd == sequence->frames.end() ? sequence->frames.back() : *odd;
  return fmt::format("a sequence whose frame {} is {}", std::distance(sequence->frames.begin(), odd) + 1,
                     withArticle(frame.kind()));
}

[[noreturn]] void throwNotAccepted(const FeatureType& type, const InputSpec& spec, const Shape& shape) {
  throw Error(ErrorCode::InvalidInput,
              fmt::format("The input \"{}\" of {} takes {}; it got {}.", spec.name, type.title, acceptedKinds(spec),
                          givenKind(spec, shape)),
              spec.help);
}

/// "shape", or "shape 2" where there can be several.
std::string nameOf(const InputSpec& spec, std::size_t place) {
  return spec.maximum > 1 ? fmt::format("{} {}", spec.name, place + 1) : spec.name;
}

void refuseUnsound(const FeatureType& type, const std::string& name, const Shape& shape) {
  const std::string flaw = unsoundness(shape);
  if (!flaw.empty())
    throw Error(ErrorCode::InvalidInput, fmt::format("The input \"{}\" of {} cannot be used: {}.", name, type.title, flaw),
                "Mend the file or the feature that it comes from.");
}

Shape converted(const FeatureType&, const InputSpec&, const std::string& name, const Shape&);

/// The sequence itself where no frame needs it.
Shape convertedFrames(const FeatureType& type, const InputSpec& spec, const std::string& name, const Shape& shape) {
  Sequence sequence = *shape.get<Sequence>();
  bool changed = false;
  for (std::size_t k = 0; k < sequence.frames.size(); ++k) {
    Shape& frame = sequence.frames[k];
    const ShapeKind before = frame.kind();
    frame = inFrame(sequence, k, [&] { return converted(type, spec, name, frame); });
    changed = changed || frame.kind() != before;
  }
  return changed ? Shape(std::move(sequence)) : shape;
}

Shape converted(const FeatureType& type, const InputSpec& spec, const std::string& name, const Shape& shape) {
  if (takenByFrames(spec, shape)) return convertedFrames(type, spec, name, shape);
  const auto& kinds = spec.kinds;
  if (kinds.empty() || std::find(kinds.begin(), kinds.end(), shape.kind()) != kinds.end()) return shape;
  if (const auto* curves = shape.get<Curves>(); curves && spec.points && singlePoint(curves->paths)) return shape;
  try {
    if (const Brep* faces = shape.get<Brep>()) return toRegion(*faces);
    return toRegion(*shape.get<Curves>());
  } catch (const Error& e) {
    throw Error(e.code(),
                fmt::format("The input \"{}\" of {} takes a region, and these {} make none: {}", name, type.title,
                            shape.kind() == ShapeKind::Brep ? "faces" : "curves", e.message()),
                e.hint());
  }
}

std::string howMany(const InputSpec& spec) {
  if (spec.minimum == spec.maximum) return std::to_string(spec.minimum);
  return spec.maximum == anyNumber ? fmt::format("at least {}", spec.minimum)
                                   : fmt::format("{} to {}", spec.minimum, spec.maximum);
}

[[noreturn]] void throwWrongNumber(const FeatureType& type, std::size_t given) {
  std::string wanted;
  for (const auto& spec : type.inputs)
    wanted += fmt::format("{}{} \"{}\"", wanted.empty() ? "" : " and ", howMany(spec), spec.name);
  throw Error(ErrorCode::InvalidInput,
              type.inputs.empty() ? fmt::format("{} takes no input; it got {}.", type.title, given)
                                  : fmt::format("{} takes {} as input; it got {}.", type.title, wanted, given),
              type.summary);
}

}  // namespace

void throwWrongKind(const Shape& shape) {
  throw Error(ErrorCode::InvalidInput,
              fmt::format("The input is {}, which cannot be used here.", withArticle(shape.kind())));
}

Inputs arrangedInputs(const FeatureType& type, std::span<const Shape> given) {
  std::size_t wanted = 0;
  for (const auto& spec : type.inputs) wanted += spec.minimum;
  if (given.size() < wanted) throwWrongNumber(type, given.size());
  const auto counts =
      inputCounts(type, given.size(), [&](std::size_t k, std::size_t i) { return accepts(type.inputs[k], given[i]); });
  std::vector<std::vector<Shape>> bySpec(counts.size());
  std::size_t next = 0;
  for (std::size_t k = 0; k < counts.size(); ++k) {
    const InputSpec& spec = type.inputs[k];
    for (std::size_t i = 0; i < std::min(counts[k], spec.maximum); ++i, ++next) {
      if (!accepts(spec, given[next])) throwNotAccepted(type, spec, given[next]);
      const std::string name = nameOf(spec, i);
      refuseUnsound(type, name, given[next]);
      bySpec[k].push_back(converted(type, spec, name, given[next]));
    }
  }
  if (next < given.size()) throwWrongNumber(type, given.size());
  Inputs arranged(std::move(bySpec));
  checkFrames(type, arranged);
  return arranged;
}

void checkResult(const FeatureType& type, const Shape& result) {
  if (result.empty()) throw Error(ErrorCode::Internal, fmt::format("{} made nothing and gave no reason.", type.title));
  if (type.produces.empty()) return;
  const auto check = [&](const Shape& shape) {
    if (std::find(type.produces.begin(), type.produces.end(), shape.kind()) == type.produces.end())
      throw Error(ErrorCode::Internal, fmt::format("{} made {} and declares that it gives {}.", type.title,
                                                   withArticle(shape.kind()), kindNames(type.produces, true)));
  };
  if (const auto* sequence = result.get<Sequence>())
    std::for_each(sequence->frames.begin(), sequence->frames.end(), check);
  else
    check(result);
}

namespace {

/// Names and places that lead to the first number that is not finite, as "facets/3/1"; nothing when there is none. (With
/// flatten() each number would be looked for among all.)
std::optional<std::string> wayToInfinite(const Value& value) {
  if (value.is_number_float())
    return std::isfinite(value.get<double>()) ? std::nullopt : std::optional<std::string>(std::in_place);
  if (!value.is_structured()) return std::nullopt;
  for (const auto& [name, each] : value.items())
    if (const auto way = wayToInfinite(each)) return way->empty() ? name : name + "/" + *way;
  return std::nullopt;
}

[[noreturn]] void refuseInfinite(const std::string& name) {
  throw Error(ErrorCode::LimitExceeded, fmt::format("The figure \"{}\" is beyond all numbers.", name),
              "The shapes may be too large, too small or too far away for it.");
}

}  // namespace

void refuseInfiniteFigures(const Evaluated& evaluated) {
  if (const auto way = wayToInfinite(evaluated.stats)) refuseInfinite(way->empty() ? "stats" : *way);
  for (const Measure& figure : evaluated.figures)
    if (const double* value = std::get_if<double>(&figure.value); value && !std::isfinite(*value))
      refuseInfinite(figure.name);
}

Measures measured(const Evaluated& evaluated, const Progress& progress) {
  Measures all = measure(evaluated.shape, progress);
  all.values.insert(all.values.end(), evaluated.figures.begin(), evaluated.figures.end());
  return all;
}

}  // namespace blossom
