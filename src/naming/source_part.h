#pragma once
#include <optional>
#include <vector>

#include "naming/likeness.h"

namespace blossom {

/// What is remembered of a part of a source: of a segment of a drawing its number, form and place, and those of the segments
/// before and after it; of a part of another shape its likeness and the structure of the shape.
Value describedSourcePart(const Shape&, SubShapeKind, int index);

/// The number that this part has now. A segment is the one that lies where it lay; or the one between the same neighbours;
/// or, where its loop has as many segments as before, the one with its number, else the only one along it. Nothing where
/// these leave doubt.
/// @param described as above @throws nlohmann::json::exception for values of another form.
std::optional<int> foundSourcePart(const Value& described, const Shape& now, SubShapeKind);

/// Of a segment that is not found, because it was divided or joined with the next: those that begin where it began or end
/// where it ended. They are not it, but what stands on its ends stands on theirs. None of other parts.
/// @param described as above @throws nlohmann::json::exception for values of another form.
std::vector<int> piecesOfSourcePart(const Value& described, const Shape& now, SubShapeKind);

}  // namespace blossom
