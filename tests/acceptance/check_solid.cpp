// check_solid SOLID.step MESH.stl DEFLECTION: is the solid closed and valid by OCCT's own check, and does the mesh enclose
// its volume? check_solid SWEEP.step: beside OCCT's own integration, to 1e-6, the divergence theorem over every span of the
// surfaces that OCCT has read, `volume_by_spans`, for solids of whole surfaces and planes. Prints JSON.
#include <BRepAdaptor_Curve.hxx>
#include <BRepAdaptor_Surface.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <STEPControl_Reader.hxx>
#include <TColStd_Array1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <fstream>
#include <iostream>
#include <iterator>
#include <map>
#include <math.hxx>
#include <math_Vector.hxx>
#include <nlohmann/json.hpp>
#include <string>

namespace {

using Corner = std::array<float, 3>;

/// Volume by the divergence theorem, and whether every directed edge has its opposite (points compared bit by bit).
std::pair<double, bool> binaryStl(const std::string& path) {
  std::ifstream in(path, std::ios::binary);
  const std::string bytes((std::istreambuf_iterator<char>(in)), {});
  std::uint32_t count = 0;
  if (bytes.size() < 84) return {0, false};
  std::memcpy(&count, bytes.data() + 80, 4);
  if (bytes.size() != 84 + 50ull * count) return {0, false};
  double six = 0;
  std::map<std::pair<Corner, Corner>, int> edges;
  for (std::uint32_t t = 0; t < count; ++t) {
    std::array<Corner, 3> c;
    std::memcpy(c.data(), bytes.data() + 84 + 50ull * t + 12, 36);
    const auto [a, b, d] = c;
    six += double(a[0]) * (double(b[1]) * d[2] - double(b[2]) * d[1]) +
           double(a[1]) * (double(b[2]) * d[0] - double(b[0]) * d[2]) +
           double(a[2]) * (double(b[0]) * d[1] - double(b[1]) * d[0]);
    for (int k = 0; k < 3; ++k) {
      ++edges[{c[k], c[(k + 1) % 3]}];
      --edges[{c[(k + 1) % 3], c[k]}];
    }
  }
  bool closed = count > 0;
  for (const auto& [edge, balance] : edges) closed = closed && balance == 0;
  return {six / 6, closed};
}

/// Nodes and weights for the interval from -1 to 1; exact for polynomials of degree 47.
struct GaussRule {
  static constexpr int count = 24;
  math_Vector nodes{1, count}, weights{1, count};
  GaussRule() {
    math::GaussPoints(count, nodes);
    math::GaussWeights(count, weights);
  }
  template <class Function>
  double operator()(double from, double to, const Function& f) const {
    double sum = 0;
    for (int i = 1; i <= count; ++i) sum += weights(i) * f((from + to) / 2 + (to - from) / 2 * nodes(i));
    return sum * (to - from) / 2;
  }
};

/// A third of the flux of x - origin through a planar face: by Stokes' theorem from its edges.
double planarThird(const TopoDS_Face& face, const BRepAdaptor_Surface& surface, const gp_Pnt& origin) {
  static const GaussRule rule;
  const gp_Pln plane = surface.Plane();
  gp_Vec twice;  // the vector area
  for (TopExp_Explorer e(face.Oriented(TopAbs_FORWARD), TopAbs_EDGE); e.More(); e.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(e.Current());
    const BRepAdaptor_Curve curve(edge);
    TColStd_Array1OfReal breaks(1, curve.NbIntervals(GeomAbs_CN) + 1);
    curve.Intervals(breaks, GeomAbs_CN);
    for (int axis = 1; axis <= 3; ++axis)
      for (int i = 1; i < breaks.Length(); ++i) {
        const double part = rule(breaks(i), breaks(i + 1), [&](double t) {
          gp_Pnt p;
          gp_Vec d;
          curve.D1(t, p, d);
          return gp_Vec(plane.Location(), p).Crossed(d).Coord(axis);
        });
        twice.SetCoord(axis, twice.Coord(axis) + (edge.Orientation() == TopAbs_REVERSED ? -part : part));
      }
  }
  return twice.Dot(gp_Vec(origin, plane.Location())) / 6;
}

/// The same of a face that is a whole surface, as those of sweeps are.
double wholeThird(const BRepAdaptor_Surface& surface, const gp_Pnt& origin) {
  static const GaussRule rule;
  TColStd_Array1OfReal us(1, surface.NbUIntervals(GeomAbs_CN) + 1), vs(1, surface.NbVIntervals(GeomAbs_CN) + 1);
  surface.UIntervals(us, GeomAbs_CN);
  surface.VIntervals(vs, GeomAbs_CN);
  double sum = 0;
  for (int i = 1; i < us.Length(); ++i)
    for (int j = 1; j < vs.Length(); ++j)
      sum += rule(us(i), us(i + 1), [&](double u) {
        return rule(vs(j), vs(j + 1), [&](double v) {
          gp_Pnt p;
          gp_Vec du, dv;
          surface.D1(u, v, p, du, dv);
          return gp_Vec(origin, p).Dot(du.Crossed(dv));
        });
      });
  return sum / 3;
}

double volumeBySpans(const TopoDS_Shape& shape, const gp_Pnt& origin) {
  double sum = 0;
  for (TopExp_Explorer e(shape, TopAbs_FACE); e.More(); e.Next()) {
    const TopoDS_Face& face = TopoDS::Face(e.Current());
    const BRepAdaptor_Surface surface(face);
    const double third =
        surface.GetType() == GeomAbs_Plane ? planarThird(face, surface, origin) : wholeThird(surface, origin);
    sum += face.Orientation() == TopAbs_REVERSED ? -third : third;
  }
  return sum;
}

}  // namespace

int main(int argc, char** argv) {
  if (argc != 2 && argc != 4) {
    std::cerr << "check_solid SOLID.step MESH.stl DEFLECTION, or check_solid SWEEP.step\n";
    return 2;
  }
  std::cout.setstate(std::ios::failbit);  // OCCT talks on stdout
  STEPControl_Reader reader;
  const bool read = reader.ReadFile(argv[1]) == IFSelect_RetDone && reader.TransferRoots() > 0;
  std::cout.clear();
  if (!read) {
    std::cout << nlohmann::json{{"error", "cannot read STEP"}} << '\n';
    return 1;
  }
  const TopoDS_Shape shape = reader.OneShape();
  GProp_GProps volume, area;
  BRepGProp::VolumePropertiesGK(shape, volume, 1e-6, true);
  BRepGProp::SurfaceProperties(shape, area, 1e-6);
  int solids = 0;
  bool closed = true;
  for (TopExp_Explorer e(shape, TopAbs_SOLID); e.More(); e.Next(), ++solids)
    for (TopExp_Explorer s(e.Current(), TopAbs_SHELL); s.More(); s.Next())
      closed = closed && BRep_Tool::IsClosed(s.Current());
  nlohmann::json told{{"solids", solids},
                      {"valid", solids > 0 && closed && volume.Mass() > 0 && BRepCheck_Analyzer(shape).IsValid()},
                      {"volume", volume.Mass()}};
  if (argc == 2) {
    told["volume_by_spans"] = volumeBySpans(shape, volume.CentreOfMass());
  } else {
    const auto [meshVolume, meshClosed] = binaryStl(argv[2]);
    const double bound = area.Mass() * std::stod(argv[3]);
    told["mesh_volume"] = meshVolume;
    told["mesh_closed"] = meshClosed;
    told["volume_ratio"] = meshClosed ? std::abs(volume.Mass() - meshVolume) / bound : 1e9;
  }
  std::cout << told << '\n';
  return 0;
}
