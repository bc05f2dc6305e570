#pragma once
#include <QString>
#include <vector>

#include "geometry/shape/shape.h"

namespace blossom::ui {

/// Draws the small picture of a document's file that the start page shows, on a thread of its own, from results that are at
/// hand. A picture that cannot be drawn is not there.
void keepPicture(std::vector<Shape> shapes, const QString& file);

}  // namespace blossom::ui
