#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Geometry>
#include <Geom_BSplineSurface.hxx>
#include <Standard_Failure.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/bspline/bspline.h"
#include "geometry/measure/measure_parts.h"
#include "geometry/numeric/gauss.h"
#include "geometry/occt/occt.h"
#include "geometry/occt/occt_reason.h"
#include "geometry/shape/bounds.h"

namespace blossom {
namespace {

std::vector<TopoDS_Shape> distinctShapes(const TopoDS_Shape& shape, TopAbs_ShapeEnum kind) {
  TopTools_IndexedMapOfShape map;
  TopExp::MapShapes(shape, kind, map);
  std::vector<TopoDS_Shape> result;
  for (int i = 1; i <= map.Extent(); ++i)
    if (kind != TopAbs_EDGE || !BRep_Tool::Degenerated(TopoDS::Edge(map(i)))) result.push_back(map(i));
  return result;
}

bool isBoundary(const TopoDS_Shape& shape) {
  return shape.Orientation() == TopAbs_FORWARD || shape.Orientation() == TopAbs_REVERSED;
}

/// Every edge is run through as often forwards as backwards.
bool isClosed(const TopoDS_Shape& shell) {
  TopTools_IndexedMapOfShape edges;
  std::vector<int> balance;
  for (TopExp_Explorer face(shell, TopAbs_FACE); face.More(); face.Next()) {
    for (TopExp_Explorer explorer(face.Current(), TopAbs_EDGE); explorer.More(); explorer.Next()) {
      const TopoDS_Edge& edge = TopoDS::Edge(explorer.Current());
      if (!isBoundary(edge) || BRep_Tool::Degenerated(edge)) continue;
      const auto index = static_cast<std::size_t>(edges.Add(edge) - 1);
      balance.resize(std::max(balance.size(), index + 1));
      balance[index] += edge.Orientation() == TopAbs_FORWARD ? 1 : -1;
    }
  }
  return std::all_of(balance.begin(), balance.end(), [](int b) { return b == 0; });
}

/// By the Euler characteristic: vertices - edges + faces, where a face with r loops is a disc with r - 1 holes.
int genus(const TopoDS_Shape& shell) {
  long characteristic = static_cast<long>(distinctShapes(shell, TopAbs_VERTEX).size()) -
                        static_cast<long>(distinctShapes(shell, TopAbs_EDGE).size());
  for (const TopoDS_Shape& face : distinctShapes(shell, TopAbs_FACE)) {
    characteristic += 2;
    for (TopExp_Explorer wire(face, TopAbs_WIRE); wire.More(); wire.Next()) --characteristic;
  }
  return static_cast<int>((2 - characteristic) / 2);
}

double edgeLength(const TopoDS_Edge& edge) {
  const BRepAdaptor_Curve curve(edge);
  TColStd_Array1OfReal breaks(1, curve.NbIntervals(GeomAbs_CN) + 1);
  curve.Intervals(breaks, GeomAbs_CN);
  const auto speed = [&](double t) {
    gp_Pnt p;
    gp_Vec d;
    curve.D1(t, p, d);
    return d.Magnitude();
  };
  const GaussRule rule = gaussRule(8);
  const double estimate = detail::gaussSum(speed, rule, curve.FirstParameter(), curve.LastParameter());
  const double noise = 1e-14 * curve.Value(curve.FirstParameter()).XYZ().Modulus();
  double sum = 0;
  for (int i = 1; i < breaks.Upper(); ++i)
    sum += integrate(speed, breaks(i), breaks(i + 1), 1e-12 * estimate + noise + 1e-300);
  return sum;
}

/// Integrals of all faces, each seen from `reference`; in parallel.
std::vector<FaceIntegral> integrals(const std::vector<TopoDS_Shape>& faces, const Vec3& reference,
                                    const Progress& progress) {
  std::vector<FaceIntegral> result(faces.size());
  parallelFor(faces.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) result[i] = integrateFace(TopoDS::Face(faces[i]), reference, progress);
  });
  return result;
}

double totalArea(const TopoDS_Shape& shape, const Progress& progress) {
  double sum = 0;
  for (const FaceIntegral& face : integrals(distinctShapes(shape, TopAbs_FACE), Vec3::Zero(), progress)) sum += face.area;
  return sum;
}

double volume(const TopoDS_Shape& solid, const Progress& progress) {
  std::vector<TopoDS_Shape> faces;
  for (TopExp_Explorer face(solid, TopAbs_FACE); face.More(); face.Next())
    if (isBoundary(face.Current())) faces.push_back(face.Current());
  const Bounds box = bounds(Shape(Brep(solid)));
  const Vec3 reference = box.empty ? Vec3::Zero() : Vec3((box.low + box.high) / 2);
  double sum = 0;
  for (const FaceIntegral& face : integrals(faces, reference, progress)) sum += face.volume;
  return std::abs(sum);  // solids turned inside out are found in files
}

Measures measureSolids(const TopoDS_Shape& shape, const std::vector<TopoDS_Shape>& solids, const Progress& progress) {
  double total = 0;
  for (std::size_t i = 0; i < solids.size(); ++i) {
    const double done = static_cast<double>(i) / static_cast<double>(solids.size());
    progress.report(done / 2, "Measuring volume");
    total += volume(solids[i], progress);
  }
  const auto shells = distinctShapes(shape, TopAbs_SHELL);
  int genusSum = 0;
  bool closed = true;
  for (const TopoDS_Shape& shell : shells) {
    const bool shellClosed = isClosed(shell);
    closed = closed && shellClosed;
    if (shellClosed) genusSum += genus(shell);
  }
  return {"solid",
          {{"volume", total, MeasureUnit::Volume},
           {"area", totalArea(shape, progress), MeasureUnit::Area},
           countMeasure("faces", distinctShapes(shape, TopAbs_FACE).size()),
           countMeasure("edges", distinctShapes(shape, TopAbs_EDGE).size()),
           countMeasure("vertices", distinctShapes(shape, TopAbs_VERTEX).size()),
           {"genus", std::int64_t{genusSum}},
           countMeasure("components", solids.size()),
           countMeasure("shells", shells.size()),
           {"closed", closed}}};
}

/// A face on a B-spline has the measures of a Surface.
Measures measureSplineFace(const TopoDS_Face& face, const Progress& progress) {
  const BRepAdaptor_Surface adaptor(face, Standard_False);
  const Surface surface = fromOcct(adaptor.BSpline());
  return {"surface",
          {{"degree_u", std::int64_t{surface.degreeU}},
           {"degree_v", std::int64_t{surface.degreeV}},
           countMeasure("poles_u", surface.countU()),
           countMeasure("poles_v", surface.countV()),
           {"min_weight", smallestWeight(surface)},
           {"area", totalArea(face, progress), MeasureUnit::Area}}};
}

Measures measureFaces(const TopoDS_Shape& shape, const std::vector<TopoDS_Shape>& faces, const Progress& progress) {
  return {"faces",
          {countMeasure("faces", faces.size()),
           {"area", totalArea(shape, progress), MeasureUnit::Area},
           countMeasure("edges", distinctShapes(shape, TopAbs_EDGE).size()),
           countMeasure("vertices", distinctShapes(shape, TopAbs_VERTEX).size())}};
}

Measures measureEdges(const TopoDS_Shape& shape, const Progress& progress) {
  double sum = 0;
  for (const TopoDS_Shape& edge : distinctShapes(shape, TopAbs_EDGE)) {
    progress.check();
    sum += edgeLength(TopoDS::Edge(edge));
  }
  std::size_t curves = distinctShapes(shape, TopAbs_WIRE).size();
  for (TopExp_Explorer free(shape, TopAbs_EDGE, TopAbs_WIRE); free.More(); free.Next()) ++curves;
  return {"curves",
          {countMeasure("curves", curves),
           {"length", sum, MeasureUnit::Length},
           countMeasure("vertices", distinctShapes(shape, TopAbs_VERTEX).size())}};
}

Measures measureShape(const TopoDS_Shape& shape, const Progress& progress) {
  if (shape.IsNull()) return {"nothing", {}};
  std::vector<TopoDS_Shape> solids = distinctShapes(shape, TopAbs_SOLID);
  if (!solids.empty()) return measureSolids(shape, solids, progress);
  const auto faces = distinctShapes(shape, TopAbs_FACE);
  if (faces.size() == 1 &&
      BRepAdaptor_Surface(TopoDS::Face(faces.front()), Standard_False).GetType() == GeomAbs_BSplineSurface)
    return measureSplineFace(TopoDS::Face(faces.front()), progress);
  return faces.empty() ? measureEdges(shape, progress) : measureFaces(shape, faces, progress);
}

}  // namespace

Measures measureBrep(const Brep& brep, const Progress& progress) {
  try {
    return measureShape(brep.shape(), progress);
  } catch (const Standard_Failure& failure) {
    throw Error(ErrorCode::Degenerate, std::string("The shape cannot be measured: ") + reasonOf(failure) + ".",
                "Check the shape; it may come from a damaged file.");
  }
}

}  // namespace blossom
