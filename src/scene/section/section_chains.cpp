#include "scene/section/section_chains.h"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <map>
#include <utility>

namespace blossom {

namespace {

constexpr std::size_t mostToJoin = 1000;

/// Takes each side once.
class Walk {
 public:
  Walk(const std::vector<SectionSide>& sides, std::size_t places) : sides_(sides), first_(places + 1), surplus_(places) {
    for (const SectionSide& side : sides) {
      ++first_[static_cast<std::size_t>(side.from) + 1];
      ++surplus_[static_cast<std::size_t>(side.from)];
      --surplus_[static_cast<std::size_t>(side.to)];
    }
    for (std::size_t i = 0; i < places; ++i) first_[i + 1] += first_[i];
    next_.assign(first_.begin(), first_.end() - 1);
    order_.resize(sides.size());
    std::vector<std::size_t> end = next_;
    for (std::size_t s = 0; s < sides.size(); ++s) order_[end[static_cast<std::size_t>(sides[s].from)]++] = s;
  }

  /// Chains that begin where more sides leave than arrive; what is left after them is closed.
  std::vector<SectionLoop> openChains() {
    std::vector<SectionLoop> chains;
    for (std::size_t place = 0; place < surplus_.size(); ++place)
      for (int i = 0; i < surplus_[place]; ++i) chains.push_back(from(static_cast<int>(place)));
    return chains;
  }

  std::vector<SectionLoop> loops() {
    std::vector<SectionLoop> loops;
    for (std::size_t place = 0; place < surplus_.size(); ++place)
      while (leaves(place)) {
        loops.push_back(from(static_cast<int>(place)));
        loops.back().pop_back();  // its first place again
      }
    return loops;
  }

 private:
  [[nodiscard]] bool leaves(std::size_t place) const { return next_[place] < first_[place + 1]; }

  SectionLoop from(int place) {
    SectionLoop chain{place};
    while (leaves(static_cast<std::size_t>(place))) {
      place = sides_[order_[next_[static_cast<std::size_t>(place)]++]].to;
      chain.push_back(place);
    }
    return chain;
  }

  const std::vector<SectionSide>& sides_;
  std::vector<std::size_t> first_, next_, order_;  // of the sides that leave each place
  std::vector<int> surplus_;                       // sides that leave less those that arrive
};

std::size_t nearestBeginning(const std::vector<SectionLoop>& chains, const Vec3& end, const std::vector<Vec3>& places) {
  const auto distance = [&](const SectionLoop& chain) {
    return (places[static_cast<std::size_t>(chain.front())] - end).squaredNorm();
  };
  const auto nearest = std::min_element(
      chains.begin(), chains.end(), [&](const SectionLoop& a, const SectionLoop& b) { return distance(a) < distance(b); });
  return static_cast<std::size_t>(nearest - chains.begin());
}

/// The last chain goes on until the nearest beginning is its own.
std::vector<SectionLoop> joined(std::vector<SectionLoop> chains, const std::vector<Vec3>& places) {
  std::vector<SectionLoop> loops;
  while (!chains.empty()) {
    const Vec3& end = places[static_cast<std::size_t>(chains.back().back())];
    const std::size_t next = chains.size() > mostToJoin ? chains.size() - 1 : nearestBeginning(chains, end, places);
    if (next + 1 == chains.size()) {
      loops.push_back(std::move(chains.back()));
      chains.pop_back();
      continue;
    }
    const SectionLoop follower = std::move(chains[next]);
    chains.erase(chains.begin() + static_cast<std::ptrdiff_t>(next));
    chains.back().insert(chains.back().end(), follower.begin(), follower.end());
  }
  return loops;
}

}  // namespace

void cancelOpposite(std::vector<SectionSide>& sides) {
  std::map<std::pair<int, int>, int> surplus;  // of sides from the lower place to the higher one
  for (const SectionSide& side : sides) surplus[std::minmax(side.from, side.to)] += side.from < side.to ? 1 : -1;
  sides.clear();
  for (const auto& [ends, count] : surplus)
    for (int k = 0; k < std::abs(count); ++k)
      sides.push_back(count > 0 ? SectionSide{ends.first, ends.second} : SectionSide{ends.second, ends.first});
}

std::vector<SectionLoop> chained(const std::vector<SectionSide>& sides, const std::vector<Vec3>& places) {
  Walk walk(sides, places.size());
  std::vector<SectionLoop> loops = joined(walk.openChains(), places);
  for (SectionLoop& loop : walk.loops()) loops.push_back(std::move(loop));
  std::erase_if(loops, [](const SectionLoop& loop) { return loop.size() < 3; });
  return loops;
}

}  // namespace blossom
