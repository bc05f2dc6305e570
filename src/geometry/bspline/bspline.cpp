#include "geometry/bspline/bspline.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "core/error.h"

namespace blossom {

namespace {

/// The non-zero basis functions of one direction at one parameter, with derivatives up to `Order`.
template <int Order>
struct Basis {
  std::array<double, static_cast<std::size_t>(Order + 1) * (kMaximumDegree + 1)> values;
  std::size_t first;  ///< the pole of the first one
  std::size_t width;

  Basis(int degree, std::span<const double> knots, double t) : width(static_cast<std::size_t>(degree) + 1) {
    const std::size_t span = findSpan(degree, knots, t);
    basisDerivatives(degree, knots, span, t, Order, values);
    first = span + 1 - width;
  }
  [[nodiscard]] const double* row(int order) const { return values.data() + static_cast<std::size_t>(order) * width; }
};

Vec4 combine(const double* weights, std::size_t count, const Vec4* poles, std::size_t stride = 1) {
  Vec4 sum = Vec4::Zero();
  for (std::size_t i = 0; i < count; ++i) sum += weights[i] * poles[i * stride];
  return sum;
}

template <int Order>
Vec4 combine(const Surface& surface, const Basis<Order>& u, int orderU, const Basis<Order>& v, int orderV) {
  Vec4 sum = Vec4::Zero();
  for (std::size_t i = 0; i < u.width; ++i)
    sum += u.row(orderU)[i] * combine(v.row(orderV), v.width, &surface.pole(u.first + i, v.first));
  return sum;
}

Vec3 project(const Vec4& homogeneous) {
  if (homogeneous.w() == 0)
    throw Error(ErrorCode::Degenerate, "The weight of a rational curve or surface vanishes.",
                "Give all poles positive weights.");
  return homogeneous.head<3>() / homogeneous.w();
}

}  // namespace

Vec4 evaluate(const Curve& curve, double t) {
  const Basis<0> basis(curve.degree, curve.knots, t);
  return combine(basis.row(0), basis.width, &curve.poles[basis.first]);
}

Vec4 evaluate(const Surface& surface, double u, double v) {
  const Basis<0> basisU(surface.degreeU, surface.knotsU, u), basisV(surface.degreeV, surface.knotsV, v);
  return combine(surface, basisU, 0, basisV, 0);
}

std::vector<Vec4> derivatives(const Curve& curve, double t, int order) {
  const std::size_t width = static_cast<std::size_t>(curve.degree) + 1, rows = static_cast<std::size_t>(order) + 1;
  const std::size_t span = findSpan(curve.degree, curve.knots, t);
  std::vector<double> basis(rows * width);
  basisDerivatives(curve.degree, curve.knots, span, t, order, basis);
  std::vector<Vec4> result(rows);
  for (std::size_t k = 0; k < rows; ++k) result[k] = combine(&basis[k * width], width, &curve.poles[span + 1 - width]);
  return result;
}

std::vector<Vec4> derivatives(const Surface& surface, double u, double v, int order) {
  const std::size_t widthU = static_cast<std::size_t>(surface.degreeU) + 1,
                    widthV = static_cast<std::size_t>(surface.degreeV) + 1;
  const std::size_t rows = static_cast<std::size_t>(order) + 1;
  const std::size_t spanU = findSpan(surface.degreeU, surface.knotsU, u),
                    spanV = findSpan(surface.degreeV, surface.knotsV, v);
  std::vector<double> basisU(rows * widthU), basisV(rows * widthV);
  basisDerivatives(surface.degreeU, surface.knotsU, spanU, u, order, basisU);
  basisDerivatives(surface.degreeV, surface.knotsV, spanV, v, order, basisV);

  std::vector<Vec4> result(rows * rows, Vec4::Zero()), column(widthU);
  for (std::size_t j = 0; j < rows; ++j) {
    for (std::size_t i = 0; i < widthU; ++i)
      column[i] = combine(&basisV[j * widthV], widthV, &surface.pole(spanU + 1 - widthU + i, spanV + 1 - widthV));
    for (std::size_t i = 0; i + j < rows; ++i) result[i * rows + j] = combine(&basisU[i * widthU], widthU, column.data());
  }
  return result;
}

Vec3 point(const Curve& curve, double t) { return project(evaluate(curve, t)); }
Vec3 point(const Surface& surface, double u, double v) { return project(evaluate(surface, u, v)); }

SurfaceFrame frame(const Surface& surface, double u, double v) {
  const Basis<1> basisU(surface.degreeU, surface.knotsU, u), basisV(surface.degreeV, surface.knotsV, v);
  const Vec4 value = combine(surface, basisU, 0, basisV, 0);
  const Vec4 du = combine(surface, basisU, 1, basisV, 0), dv = combine(surface, basisU, 0, basisV, 1);
  const Vec3 x = project(value);
  return {x, (du.head<3>() - du.w() * x) / value.w(), (dv.head<3>() - dv.w() * x) / value.w()};
}

Surface reversedU(const Surface& surface) {
  Surface result = surface;
  const auto [from, to] = surface.domainU();
  const std::size_t count = surface.knotsU.size(), nu = surface.countU(), nv = surface.countV();
  // from + to - knot would move the ends by a rounding error; they stay exact this way
  for (std::size_t i = 0; i < count; ++i) {
    const double knot = surface.knotsU[count - 1 - i];
    result.knotsU[i] = knot == from ? to : knot == to ? from : from + (to - knot);
  }
  for (std::size_t i = 0; i < nu; ++i) std::copy_n(&surface.pole(nu - 1 - i, 0), nv, &result.pole(i, 0));
  return result;
}

Surface transposed(const Surface& surface) {
  Surface result{surface.degreeV, surface.degreeU, surface.knotsV, surface.knotsU, std::vector<Vec4>(surface.poles.size())};
  for (std::size_t i = 0; i < surface.countU(); ++i)
    for (std::size_t j = 0; j < surface.countV(); ++j) result.pole(j, i) = surface.pole(i, j);
  return result;
}

Curve isoU(const Surface& surface, double u) {
  const Basis<0> basis(surface.degreeU, surface.knotsU, u);
  Curve result{surface.degreeV, surface.knotsV, std::vector<Vec4>(surface.countV())};
  for (std::size_t j = 0; j < result.poles.size(); ++j)
    result.poles[j] = combine(basis.row(0), basis.width, &surface.pole(basis.first, j), surface.countV());
  return result;
}

Curve isoV(const Surface& surface, double v) {
  const Basis<0> basis(surface.degreeV, surface.knotsV, v);
  Curve result{surface.degreeU, surface.knotsU, std::vector<Vec4>(surface.countU())};
  for (std::size_t i = 0; i < result.poles.size(); ++i)
    result.poles[i] = combine(basis.row(0), basis.width, &surface.pole(i, basis.first));
  return result;
}

namespace {
double smallestWeight(const std::vector<Vec4>& poles) {
  return std::min_element(poles.begin(), poles.end(), [](const Vec4& a, const Vec4& b) { return a.w() < b.w(); })->w();
}
}  // namespace

double smallestWeight(const Curve& curve) { return smallestWeight(curve.poles); }
double smallestWeight(const Surface& surface) { return smallestWeight(surface.poles); }

}  // namespace blossom
