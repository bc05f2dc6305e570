#pragma once
#include <optional>

#include "naming/construction.h"
#include "parameter/value.h"

namespace blossom {

/// What is stored with the number of a face, an edge or a vertex of a feature's result, so that it is found again after
/// edits of what the feature is made of: the names of the faces at it, the parts of sources in these names (source_part.h),
/// and its likeness.
/// @throws Error NotFound when there is no such part, Cancelled.
Value signatureOf(Construction&, const std::string& feature, SubShapeKind, int index, const Progress& = Progress::none());

/// The same of a shape whose construction is not known: what the part looks like, or where it lies in a drawing.
/// @throws Error NotFound.
Value appearanceOf(const Shape&, SubShapeKind, int index);

/// The number that the part with this signature has now; nothing when it is gone or several could be meant. What stands on
/// an end of a segment that was divided is found where it lay, if it is as it was there. O(size) of the steps that lead to
/// the feature, each of which is traced once.
/// @param index the number it had
/// @throws Error Cancelled; nlohmann::json::exception for signatures of another form.
std::optional<int> foundPart(Construction&, const std::string& feature, SubShapeKind, int index, const Value& signature,
                             const Progress& = Progress::none());

}  // namespace blossom
