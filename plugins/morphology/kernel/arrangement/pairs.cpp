#include "kernel/arrangement/pairs.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/parallel.h"
#include "geometry/numeric/box_tree.h"
#include "kernel/side_by_side.h"

namespace blossom::morphology::arrangement {

namespace {

using Vector = Eigen::Vector3d;

/// Radians by which all is enlarged: more than doubles lose.
constexpr double slack = 2e-4;

Box3 wholeSphere() { return {Vector::Constant(-1), Vector::Constant(1)}; }

Box3 enlarged(Box3 box, double by) {
  box.min().array() -= by;
  box.max().array() += by;
  return box;
}

/// The part of the sphere within an angle of a direction.
Box3 boxOfCap(const Vector& centre, double angle) {
  Box3 box;
  for (Eigen::Index k = 0; k < 3; ++k) {
    const double from = std::acos(std::clamp(centre[k], -1.0, 1.0));
    box.max()[k] = std::cos(std::max(0.0, from - angle));
    box.min()[k] = std::cos(std::min(M_PI, from + angle));
  }
  return box;
}

/// A direction, and how far rounding may turn it.
struct Direction {
  Vector unit;
  double blur = 0;
};

/// The directions of one shape on the sphere; those that have none are nowhere.
class OnSphere {
 public:
  OnSphere(const Features& shape, double rounding) : shape_(shape), rounding_(rounding) {
    normals_.reserve(shape.faces.size());
    for (const Features::Face& face : shape.faces) normals_.push_back(normalOf(face));
  }

  [[nodiscard]] std::vector<Box3> faces() const {
    std::vector<Box3> boxes;
    boxes.reserve(normals_.size());
    for (const Direction& normal : normals_) boxes.push_back(enlarged(Box3(normal.unit), normal.blur));
    return boxes;
  }

  [[nodiscard]] std::vector<std::optional<Box3>> edges() const {
    std::vector<std::optional<Box3>> boxes;
    boxes.reserve(shape_.edges.size());
    for (const Features::Edge& edge : shape_.edges) boxes.push_back(arcOf(edge));
    return boxes;
  }

  [[nodiscard]] std::vector<std::optional<Box3>> corners() const {
    std::vector<bool> touched(shape_.corners.size(), false);
    for (std::size_t v = 0; v < touched.size(); ++v) touched[v] = shape_.corners[v].isTouched;
    if (rounding_ > 0)
      for (const Features::Edge& edge : shape_.edges)
        if (arcOf(edge))
          for (const int end : {edge.from, edge.to}) touched[static_cast<std::size_t>(end)] = true;
    std::vector<std::optional<Box3>> boxes(touched.size());
    for (std::size_t v = 0; v < touched.size(); ++v)
      if (touched[v]) boxes[v] = coneOf(shape_.corners[v]);
    return boxes;
  }

 private:
  [[nodiscard]] Direction normalOf(const Features::Face& face) const {
    const Vector n(face.about[0].value, face.about[1].value, face.about[2].value);
    double longest = 0;
    for (std::size_t k = 0; k < 3; ++k)
      longest = std::max(longest, (inDoubles(cornerOf(face, k + 1)) - inDoubles(cornerOf(face, k))).norm());
    return {n.normalized(), slack + 2 * rounding_ * longest / n.norm()};
  }
  [[nodiscard]] const Grid3& cornerOf(const Features::Face& face, std::size_t k) const {
    return shape_.points[static_cast<std::size_t>(face.corners[k % 3])];
  }

  /// Nothing for a reflex edge that stays one.
  [[nodiscard]] std::optional<Box3> arcOf(const Features::Edge& edge) const {
    if (edge.left == Features::none) return wholeSphere();
    const Direction &left = normals_[static_cast<std::size_t>(edge.left)],
                    &right = normals_[static_cast<std::size_t>(edge.right)];
    const double blur = std::max(left.blur, right.blur);
    if (!edge.isConvex && (rounding_ == 0 || (left.unit - right.unit).norm() > 2 * blur)) return std::nullopt;
    const double cosine = std::sqrt(std::max(0.0, (1 + left.unit.dot(right.unit)) / 2));  // of half the arc
    if (cosine < 0.1) return wholeSphere();
    return enlarged(Box3(left.unit).extend(right.unit), blur + 1 - cosine);
  }

  /// Directions that fall along all edges of the corner: a cone between the normals of pairs of them.
  [[nodiscard]] Box3 coneOf(const Features::Corner& corner) const {
    constexpr double rounded = 1e-9;
    std::vector<Vector> along;
    double shortest = HUGE_VAL;
    for (const Grid3& d : corner.around) {
      along.push_back(inDoubles(d).normalized());
      shortest = std::min(shortest, inDoubles(d).norm());
    }
    std::vector<Vector> rays;
    double flattest = 1;
    for (std::size_t i = 0; i < along.size(); ++i)
      for (std::size_t j = 0; j < i; ++j) {
        // In whole numbers: two edges in nearly opposite directions meet in the tip of a long, thin cone.
        const Normal3 across = cross(corner.around[i], corner.around[j]);
        if (isZero(across)) continue;
        const Vector unit = inDoubles(across).normalized();
        for (const double sign : {1.0, -1.0}) {
          const Vector ray = sign * unit;
          if (std::any_of(along.begin(), along.end(), [&](const Vector& d) { return ray.dot(d) > rounded; })) continue;
          rays.push_back(ray);
          flattest = std::min(flattest, along[i].cross(along[j]).norm());
        }
      }
    Vector middle = Vector::Zero();
    for (const Vector& ray : rays) middle += ray;
    if (!(middle.norm() > 0.1)) return wholeSphere();
    middle.normalize();
    double cosine = 1;
    for (const Vector& ray : rays) cosine = std::min(cosine, middle.dot(ray));
    const double blur = slack + (rounding_ > 0 ? 4 * rounding_ / (shortest * flattest) : 0);
    if (cosine < 0.1 || blur > 0.5) return wholeSphere();
    return boxOfCap(middle, std::acos(std::min(1.0, cosine)) + blur);
  }

  const Features& shape_;
  double rounding_;
  std::vector<Direction> normals_;
};

const Box3* boxAt(const std::vector<Box3>& boxes, std::size_t k) { return &boxes[k]; }
const Box3* boxAt(const std::vector<std::optional<Box3>>& boxes, std::size_t k) { return boxes[k] ? &*boxes[k] : nullptr; }

/// Items of two lists whose boxes meet, in the order of the first list.
template <class First, class Second>
std::vector<FeaturePairs::Pair> meeting(const std::vector<First>& first, const std::vector<Second>& second,
                                        const Progress& progress) {
  std::vector<Box3> boxes;
  std::vector<int> numbers;
  for (std::size_t k = 0; k < second.size(); ++k)
    if (const Box3* const box = boxAt(second, k)) {
      numbers.push_back(static_cast<int>(k));
      boxes.push_back(*box);
    }
  const BoxTree<3> tree(boxes, 4, progress);
  constexpr std::size_t itemsOfPart = 128;
  std::vector<std::vector<FeaturePairs::Pair>> parts((first.size() + itemsOfPart - 1) / itemsOfPart);
  parallelFor(parts.size(), 1, progress, [&](std::size_t from, std::size_t to) {
    std::vector<int> met;
    for (std::size_t part = from; part < to; ++part)
      for (std::size_t k = part * itemsOfPart; k < std::min(first.size(), (part + 1) * itemsOfPart); ++k) {
        const Box3* const box = boxAt(first, k);
        if (!box) continue;
        met.clear();
        tree.meeting(*box, [&](std::size_t other) {
          if (box->intersects(boxes[other])) met.push_back(numbers[other]);
        });
        std::sort(met.begin(), met.end());
        for (const int other : met) parts[part].push_back({static_cast<int>(k), other});
      }
  });
  std::vector<FeaturePairs::Pair> pairs;
  for (const auto& part : parts) pairs.insert(pairs.end(), part.begin(), part.end());
  return pairs;
}

}  // namespace

FeaturePairs nearPairs(const Features& a, const Features& b, double rounding, const Progress& progress) {
  const OnSphere first(a, rounding), second(b, rounding);
  FeaturePairs pairs;
  sideBySide(
      progress, [&] { pairs.edges = meeting(first.edges(), second.edges(), progress); },
      [&] {
        pairs.facesAndCorners = meeting(first.faces(), second.corners(), progress);
        pairs.cornersAndFaces = meeting(first.corners(), second.faces(), progress);
      });
  return pairs;
}

}  // namespace blossom::morphology::arrangement
