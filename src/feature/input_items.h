#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "parameter/value.h"

namespace blossom {

struct FeatureType;

/// Where each shape of an input stood before an edit; nothing for one that is new.
using FormerPlaces = std::vector<std::optional<std::size_t>>;

/// @param before identifiers of the shapes, one of which may stand at several places. One that replaces another takes over
/// its place.
FormerPlaces formerPlaces(const std::vector<std::string>& before, const std::vector<std::string>& now);

/// The parameters of a feature after the shapes of one of its inputs have changed places: what lists hold one item of for
/// each shape (see onePer) goes with the shapes. Of lists with fewer items than shapes one goes where a shape is taken away.
/// @param before how many shapes there were
Value withItemsOfShapes(const FeatureType&, Value parameters, const std::string& input, const FormerPlaces&,
                        std::size_t before);

}  // namespace blossom
