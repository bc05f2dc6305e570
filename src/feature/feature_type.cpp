#include "feature/feature_type.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "geometry/face_region.h"
#include "geometry/planar.h"
#include "geometry/soundness.h"

namespace blossom {
namespace {

bool takes(const InputSpec& spec, ShapeKind kind) {
  return spec.kinds.empty() || std::find(spec.kinds.begin(), spec.kinds.end(), kind) != spec.kinds.end();
}

bool takesAsRegion(const InputSpec& spec, ShapeKind kind) {
  return (kind == ShapeKind::Curves || kind == ShapeKind::Brep) && takes(spec, ShapeKind::Region);
}

bool accepts(const InputSpec& spec, const Shape& shape) {
  return !shape.empty() && (takes(spec, shape.kind()) || takesAsRegion(spec, shape.kind()));
}

/// "a mesh", "curves", "nothing".
std::string withArticle(ShapeKind kind) {
  std::string name(shapeKindName(kind));
  if (kind == ShapeKind::None || kind == ShapeKind::Curves) return name;
  return "a " + name;
}

std::string acceptedKinds(const InputSpec& spec) {
  std::string text;
  for (std::size_t i = 0; i < spec.kinds.size(); ++i) {
    if (i > 0) text += i + 1 == spec.kinds.size() ? " or " : ", ";
    text += withArticle(spec.kinds[i]);
  }
  return text.empty() ? "any shape" : text;
}

[[noreturn]] void throwNotAccepted(const FeatureType& type, const InputSpec& spec, const Shape& shape) {
  throw Error(ErrorCode::InvalidInput,
              fmt::format("The input \"{}\" of {} takes {}; it got {}.", spec.name, type.title, acceptedKinds(spec),
                          withArticle(shape.kind())),
              spec.help);
}

void refuseUnsound(const FeatureType& type, const InputSpec& spec, const Shape& shape) {
  const std::string flaw = unsoundness(shape);
  if (!flaw.empty())
    throw Error(ErrorCode::InvalidInput,
                fmt::format("The input \"{}\" of {} cannot be used: {}.", spec.name, type.title, flaw),
                "Mend the file or the feature that it comes from.");
}

Shape converted(const FeatureType& type, const InputSpec& spec, const Shape& shape) {
  if (takes(spec, shape.kind())) return shape;
  try {
    if (const Brep* faces = shape.get<Brep>()) return toRegion(*faces);
    return toRegion(*shape.get<Curves>());
  } catch (const Error& e) {
    throw Error(e.code(),
                fmt::format("The input \"{}\" of {} takes a region, and these {} make none: {}", spec.name, type.title,
                            shape.kind() == ShapeKind::Brep ? "faces" : "curves", e.message()),
                e.hint());
  }
}

std::string howMany(const InputSpec& spec) {
  if (spec.least == spec.most) return std::to_string(spec.least);
  return spec.most == anyNumber ? fmt::format("at least {}", spec.least) : fmt::format("{} to {}", spec.least, spec.most);
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
  std::size_t leastLater = 0;
  for (const auto& spec : type.inputs) leastLater += spec.least;
  if (given.size() < leastLater) throwWrongNumber(type, given.size());
  std::vector<std::vector<Shape>> bySpec;
  std::size_t next = 0;
  for (const auto& spec : type.inputs) {
    leastLater -= spec.least;
    auto& taken = bySpec.emplace_back();
    while (taken.size() < spec.most && next + leastLater < given.size()) {
      if (!accepts(spec, given[next])) {
        // what an optional input does not accept is left to the inputs after it
        if (taken.size() >= spec.least && &spec != &type.inputs.back()) break;
        throwNotAccepted(type, spec, given[next]);
      }
      refuseUnsound(type, spec, given[next]);
      taken.push_back(converted(type, spec, given[next++]));
    }
  }
  if (next < given.size()) throwWrongNumber(type, given.size());
  return Inputs(std::move(bySpec));
}

Measures measured(const Evaluated& evaluated, const Progress& progress) {
  Measures all = measure(evaluated.shape, progress);
  all.values.insert(all.values.end(), evaluated.figures.begin(), evaluated.figures.end());
  return all;
}

}  // namespace blossom
