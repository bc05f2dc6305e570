#pragma once
#include <QString>
#include <vector>

#include "geometry/shape/shape.h"

namespace blossom::ui {

/// Draws the small picture of a document for the start page from available results, on a thread of its own. When it cannot
/// be drawn there is no picture.
void keepPicture(std::vector<Shape> shapes, const QString& file);

}  // namespace blossom::ui
