#pragma once
#include "manipulators/factors/factor_layout.h"
#include "manipulators/insert_edit.h"

namespace blossom::sweep {

/// The feature whose factors are edited: the one given, or without one the feature that is selected.
/// @throws Error InvalidInput when none is selected, or it neither is a motion nor sweeps one.
FeatureId featureOfFactors(const ui::ToolHost&, const FeatureId& given);

/// As editPlacement, and for any feature that makes a motion. Empty while the motion has no result.
std::optional<EditPlacement> factorPlacement(const ui::ToolHost&, const FeatureId&);

/// The document with changes of poles between the motion and its sweeps: joined to the last edit when that is one of
/// factors, else as a feature of its own.
Document withFactorChanges(const ui::ToolHost&, const EditPlacement&, const FactorChanges&);

/// The document with one more knot in a factor: one more in the last edit when that refines the same factor, else by a
/// feature of its own.
Document withFactorKnot(const ui::ToolHost&, const EditPlacement&, Factor, bool alongU, double knot);

}  // namespace blossom::sweep
