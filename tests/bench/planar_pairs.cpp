// Minkowski sums of named pairs beside CGAL's reduced convolution in the same run: milliseconds, how many times as fast, and
// the geometric mean of these with each counted as 100 at most. Ours is the median of several runs, everything included;
// CGAL runs once, for two minutes at most. `planar_pairs NAME` runs the pairs whose names contain NAME.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/memory.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/polygon_sum.h"
#include "support/planar_peer.h"
#include "support/random.h"
#include "support/run_apart.h"
#include "support/timing.h"

using namespace blossom;
using namespace blossom::test;
using planar::Loop, planar::Polygons;
using std::numbers::pi;

namespace {

struct Pair {
  const char* name;
  Polygons a, b;
};

Vec2 polar(double radius, double angle) { return radius * Vec2(std::cos(angle), std::sin(angle)); }

Polygons star(int spikes, double outer, double inner, double turn = 0) {
  Loop loop;
  for (int i = 0; i < 2 * spikes; ++i) loop.push_back(polar(i % 2 == 0 ? outer : inner, turn + pi * i / spikes));
  return {{loop, {}}};
}

Polygons regular(int corners, double radius) {
  Loop loop;
  for (int i = 0; i < corners; ++i) loop.push_back(polar(radius, 2 * pi * i / corners));
  return {{loop, {}}};
}

/// Smooth: a few waves around a circle.
Polygons blob(int corners, double radius, int waves, double depth) {
  Loop loop;
  for (int i = 0; i < corners; ++i) {
    const double angle = 2 * pi * i / corners;
    loop.push_back(
        polar(radius * (1 + depth * std::sin(waves * angle) + depth / 2 * std::cos((2 * waves + 1) * angle)), angle));
  }
  return {{loop, {}}};
}

Polygons jagged(Random& random, int corners) {
  Loop loop;
  for (int i = 0; i < corners; ++i) loop.push_back(polar(10 * uniform(random, 0.5, 1), 2 * pi * i / corners));
  return {{loop, {}}};
}

/// Teeth upwards on a bar.
Polygons comb(int teeth, double width, double height) {
  Loop loop{{0, -1}, {2 * width * teeth - width, -1}};
  for (int i = teeth - 1; i >= 0; --i) {
    const double x = 2 * width * i;
    loop.insert(loop.end(), {{x + width, height}, {x, height}});
    if (i > 0) loop.insert(loop.end(), {{x, 0}, {x - width, 0}});
  }
  return {{loop, {}}};
}

/// A band along an Archimedean spiral.
Polygons spiral(int corners, double turns, double pitch, double width) {
  Loop out, in;
  for (int i = 0; i <= corners; ++i) {
    const double angle = 2 * pi * turns * i / corners, radius = pitch * (0.5 + angle / (2 * pi));
    out.push_back(polar(radius + width / 2, angle));
    in.push_back(polar(radius - width / 2, angle));
  }
  out.insert(out.end(), in.rbegin(), in.rend());
  return {{out, {}}};
}

/// Prongs on a bar, upright or level: the sum of an upright and a level one is a grid of holes.
Polygons forkOf(int prongs, double length, bool level) {
  constexpr double thin = 0.2, step = 1;
  Loop loop{{0, -thin}, {step * (prongs - 1) + thin, -thin}};
  for (int i = prongs - 1; i >= 0; --i) {
    const double x = step * i;
    loop.insert(loop.end(), {{x + thin, length}, {x, length}});
    if (i > 0) loop.insert(loop.end(), {{x, 0}, {x - step + thin, 0}});
  }
  if (level) {
    for (Vec2& p : loop) p = Vec2(p.y(), p.x());
    std::reverse(loop.begin(), loop.end());
  }
  return {{loop, {}}};
}

std::vector<Pair> pairs() {
  Random random(5);
  return {{"blobs 400", blob(400, 10, 5, 0.2), blob(400, 6, 7, 0.15)},
          {"blobs 1000", blob(1000, 10, 5, 0.2), blob(1000, 6, 7, 0.15)},
          {"stars 20", star(20, 10, 4), star(20, 8, 3, 0.1)},
          {"stars 50 deep", star(50, 10, 1), star(50, 8, 1, 0.01)},
          {"stars 100 deep", star(100, 10, 1), star(100, 8, 1, 0.01)},
          {"combs", comb(20, 1, 10), comb(12, 1.3, 8)},
          {"spirals", spiral(200, 3, 2, 0.5), spiral(150, 2, 2, 0.4)},
          {"spiral and disc", spiral(300, 4, 2, 0.5), regular(64, 0.4)},
          {"jagged 60", jagged(random, 60), jagged(random, 60)},
          {"jagged 200", jagged(random, 200), jagged(random, 200)},
          {"star 500 and disc", star(500, 10, 8), regular(60, 1)},
          {"forks with 600 holes", forkOf(34, 31, false), forkOf(31, 34, true)},
          {"convex 500 and 700", regular(500, 10), regular(700, 7)},
          {"star 5 and 12-gon", star(5, 10, 4), regular(12, 1)}};
}

struct PeerRun {
  double seconds = 0, area = 0;
};
constexpr double patience = 120;  // s

PeerRun peerRun(const Pair& pair) {
  const std::function<double()> sum = reducedConvolution(toRegion(pair.a), toRegion(pair.b));
  PeerRun run;
  run.seconds = secondsOf([&] { run.area = sum(); });
  return run;
}

}  // namespace

int main(int argc, char** argv) {
  blossom::keepFreedMemory();  // as the programs do
  const std::string_view asked = argc > 1 ? argv[1] : "";
  double logarithms = 0, least = 1e300;
  int count = 0;
  for (const Pair& pair : pairs()) {
    if (std::string_view(pair.name).find(asked) == std::string_view::npos) continue;
    double area = 0;
    const double seconds = medianSeconds([&] { area = planar::area(planar::sum(pair.a, pair.b)); });
    const std::optional<PeerRun> peer = runApart([&] { return peerRun(pair); }, patience);
    const double times = (peer ? peer->seconds : patience) / seconds;
    fmt::print("  {:<24}{:12.3f} ms   CGAL {}{:12.1f} ms   {:8.1f} times", pair.name, 1e3 * seconds,
               peer ? "     " : "over ", 1e3 * (peer ? peer->seconds : patience), times);
    if (seconds > 0.05)
      fmt::print("   {:.2f} times one thread", timesOneThread([&] { area = planar::area(planar::sum(pair.a, pair.b)); }));
    if (peer && std::abs(area - peer->area) > 1e-9 * peer->area)
      fmt::print("   AREA {:.12g}, CGAL has {:.12g}", area, peer->area);
    fmt::print("\n");
    logarithms += std::log(std::min(times, 100.0));
    least = std::min(least, times);
    ++count;
  }
  if (count > 0)
    fmt::print("  planar sums, geometric mean {:.1f} times, least {:.1f} times\n", std::exp(logarithms / count), least);
}
