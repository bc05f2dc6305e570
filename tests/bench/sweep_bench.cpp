#include <benchmark/benchmark.h>

#include <GeomAdaptor_Surface.hxx>
#include <cmath>
#include <numbers>

#include "core/stopwatch.h"
#include "geometry/bspline/bspline.h"
#include "geometry/occt/occt.h"
#include "sweep/kernel/edit/direct_manipulation.h"
#include "sweep/kernel/grid/basis_table.h"
#include "sweep/kernel/grid/grid_curvature.h"
#include "sweep/kernel/grid/live_grid.h"
#include "sweep/kernel/grid/motion_grid.h"
#include "sweep/kernel/grid/motion_point.h"
#include "sweep/kernel/product_surface.h"
#include "sweep/kernel/validity.h"

/// Factored evaluation and product of a motion with 8 x 8 bicubic spans, against OCCT on the product surface, in one run.
/// Each peer shows `ratio`, its time over that of BM_FactoredGrid; each live edit, from the drag to points and normals,
/// shows `ratio`, the time of BM_GeomAdaptorD1 over its own.
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

/// Where the surface is dragged: inside a span, so that the smallest change moves 4 x 4 poles of a factor, which reach 7 x 7
/// of the 8 x 8 spans. Elsewhere less of the grid changes.
constexpr double dragU = 0.44, dragV = 0.56;

/// Best time of OCCT's cached evaluation of the whole grid.
double secondsOfGeomAdaptor() {
  static const double seconds = [] {
    const GeomAdaptor_Surface evaluator(subject().surface);
    return secondsOf([&] { evaluateWithOcct(evaluator, subject()); }, 5);
  }();
  return seconds;
}

/// Edits the motion anew in every step, as a drag does, and brings the live grid up to date.
template <class Edit>
void runLive(benchmark::State& state, Edit edit) {
  Subject& s = subject();
  sweep::LiveGrid live(s.motion, s.us, s.vs);
  std::size_t places = 0;
  double best = 1e9;
  int step = 0;
  for (auto _ : state)
    best = std::min(best, secondsOf(
                              [&] {
                                Motion edited = s.motion;
                                edit(edited, 0.5 + 0.1 * (++step % 7));
                                places = 0;
                                for (const auto& part : live.update(edited))
                                  places += part.rows.size() * part.columns.size();
                                benchmark::DoNotOptimize(live.grid().point[0].data());
                              },
                              1));
  state.counters["ratio"] = secondsOfGeomAdaptor() / best;
  state.counters["share"] = static_cast<double>(places) / (side * side);
}

void BM_LiveScalingEdit(benchmark::State& state) {
  const Motion& motion = subject().motion;
  const Vec3 centre = point(motion.trajectory, dragV), arm = sweep::evaluate(motion, dragU, dragV).point - centre;
  runLive(state, [&](Motion& edited, double size) { sweep::dragScaling(edited, dragU, dragV, centre + (1 + size) * arm); });
}

void BM_LiveOrientationEdit(benchmark::State& state) {
  runLive(state,
          [](Motion& edited, double size) { sweep::twistOrientation(edited, dragU, dragV, Vec3(1, 1, 1), 20 * size); });
}

void BM_LiveTrajectoryEdit(benchmark::State& state) {
  runLive(state, [](Motion& edited, double size) {
    Curve& t = edited.trajectory;
    const sweep::BasisTable basis = sweep::tabulateBasis(t.degree, t.knots, {&dragV, 1});
    for (std::size_t b = 0; b < basis.value.size(); ++b) t.poles[basis.first[0] + b][0] += basis.value[b] * size;
  });
}

/// Another point changes all of the surface.
void BM_LiveWhole(benchmark::State& state) {
  runLive(state, [](Motion& edited, double size) { edited.point *= 1 + size; });
}

void BM_Curvature(benchmark::State& state) {
  Subject& s = subject();
  sweep::GridCurvature curvature;
  for (auto _ : state) {
    sweep::evaluateCurvature(s.motion, s.us, s.vs, curvature);
    benchmark::DoNotOptimize(curvature.gaussian.data());
  }
}

void BM_SmallestWeight(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(sweep::smallestProductWeight(subject().motion));
}

void BM_SmallestNormal(benchmark::State& state) {
  for (auto _ : state) benchmark::DoNotOptimize(sweep::examine(subject().motion));
}

BENCHMARK(BM_FactoredGrid)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_OcctD1)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_GeomAdaptorD1)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Product8x8)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_LiveScalingEdit)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_LiveOrientationEdit)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_LiveTrajectoryEdit)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_LiveWhole)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_Curvature)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SmallestWeight)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_SmallestNormal)->Unit(benchmark::kMillisecond);

}  // namespace

BENCHMARK_MAIN();
