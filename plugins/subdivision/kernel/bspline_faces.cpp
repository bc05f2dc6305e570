#include "kernel/bspline_faces.h"

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "kernel/cage.h"
#include "kernel/limit_surface.h"
#include "kernel/quad_layout.h"
#include "kernel/settled_cage.h"

namespace blossom::subdivision {
namespace {

constexpr int coarsest = 2, finest = 8;  // levels of knots towards an extraordinary corner

/// Point, derivatives by u and v, and the mixed one.
struct Node {
  Vec3 at, du, dv, duv;
};

/// Turned by 0 to 3 quarters, as a face lies in its cell.
Node turned(const Frame& frame, int turn) {
  switch (turn) {
    case 1:
      return {frame.at, frame.dv, -frame.du, -frame.duv};
    case 2:
      return {frame.at, -frame.du, -frame.dv, frame.duv};
    case 3:
      return {frame.at, -frame.dv, frame.du, -frame.duv};
    default:
      return {frame.at, frame.du, frame.dv, frame.duv};
  }
}

/// The limit surface over one cell, in coordinates that grow by 1 from face to face.
class CellSurface {
 public:
  CellSurface(const LimitSurface& surface, std::span<const Vec3> points, const LayoutCell& cell)
      : surface_(surface), points_(points), cell_(cell) {}

  [[nodiscard]] Node node(double u, double v) const {
    const int column = std::clamp(static_cast<int>(std::floor(u)), 0, cell_.columns - 1);
    const int row = std::clamp(static_cast<int>(std::floor(v)), 0, cell_.rows - 1);
    return within(column, row, u - column, v - row);
  }
  /// At (s, t) of one face.
  [[nodiscard]] Node within(int column, int row, double s, double t) const {
    const PlacedFace& placed = cell_.at(column, row);
    const std::array<Vec2, 4> place{Vec2(s, t), Vec2(1 - t, s), Vec2(1 - s, 1 - t), Vec2(t, 1 - s)};
    const Vec2& at = place[static_cast<std::size_t>(placed.turn)];
    return turned(surface_.frame({placed.face, at.x(), at.y()}, points_), placed.turn);
  }
  [[nodiscard]] Vec3 at(double u, double v) const { return node(u, v).at; }

 private:
  const LimitSurface& surface_;
  std::span<const Vec3> points_;
  const LayoutCell& cell_;
};

Vec4 pole(const Vec3& p) { return {p.x(), p.y(), p.z(), 1}; }

/// Sixteen poles of a uniform bicubic B-spline whose piece is the bicubic polynomial with these corners. Rows run in u.
using PolePatch = std::array<std::array<Vec3, 4>, 4>;
PolePatch uniformPatch(const std::array<std::array<Node, 2>, 2>& corner) {
  PolePatch bezier;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      const Node& n = corner[i / 2][j / 2];
      const double a = i == 1 ? 1.0 / 3 : i == 2 ? -1.0 / 3 : 0, b = j == 1 ? 1.0 / 3 : j == 2 ? -1.0 / 3 : 0;
      bezier[i][j] = n.at + a * n.du + b * n.dv + a * b * n.duv;
    }
  // Blossoms at consecutive whole numbers.
  constexpr std::array<std::array<double, 4>, 4> change{{{6, -7, 2, 0}, {0, 2, -1, 0}, {0, -1, 2, 0}, {0, 2, -7, 6}}};
  PolePatch half, poles;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      half[i][j].setZero();
      for (std::size_t k = 0; k < 4; ++k) half[i][j] += change[i][k] * bezier[k][j];
    }
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = 0; j < 4; ++j) {
      poles[i][j].setZero();
      for (std::size_t k = 0; k < 4; ++k) poles[i][j] += change[j][k] * half[i][k];
    }
  return poles;
}

std::vector<double> uniform(int spans) {
  std::vector<double> knots;
  for (int k = -3; k <= spans + 3; ++k) knots.push_back(k);
  return knots;
}

Surface exactFace(const CellSurface& limit, const LayoutCell& cell) {
  Surface surface;
  surface.degreeU = surface.degreeV = 3;
  surface.knotsU = uniform(cell.columns);
  surface.knotsV = uniform(cell.rows);
  surface.poles.resize(static_cast<std::size_t>(cell.columns + 3) * static_cast<std::size_t>(cell.rows + 3));
  for (int column = 0; column < cell.columns; ++column)
    for (int row = 0; row < cell.rows; ++row) {
      std::array<std::array<Node, 2>, 2> corner;
      for (std::size_t i = 0; i < 2; ++i)
        for (std::size_t j = 0; j < 2; ++j)
          corner[i][j] = limit.within(column, row, static_cast<double>(i), static_cast<double>(j));
      const PolePatch patch = uniformPatch(corner);
      for (std::size_t i = 0; i < 4; ++i)
        for (std::size_t j = 0; j < 4; ++j)
          surface.pole(static_cast<std::size_t>(column) + i, static_cast<std::size_t>(row) + j) = pole(patch[i][j]);
    }
  return clamped(surface);
}

/// 0 .. spans, with knots that crowd towards the ends wanted.
std::vector<double> gradedBreaks(int spans, bool atStart, bool atEnd, int levels) {
  std::vector<double> breaks;
  for (int k = 0; k <= spans; ++k) breaks.push_back(k);
  for (int level = 1; level <= levels; ++level) {
    if (atStart) breaks.push_back(std::ldexp(1.0, -level));
    if (atEnd) breaks.push_back(spans - std::ldexp(1.0, -level));
  }
  std::sort(breaks.begin(), breaks.end());
  breaks.erase(std::unique(breaks.begin(), breaks.end()), breaks.end());
  return breaks;
}

/// Cubic with derivatives d at the ends of a piece of length h: the value in the middle is
/// (p0 + p1)/2 + h (d0 - d1)/8.
class LastPiece {
 public:
  /// @param cu,cv which end of u and v the corner is at; h length of the last piece
  LastPiece(const CellSurface& limit, const LayoutCell& cell, bool atEndU, bool atEndV, double h)
      : limit_(limit),
        h_(h),
        u_(atEndU ? cell.columns : 0),
        v_(atEndV ? cell.rows : 0),
        su_(atEndU ? -1 : 1),
        sv_(atEndV ? -1 : 1) {}

  [[nodiscard]] Node node() const {
    const Node limit = limit_.node(u_, v_);
    Node corner{limit.at, along(limit.du, alongU(limit.at)), along(limit.dv, alongV(limit.at)), Vec3::Zero()};
    corner.duv = twist(corner);
    return corner;
  }

 private:
  /// The part of d that runs along the tangent of the side, which the face on its other side shares.
  static Vec3 along(const Vec3& tangent, const Vec3& d) {
    const double square = tangent.squaredNorm();
    return square > 0 ? Vec3(d.dot(tangent) / square * tangent) : d;
  }
  /// The derivative that leads the side through the middle of the limit curve there.
  [[nodiscard]] Vec3 alongU(const Vec3& at) const {
    const Node far = limit_.node(u_ + su_ * h_, v_);
    const Vec3 middle = limit_.at(u_ + su_ * h_ / 2, v_);
    return su_ * (8 * (middle - (at + far.at) / 2) / h_) + far.du;
  }
  [[nodiscard]] Vec3 alongV(const Vec3& at) const {
    const Node far = limit_.node(u_, v_ + sv_ * h_);
    const Vec3 middle = limit_.at(u_, v_ + sv_ * h_ / 2);
    return sv_ * (8 * (middle - (at + far.at) / 2) / h_) + far.dv;
  }
  /// The twist that leads the piece through the middle of the limit surface there.
  [[nodiscard]] Vec3 twist(const Node& corner) const {
    const Node right = limit_.node(u_ + su_ * h_, v_), above = limit_.node(u_, v_ + sv_ * h_),
               opposite = limit_.node(u_ + su_ * h_, v_ + sv_ * h_);
    const Vec3 middle = limit_.at(u_ + su_ * h_ / 2, v_ + sv_ * h_ / 2);
    const double slope = h_ / 16;
    const Vec3 rest = (corner.at + right.at + above.at + opposite.at) / 4 +
                      su_ * slope * (corner.du - right.du + above.du - opposite.du) +
                      sv_ * slope * (corner.dv + right.dv - above.dv - opposite.dv);
    const double weight = su_ * sv_ * h_ * h_ / 64;
    return (middle - rest) / weight + right.duv + above.duv - opposite.duv;
  }

  const CellSurface& limit_;
  double h_, u_, v_, su_, sv_;
};

/// Every second pole along one direction lies before a node, the others behind it.
std::vector<double> offsets(const std::vector<double>& breaks) {
  std::vector<double> result;
  for (std::size_t k = 0; k < breaks.size(); ++k) {
    result.push_back(k > 0 ? -(breaks[k] - breaks[k - 1]) / 3 : 0);
    result.push_back(k + 1 < breaks.size() ? (breaks[k + 1] - breaks[k]) / 3 : 0);
  }
  return result;
}

std::vector<double> doubleKnots(const std::vector<double>& breaks) {
  std::vector<double> knots{breaks.front(), breaks.front()};
  for (const double b : breaks) knots.insert(knots.end(), {b, b});
  knots.insert(knots.end(), {breaks.back(), breaks.back()});
  return knots;
}

Surface gradedFace(const CellSurface& limit, const LayoutCell& cell, int levels) {
  const auto& odd = cell.irregularCorner;
  const std::vector<double> u = gradedBreaks(cell.columns, odd[0] || odd[3], odd[1] || odd[2], levels);
  const std::vector<double> v = gradedBreaks(cell.rows, odd[0] || odd[1], odd[2] || odd[3], levels);
  const double h = std::ldexp(1.0, -levels);
  Surface surface;
  surface.degreeU = surface.degreeV = 3;
  surface.knotsU = doubleKnots(u);
  surface.knotsV = doubleKnots(v);
  surface.poles.resize(4 * u.size() * v.size());
  const std::vector<double> du = offsets(u), dv = offsets(v);
  for (std::size_t i = 0; i < u.size(); ++i)
    for (std::size_t j = 0; j < v.size(); ++j) {
      const bool endU = i + 1 == u.size(), endV = j + 1 == v.size();
      const std::size_t corner = endU ? (endV ? 2 : 1) : (endV ? 3 : 0);
      const bool atCorner = (i == 0 || endU) && (j == 0 || endV) && odd[corner];
      const Node node = atCorner ? LastPiece(limit, cell, endU, endV, h).node() : limit.node(u[i], v[j]);
      for (const std::size_t a : {2 * i, 2 * i + 1})
        for (const std::size_t b : {2 * j, 2 * j + 1})
          surface.pole(a, b) = pole(node.at + du[a] * node.du + dv[b] * node.dv + du[a] * dv[b] * node.duv);
    }
  return surface;
}

struct Gap {
  double distance = 0, angle = 0;
};

/// Compares face and limit surface at a lattice of points in the square from (u, v) with side h.
void compare(const Surface& face, const CellSurface& limit, double u, double v, double h, Gap& gap) {
  constexpr int lattice = 6;
  for (int i = 0; i <= lattice; ++i)
    for (int j = 0; j <= lattice; ++j) {
      const double s = u + h * i / lattice, t = v + h * j / lattice;
      const SurfaceFrame made = frame(face, s, t);
      const Node wanted = limit.node(s, t);
      gap.distance = std::max(gap.distance, (made.point - wanted.at).norm());
      const Vec3 a = made.du.cross(made.dv), b = wanted.du.cross(wanted.dv);
      if (a.norm() > 0 && b.norm() > 0) gap.angle = std::max(gap.angle, std::atan2(a.cross(b).norm(), a.dot(b)));
    }
}

Gap gapOf(const Surface& face, const CellSurface& limit, const LayoutCell& cell, int levels) {
  Gap gap;
  const double h = std::ldexp(1.0, -levels), right = cell.columns - h, top = cell.rows - h;
  if (cell.irregularCorner[0]) compare(face, limit, 0, 0, h, gap);
  if (cell.irregularCorner[1]) compare(face, limit, right, 0, h, gap);
  if (cell.irregularCorner[2]) compare(face, limit, right, top, h, gap);
  if (cell.irregularCorner[3]) compare(face, limit, 0, top, h, gap);
  compare(face, limit, (cell.columns - 1) / 2, (cell.rows - 1) / 2, 1, gap);  // one face is compared as a whole
  return gap;
}

bool irregular(const LayoutCell& cell) {
  return std::any_of(cell.irregularCorner.begin(), cell.irregularCorner.end(), [](bool odd) { return odd; });
}

}  // namespace

FacesResult bsplineFaces(const Mesh& cage, const FacesOptions& options, const Progress& progress) {
  if (!(options.tolerance > 0) || !std::isfinite(options.tolerance))
    throw Error(ErrorCode::InvalidParameter, "The tolerance is not above 0.", "Give a length above 0.");
  checkCage(cage, Scheme::CatmullClark, progress);
  const SettledCage settled = settledCage(cage, options.tolerance / 2, progress.part(0, 0.1));
  const Mesh& quads = settled.quads;
  const LimitSurface surface(quads, Scheme::CatmullClark, progress.part(0.1, 0.3));
  const std::vector<LayoutCell> layout = quadLayout(quads, progress.part(0.3, 0.4));
  FacesResult result;
  for (int levels = coarsest; levels <= finest; levels += 2) {
    result = {};
    Gap gap;
    for (std::size_t c = 0; c < layout.size(); ++c) {
      progress.report(0.4 + 0.6 * static_cast<double>(c) / static_cast<double>(layout.size()), "Making faces");
      const LayoutCell& cell = layout[c];
      const CellSurface limit(surface, quads.points, cell);
      result.faces.push_back(irregular(cell) ? gradedFace(limit, cell, levels) : exactFace(limit, cell));
      result.exactFaces += irregular(cell) ? 0 : 1;
      const Gap here = gapOf(result.faces.back(), limit, cell, levels);
      gap = {std::max(gap.distance, here.distance), std::max(gap.angle, here.angle)};
    }
    result.sharpened = settled.sharpened;
    result.deviation = gap.distance + settled.sharpened;
    result.normalDeviation = gap.angle;
    if (result.deviation <= options.tolerance) break;
  }
  progress.report(1, "Making faces");
  return result;
}

}  // namespace blossom::subdivision
