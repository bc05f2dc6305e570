#pragma once
#include "core/error.h"
#include "document/document.h"
#include "document/shown.h"
#include "feature/registry.h"
#include "naming/part_reference.h"

namespace blossom {

/// Whether parameters name faces, edges or vertices.
bool namesParts(const std::vector<ParameterSpec>&, const Value& parameters);

/// The parts that the parameters of a feature name, found again in its inputs as they are now.
struct FoundParts {
  Value now;                     ///< the parameters with the numbers of now, for the evaluation
  Value kept = Value::object();  ///< those that name parts, with signatures made anew, for the document
  std::vector<Value> lost;       ///< parts that are not found again; in `kept` they stay as they are
};

/// Parts without a signature, as in older documents and on the command line, are those with their numbers.
/// @param parameters complete and in canonical form
/// @param arranged the inputs of the feature
/// @throws Error Cancelled.
FoundParts foundParts(const Feature&, const FeatureType&, const Value& parameters, const Inputs& arranged, Construction&,
                      const Progress&);

/// A sequence has no faces, edges and vertices that could be named: each of its frames has its own.
/// @throws Error InvalidInput when a parameter names one.
void refusePartsOfSequences(const FeatureType&, const Value& parameters, const Inputs& arranged);

/// "Edge lost: .."
[[nodiscard]] Error lostError(const Value& part);

/// The document with what the parts look like that were named since `before`: they are meant as they are seen now, whatever
/// else is edited before the next evaluation has come to its end. O(size) of the shapes concerned.
Document withAppearances(Document, const Document& before, const Registry&, const ShapeOf&);

/// The document with the parameters of a feature as they were kept.
Document withKeptParts(const Document&, const FeatureId&, const Value& kept);

}  // namespace blossom
