#include "naming/face_origins.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <cmath>
#include <memory>

#include "geometry/occt/occt.h"
#include "geometry/planar/planar.h"
#include "naming/likeness.h"
#include "naming/placed_edges.h"
#include "naming/placed_face.h"

namespace blossom {

namespace {

using Faces = std::vector<std::unique_ptr<PlacedFace>>;

Faces facesOf(const TopoDS_Shape& shape, const Progress& progress) {
  Faces faces;
  for (const TopoDS_Shape& face : subShapesOf(shape, TopAbs_FACE)) {
    progress.check();
    faces.push_back(std::make_unique<PlacedFace>(TopoDS::Face(face)));
  }
  return faces;
}

/// An input with the faces and edges that images of it are compared with.
struct Input {
  Faces faces;
  bool oneFace = false;  ///< its parts are face 0 together: a region
  std::vector<DistanceTo> edges;
  double tolerance = 0;
};

Input inputOf(const Shape& shape, const Progress& progress) {
  Input input;
  input.tolerance = samePlace(shape);
  input.edges = distancesToEdges(shape, input.tolerance / 1e-6);
  if (const auto* brep = shape.get<Brep>()) input.faces = facesOf(brep->shape(), progress);
  if (const auto* region = shape.get<Region>()) input.faces = facesOf(toFaces(*region), progress);
  input.oneFace = shape.kind() == ShapeKind::Region;
  return input;
}

/// Whether a face with these inner points is a part of the other.
bool within(const std::vector<Vec3>& inner, const PlacedFace& other, double tolerance) {
  return !inner.empty() && other.holds(inner.front(), tolerance) &&
         std::all_of(inner.begin() + 1, inner.end(), [&](const Vec3& p) { return other.onSurface(p, tolerance); });
}

std::vector<Vec3> mapped(const std::vector<Vec3>& points, const Eigen::Affine3d& map) {
  std::vector<Vec3> images;
  images.reserve(points.size());
  for (const Vec3& p : points) images.push_back(map * p);
  return images;
}

/// Three points of an edge; none of one that is no curve.
std::vector<Vec3> pointsOf(const TopoDS_Edge& edge) {
  if (BRep_Tool::Degenerated(edge)) return {};
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter(), span = curve.LastParameter() - first;
  std::vector<Vec3> points;
  for (const double t : {0.31, 0.5, 0.83}) {
    const gp_Pnt p = curve.Value(first + t * span);
    points.emplace_back(p.X(), p.Y(), p.Z());
  }
  return points;
}

class Tracer {
 public:
  Tracer(const std::vector<Shape>& inputs, const std::vector<InputImage>& images, double tolerance, const Progress& progress)
      : images_(images), tolerance_(tolerance) {
    for (const Shape& shape : inputs) inputs_.push_back(inputOf(shape, progress));
  }

  std::vector<FaceOrigin> ofFace(const PlacedFace& face) const {
    std::vector<FaceOrigin> origins;
    for (const InputImage& image : images_) {
      const Input& input = inputs_.at(image.input);
      const std::vector<Vec3> back = mapped(face.inside(), image.map.inverse());
      for (std::size_t k = 0; k < input.faces.size(); ++k) {
        const PlacedFace& other = *input.faces[k];
        if (within(back, other, std::max(tolerance_, input.tolerance)) ||
            within(mapped(other.inside(), image.map), face, tolerance_))
          origins.push_back({image.input, SubShapeKind::Face, input.oneFace ? 0 : static_cast<int>(k), image.tag});
      }
    }
    return sorted(std::move(origins));
  }

  std::vector<FaceOrigin> ofBorder(const TopoDS_Shape& face) const {
    std::vector<FaceOrigin> origins;
    for (const TopoDS_Shape& edge : subShapesOf(face, TopAbs_EDGE)) addEdges(pointsOf(TopoDS::Edge(edge)), origins);
    return sorted(std::move(origins));
  }

 private:
  static std::vector<FaceOrigin> sorted(std::vector<FaceOrigin> origins) {
    std::sort(origins.begin(), origins.end());
    origins.erase(std::unique(origins.begin(), origins.end()), origins.end());
    return origins;
  }

  void addEdges(const std::vector<Vec3>& points, std::vector<FaceOrigin>& origins) const {
    if (points.empty()) return;
    for (const InputImage& image : images_) {
      const Input& input = inputs_.at(image.input);
      const std::vector<Vec3> back = mapped(points, image.map.inverse());
      const double reach = std::max(tolerance_, input.tolerance);
      for (std::size_t k = 0; k < input.edges.size(); ++k)
        if (std::all_of(back.begin(), back.end(), [&](const Vec3& p) { return input.edges[k](p) <= reach; }))
          origins.push_back({image.input, SubShapeKind::Edge, static_cast<int>(k), {}});
    }
  }

  std::vector<Input> inputs_;
  const std::vector<InputImage>& images_;
  double tolerance_;
};

}  // namespace

std::vector<std::vector<FaceOrigin>> faceOrigins(const TopoDS_Shape& result, const std::vector<Shape>& inputs,
                                                 const std::vector<InputImage>& images, const Progress& progress) {
  const Tracer tracer(inputs, images, samePlace(Brep(result)), progress);
  const std::vector<TopoDS_Shape> faces = subShapesOf(result, TopAbs_FACE);
  const Faces placed = facesOf(result, progress);
  std::vector<std::vector<FaceOrigin>> origins;
  origins.reserve(placed.size());
  for (std::size_t k = 0; k < placed.size(); ++k) {
    progress.check();
    std::vector<FaceOrigin> found = tracer.ofFace(*placed[k]);
    if (found.empty()) found = tracer.ofBorder(faces[k]);
    origins.push_back(std::move(found));
  }
  return origins;
}

}  // namespace blossom
