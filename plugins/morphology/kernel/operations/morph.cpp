#include <algorithm>
#include <memory>
#include <optional>

#include "kernel/morphology.h"
#include "kernel/operations/pair.h"

namespace blossom::morphology {

namespace {

/// The in-between solids of some solids. Two of them are paired once for all frames.
class Morph {
 public:
  Morph(const std::vector<Operand>& shapes, const std::vector<std::vector<double>>& weights, const Progress& progress)
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
    }
  }

  void frame(const std::vector<double>& weights, double from, double to) {
    std::vector<Part> parts;
    for (std::size_t k = 0; k < shapes_.size(); ++k)
      if (weights[k] > 0) parts.push_back({k, weights[k]});
    if (parts.size() == 1) return work_.finish(shapes_[parts.front().shape], grid_, from, to);
    Vec3 centre = Vec3::Zero();
    for (const Part& part : parts) centre += part.weight * shapes_[part.shape].centre;
    const double most = from + 0.9 * (to - from);
    if (const auto prism = ofPrisms(parts, from, most)) return work_.finish(*prism, centre, most, to);
    if (std::all_of(parts.begin(), parts.end(), [&](const Part& p) { return isConvex(shapes_[p.shape]); }))
      return work_.finish(ofHulls(parts), centre, most, to);
    const Sum sum = ofAny(parts, from, most);
    work_.finish(sum.mesh, centre + sum.moved, most, to);
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
  double leastWeight_ = 1;  ///< of all frames, above 0
  std::optional<ConvexSums> convex_;
  std::shared_ptr<const arrangement::FeaturePairs> kept_;
  bool isPaired_ = false;
};

}  // namespace

MorphologyResult solidMorph(const std::vector<Operand>& shapes, const std::vector<std::vector<double>>& weights,
                            const Progress& progress) {
  Morph morph(shapes, weights, progress);
  const double share = 0.9 / static_cast<double>(std::max<std::size_t>(1, weights.size()));
  double from = 0.1;
  for (const std::vector<double>& row : weights) {
    morph.frame(row, from, from + share);
    from += share;
  }
  return morph.result();
}

}  // namespace blossom::morphology
