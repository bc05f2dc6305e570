#pragma once
#include <vector>

#include "geometry/shape/motion.h"

namespace blossom::sweep {

/// The poles in u of the curve that a factor is at one v, repeated rows among them. O(rows degree).
std::vector<Vec4> sectionRows(const Surface&, double v);

/// The knots in u come back after every n-th of the period, and so do the rows: how many rows lie between, 0 when they do
/// not. Equal up to 1e-12 of the period.
std::size_t rowsPerPart(const Surface& closed, int n);

/// The knots in u are the same read backwards, up to 1e-12 of their range.
bool knotsAreMirrored(const Surface&);

}  // namespace blossom::sweep
