#include <benchmark/benchmark.h>

#include <GeomAdaptor_Surface.hxx>
#include <cmath>
#include <numbers>

#include "core/stopwatch.h"
#include "geometry/occt/occt.h"
#include "sweep/kernel/motion_grid.h"
#include "sweep/kernel/product_surface.h"

/// Factored evaluation and product of a motion with 8 x 8 bicubic spans, against OCCT on the product surface, in one run.
/// Each peer shows `ratio`, its time over that of BM_FactoredGrid.
using namespace blossom;

namespace {

constexpr std::size_t side = 256;

/// A lobed tube with 8 x 8 spans, clamped in both directions, every factor bicubic or cubic.
Motion motionOf8x8Spans() {
  std::vector<double> knots(3, 0.0);
  for (int i = 0; i <= 8; ++i) knots.push_back(i / 8.0);
  knots.insert(knots.end(), 3, 1.0);
  Motion motion{{3, knots, {}}, {3, 3, knots, knots, {}}, {3, 3, knots, knots, {}}, ClosedU::No, Vec3(1, 0, 0)};
  for (int j = 0; j < 11; ++j) motion.trajectory.poles.emplace_back(std::sin(0.3 * j), 0.2 * j, j, 1);
  for (int i = 0; i < 11; ++i)
    for (int j = 0; j < 11; ++j) {
      const double half = std::numbers::pi * i / 10, lean = 0.05 * j;
      motion.orientation.poles.emplace_back(std::cos(half) * std::cos(lean), std::sin(half) * std::sin(lean),
                                            std::cos(half) * std::sin(lean), std::sin(half) * std::cos(lean));
      motion.scaling.poles.emplace_back(5 + std::cos(0.7 * i), 5, 5, 1 + 0.01 * j);
    }
  return motion;
}

/// Time of one call in seconds, the best of a few: what the ratios are taken against.
template <class Work>
double secondsOf(Work work, int repetitions) {
  double best = 1e9;
  for (int k = 0; k < repetitions; ++k) {
    const Stopwatch watch;
    work();
    best = std::min(best, watch.elapsedMs() / 1000);
  }
  return best;
}

struct Subject {
  Motion motion = motionOf8x8Spans();
  Handle(Geom_BSplineSurface) surface = toOcct(sweep::productSurface(motion).surface);
  std::vector<double> us = sweep::evenParameters(motion.domainU(), side), vs = sweep::evenParameters(motion.domainV(), side);
  sweep::MotionGrid grid;
  double factored = secondsOf([this] { sweep::evaluateGrid(motion, us, vs, grid); }, 20);
};

Subject& subject() {
  static Subject the;
  return the;
}

void BM_FactoredGrid(benchmark::State& state) {
  Subject& s = subject();
  for (auto _ : state) {
    sweep::evaluateGrid(s.motion, s.us, s.vs, s.grid);
    benchmark::DoNotOptimize(s.grid.point[0].data());
  }
  state.counters["ns_per_point"] = s.factored * 1e9 / (side * side);
}

/// Points and first derivatives over the same grid, then the normal, as the factored evaluation gives it.
template <class Evaluator>
void evaluateWithOcct(const Evaluator& evaluator, const Subject& s) {
  gp_Pnt point;
  gp_Vec du, dv;
  for (const double u : s.us)
    for (const double v : s.vs) {
      evaluator.D1(u, v, point, du, dv);
      gp_Vec normal = du.Crossed(dv);
      benchmark::DoNotOptimize(normal);
    }
}

template <class Evaluator>
void runPeer(benchmark::State& state, const Evaluator& evaluator) {
  Subject& s = subject();
  double best = 1e9;
  for (auto _ : state) best = std::min(best, secondsOf([&] { evaluateWithOcct(evaluator, s); }, 1));
  state.counters["ratio"] = best / s.factored;
}

void BM_OcctD1(benchmark::State& state) { runPeer(state, *subject().surface); }
void BM_GeomAdaptorD1(benchmark::State& state) { runPeer(state, GeomAdaptor_Surface(subject().surface)); }

void BM_Product8x8(benchmark::State& state) {
  Subject& s = subject();
  double best = 1e9;
  for (auto _ : state)
    best = std::min(best, secondsOf([&] { benchmark::DoNotOptimize(sweep::productSurface(s.motion)); }, 1));
  state.counters["ratio"] = best / s.factored;
}

BENCHMARK(BM_FactoredGrid)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_OcctD1)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_GeomAdaptorD1)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Product8x8)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
