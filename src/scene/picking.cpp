#include "scene/picking.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

#include "scene/pick_tree.h"

namespace blossom {

namespace {

/// A face that is nearly along the ray lies this many tolerances in front of an edge it ends at.
constexpr double slope = 30;

SubPick pickOf(SubShapeKind kind, int index, const NearHit& hit, const Ray& ray) {
  return {kind, index, hit.point, -ray.direction, hit.distance};
}

/// Whether the convex polygon has any point within all bounds: cut by one after the other.
bool reachesInto(const std::vector<CutPlane>& bounds, std::vector<Vec3> polygon) {
  for (const CutPlane& bound : bounds) {
    std::vector<Vec3> kept;
    for (std::size_t i = 0; i < polygon.size(); ++i) {
      const Vec3 &a = polygon[i], &b = polygon[(i + 1) % polygon.size()];
      const double ha = bound.height(a), hb = bound.height(b);
      if (ha <= 0) kept.push_back(a);
      if ((ha < 0 && hb > 0) || (ha > 0 && hb < 0)) kept.push_back(a + (b - a) * (ha / (ha - hb)));
    }
    if (kept.empty()) return false;
    polygon = std::move(kept);
  }
  return true;
}

bool isInside(const std::vector<CutPlane>& bounds, const Vec3& p) {
  return std::all_of(bounds.begin(), bounds.end(), [&](const CutPlane& bound) { return bound.height(p) <= 0; });
}

bool liesWithin(const std::vector<CutPlane>& bounds, const std::vector<Vec3>& piece, bool crossing) {
  // Mostly a piece lies wholly outside of one bound.
  for (const CutPlane& bound : bounds)
    if (std::all_of(piece.begin(), piece.end(), [&](const Vec3& p) { return bound.height(p) > 0; })) return false;
  const auto inside = [&](const Vec3& p) { return isInside(bounds, p); };
  if (!crossing) return std::all_of(piece.begin(), piece.end(), inside);
  return std::any_of(piece.begin(), piece.end(), inside) || reachesInto(bounds, piece);
}

/// Counts the pieces of each number and how many of them are met.
class Counter {
 public:
  void add(int number, bool met) {
    if (number < 0) return;
    const auto i = static_cast<std::size_t>(number);
    if (i >= pieces_.size()) {
      pieces_.resize(i + 1, 0);
      met_.resize(i + 1, 0);
    }
    ++pieces_[i];
    if (met) ++met_[i];
  }
  [[nodiscard]] std::vector<int> numbers(bool crossing) const {
    std::vector<int> result;
    for (std::size_t i = 0; i < pieces_.size(); ++i)
      if (crossing ? met_[i] > 0 : pieces_[i] > 0 && met_[i] == pieces_[i]) result.push_back(static_cast<int>(i));
    return result;
  }

 private:
  std::vector<int> pieces_, met_;
};

}  // namespace

Vec3 CutPlane::axis() const {
  const Vec3 up = std::abs(normal.z()) < 0.9 ? Vec3::UnitZ() : Vec3::UnitX();
  return up.cross(normal).normalized();
}

PickIndex::PickIndex(const SceneData& scene) : tree_(std::make_unique<const Tree>(scene)) {}
PickIndex::~PickIndex() = default;

double PickIndex::faceDistance(const Ray& ray, const std::optional<CutPlane>& cut) const {
  return tree_->firstFace(ray, cut).distance;
}

std::optional<SubPick> PickIndex::pick(const Ray& ray, const PickOptions& options) const {
  const FaceHit face = tree_->firstFace(ray, options.cut);
  const bool met = face.distance < std::numeric_limits<double>::infinity();
  const double reach =
      met && options.facesHide
          ? face.distance + slope * (options.tolerance + options.tolerancePerMm * face.distance) + 1e-9 * tree_->size
          : std::numeric_limits<double>::infinity();
  const auto isHidden = [&](const NearHit& hit) { return tree_->hidden(hit, ray, options); };

  if (options.vertices)
    for (const NearHit& hit : tree_->verticesNear(ray, options, reach))
      if (!isHidden(hit)) return pickOf(SubShapeKind::Vertex, hit.item, hit, ray);
  std::optional<NearHit> unnamed;
  if (options.edges)
    for (const NearHit& hit : tree_->segmentsNear(ray, options, reach)) {
      const int number = tree_->edgeNumbers[static_cast<std::size_t>(hit.item)];
      if ((number < 0 && unnamed) || isHidden(hit)) continue;
      if (number >= 0) return pickOf(SubShapeKind::Edge, number, hit, ray);
      unnamed = hit;
    }
  if (options.faces && met) {
    const Vec3 point = ray.origin + face.distance * ray.direction;
    if (face.triangle < 0) return SubPick{SubShapeKind::Whole, -1, point, options.cut->normal, face.distance};
    const auto triangle = static_cast<std::size_t>(face.triangle);
    const int number = triangle < tree_->faceNumbers.size() ? tree_->faceNumbers[triangle] : -1;
    return SubPick{number < 0 ? SubShapeKind::Whole : SubShapeKind::Face, number, point, tree_->normalAt(face),
                   face.distance};
  }
  if (unnamed) return pickOf(SubShapeKind::Whole, -1, *unnamed, ray);
  return std::nullopt;
}

std::vector<int> PickIndex::within(const std::vector<CutPlane>& bounds, SubShapeKind kind, bool crossing) const {
  const Tree& t = *tree_;
  const bool whole = kind == SubShapeKind::Whole;
  Counter counter;
  if (kind == SubShapeKind::Face || whole)
    for (std::size_t i = 0; i < t.triangles.size(); ++i) {
      const int triangle = static_cast<int>(i);
      counter.add(whole ? 0 : (i < t.faceNumbers.size() ? t.faceNumbers[i] : -1),
                  liesWithin(bounds, {t.corner(triangle, 0), t.corner(triangle, 1), t.corner(triangle, 2)}, crossing));
    }
  if (kind == SubShapeKind::Edge || whole)
    for (std::size_t i = 0; i < t.segments.size(); ++i) {
      const auto s = static_cast<std::size_t>(t.segments[i]);
      counter.add(whole ? 0 : t.edgeNumbers[i], liesWithin(bounds, {t.linePoints[s], t.linePoints[s + 1]}, crossing));
    }
  if (kind == SubShapeKind::Vertex || (whole && t.triangles.empty() && t.segments.empty()))
    for (std::size_t i = 0; i < t.vertices.size(); ++i)
      counter.add(whole ? 0 : static_cast<int>(i), liesWithin(bounds, {t.vertices[i]}, crossing));
  return counter.numbers(crossing);
}

}  // namespace blossom
