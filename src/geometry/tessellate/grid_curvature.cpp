#include "geometry/tessellate/grid_curvature.h"

#include <array>

#include "core/parallel.h"
#include "geometry/bspline/bspline.h"

namespace blossom {
namespace {

/// Homogeneous derivatives by the orders in u and v.
struct HomogeneousJet {
  Vec4 value = Vec4::Zero(), u = Vec4::Zero(), v = Vec4::Zero(), uu = Vec4::Zero(), uv = Vec4::Zero(), vv = Vec4::Zero();
};

/// Differentiates x w = X and solves for the highest derivative of x.
SurfaceJet inSpace(const HomogeneousJet& h) {
  const double w = h.value.w();
  const Vec3 x = h.value.head<3>() / w;
  SurfaceJet jet;
  jet.u = (h.u.head<3>() - h.u.w() * x) / w;
  jet.v = (h.v.head<3>() - h.v.w() * x) / w;
  jet.uu = (h.uu.head<3>() - 2 * h.u.w() * jet.u - h.uu.w() * x) / w;
  jet.uv = (h.uv.head<3>() - h.u.w() * jet.v - h.v.w() * jet.u - h.uv.w() * x) / w;
  jet.vv = (h.vv.head<3>() - 2 * h.v.w() * jet.v - h.vv.w() * x) / w;
  return jet;
}

/// Basis functions of every sample with their first two derivatives: [3][degree + 1] each.
std::vector<double> secondOrderTable(int degree, const std::vector<double>& knots, const std::vector<GridSample>& samples) {
  const auto width = 3 * (static_cast<std::size_t>(degree) + 1);
  std::vector<double> table(samples.size() * width);
  for (std::size_t i = 0; i < samples.size(); ++i)
    basisDerivatives(degree, knots, samples[i].span, samples[i].t, 2, std::span(table).subspan(i * width, width));
  return table;
}

SurfaceCurvature curvatureNear(const Surface& surface, double u, double v) {
  const auto [u0, u1] = surface.domainU();
  const auto [v0, v1] = surface.domainV();
  for (const double step : {1e-4, 1e-3, 1e-2})
    if (const auto c = curvatureOf(jetOf(surface, u + step * ((u0 + u1) / 2 - u), v + step * ((v0 + v1) / 2 - v))))
      return *c;
  return {};
}

class CurvatureRows {
 public:
  CurvatureRows(const Surface& surface, const SurfaceGrid& grid, std::vector<SurfaceCurvature>& result)
      : surface_(surface),
        grid_(grid),
        result_(result),
        tableU_(secondOrderTable(surface.degreeU, surface.knotsU, grid.u)),
        tableV_(secondOrderTable(surface.degreeV, surface.knotsV, grid.v)) {}

  void row(std::size_t i) const {
    const std::size_t countV = surface_.countV();
    const auto orderU = static_cast<std::size_t>(surface_.degreeU) + 1;
    const double* basis = &tableU_[i * 3 * orderU];
    const std::size_t first = grid_.u[i].span - orderU + 1;
    // The row's own curve in v, and its first two derivatives by u.
    std::array<std::vector<Vec4>, 3> rows;
    for (std::size_t order = 0; order < 3; ++order) {
      rows[order].assign(countV, Vec4::Zero());
      for (std::size_t k = 0; k < orderU; ++k)
        for (std::size_t j = 0; j < countV; ++j) rows[order][j] += basis[order * orderU + k] * surface_.pole(first + k, j);
    }
    for (std::size_t j = 0; j < grid_.v.size(); ++j) {
      const auto c = curvatureOf(inSpace(jetAt(j, rows)));
      result_[i * grid_.v.size() + j] = c ? *c : curvatureNear(surface_, grid_.u[i].t, grid_.v[j].t);
    }
  }

 private:
  [[nodiscard]] HomogeneousJet jetAt(std::size_t j, const std::array<std::vector<Vec4>, 3>& rows) const {
    const auto orderV = static_cast<std::size_t>(surface_.degreeV) + 1;
    const double* basis = &tableV_[j * 3 * orderV];
    const std::size_t first = grid_.v[j].span - orderV + 1;
    HomogeneousJet h;
    for (std::size_t k = 0; k < orderV; ++k) {
      const double value = basis[k], slope = basis[orderV + k], bend = basis[2 * orderV + k];
      h.value += value * rows[0][first + k];
      h.u += value * rows[1][first + k];
      h.uu += value * rows[2][first + k];
      h.v += slope * rows[0][first + k];
      h.uv += slope * rows[1][first + k];
      h.vv += bend * rows[0][first + k];
    }
    return h;
  }

  const Surface& surface_;
  const SurfaceGrid& grid_;
  std::vector<SurfaceCurvature>& result_;
  std::vector<double> tableU_, tableV_;
};

}  // namespace

SurfaceJet jetOf(const Surface& surface, double u, double v) {
  const std::vector<Vec4> d = derivatives(surface, u, v, 2);  // [i * 3 + j]
  return inSpace({d[0], d[3], d[1], d[6], d[4], d[2]});
}

std::vector<SurfaceCurvature> gridCurvature(const Surface& surface, const SurfaceGrid& grid, const Progress& progress) {
  std::vector<SurfaceCurvature> result(grid.u.size() * grid.v.size());
  const CurvatureRows rows(surface, grid, result);
  parallelFor(grid.u.size(), 8, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) rows.row(i);
  });
  return result;
}

}  // namespace blossom
