#pragma once
#include <string>

#include "core/progress.h"
#include "exchange/format/format.h"

namespace blossom::svg {

/// The curves of an SVG document in mm, y up. The page is mirrored in place: the content of the viewBox stays in it.
/// @throws Error FormatDamaged, LimitExceeded, Cancelled.
Imported readDocument(const std::string& content, const Progress&);

}  // namespace blossom::svg
