#include "kernel/preview/field_sum.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include "core/parallel.h"
#include "geometry/mesh/mesh_topology.h"
#include "kernel/preview/distance_grid.h"
#include "kernel/preview/surface_net.h"
#include "kernel/side_by_side.h"

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

/// Points of a triangle in rows along its longest side, no two neighbours farther apart than a step. Segments and points are
/// flat triangles.
void addSamples(Triangle3 t, double step, std::vector<Vec3>& samples) {
  const auto length = [&](std::size_t k) { return (t[(k + 1) % 3] - t[k]).norm(); };
  std::size_t longest = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (length(k) > length(longest)) longest = k;
  std::rotate(t.begin(), t.begin() + static_cast<std::ptrdiff_t>(longest), t.end());
  const double height = length(0) > 0 ? (t[1] - t[0]).cross(t[2] - t[0]).norm() / length(0) : 0;
  const auto parts = [&](double distance) { return std::max(1, static_cast<int>(std::ceil(distance / step))); };
  const int rows = parts(height);
  for (int row = 0; row <= rows; ++row) {
    const double up = row / static_cast<double>(rows);
    const Vec3 from = t[0] + up * (t[2] - t[0]), to = t[1] + up * (t[2] - t[1]);
    const int count = parts((to - from).norm());
    for (int k = 0; k <= count; ++k) samples.emplace_back(from + k / static_cast<double>(count) * (to - from));
  }
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

std::vector<Vec3> samplesOf(const PreviewTerm& term, const std::vector<Triangle3>& triangles, double step,
                            const Progress& progress) {
  std::vector<Vec3> samples;
  for (std::size_t t = 0; t < triangles.size(); ++t) {
    if (t % 1024 == 0) progress.check();
    addSamples(triangles[t], step, samples);
  }
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
  const Bounds boxOfA = boundsOf(a), boxOfB = boundsOf(b);
  GridValues grid = gridAround(boxOfA, boxOfB, cells);
  const std::vector<Triangle3> solid = trianglesOf(a), other = trianglesOf(b);
  const auto stepOf = [&](const Bounds& box) {
    constexpr double finer = 1.5;  // than the grid of the sum, where a shape is as large as that
    return std::max(std::min(grid.step, (box.high - box.low).maxCoeff() / (finer * cells)), 1e-9);
  };
  std::optional<DistanceGrid> toA, toB;
  sideBySide(
      progress, [&] { toA.emplace(solid, stepOf(boxOfA), progress); },
      [&] {
        if (!other.empty()) toB.emplace(other, stepOf(boxOfB), progress);
      });
  const SampleTree boundaryOfB(samplesOf(b, other, grid.step, progress));
  const SampleTree boundaryOfA(toB ? samplesOf(a, solid, grid.step, progress) : std::vector<Vec3>());
  const double band = 2 * grid.step;
  parallelFor(static_cast<std::size_t>(grid.count[2]), 1, progress.part(0.4, 0.9), [&](std::size_t first, std::size_t last) {
    for (auto z = static_cast<int>(first); z < static_cast<int>(last); ++z)
      for (int y = 0; y < grid.count[1]; ++y)
        for (int x = 0; x < grid.count[0]; ++x) {
          const Vec3 p = grid.low + grid.step * Vec3(x, y, z);
          double value = boundaryOfB.least(*toA, p, band, band);
          if (toB && value > -band) value = boundaryOfA.least(*toB, p, value, band);
          grid.values[grid.index(x, y, z)] = static_cast<float>(value);
        }
  });
  return surfaceNet(grid, progress.part(0.9, 1));
}

}  // namespace blossom::morphology
