#include "geometry/planar/winding/left_out_edges.h"

#include <algorithm>
#include <cstdlib>
#include <iterator>
#include <numeric>

#include "core/error.h"
#include "core/parallel_sort.h"

namespace blossom::planar {

LeftOutEdges::LeftOutEdges(const CertainInside& inside)
    : inside_(inside), heights_(static_cast<std::size_t>(inside.cells().rows()) + 1, 0) {}

bool LeftOutEdges::take(const CountedEdge& edge) {
  if (!inside_.contains(edge.from, edge.to)) return false;
  any_ = true;
  countHeights(edge);
  addEnd(edge.from, edge.count);
  addEnd(edge.to, -edge.count);
  return true;
}

void LeftOutEdges::add(LeftOutEdges&& others) {
  any_ = any_ || others.any_;
  for (std::size_t i = 0; i < heights_.size(); ++i) heights_[i] += others.heights_[i];
  ends_.insert(ends_.end(), others.ends_.begin(), others.ends_.end());
  joinIfMany();
}

void LeftOutEdges::countHeights(const CountedEdge& edge) {
  const auto [low, high] = std::minmax(edge.from.y, edge.to.y);
  heights_[static_cast<std::size_t>(inside_.rowOf(low))] += std::abs(edge.count);
  heights_[static_cast<std::size_t>(inside_.rowOf(high)) + 1] -= std::abs(edge.count);
}

void LeftOutEdges::addEnd(const GridPoint& at, int count) {
  if (inside_.isDeep(at)) return;                    // all edges there are left out, and as many begin as end
  if (!ends_.empty() && ends_.back().first == at) {  // where one edge of a chain ends and the next one begins
    ends_.back().second += count;
    if (ends_.back().second == 0) ends_.pop_back();
    return;
  }
  ends_.emplace_back(at, count);
  joinIfMany();
}

void LeftOutEdges::joinIfMany() {
  if (ends_.size() < full_) return;
  joinEnds();
  constexpr std::size_t most = 20'000'000;
  if (ends_.size() > most)
    throw Error(ErrorCode::LimitExceeded, "The sum of these shapes has more than twenty million edges near its boundary.",
                "Raise the tolerance, so that curves get fewer corners.");
  full_ = std::max(full_, 2 * ends_.size());
}

void LeftOutEdges::joinEnds() {
  sortInQuarters(
      ends_, [](const End& a, const End& b) { return a.first < b.first; }, Progress::none());
  std::size_t kept = 0;
  for (std::size_t i = 0; i < ends_.size();) {
    auto sum = ends_[i];
    for (++i; i < ends_.size() && ends_[i].first == sum.first; ++i) sum.second += ends_[i].second;
    if (sum.second != 0) ends_[kept++] = sum;
  }
  ends_.resize(kept);
}

/// From end to end towards the door, from both sides: short edges instead of a long one for each. All ends lie in one run.
/// Where very many ends have one sign, what flows along would add up to more than is left out: each goes its own way there.
void LeftOutEdges::addAlong(std::vector<End>& ends, const GridPoint& door, std::vector<CountedEdge>& edges) {
  const auto isBefore = [](const End& a, const End& b) { return a.first < b.first; };
  std::sort(ends.begin(), ends.end(), isBefore);
  const auto middle = std::lower_bound(ends.begin(), ends.end(), End{door, 0}, isBefore);
  std::vector<CountedEdge> chain;
  std::int64_t flowing = 0;
  const auto addChain = [&](auto from, auto to) {
    int flow = 0;
    for (; from != to; ++from) {
      flow += from->second;
      flowing += std::abs(flow);
      chain.push_back({from->first, std::next(from) == to ? door : std::next(from)->first, flow, 0});
    }
  };
  addChain(ends.begin(), middle);
  addChain(ends.rbegin(), std::make_reverse_iterator(middle));
  constexpr std::int64_t veryMuch = 1 << 16;
  if (flowing > veryMuch) {
    chain.clear();
    for (const auto& [at, count] : ends) chain.push_back({at, door, count, 0});
  }
  for (const CountedEdge& edge : chain) addPath(edge, edges);
}

void LeftOutEdges::addPath(const CountedEdge& edge, std::vector<CountedEdge>& edges) {
  if (edge.count == 0 || edge.from == edge.to) return;
  edges.push_back(edge);
  countHeights(edge);
}

// Along each run to the door to the next one, and so on to the first run of the part.
std::vector<CountedEdge> LeftOutEdges::paths() {
  joinEnds();
  const auto runs = inside_.runs();
  std::vector<std::vector<End>> endsOf(runs.size());
  for (const End& end : ends_) endsOf[inside_.runAt(end.first)].push_back(end);
  std::vector<CountedEdge> edges;
  for (std::size_t i = runs.size(); i-- > 0;) {
    const GridPoint door = inside_.middle(runs[i].door, runs[i].row);
    addAlong(endsOf[i], door, edges);
    const int flow =
        std::accumulate(endsOf[i].begin(), endsOf[i].end(), 0, [](int sum, const End& e) { return sum + e.second; });
    if (flow == 0 || runs[i].parent < 0) continue;  // all that begins in a part ends in it
    const auto parent = static_cast<std::size_t>(runs[i].parent);
    const GridPoint beside = inside_.middle(runs[i].door, runs[parent].row);
    addPath({door, beside, flow, 0}, edges);
    endsOf[parent].emplace_back(beside, flow);
  }
  return edges;
}

// A level ray meets no more edges than pass its height, and each changes the winding number by one.
int LeftOutEdges::largestChange() const {
  std::int64_t passing = 0, most = 0;
  for (const std::int64_t more : heights_) most = std::max(most, passing += more);
  constexpr std::int64_t limit = std::int64_t{1}
                                 << 29;  // a winding number is that of the loops and what changes beside them
  if (most > limit)
    throw Error(ErrorCode::LimitExceeded, "The sum of these shapes has too many edges at one height.",
                "Raise the tolerance, so that curves get fewer corners.");
  return static_cast<int>(most);
}

// Left and right ends of runs, as far as they lie above one another.
void LeftOutEdges::addUpright(int times, std::vector<CountedEdge>& edges) const {
  const BitRaster& cells = inside_.cells();
  const std::vector<BitRun> runs = runsOf(cells);
  constexpr int none = -1;
  const auto addEnds = [&](int BitRun::*end, bool up) {
    std::vector<int> since(static_cast<std::size_t>(cells.columns()) + 1, none);  // the row where a border begins
    std::vector<int> open, now;
    std::size_t next = 0;
    for (int row = 0; row <= cells.rows(); ++row) {
      now.clear();
      for (; next < runs.size() && runs[next].row == row; ++next) now.push_back(runs[next].*end);
      for (const int column : open) {
        if (std::binary_search(now.begin(), now.end(), column)) continue;
        int& begin = since[static_cast<std::size_t>(column)];
        const GridPoint low = inside_.corner(column, begin), high = inside_.corner(column, row);
        edges.push_back({up ? low : high, up ? high : low, times, 0});
        begin = none;
      }
      for (const int column : now)
        if (int& begin = since[static_cast<std::size_t>(column)]; begin == none) begin = row;
      std::swap(open, now);
    }
  };
  addEnds(&BitRun::first, false);
  addEnds(&BitRun::last, true);
}

void LeftOutEdges::addLoops(int times, std::vector<CountedEdge>& edges) const {
  addUpright(times, edges);
  const BitRaster& cells = inside_.cells();
  const auto addBorders = [&](int row, int beside, int way) {
    BitRaster only(cells.columns(), 1);
    for (int w = 0; w < cells.words(); ++w)
      only.row(0)[w] = cells.row(row)[w] & ~(beside >= 0 && beside < cells.rows() ? cells.row(beside)[w] : 0);
    for (const BitRun& run : runsOf(only)) {
      const int border = std::max(row, beside);
      edges.push_back({inside_.corner(run.first, border), inside_.corner(run.last, border), way * times, 0});
    }
  };
  for (int row = 0; row < cells.rows(); ++row) {
    addBorders(row, row - 1, 1);
    addBorders(row, row + 1, -1);
  }
}

std::vector<CountedEdge> LeftOutEdges::closings() {
  if (!any_) return {};
  std::vector<CountedEdge> edges = paths();
  addLoops(largestChange() + 1, edges);
  return edges;
}

}  // namespace blossom::planar
