#include "kernel/medial/medial_chains.h"

#include <algorithm>
#include <numeric>
#include <utility>

namespace blossom::pocket {

namespace {

void thinBetween(const std::vector<Vec3>& points, std::size_t from, std::size_t to, double tolerance,
                 std::vector<bool>& keep) {
  double worst = tolerance;
  std::size_t where = from;
  const Vec3 along = points[to] - points[from];
  for (std::size_t i = from + 1; i < to; ++i) {
    const double share =
        along.squaredNorm() > 0 ? std::clamp((points[i] - points[from]).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
    const double away = (points[from] + share * along - points[i]).norm();
    if (away > worst) {
      worst = away;
      where = i;
    }
  }
  if (where == from) return;
  keep[where] = true;
  thinBetween(points, from, where, tolerance, keep);
  thinBetween(points, where, to, tolerance, keep);
}

void reverse(Chain& chain) {
  std::swap(chain.from, chain.to);
  std::reverse(chain.points.begin(), chain.points.end());
  std::reverse(chain.touched.begin(), chain.touched.end());
  for (Touched& touched : chain.touched) std::swap(touched.left, touched.right);
}

double lengthOf(const Chain& chain) {
  double length = 0;
  for (std::size_t i = 1; i < chain.points.size(); ++i) length += (chain.points[i] - chain.points[i - 1]).head<2>().norm();
  return length;
}

class Joining {
 public:
  Joining(std::vector<MedialVertex>& vertices, std::vector<Chain>& chains)
      : vertices_(vertices), chains_(chains), same_(vertices.size()) {
    std::iota(same_.begin(), same_.end(), std::size_t(0));
  }

  void uniteVertices(double apart) {
    std::vector<Chain> longOnes;
    for (Chain& chain : chains_) {
      const bool corner = vertices_[chain.from].clearance == 0 || vertices_[chain.to].clearance == 0;
      if (!corner && chain.from != chain.to && lengthOf(chain) < apart)
        same_[root(chain.from)] = root(chain.to);
      else
        longOnes.push_back(std::move(chain));
    }
    chains_ = std::move(longOnes);
    for (Chain& chain : chains_) {
      chain.from = root(chain.from);
      chain.to = root(chain.to);
      chain.points.front() = pointOf(chain.from);
      chain.points.back() = pointOf(chain.to);
    }
    used_.assign(same_.size(), false);
    for (std::size_t i = 0; i < same_.size(); ++i) used_[root(i)] = true;
  }

  /// Such as the straight piece up to a leaf and the chain that it was added to.
  void uniteChains() {
    std::vector<std::vector<std::size_t>> at(vertices_.size());
    for (std::size_t e = 0; e < chains_.size(); ++e) {
      at[chains_[e].from].push_back(e);
      at[chains_[e].to].push_back(e);
    }
    std::vector<bool> gone(chains_.size(), false);
    for (std::size_t v = 0; v < at.size(); ++v) {
      if (at[v].size() != 2 || at[v][0] == at[v][1]) continue;
      Chain& keep = chains_[at[v][0]];
      Chain& drop = chains_[at[v][1]];
      const std::size_t far = drop.from == v ? drop.to : drop.from;
      if (keep.from == keep.to || far == v || keep.from == far || keep.to == far) continue;
      if (drop.from != v) reverse(drop);
      if (keep.to != v) reverse(keep);
      keep.points.insert(keep.points.end(), drop.points.begin() + 1, drop.points.end());
      keep.touched.insert(keep.touched.end(), drop.touched.begin() + 1, drop.touched.end());
      keep.to = far;
      std::replace(at[far].begin(), at[far].end(), at[v][1], at[v][0]);
      gone[at[v][1]] = true;
      used_[v] = false;
    }
    std::vector<Chain> left;
    for (std::size_t e = 0; e < chains_.size(); ++e)
      if (!gone[e]) left.push_back(std::move(chains_[e]));
    chains_ = std::move(left);
  }

  void renumber() {
    std::vector<std::size_t> number(used_.size(), 0);
    std::vector<MedialVertex> vertices;
    for (std::size_t i = 0; i < used_.size(); ++i) {
      if (!used_[i]) continue;
      number[i] = vertices.size();
      vertices.push_back(vertices_[i]);
    }
    vertices_ = std::move(vertices);
    for (Chain& chain : chains_) {
      chain.from = number[chain.from];
      chain.to = number[chain.to];
    }
  }

 private:
  std::size_t root(std::size_t i) {
    while (same_[i] != i) i = same_[i] = same_[same_[i]];
    return i;
  }
  [[nodiscard]] Vec3 pointOf(std::size_t vertex) const {
    const MedialVertex& v = vertices_[vertex];
    return {v.at.x(), v.at.y(), v.clearance};
  }

  std::vector<MedialVertex>& vertices_;
  std::vector<Chain>& chains_;
  std::vector<std::size_t> same_;
  std::vector<bool> used_;
};

}  // namespace

void thin(Chain& chain, double tolerance) {
  std::vector<bool> keep(chain.points.size(), false);
  keep.front() = keep.back() = true;
  // A closed chain has no chord: keep its middle first.
  const std::size_t middle = chain.points.size() / 2;
  keep[middle] = true;
  thinBetween(chain.points, 0, middle, tolerance, keep);
  thinBetween(chain.points, middle, chain.points.size() - 1, tolerance, keep);
  Chain thinned{chain.from, chain.to, {}, {}};
  for (std::size_t i = 0; i < chain.points.size(); ++i) {
    if (!keep[i]) continue;
    thinned.points.push_back(chain.points[i]);
    thinned.touched.push_back(chain.touched[i]);
  }
  chain = std::move(thinned);
}

void joinNeighbours(std::vector<MedialVertex>& vertices, std::vector<Chain>& chains, double apart) {
  Joining joining(vertices, chains);
  joining.uniteVertices(apart);
  joining.uniteChains();
  joining.renumber();
}

}  // namespace blossom::pocket
