#include <benchmark/benchmark.h>

#include "geometry/crossing/self_crossing.h"
#include "geometry/crossing/surface_crossing.h"
#include "modeling/kernel/solid/extrude.h"
#include "modeling/kernel/solid/loft.h"
#include "modeling/kernel/solid/pipe.h"
#include "modeling/kernel/solid/revolve.h"
#include "support/crossing_shapes.h"
#include "sweep/kernel/product_surface.h"

/// What it costs to look whether a shape crosses itself, for shapes that come near to it and do not: BM_Crossing.. is the
/// test alone, BM_Whole.. everything that makes the shape, the test included.
using namespace blossom;
using namespace blossom::test;

namespace {

Surface sweptCoil() { return sweep::productSurface(coil(10, 20, 0.1, 0.2, 9)).surface; }
TopoDS_Shape revolved() { return modeling::revolve(hookedProfile(10, 8, 1, -0.05), {{0, 0, 0}, {0, 0, 1}, 300}).shape; }
TopoDS_Shape lofted() {
  std::vector<TopoDS_Shape> sections;
  for (const TopoDS_Wire& wire : cup(15, 12, 20, -0.1)) sections.push_back(faceIn(wire));
  return modeling::loft(sections, {true, true}).shape;
}
TopoDS_Shape tapered() {
  modeling::ExtrudeOptions options;
  options.height = 10;
  options.taper = -10;
  return modeling::extrude(slotted(40, 10, 10, -0.05), options).shape;
}
TopoDS_Shape piped() { return modeling::pipe(faceIn(circleWire({0, 0, 0}, 2)), overpass(40, 2, -0.1), {}).shape; }

template <class Make>
void whole(benchmark::State& state, const Make& make) {
  for (auto _ : state) benchmark::DoNotOptimize(make());
}
template <class Make>
void solidCrossing(benchmark::State& state, const Make& make) {
  const TopoDS_Shape shape = make();
  for (auto _ : state) benchmark::DoNotOptimize(selfCrossing(shape, Progress::none()));
}

void BM_WholeSweep(benchmark::State& state) {
  whole(state, [] {
    const Surface surface = sweptCoil();
    return findCrossing(surface).triangles;
  });
}
void BM_CrossingSweep(benchmark::State& state) {
  const Surface surface = sweptCoil();
  for (auto _ : state) benchmark::DoNotOptimize(findCrossing(surface));
}
void BM_WholeRevolve(benchmark::State& state) { whole(state, revolved); }
void BM_CrossingRevolve(benchmark::State& state) {
  const TopoDS_Shape shape = revolved();
  for (auto _ : state) benchmark::DoNotOptimize(findCrossing(shape));
}
void BM_WholeLoft(benchmark::State& state) { whole(state, lofted); }
void BM_CrossingLoft(benchmark::State& state) { solidCrossing(state, lofted); }
void BM_WholeTaper(benchmark::State& state) { whole(state, tapered); }
void BM_CrossingTaper(benchmark::State& state) { solidCrossing(state, tapered); }
void BM_WholePipe(benchmark::State& state) { whole(state, piped); }
void BM_CrossingPipe(benchmark::State& state) { solidCrossing(state, piped); }

}  // namespace

BENCHMARK(BM_WholeSweep)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_CrossingSweep)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_WholeRevolve)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_CrossingRevolve)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_WholeLoft)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_CrossingLoft)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_WholeTaper)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_CrossingTaper)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_WholePipe)->Unit(benchmark::kMillisecond);
BENCHMARK(BM_CrossingPipe)->Unit(benchmark::kMillisecond);

BENCHMARK_MAIN();
