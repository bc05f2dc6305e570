#include "region_inputs.h"

namespace blossom::minkowski {

std::vector<Region> regionsOf(const Inputs& inputs) {
  std::vector<Region> regions;
  for (const Shape& shape : inputs.of(0)) {
    const Region* region = shape.get<Region>();
    if (!region) throwWrongKind(shape);
    regions.push_back(*region);
  }
  return regions;
}

std::optional<double> toleranceOf(const Value& given) {
  return given.is_null() ? std::nullopt : std::optional(given.get<double>());
}

ParameterSpec toleranceSpec() {
  return whenNone(optional(positiveLength()),
                  "a 10,000th of each shape's size and a 500th of its thickness, at most 0.01 mm");
}

Evaluated evaluatedSum(RegionSumResult result) {
  Evaluated out;
  out.stats["sums"] = result.sums;
  out.warnings = std::move(result.warnings);
  out.shape = std::move(result.region);
  return out;
}

}  // namespace blossom::minkowski
