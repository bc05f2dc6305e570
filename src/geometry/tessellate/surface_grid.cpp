#include "geometry/tessellate/surface_grid.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/bspline/bspline.h"
#include "geometry/tessellate/grid_curvature.h"

namespace blossom {
namespace {

/// Basis functions and first derivatives of every sample: [2][degree + 1] each.
std::vector<double> basisTable(int degree, const std::vector<double>& knots, const std::vector<GridSample>& samples) {
  const auto width = 2 * (static_cast<std::size_t>(degree) + 1);
  std::vector<double> table(samples.size() * width);
  for (std::size_t i = 0; i < samples.size(); ++i)
    basisDerivatives(degree, knots, samples[i].span, samples[i].t, 1, std::span(table).subspan(i * width, width));
  return table;
}

struct Frame {
  Vec3 point, du, dv;
};

Frame quotient(const Vec4& value, const Vec4& du, const Vec4& dv) {
  const Vec3 point = value.head<3>() / value.w();
  return {point, (du.head<3>() - du.w() * point) / value.w(), (dv.head<3>() - dv.w() * point) / value.w()};
}

Vec3 unitNormal(const Vec3& du, const Vec3& dv) {
  const Vec3 normal = du.cross(dv);
  const double speed = std::max(du.squaredNorm(), dv.squaredNorm());
  return normal.norm() > 1e-8 * speed ? Vec3(normal.normalized()) : Vec3(0, 0, 0);
}

/// At a pole one derivative vanishes: a little way inside the normal is there and nearly the same.
Vec3 normalNear(const Surface& surface, double u, double v) {
  const auto [u0, u1] = surface.domainU();
  const auto [v0, v1] = surface.domainV();
  for (const double step : {1e-5, 1e-3, 1e-2}) {
    const SurfaceFrame inside = frame(surface, u + step * ((u0 + u1) / 2 - u), v + step * ((v0 + v1) / 2 - v));
    Vec3 normal = unitNormal(inside.du, inside.dv);
    if (normal.norm() > 0.5) return normal;
  }
  return {0, 0, 1};
}

class GridEvaluator {
 public:
  GridEvaluator(const Surface& surface, SurfaceGrid& grid)
      : surface_(surface),
        grid_(grid),
        tableU_(basisTable(surface.degreeU, surface.knotsU, grid.u)),
        tableV_(basisTable(surface.degreeV, surface.knotsV, grid.v)) {}

  void row(std::size_t i) const {
    const std::size_t countV = surface_.countV();
    const auto orderU = static_cast<std::size_t>(surface_.degreeU) + 1;
    const double* basis = &tableU_[i * 2 * orderU];
    const std::size_t first = grid_.u[i].span - orderU + 1;
    // The row's own curve in v and its derivative by u.
    std::vector<Vec4> value(countV, Vec4::Zero()), slope(countV, Vec4::Zero());
    for (std::size_t k = 0; k < orderU; ++k) {
      const Vec4* poles = &surface_.pole(first + k, 0);
      for (std::size_t j = 0; j < countV; ++j) value[j] += basis[k] * poles[j];
      if (!grid_.normals.empty())
        for (std::size_t j = 0; j < countV; ++j) slope[j] += basis[orderU + k] * poles[j];
    }
    for (std::size_t j = 0; j < grid_.v.size(); ++j)
      grid_.normals.empty() ? placePoint(i, j, value) : placePointAndNormal(i, j, value, slope);
  }

 private:
  void placePoint(std::size_t i, std::size_t j, const std::vector<Vec4>& value) const {
    const auto orderV = static_cast<std::size_t>(surface_.degreeV) + 1;
    const double* basis = &tableV_[j * 2 * orderV];
    const std::size_t first = grid_.v[j].span - orderV + 1;
    Vec4 s = Vec4::Zero();
    for (std::size_t k = 0; k < orderV; ++k) s += basis[k] * value[first + k];
    place(i * grid_.v.size() + j, s.head<3>() / s.w());
  }

  void placePointAndNormal(std::size_t i, std::size_t j, const std::vector<Vec4>& value,
                           const std::vector<Vec4>& slope) const {
    const auto orderV = static_cast<std::size_t>(surface_.degreeV) + 1;
    const double* basis = &tableV_[j * 2 * orderV];
    const std::size_t first = grid_.v[j].span - orderV + 1;
    Vec4 s = Vec4::Zero(), du = Vec4::Zero(), dv = Vec4::Zero();
    for (std::size_t k = 0; k < orderV; ++k) {
      s += basis[k] * value[first + k];
      du += basis[k] * slope[first + k];
      dv += basis[orderV + k] * value[first + k];
    }
    const Frame at = quotient(s, du, dv);
    const std::size_t index = i * grid_.v.size() + j;
    place(index, at.point);
    const Vec3 normal = unitNormal(at.du, at.dv);
    grid_.normals[index] = normal.norm() > 0.5 ? normal : normalNear(surface_, grid_.u[i].t, grid_.v[j].t);
  }

  void place(std::size_t index, const Vec3& point) const {
    if (!point.allFinite())
      throw Error(ErrorCode::Degenerate, "The surface runs through infinity.", "Look for poles with the weight 0 or less.");
    grid_.points[index] = point;
  }

  const Surface& surface_;
  SurfaceGrid& grid_;
  std::vector<double> tableU_, tableV_;
};

}  // namespace

std::vector<double> domainBreaks(int degree, const std::vector<double>& knots) {
  const double low = knots[static_cast<std::size_t>(degree)];
  const double high = knots[knots.size() - 1 - static_cast<std::size_t>(degree)];
  std::vector<double> result;
  for (const double knot : knots)
    if (knot >= low && knot <= high && (result.empty() || knot > result.back())) result.push_back(knot);
  return result;
}

std::vector<GridSample> samples(int degree, const std::vector<double>& knots, const std::vector<double>& breaks,
                                const std::vector<int>& steps, int times, Kinks kinks) {
  std::vector<GridSample> result;
  for (std::size_t k = 0; k + 1 < breaks.size(); ++k) {
    const std::size_t span = findSpan(degree, knots, breaks[k]);
    const auto multiplicity = std::count(knots.begin(), knots.end(), breaks[k]);
    const int count = steps[k] * times;
    const bool kink = kinks == Kinks::Twice && multiplicity >= degree;
    for (int i = k == 0 || kink ? 0 : 1; i <= count; ++i) {
      const double t = i == count ? breaks[k + 1] : breaks[k] + (breaks[k + 1] - breaks[k]) * i / count;
      result.push_back({t, span, k, i % times != 0});
    }
  }
  return result;
}

std::vector<GridSample> samplesAt(int degree, const std::vector<double>& knots, const std::vector<double>& parameters) {
  std::vector<GridSample> result;
  result.reserve(parameters.size());
  for (const double t : parameters) result.push_back({t, findSpan(degree, knots, t), 0, false});
  return result;
}

SurfaceGrid evaluateGrid(const Surface& surface, std::vector<GridSample> u, std::vector<GridSample> v,
                         const Progress& progress, GridNormals normals) {
  SurfaceGrid grid{std::move(u), std::move(v), {}, {}};
  grid.points.resize(grid.u.size() * grid.v.size());
  if (normals == GridNormals::Yes) grid.normals.resize(grid.points.size());
  const GridEvaluator evaluator(surface, grid);
  parallelFor(grid.u.size(), 8, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) evaluator.row(i);
  });
  return grid;
}

SecondOrder secondOrder(const Surface& surface, double u, double v) {
  const auto [du, dv, uu, uv, vv] = jetOf(surface, u, v);
  const Vec3 normal = unitNormal(du, dv);
  const auto bend = [&](const Vec3& second) { return normal.norm() > 0.5 ? std::abs(second.dot(normal)) : second.norm(); };
  return {bend(uu), bend(uv), bend(vv), du.norm(), dv.norm()};
}

}  // namespace blossom
