#include "scene/pick_tree.h"

#include <vtkCellArray.h>
#include <vtkCellArrayIterator.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkPointData.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>

namespace blossom {

namespace {

std::vector<Vec3> pointsOf(vtkPoints* points) {
  std::vector<Vec3> result;
  if (!points) return result;
  result.resize(static_cast<std::size_t>(points->GetNumberOfPoints()));
  for (std::size_t i = 0; i < result.size(); ++i) points->GetPoint(static_cast<vtkIdType>(i), result[i].data());
  return result;
}

std::vector<int> numbersOf(vtkPolyData& data, const char* name) {
  std::vector<int> result;
  vtkDataArray* array = data.GetCellData()->GetArray(name);
  if (!array) return result;
  result.reserve(static_cast<std::size_t>(array->GetNumberOfTuples()));
  for (vtkIdType i = 0; i < array->GetNumberOfTuples(); ++i) result.push_back(static_cast<int>(array->GetTuple1(i)));
  return result;
}

template <class Item>
RayTree treeOver(std::size_t count, const Item& addTo) {
  std::vector<FloatBox> boxes(count);
  for (std::size_t i = 0; i < count; ++i) addTo(i, boxes[i]);
  return RayTree(boxes);
}

/// The ray prepared for tests against boxes.
class Slabs {
 public:
  explicit Slabs(const Ray& ray) : origin_(ray.origin), direction_(ray.direction) {
    constexpr double minimum = 1e-300;  // 1 / 0 would make 0 * infinity of a box that is touched
    for (int k = 0; k < 3; ++k) inverse_[k] = 1 / (std::abs(direction_[k]) < minimum ? minimum : direction_[k]);
  }

  [[nodiscard]] double enter(const FloatBox& box, double wider = 0) const {
    double from = 0, to = std::numeric_limits<double>::infinity();
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const double a = (static_cast<double>(box.low[k]) - wider - origin_[axis]) * inverse_[axis];
      const double b = (static_cast<double>(box.high[k]) + wider - origin_[axis]) * inverse_[axis];
      from = std::max(from, std::min(a, b));
      to = std::min(to, std::max(a, b));
    }
    return from <= to ? from : std::numeric_limits<double>::infinity();
  }

  /// With the tolerance at the far end of the box.
  [[nodiscard]] double enterNear(const FloatBox& box, const PickOptions& options) const {
    double farthest = 0;
    for (std::size_t k = 0; k < 3; ++k) {
      const auto axis = static_cast<Eigen::Index>(k);
      const double d = direction_[axis];
      farthest += d * (static_cast<double>(d > 0 ? box.high[k] : box.low[k]) - origin_[axis]);
    }
    if (farthest < 0) farthest = 0;
    return enter(box, options.tolerance + options.tolerancePerMm * farthest);
  }

 private:
  Vec3 origin_, direction_;
  Vec3 inverse_;
};

/// Parameter in 0..1 of the point of a segment nearest to a line.
double nearestOnSegment(const Vec3& a, const Vec3& b, const Ray& ray) {
  const Vec3 along = b - a;
  const Vec3 across = along - along.dot(ray.direction) * ray.direction;
  const double squared = across.squaredNorm();
  if (!(squared > 1e-24 * along.squaredNorm()))
    return (b - a).dot(ray.direction) < 0 ? 1 : 0;  // seen end on: the nearer end
  return std::clamp((ray.origin - a).dot(across) / squared, 0.0, 1.0);
}

/// Keeps the part of a segment that is not cut away. @returns whether anything is left.
bool clip(Vec3& a, Vec3& b, const std::optional<CutPlane>& cut) {
  if (!cut) return true;
  const double ha = cut->height(a), hb = cut->height(b);
  if (ha > 0 && hb > 0) return false;
  if (ha > 0) a += (b - a) * (ha / (ha - hb));
  if (hb > 0) b += (a - b) * (hb / (hb - ha));
  return true;
}

std::optional<NearHit> nearHit(int item, const Vec3& point, const Ray& ray, const PickOptions& options, double limit) {
  const double distance = (point - ray.origin).dot(ray.direction);
  if (distance < 0 || distance > limit) return std::nullopt;
  const double off = (point - ray.origin - distance * ray.direction).norm();
  const double tolerance = options.tolerance + options.tolerancePerMm * distance;
  if (off > tolerance) return std::nullopt;
  return NearHit{item, distance, tolerance > 0 ? off / tolerance : 0, point};
}

/// Those nearest to the ray first; of nearly equal ones the nearer to the eye.
void sortBest(std::vector<NearHit>& hits) {
  constexpr std::size_t most = 64;  // each may be tested for being hidden
  constexpr double same = 0.2;
  const auto better = [](const NearHit& a, const NearHit& b) {
    const double ka = std::floor(a.off / same), kb = std::floor(b.off / same);
    return ka != kb ? ka < kb : a.distance < b.distance;
  };
  const auto end = hits.begin() + static_cast<std::ptrdiff_t>(std::min(hits.size(), most));
  std::partial_sort(hits.begin(), end, hits.end(), better);
  hits.erase(end, hits.end());
}

std::optional<FaceHit> meet(const Ray& ray, const Vec3& a, const Vec3& b, const Vec3& c) {
  constexpr double border = 1e-9;  // a ray through a common edge meets one of its faces
  const Vec3 e1 = b - a, e2 = c - a, p = ray.direction.cross(e2);
  const double determinant = e1.dot(p);
  if (determinant == 0) return std::nullopt;
  const Vec3 s = ray.origin - a, q = s.cross(e1);
  const double u = s.dot(p) / determinant, v = ray.direction.dot(q) / determinant;
  if (!(u >= -border && v >= -border && u + v <= 1 + border)) return std::nullopt;
  return FaceHit{e2.dot(q) / determinant, -1, u, v};
}

}  // namespace

PickIndex::Tree::Tree(const SceneData& scene) : faces(scene.faces), solid(scene.solid) {
  FloatBox all;
  if (scene.faces) {
    points = pointsOf(scene.faces->GetPoints());
    const auto cell = vtk::TakeSmartPointer(scene.faces->GetPolys()->NewIterator());
    triangles.reserve(static_cast<std::size_t>(scene.faces->GetNumberOfPolys()));
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cell->GetCurrentCell(count, ids);
      triangles.push_back({static_cast<int>(ids[0]), static_cast<int>(ids[1]), static_cast<int>(ids[2])});
    }
    faceNumbers = numbersOf(*scene.faces, "face");
  }
  if (scene.edges) {
    linePoints = pointsOf(scene.edges->GetPoints());
    const std::vector<int> numbers = numbersOf(*scene.edges, "edge");
    const auto cell = vtk::TakeSmartPointer(scene.edges->GetLines()->NewIterator());
    for (cell->GoToFirstCell(); !cell->IsDoneWithTraversal(); cell->GoToNextCell()) {
      vtkIdType count = 0;
      const vtkIdType* ids = nullptr;
      cell->GetCurrentCell(count, ids);
      const auto line = static_cast<std::size_t>(cell->GetCurrentCellId());
      for (vtkIdType i = 0; i + 1 < count; ++i) {  // the points of a polyline follow one another
        segments.push_back(static_cast<int>(ids[i]));
        edgeNumbers.push_back(line < numbers.size() ? numbers[line] : -1);
      }
    }
  }
  vertices = pointsOf(scene.vertices);
  triangleTree = treeOver(triangles.size(), [&](std::size_t i, FloatBox& box) {
    for (const int k : triangles[i]) box.add(points[static_cast<std::size_t>(k)]);
    all.add(box);
  });
  segmentTree = treeOver(segments.size(), [&](std::size_t i, FloatBox& box) {
    const auto s = static_cast<std::size_t>(segments[i]);
    box.add(linePoints[s]);
    box.add(linePoints[s + 1]);
    all.add(box);
  });
  vertexTree = treeOver(vertices.size(), [&](std::size_t i, FloatBox& box) {
    box.add(vertices[i]);
    all.add(box);
  });
  if (!all.empty()) size = (Vec3(all.high[0], all.high[1], all.high[2]) - Vec3(all.low[0], all.low[1], all.low[2])).norm();
}

FaceHit PickIndex::Tree::firstFace(const Ray& ray, const std::optional<CutPlane>& cut) const {
  FaceHit best;
  const Slabs slabs(ray);
  triangleTree.walk([&](const FloatBox& box) { return slabs.enter(box); },
                    [&](int triangle) {
                      auto hit = meet(ray, corner(triangle, 0), corner(triangle, 1), corner(triangle, 2));
                      if (!hit || hit->distance < 0 || hit->distance >= best.distance) return;
                      if (cut && cut->height(ray.origin + hit->distance * ray.direction) > 0) return;
                      hit->triangle = triangle;
                      best = *hit;
                    },
                    best.distance);
  if (!cut || !solid || best.triangle < 0) return best;
  // Whoever comes out of a solid through its first face has gone into it where it is cut.
  const double height = cut->height(ray.origin), falling = -cut->normal.dot(ray.direction);
  if (height <= 0 || falling <= 0) return best;
  const Vec3 &a = corner(best.triangle, 0), &b = corner(best.triangle, 1), &c = corner(best.triangle, 2);
  if ((b - a).cross(c - a).dot(ray.direction) <= 0) return best;
  return FaceHit{height / falling, -1, 0, 0};
}

std::vector<NearHit> PickIndex::Tree::segmentsNear(const Ray& ray, const PickOptions& options, double limit) const {
  std::vector<NearHit> hits;
  const Slabs slabs(ray);
  segmentTree.walk([&](const FloatBox& box) { return slabs.enterNear(box, options); },
                   [&](int item) {
                     const auto s = static_cast<std::size_t>(segments[static_cast<std::size_t>(item)]);
                     Vec3 a = linePoints[s], b = linePoints[s + 1];
                     if (!clip(a, b, options.cut)) return;
                     const Vec3 point = a + (b - a) * nearestOnSegment(a, b, ray);
                     if (const auto hit = nearHit(item, point, ray, options, limit)) hits.push_back(*hit);
                   },
                   limit);
  sortBest(hits);
  return hits;
}

std::vector<NearHit> PickIndex::Tree::verticesNear(const Ray& ray, const PickOptions& options, double limit) const {
  std::vector<NearHit> hits;
  const Slabs slabs(ray);
  vertexTree.walk([&](const FloatBox& box) { return slabs.enterNear(box, options); },
                  [&](int item) {
                    const Vec3& point = vertices[static_cast<std::size_t>(item)];
                    if (options.cut && options.cut->height(point) > 0) return;
                    if (const auto hit = nearHit(item, point, ray, options, limit)) hits.push_back(*hit);
                  },
                  limit);
  sortBest(hits);
  return hits;
}

// Looks from where the eye sees the point: beside the ray in a parallel view, from the ray's origin in perspective.
bool PickIndex::Tree::hidden(const NearHit& hit, const Ray& ray, const PickOptions& options) const {
  if (!options.facesHide || triangles.empty()) return false;
  const Vec3 aside = hit.point - (ray.origin + hit.distance * ray.direction);
  const double there = options.tolerance + options.tolerancePerMm * hit.distance;
  const Vec3 from = ray.origin + aside * (there > 0 ? options.tolerance / there : 1);
  const double distance = (hit.point - from).norm();
  if (!(distance > 0)) return false;
  const double slack = std::max(1e-6 * (size + distance), 1e-3 * there);
  return firstFace({from, (hit.point - from) / distance}, options.cut).distance < distance - slack;
}

Vec3 PickIndex::Tree::normalAt(const FaceHit& hit) const {
  const auto& ids = triangles[static_cast<std::size_t>(hit.triangle)];
  if (vtkDataArray* normals = faces->GetPointData()->GetNormals()) {
    Vec3 sum = Vec3::Zero();
    const std::array<double, 3> weights{1 - hit.u - hit.v, hit.u, hit.v};
    for (std::size_t k = 0; k < 3; ++k) {
      Vec3 n;
      normals->GetTuple(ids[k], n.data());
      sum += weights[k] * n;
    }
    if (sum.norm() > 0.1) return sum.normalized();
  }
  const Vec3 &a = corner(hit.triangle, 0), &b = corner(hit.triangle, 1), &c = corner(hit.triangle, 2);
  const Vec3 normal = (b - a).cross(c - a);
  return normal.norm() > 0 ? Vec3(normal.normalized()) : Vec3(Vec3::UnitZ());
}

}  // namespace blossom
