// Minkowski sums of named solids beside CGAL's `minkowski_sum_3` in the same run: milliseconds, how many times as fast, and
// whether the volumes agree; of sums that take a while, how many times as fast as with one thread. What is measured is the
// sum alone, with its checks and without the worker's start: the median of up to 9 runs. CGAL's runs once, in a process of
// its own, for 20 s at most. `solid_pairs FOLDER [NAME]`: the solids of a folder (README.md there tells
// how they were made), and the pairs whose names contain NAME.
#include <fmt/format.h>

#include <cmath>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include "core/memory.h"
#include "support/exchange.h"
#include "support/morphology.h"
#include "support/run_apart.h"
#include "support/solid_peer.h"
#include "support/timing.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::morphology;

namespace {

constexpr double patience = 20;  // s

struct Run {
  double seconds = 0, volume = 0;
};

struct Pair {
  std::string name;
  Mesh a, b;
};

std::vector<Pair> pairs(const std::filesystem::path& folder) {
  const auto solid = [&](const char* name) {
    return *readShape(formats(), folder / (std::string(name) + ".off")).shape.get<Mesh>();
  };
  std::vector<Pair> all;
  if (std::filesystem::exists(folder / "gear8.off"))
    for (const auto& [a, b] : std::vector<std::pair<const char*, const char*>>{{"gear8", "channel"},
                                                                               {"frame", "gear8"},
                                                                               {"comb6", "channel"},
                                                                               {"gear20", "gear8"},
                                                                               {"grate", "grate"},
                                                                               {"gear8", "ico80"},
                                                                               {"torus256", "ico80"},
                                                                               {"torus256", "torus96"},
                                                                               {"torus1024", "ico320"},
                                                                               {"bumpy320", "ico80"},
                                                                               {"bumpy1280", "ico80"},
                                                                               {"gear8", "bumpy320"},
                                                                               {"gear20", "bumpy320"},
                                                                               {"bumpy1280", "bumpy320"}})
      all.push_back({fmt::format("{} + {}", a, b), solid(a), solid(b)});
  all.push_back({"ball:5:4 + ball:2:4", ballOf(5, 4), ballOf(2, 4)});
  all.push_back({"ball:5:2 + ball:2:2", ballOf(5, 2), ballOf(2, 2)});
  all.push_back({"box + ball:2:3", cuboid({0, 0, 0}, {3, 4, 5}), ballOf(2, 3)});
  return all;
}

Run ours(const Pair& pair) {
  Run run;
  run.seconds = medianSeconds([&] { run.volume = volumeOf(solidSumOf(pair.a, pair.b)); });
  return run;
}

std::optional<Run> peers(const Pair& pair) {
  const Mesh a = triangulated(pair.a).first, b = triangulated(pair.b).first;
  const auto sum = [&] {
    Run run;
    run.seconds = secondsOf([&] { run.volume = volumeOf(sumByNef(a, b)); });
    return run;
  };
  return runApart(sum, patience);
}

std::string milliseconds(const std::optional<Run>& run) {
  return run ? fmt::format("{:10.1f} ms", 1e3 * run->seconds) : fmt::format("over {:.0f} s", patience);
}

void compare(const Pair& pair) {
  const Run run = ours(pair);
  const auto cgal = peers(pair);
  fmt::print("  {:<24}{}   CGAL {}   {:8.1f} times", pair.name, milliseconds(run), milliseconds(cgal),
             (cgal ? cgal->seconds : patience) / run.seconds);
  constexpr double aWhile = 0.1;  // s
  if (run.seconds > aWhile / 2) {
    const double times = timesOneThread([&] { solidSumOf(pair.a, pair.b); });
    if (times * run.seconds > aWhile) fmt::print("   {:.2f} times one thread", times);
  }
  if (cgal && std::abs(run.volume - cgal->volume) > 1e-9 * cgal->volume)
    fmt::print("   VOLUME {:.12g}, CGAL has {:.12g}", run.volume, cgal->volume);
  fmt::print("\n");
  std::fflush(stdout);
}

}  // namespace

int main(int argc, char** argv) {
  keepFreedMemory();  // as the programs do
  const std::filesystem::path folder = argc > 1 ? argv[1] : "";
  const std::string asked = argc > 2 ? argv[2] : "";
  for (const Pair& pair : pairs(folder)) {
    if (pair.name.find(asked) == std::string::npos) continue;
    compare(pair);
  }
}
