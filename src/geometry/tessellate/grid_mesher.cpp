#include "geometry/tessellate/grid_mesher.h"

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Poly_PolygonOnTriangulation.hxx>
#include <TColStd_Array1OfInteger.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopoDS.hxx>
#include <algorithm>
#include <set>

#include "core/parallel.h"
#include "geometry/occt/grid_face.h"
#include "geometry/tessellate/grid_fit.h"

namespace blossom {
namespace {

constexpr std::array<GridSide, 4> allSides{GridSide::V0, GridSide::U1, GridSide::V1, GridSide::U0};

/// Parameters of the points of every edge, by the edge's own shape.
using EdgePoints = std::map<const TopoDS_TShape*, std::vector<double>>;

struct FittedFace {
  GridFace face;
  SurfaceGrid grid;

  [[nodiscard]] std::vector<double> parameters(GridSide side) const {
    std::vector<double> result;
    for (const GridSample& sample : side == GridSide::V0 || side == GridSide::V1 ? grid.u : grid.v)
      result.push_back(sample.t);
    return result;
  }
};

/// Sorted, with values that differ by rounding alone taken once.
void unify(std::vector<double>& values, double first, double last) {
  const double rounding = 1e-7 * (last - first);
  std::sort(values.begin(), values.end());
  std::vector<double> result{first};
  for (const double t : values)
    if (t > result.back() + rounding && t < last - rounding) result.push_back(t);
  result.push_back(last);
  values = std::move(result);
}

EdgePoints edgePoints(const std::vector<FittedFace>& faces) {
  EdgePoints points;
  std::map<const TopoDS_TShape*, std::pair<double, double>> ranges;
  for (const FittedFace& fitted : faces) {
    for (const GridSide side : allSides) {
      const std::vector<double> parameters = fitted.parameters(side);
      for (const SideEdge& edge : fitted.face.side(side)) {
        auto& values = points[edge.edge.TShape().get()];
        for (const double s : parameters)
          if (s > edge.low() && s < edge.high()) values.push_back(edge.onEdge(s));
        ranges[edge.edge.TShape().get()] = {edge.first, edge.last};
      }
    }
  }
  for (auto& [edge, values] : points) unify(values, ranges[edge].first, ranges[edge].second);
  return points;
}

/// Nodes along one side, in order of the surface's parameter.
struct Border {
  std::vector<double> parameters;
  std::vector<int> nodes;
};

/// One face: the inner points of its grid, and around them a strip to the points of the edges.
class GridFaceMesher {
 public:
  GridFaceMesher(const FittedFace& fitted, const EdgePoints& points) : fitted_(fitted), points_(points) {
    const std::size_t lastU = grid().u.size() - 1, lastV = grid().v.size() - 1;
    for (std::size_t i = 1; i < lastU; ++i)
      for (std::size_t j = 1; j < lastV; ++j)
        addNode(grid().u[i].t, grid().v[j].t, grid().point(i, j), grid().normals[i * grid().v.size() + j]);
    for (const GridSide side : allSides) addBorder(side);
    for (std::size_t i = 1; i + 1 < lastU; ++i)
      for (std::size_t j = 1; j + 1 < lastV; ++j) addCell(i, j);
    for (const GridSide side : allSides) addStrip(side);
  }

  /// Stores triangles and polygons in the face and its edges.
  Handle(Poly_Triangulation) store() const {
    const BRep_Builder builder;
    Handle(Poly_Triangulation) mesh = triangulation();
    builder.UpdateFace(fitted_.face.face, mesh);
    TopLoc_Location location;
    BRep_Tool::Triangulation(fitted_.face.face, location);
    std::set<const TopoDS_TShape*> done;
    for (const GridSide side : allSides) {
      for (const SideEdge& edge : fitted_.face.side(side)) {
        if (!done.insert(edge.edge.TShape().get()).second) continue;
        const TopoDS_Edge forward = TopoDS::Edge(edge.edge.Oriented(TopAbs_FORWARD));
        const auto one = polygon(forward.TShape().get(), TopAbs_FORWARD);
        const auto other = polygon(forward.TShape().get(), TopAbs_REVERSED);
        if (!one.IsNull() && !other.IsNull()) {
          builder.UpdateEdge(forward, one, other, mesh, location);
        } else {
          builder.UpdateEdge(forward, one.IsNull() ? other : one, mesh, location);
        }
      }
    }
    return mesh;
  }

  [[nodiscard]] const std::vector<Vec3>& normals() const { return normals_; }

 private:
  [[nodiscard]] const SurfaceGrid& grid() const { return fitted_.grid; }

  int addNode(double u, double v, const Vec3& point, const Vec3& normal) {
    parameters_.push_back(Vec2(u, v) + fitted_.face.shift);
    nodes_.push_back(point);
    normals_.push_back(normal);
    return static_cast<int>(nodes_.size()) - 1;
  }

  [[nodiscard]] int inner(std::size_t i, std::size_t j) const {
    return static_cast<int>((i - 1) * (grid().v.size() - 2) + j - 1);
  }

  static bool alongU(GridSide side) { return side == GridSide::V0 || side == GridSide::V1; }

  /// Nodes of a side; corners belong to two sides and come with the first of them. A degenerate edge is one point.
  void addBorder(GridSide side) {
    const Surface& surface = fitted_.face.surface;
    Border& border = borders_[static_cast<std::size_t>(side)];
    border.parameters = sideParameters(side);
    const std::size_t last = border.parameters.size() - 1;
    const auto [u0, u1] = surface.domainU();
    const auto [v0, v1] = surface.domainV();
    const double across = side == GridSide::V0 ? v0 : side == GridSide::V1 ? v1 : side == GridSide::U0 ? u0 : u1;
    auto u = samplesAt(surface.degreeU, surface.knotsU, alongU(side) ? border.parameters : std::vector{across});
    auto v = samplesAt(surface.degreeV, surface.knotsV, alongU(side) ? std::vector{across} : border.parameters);
    const SurfaceGrid line = evaluateGrid(surface, std::move(u), std::move(v), Progress::none());
    const bool point = fitted_.face.side(side).front().degenerated;
    for (std::size_t k = 0; k <= last; ++k) {
      const double s = border.parameters[k];
      const Vec2 uv = alongU(side) ? Vec2(s, across) : Vec2(across, s);
      const bool corner = k == 0 || k == last;
      const int known = corner ? knownCorner(uv) : -1;
      border.nodes.push_back(known >= 0 ? known : addNode(uv.x(), uv.y(), line.points[k], line.normals[k]));
      if (corner && known < 0) corners_.emplace_back(uv, border.nodes.back());
      if (point) nodes_[static_cast<std::size_t>(border.nodes.back())] = nodes_[static_cast<std::size_t>(border.nodes[0])];
    }
  }

  [[nodiscard]] int knownCorner(const Vec2& uv) const {
    for (const auto& [place, node] : corners_)
      if (place == uv) return node;
    return -1;
  }

  [[nodiscard]] std::vector<double> sideParameters(GridSide side) const {
    std::vector<double> result;
    for (const SideEdge& edge : fitted_.face.side(side)) {
      const std::vector<double>& points = points_.at(edge.edge.TShape().get());
      std::vector<double> here;
      here.reserve(points.size());
      for (const double t : points) here.push_back(edge.onSide(t));
      here.front() = edge.from;
      here.back() = edge.to;
      if (edge.from > edge.to) std::reverse(here.begin(), here.end());
      result.insert(result.end(), here.begin() + (result.empty() ? 0 : 1), here.end());
    }
    return result;
  }

  void addTriangle(int a, int b, int c, bool turned = false) {
    const auto at = [&](int i) -> const Vec3& { return nodes_[static_cast<std::size_t>(i)]; };
    if (at(a) == at(b) || at(b) == at(c) || at(c) == at(a)) return;  // at a pole
    if (turned) std::swap(b, c);
    triangles_.push_back({a, b, c});
  }

  void addCell(std::size_t i, std::size_t j) {
    const int p00 = inner(i, j), p10 = inner(i + 1, j), p01 = inner(i, j + 1), p11 = inner(i + 1, j + 1);
    if (mainDiagonal(grid().point(i, j), grid().point(i + 1, j), grid().point(i, j + 1), grid().point(i + 1, j + 1))) {
      addTriangle(p00, p10, p11);
      addTriangle(p00, p11, p01);
    } else {
      addTriangle(p00, p10, p01);
      addTriangle(p10, p11, p01);
    }
  }

  /// Triangles between the points of a side and the nearest inner row, whichever is behind going on.
  void addStrip(GridSide side) {
    const Border& border = borders_[static_cast<std::size_t>(side)];
    const std::size_t lastU = grid().u.size() - 1, lastV = grid().v.size() - 1;
    const auto& along = alongU(side) ? grid().u : grid().v;
    const auto row = [&](std::size_t k) {
      return side == GridSide::V0   ? inner(k, 1)
             : side == GridSide::V1 ? inner(k, lastV - 1)
             : side == GridSide::U0 ? inner(1, k)
                                    : inner(lastU - 1, k);
    };
    const bool turned = side == GridSide::V1 || side == GridSide::U0;
    const double rounding = 1e-6 * (along.back().t - along.front().t);
    const auto distance = [&](int a, int b) {
      return (nodes_[static_cast<std::size_t>(a)] - nodes_[static_cast<std::size_t>(b)]).squaredNorm();
    };
    std::size_t o = 0, i = 1;
    const std::size_t lastOuter = border.nodes.size() - 1, lastInner = along.size() - 2;
    while (o < lastOuter || i < lastInner) {
      bool outer = o < lastOuter;
      if (outer && i < lastInner) {
        const double ahead = border.parameters[o + 1] - along[i + 1].t;
        outer = std::abs(ahead) > rounding ? ahead < 0
                                           : distance(border.nodes[o + 1], row(i)) <= distance(border.nodes[o], row(i + 1));
      }
      if (outer) {
        addTriangle(border.nodes[o], border.nodes[o + 1], row(i), turned);
        ++o;
      } else {
        addTriangle(border.nodes[o], row(i + 1), row(i), turned);
        ++i;
      }
    }
  }

  [[nodiscard]] Handle(Poly_Triangulation) triangulation() const {
    Handle(Poly_Triangulation) mesh =
        new Poly_Triangulation(static_cast<int>(nodes_.size()), static_cast<int>(triangles_.size()), Standard_True);
    for (std::size_t i = 0; i < nodes_.size(); ++i) {
      mesh->SetNode(static_cast<int>(i) + 1, gp_Pnt(nodes_[i].x(), nodes_[i].y(), nodes_[i].z()));
      mesh->SetUVNode(static_cast<int>(i) + 1, gp_Pnt2d(parameters_[i].x(), parameters_[i].y()));
    }
    for (std::size_t t = 0; t < triangles_.size(); ++t)
      mesh->SetTriangle(static_cast<int>(t) + 1,
                        Poly_Triangle(triangles_[t][0] + 1, triangles_[t][1] + 1, triangles_[t][2] + 1));
    mesh->Deflection(0);
    return mesh;
  }

  /// The nodes of an edge in one of its two directions, in order of its parameter; none when it has no such use here.
  [[nodiscard]] Handle(Poly_PolygonOnTriangulation) polygon(const TopoDS_TShape* wanted, TopAbs_Orientation way) const {
    for (const GridSide side : allSides) {
      std::size_t start = 0;
      for (const SideEdge& edge : fitted_.face.side(side)) {
        const std::vector<double>& points = points_.at(edge.edge.TShape().get());
        if (edge.edge.TShape().get() == wanted && edge.edge.Orientation() == way) return polygon(edge, side, start, points);
        start += points.size() - 1;
      }
    }
    return nullptr;
  }

  [[nodiscard]] Handle(Poly_PolygonOnTriangulation)
      polygon(const SideEdge& edge, GridSide side, std::size_t start, const std::vector<double>& points) const {
    const int count = static_cast<int>(points.size());
    TColStd_Array1OfInteger nodes(1, count);
    TColStd_Array1OfReal parameters(1, count);
    for (int k = 0; k < count; ++k) {
      const std::size_t place = start + static_cast<std::size_t>(edge.from < edge.to ? k : count - 1 - k);
      nodes.SetValue(k + 1, borders_[static_cast<std::size_t>(side)].nodes[place] + 1);
      parameters.SetValue(k + 1, points[static_cast<std::size_t>(k)]);
    }
    Handle(Poly_PolygonOnTriangulation) result = new Poly_PolygonOnTriangulation(nodes, parameters);
    result->Deflection(0);
    return result;
  }

  const FittedFace& fitted_;
  const EdgePoints& points_;
  std::vector<Vec2> parameters_;
  std::vector<Vec3> nodes_, normals_;
  std::vector<std::array<int, 3>> triangles_;
  std::array<Border, 4> borders_;
  std::vector<std::pair<Vec2, int>> corners_;
};

/// Faces of one shape under several locations share their triangles.
std::vector<GridFace> distinctGridFaces(const TopTools_IndexedMapOfShape& faces) {
  std::vector<GridFace> result;
  std::set<const TopoDS_TShape*> seen;
  for (int i = 1; i <= faces.Extent(); ++i)
    if (seen.insert(faces(i).TShape().get()).second)
      if (auto face = gridFace(TopoDS::Face(faces(i)))) result.push_back(std::move(*face));
  return result;
}

}  // namespace

GridNormalsOf meshGridFaces(const TopTools_IndexedMapOfShape& faces, const TessellationOptions& options,
                            const Progress& progress) {
  std::vector<FittedFace> fitted;
  for (GridFace& face : distinctGridFaces(faces)) fitted.push_back({std::move(face), {}});
  parallelFor(fitted.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t f = begin; f < end; ++f)
      fitted[f].grid = fitGrid(fitted[f].face.surface, options, GridBorder::Shared, progress);
  });
  const EdgePoints points = edgePoints(fitted);
  GridNormalsOf normals;
  for (const FittedFace& face : fitted) {
    progress.check();
    const GridFaceMesher mesher(face, points);
    normals[mesher.store().get()] = mesher.normals();
  }
  return normals;
}

}  // namespace blossom
