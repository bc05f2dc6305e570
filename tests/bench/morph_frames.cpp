// In-betweens of morphs, everything included: milliseconds a frame, and whole sequences. `morph_frames NAME` runs the morphs
// whose names contain NAME. Outlines that other people drew take part when ../shared/data is there.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <numbers>
#include <string_view>

#include "core/memory.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/polygons/polygons.h"
#include "geometry/planar/polygons/sound_region.h"
#include "minkowski/kernel/morph/morph.h"
#include "support/exchange.h"
#include "support/timing.h"

using namespace blossom;
using namespace blossom::test;
using std::numbers::pi;

namespace {

struct Case {
  const char* name;
  std::vector<Region> shapes;
  int frames = 0;
};

Vec2 polar(double radius, double angle) { return radius * Vec2(std::cos(angle), std::sin(angle)); }

Region star(int spikes, double outer, double inner, double turn = 0) {
  planar::Loop loop;
  for (int i = 0; i < 2 * spikes; ++i) loop.push_back(polar(i % 2 == 0 ? outer : inner, turn + pi * i / spikes));
  return planar::toRegion({{loop, {}}});
}

Region regular(int corners, double radius) {
  planar::Loop loop;
  for (int i = 0; i < corners; ++i) loop.push_back(polar(radius, 2 * pi * i / corners));
  return planar::toRegion({{loop, {}}});
}

Region disc(double radius) { return {{Path{{Arc2{Vec2::Zero(), radius, 0, 2 * pi}}, true, {}, {}}}}; }

Region drawing(const char* name) { return toRegion(*readShape(formats(), sharedData() / "svg" / name).shape.get<Curves>()); }

/// Of the pieces that may bound in-betweens, the second morph has 34,464 crossings at t = 0.5, counted in pairs.
std::vector<Case> cases() {
  std::vector<Case> all{{"figure 7, rounded", {regular(3, 20), regular(5, 18), disc(18), star(5, 24, 9)}, 101},
                        {"30,000 crossings", {star(32, 10, 4), star(32, 8, 3, 0.05)}, 51},
                        {"stars of 60 spikes", {star(60, 10, 5), star(60, 8, 4, 0.02)}, 21}};
  if (std::filesystem::exists(sharedData()))
    for (const auto& [name, from, to] : {std::tuple("flower to butterfly", "flower.svg", "butterfly.svg"),
                                         {"snowflake to cat", "snowflake.svg", "cat.svg"},
                                         {"jellyfish to owl", "jellyfish.svg", "owl.svg"}})
      all.push_back({name, {drawing(from), drawing(to)}, 200});
  return all;
}

}  // namespace

int main(int argc, char** argv) {
  blossom::keepFreedMemory();  // as the programs do
  const std::string_view asked = argc > 1 ? argv[1] : "";
  for (const Case& each : cases()) {
    if (std::string_view(each.name).find(asked) == std::string_view::npos) continue;
    std::vector<std::vector<double>> times;
    for (int k = 0; k < each.frames; ++k)
      times.push_back(minkowski::diagonal(each.shapes.size() - 1, static_cast<double>(k) / (each.frames - 1)));
    minkowski::MorphResult result;
    const double seconds = secondsOf([&] { result = minkowski::morph(each.shapes, times); });
    std::size_t segments = 0;
    for (const Region& region : result.regions)
      for (const Path& loop : region.loops) segments += loop.segments.size();
    fmt::print("  {:<28}{:4} frames {:9.1f} ms, {:7.3f} ms a frame of {} segments\n", each.name, each.frames, 1e3 * seconds,
               1e3 * seconds / each.frames, segments / result.regions.size());
  }
}
