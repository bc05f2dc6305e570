#pragma once
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "core/vector.h"
#include "geometry/values/color.h"

namespace blossom {

struct Line2 {
  Vec2 from, to;
  friend bool operator==(const Line2&, const Line2&) = default;
};

/// Circular arc; a full circle has |sweep| = 2 pi. Angles in radians, counter-clockwise from +x; sweep < 0 runs clockwise.
struct Arc2 {
  Vec2 center;
  double radius = 0;
  double start = 0;
  double sweep = 0;
  friend bool operator==(const Arc2&, const Arc2&) = default;
};

/// Planar B-spline, poles homogeneous (w x, w y, w), full knot vector as in Curve. Elliptic arcs are rational quadratics.
struct Spline2 {
  int degree = 0;
  std::vector<double> knots;
  std::vector<Vec3> poles;
  friend bool operator==(const Spline2&, const Spline2&) = default;
};

using Segment = std::variant<Line2, Arc2, Spline2>;

/// Consecutive segments: each starts where the one before it ends. A closed path ends where it starts.
struct Path {
  std::vector<Segment> segments;
  bool closed = false;
  std::string layer;  ///< layer or group of the file it came from
  std::optional<Color> color;
  friend bool operator==(const Path&, const Path&) = default;
};

/// Rule by which overlapping closed paths enclose an area.
enum class FillRule { NonZero, EvenOdd };

/// Planar curves, open and closed, in file order: the content of a DXF or an SVG.
struct Curves {
  std::vector<Path> paths;
  FillRule fillRule = FillRule::EvenOdd;
  friend bool operator==(const Curves&, const Curves&) = default;
};

/// A bounded planar area: closed paths that do not cross; outer loops run counter-clockwise, holes clockwise.
struct Region {
  std::vector<Path> loops;
  friend bool operator==(const Region&, const Region&) = default;
};

}  // namespace blossom
