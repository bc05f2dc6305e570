#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>

#include "geometry/mesh/mesh_topology.h"
#include "kernel/morphology.h"
#include "kernel/operations/pair.h"

namespace blossom::morphology {

namespace {

/// The in-between solids of some solids. Two of them are paired once for all frames.
class Morph {
 public:
  Morph(const std::vector<Operand>& shapes, const std::vector<std::vector<double>>& weights, const MorphOptions& options,
        const Progress& progress)
      : work_(progress) {
    for (const std::vector<double>& row : weights)
      for (const double weight : row)
        if (weight > 0) leastWeight_ = std::min(leastWeight_, weight);
    Bounds largest = shapes.front().bounds();
    for (const Operand& shape : shapes) {
      requireSolid(shape);
      const Bounds box = shape.bounds();
      if ((box.high - box.low).maxCoeff() > (largest.high - largest.low).maxCoeff()) largest = box;
    }
    grid_ = gridFor(largest, largest);
    const double share = 0.1 / static_cast<double>(shapes.size());
    for (const Operand& shape : shapes) {
      const double from = share * static_cast<double>(shapes_.size());
      shapes_.push_back(work_.prepare(shape, grid_, from, from + share));
      if (!options.volumePreserving) continue;
      // Bodies that overlap count once.
      shapes_.back() = work_.united(std::move(shapes_.back()), grid_, from, from + share);
      volumes_.push_back(signedVolume(shapes_.back().triangles));
    }
  }

  void frame(const std::vector<double>& weights, std::size_t number, std::size_t count) {
    work_.startFrame(number, count);
    std::vector<Part> parts;
    for (std::size_t k = 0; k < shapes_.size(); ++k)
      if (weights[k] > 0) parts.push_back({k, weights[k]});
    if (parts.size() == 1) return work_.finish(shapes_[parts.front().shape], grid_, 0, 1);
    Vec3 centre = Vec3::Zero();
    for (const Part& part : parts) centre += part.weight * shapes_[part.shape].centre;
    constexpr double most = 0.9;
    if (const auto prism = ofPrisms(parts, 0, most)) {
      if (volumes_.empty()) return work_.finish(*prism, centre, most, 1);
      work_.stats().way = Way::Prisms;
      return work_.finish(blendedVolume(trianglesOf(*prism, work_.progress()), parts), centre, most, 1);
    }
    if (std::all_of(parts.begin(), parts.end(), [&](const Part& p) { return isConvex(shapes_[p.shape]); }))
      return work_.finish(blendedVolume(ofHulls(parts), parts), centre, most, 1);
    Sum sum = ofAny(parts, 0, most);
    for (Vec3& p : sum.mesh.points) p += sum.moved;
    work_.finish(blendedVolume(std::move(sum.mesh), parts), centre, most, 1);
  }

  MorphologyResult result() { return work_.result(); }

 private:
  struct Part {
    std::size_t shape = 0;
    double weight = 0;
  };
  struct Sum {
    Mesh mesh;
    Vec3 moved = Vec3::Zero();  ///< of its origin
  };

  /// Scaled about the blend of the middles.
  Mesh blendedVolume(Mesh mesh, const std::vector<Part>& parts) const {
    if (volumes_.empty()) return mesh;
    double wanted = 0;
    Vec3 middle = Vec3::Zero();
    for (const Part& part : parts) {
      wanted += part.weight * volumes_[part.shape];
      middle += part.weight * shapes_[part.shape].bounds.center();
    }
    const double factor = std::cbrt(wanted / signedVolume(mesh));
    for (Vec3& p : mesh.points) p = middle + factor * (p - middle);
    return mesh;
  }

  /// Along the first axis along which all are prisms.
  std::optional<Prism> ofPrisms(const std::vector<Part>& parts, double from, double to) {
    for (int axis = 0; axis < 3; ++axis) {
      std::vector<const Prism*> prisms;
      for (const Part& part : parts)
        for (const Prism& prism : shapes_[part.shape].prisms)
          if (prism.axis == axis) prisms.push_back(&prism);
      if (prisms.size() != parts.size()) continue;
      Prism made = scaled(*prisms.front(), parts.front().weight);
      for (std::size_t k = 1; k < parts.size(); ++k)
        made = sum(made, scaled(*prisms[k], parts[k].weight), work_.progress().part(from, to));
      return made;
    }
    return std::nullopt;
  }

  Mesh ofHulls(const std::vector<Part>& parts) {
    const Mesh &first = shapes_[parts[0].shape].hull, &second = shapes_[parts[1].shape].hull;
    if (shapes_.size() == 2) {
      if (!convex_) convex_.emplace(first, second, work_);
      return convex_->sum(parts[0].weight, parts[1].weight);
    }
    Mesh made = ConvexSums(first, second, work_).sum(parts[0].weight, parts[1].weight);
    for (std::size_t k = 2; k < parts.size(); ++k)
      made = ConvexSums(made, shapes_[parts[k].shape].hull, work_).sum(1, parts[k].weight);
    return made;
  }

  /// Of two solids that are paired already.
  const arrangement::FeaturePairs* kept() {
    if (shapes_.size() != 2) return nullptr;
    if (!kept_ && !isPaired_) {
      kept_ = keptPairs(termOf(shapes_[0]), termOf(shapes_[1]), grid_.step, leastWeight_, work_.progress());
      if (kept_) ++work_.stats().pairings;
      isPaired_ = true;
    }
    return kept_.get();
  }

  Sum ofAny(const std::vector<Part>& parts, double from, double to) {
    const double share = (to - from) / static_cast<double>(parts.size() - 1);
    Sum made{sumOfAny(work_, shapes_[parts[0].shape], parts[0].weight, shapes_[parts[1].shape], parts[1].weight, grid_, from,
                      from + share, kept())};
    for (std::size_t k = 2; k < parts.size(); ++k) {
      const double begin = from + share * static_cast<double>(k - 1), middle = begin + 0.1 * share;
      const Prepared& next = shapes_[parts[k].shape];
      const Prepared before = work_.asOperand(made.mesh, "The in-between solid", grid_, begin, middle);
      made.moved += before.centre;
      made.mesh = sumOfAny(work_, before, 1, next, parts[k].weight, grid_, middle, begin + share);
    }
    return made;
  }

  Work work_;
  CommonGrid grid_;
  std::vector<Prepared> shapes_;
  std::vector<double> volumes_;  ///< of the shapes, where they are to be blended
  double leastWeight_ = 1;       ///< of all frames, above 0
  std::optional<ConvexSums> convex_;
  std::shared_ptr<const arrangement::FeaturePairs> kept_;
  bool isPaired_ = false;
};

}  // namespace

MorphologyResult solidMorph(const std::vector<Operand>& shapes, const std::vector<std::vector<double>>& weights,
                            const MorphOptions& options, const Progress& progress) {
  Morph morph(shapes, weights, options, progress);
  for (std::size_t k = 0; k < weights.size(); ++k) morph.frame(weights[k], k, weights.size());
  return morph.result();
}

}  // namespace blossom::morphology
