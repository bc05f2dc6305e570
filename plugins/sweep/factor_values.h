#pragma once
#include "kernel/edit/factor_changes.h"
#include "parameter/parameter.h"

namespace blossom::sweep {

/// The parameters of sweep.factors: their declaration, and the changes they stand for.

// Lists of records, one for each kind of change.
ParameterSpec trajectoryMoves();
ParameterSpec trajectoryWeights();
ParameterSpec orientationTurns();
ParameterSpec scalingChanges();

/// @param parameters complete, canonical: the four lists by the names that errors of the kernel use
FactorChanges changesOf(const Value& parameters);
/// Those of the four lists that are not empty.
Value valuesOf(const FactorChanges&);

}  // namespace blossom::sweep
