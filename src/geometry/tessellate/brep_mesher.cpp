#include "geometry/tessellate/brep_mesher.h"

#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_Copy.hxx>
#include <BRepMesh_IncrementalMesh.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <GCPnts_TangentialDeflection.hxx>
#include <Poly_PolygonOnTriangulation.hxx>
#include <Poly_Triangulation.hxx>
#include <Precision.hxx>
#include <Standard_Failure.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedDataMapOfShapeListOfShape.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/numeric/union_find.h"
#include "geometry/occt/occt_progress.h"
#include "geometry/occt/occt_reason.h"
#include "geometry/occt/occt_vector.h"
#include "geometry/tessellate/face_mesh.h"
#include "geometry/tessellate/grid_mesher.h"

namespace blossom {
namespace {

class ShapeMesher {
 public:
  ShapeMesher(const TopoDS_Shape& shape, const TessellationOptions& options, const Progress& progress)
      : shape_(BRepBuilderAPI_Copy(shape, Standard_False, Standard_False).Shape()), options_(options), progress_(progress) {
    TopExp::MapShapes(shape_, TopAbs_FACE, faceMap_);
  }

  Tessellation run(PointOrigins* origins) {
    if (faceMap_.Extent() > 0) {
      triangulate();
      placePoints();
      addTriangles();
    }
    addEdges();
    addVertices();
    for (TopExp_Explorer vertex(shape_, TopAbs_VERTEX, TopAbs_EDGE); vertex.More(); vertex.Next())
      result_.markers.push_back(toVec(BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current())).XYZ()));
    if (origins) *origins = originsOfPoints();
    return std::move(result_);
  }

 private:
  PointOrigins originsOfPoints() {
    PointOrigins origins{std::move(parameters_), {}};
    origins.joint.reserve(result_.points.size());
    for (std::size_t i = 0; i < result_.points.size(); ++i) origins.joint.push_back(static_cast<int>(joints_->find(i)));
    return origins;
  }

  /// B-spline rectangles become grids; BRepMesh meshes the other faces and uses the edges of the grids.
  void triangulate() {
    grids_ = meshGridFaces(faceMap_, options_, progress_);
    triangulateOthers();
    if (grids_.empty() || edgesAgree()) return;
    // BRepMesh has divided an edge anew: it must then do all faces.
    grids_.clear();
    BRepTools::Clean(shape_);
    triangulateOthers();
  }

  /// OCCT does not always keep its deflection on free-form faces: measured, and the faces in question meshed again finer.
  void triangulateOthers() {
    constexpr int maximumRounds = 4;
    collectFaces();
    double deflection = options_.chord;
    for (int round = 0; round < maximumRounds; ++round) {
      if (std::all_of(faces_.begin(), faces_.end(), [](const FaceMesh& mesh) { return mesh.normals; })) break;
      runBRepMesh(deflection);
      collectFaces();
      const std::vector<double> sags = largestSags();
      const double worst = *std::max_element(sags.begin(), sags.end());
      if (worst <= options_.chord || round + 1 == maximumRounds) break;
      forgetTooCoarse(sags, round > 0);
      deflection = std::max(deflection * std::max(0.15, 0.8 * options_.chord / worst), 10 * Precision::Confusion());
    }
    if (std::all_of(faces_.begin(), faces_.end(), [](const FaceMesh& mesh) { return mesh.triangulation.IsNull(); }))
      throw Error(ErrorCode::Degenerate, "None of the faces can be divided into triangles.",
                  "Check the shape; its edges may not bound its faces.");
  }

  void runBRepMesh(double deflection) {
    IMeshTools_Parameters parameters;
    parameters.Deflection = std::max(deflection, 2 * Precision::Confusion());
    parameters.Angle = options_.angle;
    parameters.InParallel = Standard_True;
    const Handle(OcctProgress) indicator = new OcctProgress(progress_, "Meshing");
    const BRepMesh_IncrementalMesh mesher(shape_, parameters, indicator->Start());
    progress_.check();
  }

  void collectFaces() {
    faces_.assign(static_cast<std::size_t>(faceMap_.Extent()), {});
    for (int i = 1; i <= faceMap_.Extent(); ++i) {
      FaceMesh& mesh = faces_[static_cast<std::size_t>(i - 1)];
      mesh.face = TopoDS::Face(faceMap_(i));
      mesh.triangulation = BRep_Tool::Triangulation(mesh.face, mesh.location);
      if (!mesh.triangulation.IsNull() && !mesh.triangulation->HasUVNodes()) mesh.triangulation.Nullify();
      const auto grid = grids_.find(mesh.triangulation.get());
      if (grid != grids_.end()) mesh.normals = &grid->second;
    }
  }

  /// Of each face that BRepMesh has done.
  std::vector<double> largestSags() const {
    std::vector<double> worst(faces_.size());
    parallelFor(faces_.size(), 1, progress_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
        if (!faces_[f].triangulation.IsNull() && !faces_[f].normals) worst[f] = largestSag(faces_[f]);
    });
    return worst;
  }

  double largestSag(const FaceMesh& mesh) const {
    const BRepAdaptor_Surface surface(mesh.face, Standard_False);
    if (surface.GetType() == GeomAbs_Plane) return 0;
    const std::vector<Collapsed> collapsed = collapsedParameters(*mesh.triangulation, surface);
    double worst = 0;
    for (int t = 1; t <= mesh.triangulation->NbTriangles(); ++t) {
      if (t % 4096 == 0) progress_.check();
      worst = std::max(worst, sag(mesh, surface, mesh.triangulation->Triangle(t), collapsed));
    }
    return std::max(0.0, worst - BRep_Tool::Tolerance(mesh.face));
  }

  /// Leaves BRepMesh only the faces that are too coarse; the others keep their triangles, and with them their edges.
  /// @param neighbors too: an edge may have been the reason
  void forgetTooCoarse(const std::vector<double>& sags, bool neighbors) {
    TopTools_IndexedDataMapOfShapeListOfShape owners;
    TopExp::MapShapesAndUniqueAncestors(shape_, TopAbs_EDGE, TopAbs_FACE, owners);
    std::vector<bool> again(faces_.size());
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      if (sags[f] <= options_.chord) continue;
      again[f] = true;
      if (!neighbors) continue;
      for (TopExp_Explorer edge(faces_[f].face, TopAbs_EDGE); edge.More(); edge.Next())
        for (const TopoDS_Shape& owner : owners.FindFromKey(edge.Current()))
          if (const auto other = static_cast<std::size_t>(faceMap_.FindIndex(owner) - 1); !faces_[other].normals)
            again[other] = true;
    }
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (!again[f]) keep(faces_[f]);
    for (std::size_t f = 0; f < faces_.size(); ++f)
      if (again[f]) BRepTools::Clean(faces_[f].face);
  }

  /// A stored deflection of 0 satisfies any later request.
  static void keep(const FaceMesh& mesh) {
    if (mesh.triangulation.IsNull()) return;
    mesh.triangulation->Deflection(0);
    for (TopExp_Explorer edge(mesh.face, TopAbs_EDGE); edge.More(); edge.Next()) {
      const auto polygon =
          BRep_Tool::PolygonOnTriangulation(TopoDS::Edge(edge.Current()), mesh.triangulation, mesh.location);
      if (!polygon.IsNull()) polygon->Deflection(0);
    }
  }

  /// Has every edge the same number of points in all its faces?
  bool edgesAgree() const {
    TopTools_IndexedDataMapOfShapeListOfShape edges;
    TopExp::MapShapesAndUniqueAncestors(shape_, TopAbs_EDGE, TopAbs_FACE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
      const auto edgeRows = rows(TopoDS::Edge(edges.FindKey(i)), edges(i));
      for (const auto& row : edgeRows)
        if (row.size() != edgeRows.front().size()) return false;
    }
    return true;
  }

  void placePoints() {
    int total = 0;
    for (FaceMesh& mesh : faces_) {
      mesh.offset = total;
      if (!mesh.triangulation.IsNull()) total += mesh.triangulation->NbNodes();
    }
    result_.points.resize(static_cast<std::size_t>(total));
    parameters_.resize(static_cast<std::size_t>(total));
    result_.normals.resize(static_cast<std::size_t>(total));
    if (options_.curvature) result_.curvatures.resize(static_cast<std::size_t>(total));
    parallelFor(faces_.size(), 1, progress_, [&](std::size_t begin, std::size_t end) {
      for (std::size_t f = begin; f < end; ++f)
        if (!faces_[f].triangulation.IsNull()) placeFace(faces_[f]);
    });
  }

  void placeFace(const FaceMesh& mesh) {
    const gp_Trsf& place = mesh.location.Transformation();
    const BRepAdaptor_Surface surface(mesh.face, Standard_False);
    const gp_Pnt2d center = parameterCenter(*mesh.triangulation);
    const double side = isInverted(mesh) ? -1 : 1;
    for (int i = 1; i <= mesh.triangulation->NbNodes(); ++i) {
      const auto index = static_cast<std::size_t>(mesh.offset + i - 1);
      result_.points[index] = toVec(mesh.triangulation->Node(i).Transformed(place).XYZ());
      parameters_[index] = {mesh.triangulation->UVNode(i).X(), mesh.triangulation->UVNode(i).Y()};
      result_.normals[index] = mesh.normals ? gridNormal(mesh, static_cast<std::size_t>(i - 1))
                                            : Vec3(side * normalAt(surface, mesh.triangulation->UVNode(i), center));
      if (!options_.curvature) continue;
      SurfaceCurvature& curvature = result_.curvatures[index];
      curvature = curvatureAt(surface, mesh.triangulation->UVNode(i), center);
      curvature.mean *= side;
      if (i % 4096 == 0) progress_.check();
    }
  }

  /// Normals of a grid are those of the surface before it is placed.
  static Vec3 gridNormal(const FaceMesh& mesh, std::size_t i) {
    const Vec3& own = (*mesh.normals)[i];
    const Vec3 placed = toVec(gp_Vec(own.x(), own.y(), own.z()).Transformed(mesh.location.Transformation()).XYZ());
    return mesh.face.Orientation() == TopAbs_REVERSED ? -placed.normalized() : placed.normalized();
  }

  /// A mirroring location turns du x dv round, as a reversed orientation does.
  static bool isInverted(const FaceMesh& mesh) {
    return (mesh.face.Orientation() == TopAbs_REVERSED) != mesh.location.Transformation().IsNegative();
  }

  void addTriangles() {
    for (std::size_t f = 0; f < faces_.size(); ++f) {
      const FaceMesh& mesh = faces_[f];
      if (mesh.triangulation.IsNull()) continue;
      for (int t = 1; t <= mesh.triangulation->NbTriangles(); ++t) {
        int a = 0, b = 0, c = 0;
        mesh.triangulation->Triangle(t).Get(a, b, c);
        if (isInverted(mesh)) std::swap(b, c);
        result_.triangles.push_back({mesh.offset + a - 1, mesh.offset + b - 1, mesh.offset + c - 1});
        result_.faceOfTriangle.push_back(static_cast<int>(f));
      }
    }
  }

  /// The points of an edge in one of its faces; a seam has two rows of them.
  std::vector<std::vector<std::size_t>> rows(const TopoDS_Edge& edge, const TopTools_ListOfShape& owners) const {
    std::vector<std::vector<std::size_t>> result;
    for (const TopoDS_Shape& owner : owners) {
      const int index = faceMap_.FindIndex(owner);
      const FaceMesh& mesh = faces_[static_cast<std::size_t>(index - 1)];
      if (mesh.triangulation.IsNull()) continue;
      const auto add = [&](TopAbs_Orientation orientation) {
        const TopoDS_Edge oriented = TopoDS::Edge(edge.Oriented(orientation));
        const auto polygon = BRep_Tool::PolygonOnTriangulation(oriented, mesh.triangulation, mesh.location);
        if (polygon.IsNull()) return;
        auto& row = result.emplace_back();
        for (int i = 1; i <= polygon->NbNodes(); ++i)
          row.push_back(static_cast<std::size_t>(mesh.offset + polygon->Node(i) - 1));
      };
      add(TopAbs_FORWARD);
      if (BRep_Tool::IsClosed(edge, mesh.face)) add(TopAbs_REVERSED);
    }
    return result;
  }

  void addVertices() {
    TopTools_IndexedMapOfShape vertices;
    TopExp::MapShapes(shape_, TopAbs_VERTEX, vertices);
    result_.vertices.reserve(static_cast<std::size_t>(vertices.Extent()));
    for (int i = 1; i <= vertices.Extent(); ++i)
      result_.vertices.push_back(toVec(BRep_Tool::Pnt(TopoDS::Vertex(vertices(i))).XYZ()));
  }

  void addEdges() {
    joints_.emplace(result_.points.size());
    TopTools_IndexedMapOfShape numbers;  // that of the faces counts otherwise where there are free edges
    TopExp::MapShapes(shape_, TopAbs_EDGE, numbers);
    TopTools_IndexedDataMapOfShapeListOfShape edges;
    TopExp::MapShapesAndUniqueAncestors(shape_, TopAbs_EDGE, TopAbs_FACE, edges);
    for (int i = 1; i <= edges.Extent(); ++i) {
      if (i % 256 == 0) progress_.check();
      const TopoDS_Edge& edge = TopoDS::Edge(edges.FindKey(i));
      const auto edgeRows = rows(edge, edges(i));
      alignRows(edge, edgeRows);
      if (BRep_Tool::Degenerated(edge)) continue;
      const std::size_t drawn = result_.edges.size();
      if (edges(i).IsEmpty()) {
        addFreeEdge(edge);
      } else if (!edgeRows.empty() && !isSmoothSeam(edge, edges(i), edgeRows)) {
        auto& polyline = result_.edges.emplace_back();
        for (const std::size_t p : edgeRows.front()) polyline.push_back(result_.points[p]);
      }
      if (result_.edges.size() > drawn) result_.edgeIndices.push_back(numbers.FindIndex(edge) - 1);
    }
  }

  /// Gives an edge's points the same coordinates in all faces, and its ends those of the vertices.
  void alignRows(const TopoDS_Edge& edge, const std::vector<std::vector<std::size_t>>& edgeRows) {
    const auto place = [&](const TopoDS_Vertex& vertex, std::size_t index) {
      if (vertex.IsNull()) return;
      result_.points[index] = toVec(BRep_Tool::Pnt(vertex).XYZ());
      const int number = vertexMap_.Add(vertex);
      if (number > static_cast<int>(atVertex_.size())) atVertex_.push_back(index);
      joints_->unite(atVertex_[static_cast<std::size_t>(number - 1)], index);
    };
    const TopoDS_Edge forward = TopoDS::Edge(edge.Oriented(TopAbs_FORWARD));
    for (const auto& row : edgeRows) {
      const auto& first = edgeRows.front();
      if (row.size() == first.size())
        for (std::size_t k = 0; k < row.size(); ++k) {
          result_.points[row[k]] = result_.points[first[k]];
          joints_->unite(first[k], row[k]);
        }
      if (BRep_Tool::Degenerated(edge))
        for (const std::size_t p : row) place(TopExp::FirstVertex(forward), p);
      place(TopExp::FirstVertex(forward), row.front());
      place(TopExp::LastVertex(forward), row.back());
    }
  }

  /// Where a surface closes smoothly onto itself, nothing is to be seen.
  bool isSmoothSeam(const TopoDS_Edge& edge, const TopTools_ListOfShape& owners,
                    const std::vector<std::vector<std::size_t>>& edgeRows) const {
    constexpr double smooth = 0.99;
    if (owners.Extent() != 1 || edgeRows.size() != 2 || !BRep_Tool::IsClosed(edge, TopoDS::Face(owners.First())))
      return false;
    const auto& [a, b] = std::pair(edgeRows[0], edgeRows[1]);
    for (std::size_t k = 0; k < std::min(a.size(), b.size()); ++k)
      if (result_.normals[a[k]].dot(result_.normals[b[k]]) < smooth) return false;
    return true;
  }

  void addFreeEdge(const TopoDS_Edge& edge) {
    const BRepAdaptor_Curve curve(edge);
    const GCPnts_TangentialDeflection points(curve, options_.angle, options_.chord);
    auto& polyline = result_.edges.emplace_back();
    for (int i = 1; i <= points.NbPoints(); ++i) polyline.push_back(toVec(points.Value(i).XYZ()));
  }

  TopoDS_Shape shape_;
  TessellationOptions options_;
  const Progress& progress_;
  TopTools_IndexedMapOfShape faceMap_;
  GridNormalsOf grids_;
  std::vector<FaceMesh> faces_;
  std::vector<Vec2> parameters_;     ///< of the points
  std::optional<UnionFind> joints_;  ///< of the points, by edges and vertices
  TopTools_IndexedMapOfShape vertexMap_;
  std::vector<std::size_t> atVertex_;  ///< a point at each of its vertices
  Tessellation result_;
};

}  // namespace

Tessellation meshShape(const TopoDS_Shape& shape, const TessellationOptions& options, const Progress& progress,
                       PointOrigins* origins) {
  try {
    return ShapeMesher(shape, options, progress).run(origins);
  } catch (const Standard_Failure& failure) {
    throw Error(ErrorCode::Degenerate, std::string("The shape cannot be meshed: ") + reasonOf(failure) + ".",
                "Check the shape; it may come from a damaged file.");
  }
}

}  // namespace blossom
