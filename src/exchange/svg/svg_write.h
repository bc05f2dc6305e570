#pragma once
#include <filesystem>

#include "core/progress.h"
#include "exchange/format/drawn_box.h"
#include "geometry/shape/shape.h"
#include "parameter/value.h"

namespace blossom::svg {

/// Writes curves or a region as SVG paths in mm. Lines, arcs and Béziers up to degree 3 are written exactly, other splines
/// as cubics within the option `tolerance`. A sequence becomes an animation (SMIL) of `seconds`, whose viewers without
/// animation show the first frame, or a contact sheet of up to `sheet` frames.
/// @param page what the page shows; nullptr: all that is drawn. @throws Error FileUnwritable, OutputNotSupported, Cancelled.
void writeDocument(const Shape&, const std::filesystem::path&, const Value& options, const Progress&,
                   const DrawnBox* page = nullptr);

/// The page that all frames of a sequence share when they are written to a file each.
DrawnBox sharedPage(const Sequence&, const Value& options, const Progress&);

}  // namespace blossom::svg
