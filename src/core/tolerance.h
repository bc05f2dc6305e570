#pragma once

namespace blossom {

/// Distances below which geometry counts as equal. Lengths in mm, angles in radians.
struct Tolerance {
  double confusion = 1e-7;  ///< two points closer than this are one point (OCCT's Precision::Confusion)
  double joining = 1e-4;    ///< largest gap closed when the ends of imported curves are joined
  double angular = 1e-9;    ///< two directions closer than this are parallel
  double chord = 1e-2;      ///< largest distance between a curve and its polyline
};

}  // namespace blossom
