#include "kernel/preview/field_sum.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <utility>

#include "core/parallel.h"
#include "geometry/mesh/mesh_topology.h"
#include "kernel/preview/distance_grid.h"
#include "kernel/preview/surface_net.h"

namespace blossom::morphology {

namespace {

std::vector<Triangle3> trianglesOf(const PreviewTerm& term) {
  std::vector<Triangle3> all;
  for (std::size_t f = 0; f < term.triangles.faceCount(); ++f) {
    const auto points = facePoints(term.triangles, f);
    all.push_back({term.factor * points[0], term.factor * points[1], term.factor * points[2]});
  }
  return all;
}

/// Points of a triangle, no two neighbours farther apart than a step. Segments and points are flat triangles.
void addSamples(const Triangle3& t, double step, std::vector<Vec3>& samples) {
  const double longest = std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
  constexpr double mostParts = 1000;
  const int parts = static_cast<int>(std::clamp(std::ceil(longest / step), 1.0, mostParts));
  for (int i = 0; i <= parts; ++i)
    for (int j = 0; i + j <= parts; ++j)
      samples.push_back(t[0] + i / static_cast<double>(parts) * (t[1] - t[0]) +
                        j / static_cast<double>(parts) * (t[2] - t[0]));
}

/// One sample in each cell of a grid, which may lose the outermost ones.
std::vector<Vec3> thinnedOut(std::vector<Vec3> samples, double step) {
  const auto cell = [&](const Vec3& p) {
    return std::array{std::floor(p.x() / step), std::floor(p.y() / step), std::floor(p.z() / step)};
  };
  std::stable_sort(samples.begin(), samples.end(), [&](const Vec3& p, const Vec3& q) { return cell(p) < cell(q); });
  samples.erase(
      std::unique(samples.begin(), samples.end(), [&](const Vec3& p, const Vec3& q) { return cell(p) == cell(q); }),
      samples.end());
  return samples;
}

std::vector<Vec3> samplesOf(const PreviewTerm& term, double step) {
  std::vector<Vec3> samples;
  for (const Triangle3& t : trianglesOf(term)) addSamples(t, step, samples);
  for (const auto& piece : term.pieces) {
    const auto corner = [&](std::size_t k) { return Vec3(term.factor * piece[std::min(k, piece.size() - 1)]); };
    addSamples({corner(0), corner(1), corner(2)}, step, samples);
  }
  constexpr std::size_t manySamples = 60'000;
  const double apart = samples.size() > manySamples ? step / 2 : 1e-6 * step;  // else only those that are the same
  return thinnedOut(std::move(samples), apart);
}

/// Samples in balls within balls.
class SampleTree {
 public:
  explicit SampleTree(std::vector<Vec3> samples) : samples_(std::move(samples)) {
    if (!samples_.empty()) build(0, samples_.size());
  }

  /// The smallest value of a field at x - b over the samples b, as far as it lies between -enough and `most`.
  /// @pre the field changes no faster than places
  template <class Field>
  [[nodiscard]] double least(const Field& field, const Vec3& x, double most, double enough) const {
    double best = most;
    if (!nodes_.empty()) search(0, field, x, field(x - nodes_[0].middle), best, enough);
    return best;
  }

 private:
  struct Node {
    Vec3 middle = Vec3::Zero();
    double radius = 0;
    std::size_t first = 0, last = 0;
    int low = -1, high = -1;  ///< children
  };
  static constexpr std::size_t fewSamples = 6;

  int build(std::size_t first, std::size_t last) {
    const int number = static_cast<int>(nodes_.size());
    Node node{Vec3::Zero(), 0, first, last};
    Bounds box;
    for (std::size_t k = first; k < last; ++k) box.add(samples_[k]);
    node.middle = box.center();
    for (std::size_t k = first; k < last; ++k) node.radius = std::max(node.radius, (samples_[k] - node.middle).norm());
    nodes_.push_back(node);
    if (last - first <= fewSamples) return number;
    Eigen::Index axis = 0;
    (box.high - box.low).maxCoeff(&axis);
    const std::size_t half = (first + last) / 2;
    const auto at = [&](std::size_t k) { return samples_.begin() + static_cast<std::ptrdiff_t>(k); };
    std::nth_element(at(first), at(half), at(last), [&](const Vec3& p, const Vec3& q) { return p[axis] < q[axis]; });
    const int low = build(first, half), high = build(half, last);
    nodes_[static_cast<std::size_t>(number)].low = low;
    nodes_[static_cast<std::size_t>(number)].high = high;
    return number;
  }

  /// @param value of the field at the middle of the ball
  template <class Field>
  void search(int number, const Field& field, const Vec3& x, double value, double& best, double enough) const {
    const Node& node = nodes_[static_cast<std::size_t>(number)];
    if (best < -enough || value - node.radius >= best) return;
    if (node.low < 0) {
      for (std::size_t k = node.first; k < node.last; ++k) best = std::min(best, field(x - samples_[k]));
      return;
    }
    const auto valueAt = [&](int child) { return field(x - nodes_[static_cast<std::size_t>(child)].middle); };
    std::array<std::pair<double, int>, 2> order{std::pair{valueAt(node.low), node.low}, {valueAt(node.high), node.high}};
    if (order[1].first < order[0].first) std::swap(order[0], order[1]);
    for (const auto& [there, child] : order) search(child, field, x, there, best, enough);
  }

  std::vector<Vec3> samples_;
  std::vector<Node> nodes_;
};

/// A corner of each body.
std::vector<Vec3> bodiesOf(const PreviewTerm& term) {
  const MeshTopology topology = meshTopology(term.triangles);
  std::vector<Vec3> corners(topology.components.size());
  for (std::size_t f = 0; f < term.triangles.faceCount(); ++f)
    corners[static_cast<std::size_t>(topology.componentOfFace[f])] =
        term.factor * term.triangles.points[static_cast<std::size_t>(term.triangles.face(f)[0])];
  return corners;
}

Bounds boundsOf(const PreviewTerm& term) {
  Bounds box;
  for (const Vec3& p : term.triangles.points) box.add(term.factor * p);
  for (const auto& piece : term.pieces)
    for (const Vec3& p : piece) box.add(term.factor * p);
  return box;
}

GridValues gridAround(const Bounds& a, const Bounds& b, int cells) {
  GridValues grid;
  const Vec3 low = a.low + b.low, high = a.high + b.high;
  grid.step = std::max((high - low).maxCoeff() / cells, 1e-9);
  constexpr double besides = 1.5;  // cells around the sum
  grid.low = low - besides * grid.step * Vec3::Ones();
  std::size_t places = 1;
  for (std::size_t k = 0; k < 3; ++k) {
    const auto axis = static_cast<Eigen::Index>(k);
    grid.count[k] = static_cast<int>(std::ceil((high[axis] - low[axis]) / grid.step + 2 * besides)) + 1;
    places *= static_cast<std::size_t>(grid.count[k]);
  }
  grid.values.resize(places);
  return grid;
}

}  // namespace

Mesh fieldSum(const PreviewTerm& a, const PreviewTerm& b, int cells, const Progress& progress) {
  GridValues grid = gridAround(boundsOf(a), boundsOf(b), cells);
  const std::vector<Triangle3> solid = trianglesOf(a), other = trianglesOf(b);
  const DistanceGrid toA(solid, grid.step, progress.part(0, 0.2));
  std::optional<DistanceGrid> toB;
  if (!other.empty()) toB.emplace(other, grid.step, progress.part(0.2, 0.4));
  const SampleTree boundary(samplesOf(b, grid.step));
  const std::vector<Vec3> bodies = bodiesOf(a);
  const double band = 2 * grid.step;
  parallelFor(static_cast<std::size_t>(grid.count[2]), 1, progress.part(0.4, 0.9), [&](std::size_t first, std::size_t last) {
    for (auto z = static_cast<int>(first); z < static_cast<int>(last); ++z)
      for (int y = 0; y < grid.count[1]; ++y)
        for (int x = 0; x < grid.count[0]; ++x) {
          const Vec3 p = grid.low + grid.step * Vec3(x, y, z);
          double value = boundary.least(toA, p, band, band);
          if (toB)
            for (const Vec3& body : bodies) value = std::min(value, (*toB)(p - body));
          grid.values[grid.index(x, y, z)] = static_cast<float>(value);
        }
  });
  return surfaceNet(grid, progress.part(0.9, 1));
}

}  // namespace blossom::morphology
