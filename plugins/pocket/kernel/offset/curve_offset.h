#pragma once
#include <cstddef>
#include <vector>

#include "kernel/medial/boundary.h"
#include "kernel/offset/curve_arcs.h"
#include "kernel/offset/offset_trace.h"

namespace blossom::pocket {

/// Traced pieces that follow one free-form curve.
struct CurveRun {
  const Boundary* boundary = nullptr;
  const CurveArcs* arcs = nullptr;
  std::size_t curve = 0;
  const TracedLoop* loop = nullptr;
  std::size_t first = 0, count = 0;  ///< of the loop, all around
  double distance = 0;
  double sign = 1;  ///< 1: to the left of the curve
  double tolerance = 1e-3;

  [[nodiscard]] const TracedPiece& piece(std::size_t k) const { return (*loop)[(first + k) % loop->size()]; }
};

/// Whether x lies at the distance from the true boundary. Near centres of curvature the exact offset of one curve may come
/// closer to the boundary than the chords told, and does not count.
bool isAtDistance(const Boundary&, const Vec2& x, double distance, double tolerance);

/// The offset of a curve along a run, from one point to another one: circles parallel to the arcs that follow the curve, and
/// biarcs through exact points where these do not reach, at the ends and beside centres of curvature.
std::vector<Segment> offsetAlong(const CurveRun&, const Vec2& from, const Vec2& to);

}  // namespace blossom::pocket
