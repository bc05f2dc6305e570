#include <benchmark/benchmark.h>

#include <array>
#include <optional>
#include <random>

#include "geometry/bspline/bspline.h"
#include "geometry/bspline/patch_polynomial.h"
#include "geometry/bspline/product.h"

/// The product surface of a two-parameter motion, r and s bicubic over 8 x 8 spans, t cubic over 8 (degree 9 x 12), with all
/// components general. Beside it, to judge it by: evaluating the factors at the Greville abscissae, which a collocation
/// would do before it solves its systems, and |r|^2 s by two products of whole surfaces, a small part of the same work.
namespace {

using namespace blossom;

std::vector<double> clampedKnots(int degree, int spans) {
  std::vector<double> knots(static_cast<std::size_t>(degree), 0.0);
  for (int i = 0; i <= spans; ++i) knots.push_back(static_cast<double>(i) / spans);
  knots.insert(knots.end(), static_cast<std::size_t>(degree), 1.0);
  return knots;
}

struct Factors {
  Surface r, s;
  Curve t;
};

Factors factors(int degree, int spans) {
  std::mt19937_64 random(7);
  std::uniform_real_distribution<double> noise(-1, 1);
  const auto pole = [&] { return Vec4(noise(random), noise(random), noise(random), 2 + noise(random)); };
  const std::vector<double> knots = clampedKnots(degree, spans);
  Factors f{{degree, degree, knots, knots, {}}, {degree, degree, knots, knots, {}}, {degree, knots, {}}};
  const std::size_t n = f.r.countU();
  for (std::size_t i = 0; i < n * n; ++i) f.r.poles.push_back(pole()), f.s.poles.push_back(pole());
  for (std::size_t i = 0; i < n; ++i) f.t.poles.push_back(pole());
  return f;
}

/// (tw Q(r) s + t |r|^2 sw, tw |r|^2 sw), all components general.
Surface sweepProduct(const Factors& f) {
  const int p = f.r.degreeU;
  const PatchGrid grid(productKnots(std::vector<ProductFactor>{{p, 2, f.r.knotsU}, {p, 1, f.s.knotsU}}),
                       productKnots(std::vector<ProductFactor>{{p, 2, f.r.knotsV}, {p, 1, f.s.knotsV}, {p, 1, f.t.knots}}));
  const auto r = patchPolynomials(f.r, grid), s = patchPolynomials(f.s, grid), t = patchPolynomialsInV(f.t, grid);
  std::array<std::array<std::optional<PatchPolynomial>, 4>, 4> rr;
  for (std::size_t i = 0; i < 4; ++i)
    for (std::size_t j = i; j < 4; ++j) rr[i][j] = product(r[i], r[j]);
  const auto sum = [&](std::array<double, 4> squares) {
    PatchPolynomial result(grid.patches(), 2 * p, 2 * p);
    for (std::size_t i = 0; i < 4; ++i) result.add(*rr[i][i], squares[i]);
    return result;
  };
  const auto twice = [&](std::size_t i, std::size_t j, std::size_t k, std::size_t l, double sign) {
    PatchPolynomial result(grid.patches(), 2 * p, 2 * p);
    return std::move(result.add(*rr[i][j], 2).add(*rr[k][l], 2 * sign));
  };
  const PatchPolynomial q[3][3] = {{sum({1, 1, -1, -1}), twice(1, 2, 0, 3, -1), twice(1, 3, 0, 2, 1)},
                                   {twice(1, 2, 0, 3, 1), sum({1, -1, 1, -1}), twice(2, 3, 0, 1, -1)},
                                   {twice(1, 3, 0, 2, -1), twice(2, 3, 0, 1, 1), sum({1, -1, -1, 1})}};
  const PatchPolynomial scale = product(sum({1, 1, 1, 1}), s[3]);
  const auto component = [&](std::size_t i) {
    PatchPolynomial y = product(q[i][0], s[0]);
    y.addProduct(q[i][1], s[1]).addProduct(q[i][2], s[2]);
    return std::move(product(t[3], y).addProduct(t[i], scale));
  };
  return assemble({component(0), component(1), component(2), product(t[3], scale)}, grid);
}

/// Values of the product at the Greville abscissae of its knots.
double greville(const Factors& f, const ProductKnots& u, const ProductKnots& v) {
  const auto abscissa = [](const ProductKnots& k, std::size_t i) {
    double sum = 0;
    for (std::size_t m = 1; m <= static_cast<std::size_t>(k.degree); ++m) sum += k.knots[i + m];
    return sum / k.degree;
  };
  double checksum = 0;
  for (std::size_t i = 0; i + static_cast<std::size_t>(u.degree) + 1 < u.knots.size(); ++i)
    for (std::size_t j = 0; j + static_cast<std::size_t>(v.degree) + 1 < v.knots.size(); ++j) {
      const double a = abscissa(u, i), b = abscissa(v, j);
      const Vec4 r = evaluate(f.r, a, b), s = evaluate(f.s, a, b), t = evaluate(f.t, b);
      checksum += r.squaredNorm() * s.w() * t.w();
    }
  return checksum;
}

void BM_PatchProduct(benchmark::State& state) {
  const Factors f = factors(3, static_cast<int>(state.range(0)));
  for (auto _ : state) benchmark::DoNotOptimize(sweepProduct(f));
  const Surface x = sweepProduct(f);
  state.counters["poles"] = static_cast<double>(x.poles.size());
}
BENCHMARK(BM_PatchProduct)->Arg(8)->Arg(16)->Unit(benchmark::kMillisecond);

void BM_GrevilleEvaluation(benchmark::State& state) {
  const Factors f = factors(3, 8);
  const ProductKnots u = productKnots(std::vector<ProductFactor>{{3, 3, f.r.knotsU}}),
                     v = productKnots(std::vector<ProductFactor>{{3, 4, f.r.knotsV}});
  for (auto _ : state) benchmark::DoNotOptimize(greville(f, u, v));
}
BENCHMARK(BM_GrevilleEvaluation)->Unit(benchmark::kMillisecond);

void BM_SurfaceProduct(benchmark::State& state) {
  const Factors f = factors(3, 8);
  for (auto _ : state) benchmark::DoNotOptimize(product(f.r, f.s));
}
BENCHMARK(BM_SurfaceProduct)->Unit(benchmark::kMillisecond);

void BM_ChainedSurfaceProducts(benchmark::State& state) {
  const Factors f = factors(3, 8);
  for (auto _ : state) benchmark::DoNotOptimize(product(product(f.r, f.r), f.s));
}
BENCHMARK(BM_ChainedSurfaceProducts)->Unit(benchmark::kMillisecond);

void BM_BezierAndBack(benchmark::State& state) {
  const Factors f = factors(3, 8);
  const Surface x = sweepProduct(f);
  for (auto _ : state) benchmark::DoNotOptimize(fromBezier(toBezier(x), x.knotsU, x.knotsV));
}
BENCHMARK(BM_BezierAndBack)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
