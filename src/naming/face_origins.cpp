#include "naming/face_origins.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <memory>

#include "geometry/bspline/bspline.h"
#include "geometry/occt/occt.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/bounds.h"
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

constexpr std::array probeAt{0.31, 0.5, 0.83};  // fractions of an edge

/// Three points of an edge; none of one that is no curve.
std::vector<Vec3> pointsOf(const TopoDS_Edge& edge) {
  if (BRep_Tool::Degenerated(edge)) return {};
  const BRepAdaptor_Curve curve(edge);
  const double first = curve.FirstParameter(), span = curve.LastParameter() - first;
  std::vector<Vec3> points;
  for (const double t : probeAt) {
    const gp_Pnt p = curve.Value(first + t * span);
    points.emplace_back(p.X(), p.Y(), p.Z());
  }
  return points;
}

Vec2 pointAt(const Segment& segment, double t) {
  if (const auto* line = std::get_if<Line2>(&segment)) return line->from + t * (line->to - line->from);
  if (const auto* arc = std::get_if<Arc2>(&segment)) {
    const double angle = arc->start + t * arc->sweep;
    return arc->center + arc->radius * Vec2(std::cos(angle), std::sin(angle));
  }
  const Curve curve = toCurve(std::get<Spline2>(segment));
  const auto [first, last] = curve.domain();
  return point(curve, first + t * (last - first)).head<2>();
}

std::vector<Vec3> pointsOf(const Segment& segment) {
  std::vector<Vec3> points;
  for (const double t : probeAt) {
    const Vec2 p = pointAt(segment, t);
    points.emplace_back(p.x(), p.y(), 0);
  }
  return points;
}

/// Points of each edge of a B-rep or segment of a drawing, by number.
std::vector<std::vector<Vec3>> probesOf(const Shape& shape) {
  std::vector<std::vector<Vec3>> probes;
  const auto addPaths = [&](const std::vector<Path>& paths) {
    for (const Path& path : paths)
      for (const Segment& segment : path.segments) probes.push_back(pointsOf(segment));
  };
  if (const auto* region = shape.get<Region>()) addPaths(region->loops);
  if (const auto* curves = shape.get<Curves>()) addPaths(curves->paths);
  if (const auto* brep = shape.get<Brep>())
    for (const TopoDS_Shape& edge : subShapesOf(brep->shape(), TopAbs_EDGE)) probes.push_back(pointsOf(TopoDS::Edge(edge)));
  return probes;
}

/// An input with the faces and edges that images of it are compared with.
struct Input {
  Faces faces;
  bool oneFace = false;  ///< its parts are face 0 together: a region
  std::vector<DistanceTo> edges;
  std::vector<std::vector<Vec3>> probes;  ///< points of each edge
  double tolerance = 0;
};

Input inputOf(const Shape& shape, const Progress& progress) {
  Input input;
  input.tolerance = samePlace(shape);
  input.edges = distancesToEdges(shape, input.tolerance / 1e-6);
  input.probes = probesOf(shape);
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

/// The box around the image of a box, a little larger than that.
Bnd_Box imageBox(const Bounds& original, const Eigen::Affine3d& map) {
  Bnd_Box box;
  if (original.empty) return box;
  for (int k = 0; k < 8; ++k) {
    const Vec3 corner((k & 1 ? original.high : original.low).x(), (k & 2 ? original.high : original.low).y(),
                      (k & 4 ? original.high : original.low).z());
    const Vec3 image = map * corner;
    box.Add(gp_Pnt(image.x(), image.y(), image.z()));
  }
  constexpr double more = 1e-3;
  box.Enlarge(more * std::max(1.0, original.diagonal()));
  return box;
}

class Tracer {
 public:
  Tracer(const std::vector<Shape>& inputs, const std::vector<InputImage>& images, double tolerance, const Progress& progress)
      : images_(images), tolerance_(tolerance) {
    for (const Shape& shape : inputs) inputs_.push_back(inputOf(shape, progress));
    for (const InputImage& image : images_) boxes_.push_back(imageBox(bounds(inputs.at(image.input)), image.map));
  }

  std::vector<FaceOrigin> ofFace(const PlacedFace& face) const {
    std::vector<FaceOrigin> origins;
    for (std::size_t i = 0; i < images_.size(); ++i) {
      if (face.isOutside(boxes_[i])) continue;
      const InputImage& image = images_[i];
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

  /// The edges of inputs that bound the face or lie in it, as those that a ring of a revolution came from. Those of one
  /// image alone keep its tag; a side has edges at both ends.
  std::vector<FaceOrigin> ofEdges(const TopoDS_Shape& face, const PlacedFace& placed) const {
    std::vector<FaceOrigin> origins;
    for (const TopoDS_Shape& edge : subShapesOf(face, TopAbs_EDGE)) addEdges(pointsOf(TopoDS::Edge(edge)), origins);
    addEdgesIn(placed, origins);
    const bool oneImage =
        std::all_of(origins.begin(), origins.end(), [&](const FaceOrigin& each) { return each.tag == origins.front().tag; });
    if (!oneImage)
      for (FaceOrigin& origin : origins) origin.tag.clear();
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
    for (std::size_t i = 0; i < images_.size(); ++i) {
      if (boxes_[i].IsOut(gp_Pnt(points[0].x(), points[0].y(), points[0].z()))) continue;
      const InputImage& image = images_[i];
      const Input& input = inputs_.at(image.input);
      const std::vector<Vec3> back = mapped(points, image.map.inverse());
      const double reach = std::max(tolerance_, input.tolerance);
      for (std::size_t k = 0; k < input.edges.size(); ++k)
        if (std::all_of(back.begin(), back.end(), [&](const Vec3& p) { return input.edges[k](p) <= reach; }))
          origins.push_back({image.input, SubShapeKind::Edge, static_cast<int>(k), image.tag});
    }
  }

  void addEdgesIn(const PlacedFace& face, std::vector<FaceOrigin>& origins) const {
    for (std::size_t i = 0; i < images_.size(); ++i) {
      if (face.isOutside(boxes_[i])) continue;
      const InputImage& image = images_[i];
      const std::vector<std::vector<Vec3>>& probes = inputs_.at(image.input).probes;
      for (std::size_t k = 0; k < probes.size(); ++k) {
        const std::vector<Vec3> points = mapped(probes[k], image.map);
        if (!points.empty() &&
            std::all_of(points.begin(), points.end(), [&](const Vec3& p) { return face.holds(p, tolerance_); }))
          origins.push_back({image.input, SubShapeKind::Edge, static_cast<int>(k), image.tag});
      }
    }
  }

  std::vector<Input> inputs_;
  const std::vector<InputImage>& images_;
  std::vector<Bnd_Box> boxes_;  ///< of the images: most tell at once that they have nothing to do with a face
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
    if (found.empty()) found = tracer.ofEdges(faces[k], *placed[k]);
    origins.push_back(std::move(found));
  }
  return origins;
}

}  // namespace blossom
