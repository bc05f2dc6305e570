#pragma once
#include <BRep_Tool.hxx>
#include <Geom_BSplineSurface.hxx>
#include <IGESControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Face.hxx>
#include <algorithm>
#include <array>
#include <cmath>
#include <fstream>
#include <iostream>
#include <nlohmann/json.hpp>
#include <random>
#include <stdexcept>
#include <string>
#include <vector>

/// Checks an exported sweep against its motion file. Shares no code with Blossom: it reads the JSON itself, evaluates M(u,v)
/// p by the matrix printed in Yoon & Lee 2009, section 3 (r21 with the factor 2 that the paper lost), and reads the file
/// with OCCT.
namespace sweep_checker {

using Four = std::array<double, 4>;
using Three = std::array<double, 3>;

/// N_i,p(t) by the recursion of Cox and de Boor, all of them; the last span counts as closed.
inline std::vector<double> allBasisFunctions(int degree, const std::vector<double>& knots, double t) {
  const std::size_t last = knots.size() - 1;
  std::vector<double> n(last, 0.0);
  const double end = knots[last - static_cast<std::size_t>(degree)];
  for (std::size_t i = 0; i < last; ++i)
    n[i] = (knots[i] <= t && t < knots[i + 1]) || (t == end && knots[i] < end && knots[i + 1] == end) ? 1 : 0;
  for (int p = 1; p <= degree; ++p)
    for (std::size_t i = 0; i + static_cast<std::size_t>(p) < last; ++i) {
      const std::size_t far = i + static_cast<std::size_t>(p);
      const double a = knots[far] > knots[i] ? (t - knots[i]) / (knots[far] - knots[i]) : 0;
      const double b = knots[far + 1] > knots[i + 1] ? (knots[far + 1] - t) / (knots[far + 1] - knots[i + 1]) : 0;
      n[i] = a * n[i] + b * n[i + 1];
    }
  n.resize(last - static_cast<std::size_t>(degree));
  return n;
}

struct Factor {
  int degreeU = 0, degreeV = 0;
  std::vector<double> knotsU, knotsV;
  std::vector<std::vector<Four>> poles;  // [u][v]

  [[nodiscard]] Four at(double u, double v) const {
    const auto nu = allBasisFunctions(degreeU, knotsU, u), nv = allBasisFunctions(degreeV, knotsV, v);
    Four sum{};
    for (std::size_t i = 0; i < poles.size(); ++i)
      for (std::size_t j = 0; nu[i] != 0 && j < poles[i].size(); ++j)
        for (std::size_t c = 0; c < 4; ++c) sum[c] += nu[i] * nv[j] * poles[i][j][c];
    return sum;
  }
};

class MotionFile {
 public:
  explicit MotionFile(const std::string& path) {
    const auto json = nlohmann::json::parse(std::ifstream(path));
    const auto& t = json.at("trajectory");
    degree_ = t.at("degree");
    knots_ = t.at("knots").get<std::vector<double>>();
    points_ = t.at("poles").get<std::vector<Three>>();
    weights_ = t.contains("weights") ? t.at("weights").get<std::vector<double>>() : std::vector<double>(points_.size(), 1.0);
    const std::string closed =
        json.at("orientation").contains("closed_u") && json.at("orientation").at("closed_u").is_string()
            ? json.at("orientation").at("closed_u").get<std::string>()
            : std::string();
    orientation_ = read(json.at("orientation"), closed.empty() ? 0 : closed == "anti-periodic" ? -1 : 1);
    scaling_ = read(json.at("scaling"), closed.empty() ? 0 : 1);
    p_ = json.at("point").get<Three>();
  }

  [[nodiscard]] double u0() const { return orientation_.knotsU[static_cast<std::size_t>(orientation_.degreeU)]; }
  [[nodiscard]] double u1() const { return *(orientation_.knotsU.rbegin() + orientation_.degreeU); }
  [[nodiscard]] double v0() const { return knots_.front(); }
  [[nodiscard]] double v1() const { return knots_.back(); }
  [[nodiscard]] int degreeU() const { return 2 * orientation_.degreeU + scaling_.degreeU; }
  [[nodiscard]] int degreeV() const { return degree_ + 2 * orientation_.degreeV + scaling_.degreeV; }

  /// The printed matrix, column by column, times (px, py, pz, 1).
  [[nodiscard]] Three point(double u, double v) const {
    const auto n = allBasisFunctions(degree_, knots_, v);
    double tx = 0, ty = 0, tz = 0, tw = 0;
    for (std::size_t j = 0; j < points_.size(); ++j) {
      const double w = n[j] * weights_[j];
      tx += w * points_[j][0], ty += w * points_[j][1], tz += w * points_[j][2], tw += w;
    }
    const auto [rw, rx, ry, rz] = orientation_.at(u, v);
    const auto [sx, sy, sz, sw] = scaling_.at(u, v);
    const double delta = rw * rw + rx * rx + ry * ry + rz * rz;
    const double r11 = rw * rw + rx * rx - ry * ry - rz * rz, r12 = 2 * (rx * ry - rw * rz), r13 = 2 * (rx * rz + rw * ry);
    const double r21 = 2 * (rx * ry + rw * rz), r22 = rw * rw - rx * rx + ry * ry - rz * rz, r23 = 2 * (ry * rz - rw * rx);
    const double r31 = 2 * (rx * rz - rw * ry), r32 = 2 * (ry * rz + rw * rx), r33 = rw * rw - rx * rx - ry * ry + rz * rz;
    const double x = sx * tw * r11 * p_[0] + sy * tw * r12 * p_[1] + sz * tw * r13 * p_[2] + sw * tx * delta;
    const double y = sx * tw * r21 * p_[0] + sy * tw * r22 * p_[1] + sz * tw * r23 * p_[2] + sw * ty * delta;
    const double z = sx * tw * r31 * p_[0] + sy * tw * r32 * p_[1] + sz * tw * r33 * p_[2] + sw * tz * delta;
    const double w = sw * tw * delta;
    return {x / w, y / w, z / w};
  }

 private:
  static Factor read(const nlohmann::json& json, int sign) {
    Factor factor{json.at("degree").at(0), json.at("degree").at(1), json.at("knots").at(0), json.at("knots").at(1),
                  json.at("poles")};
    if (sign == 0) return factor;
    const std::size_t n = factor.poles.size(), p = static_cast<std::size_t>(factor.degreeU);
    if (factor.knotsU.size() == n + 1) {
      const std::vector<double> one = factor.knotsU;
      const double period = one[n] - one[0];
      factor.knotsU.clear();
      for (std::size_t i = n - p; i < n; ++i) factor.knotsU.push_back(one[i] - period);
      factor.knotsU.insert(factor.knotsU.end(), one.begin(), one.end());
      for (std::size_t i = 1; i <= p; ++i) factor.knotsU.push_back(one[i] + period);
    }
    for (std::size_t i = 0; i < p; ++i) {
      factor.poles.push_back(factor.poles[i]);
      for (Four& pole : factor.poles.back())
        for (double& c : pole) c *= sign;
    }
    return factor;
  }

  int degree_ = 0;
  std::vector<double> knots_, weights_;
  std::vector<Three> points_;
  Factor orientation_, scaling_;
  Three p_{};
};

/// The B-spline surface of highest degree in a STEP or IGES file, placed.
inline Handle(Geom_BSplineSurface) readSurface(const std::string& path) {
  std::cout.setstate(std::ios::failbit);  // OCCT talks on stdout
  const bool iges = path.ends_with(".igs") || path.ends_with(".iges");
  STEPControl_Reader step;
  IGESControl_Reader igs;
  XSControl_Reader& reader = iges ? static_cast<XSControl_Reader&>(igs) : static_cast<XSControl_Reader&>(step);
  const bool read = reader.ReadFile(path.c_str()) == IFSelect_RetDone && reader.TransferRoots() > 0;
  std::cout.clear();
  if (!read) throw std::runtime_error("OCCT cannot read " + path);
  Handle(Geom_BSplineSurface) found;
  for (TopExp_Explorer faces(reader.OneShape(), TopAbs_FACE); faces.More(); faces.Next()) {
    const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(faces.Current())));
    if (!surface.IsNull() &&
        (found.IsNull() || surface->UDegree() + surface->VDegree() > found->UDegree() + found->VDegree()))
      found = surface;
  }
  if (found.IsNull()) throw std::runtime_error("no B-spline surface in " + path);
  return found;
}

/// Largest distance between the surface and M(u,v) p at `count` random parameters and the four corners.
inline double largestError(const MotionFile& motion, const Geom_BSplineSurface& surface, int count,
                           std::mt19937_64& random) {
  std::uniform_real_distribution<double> u(motion.u0(), motion.u1()), v(motion.v0(), motion.v1());
  double largest = 0;
  const auto compare = [&](double a, double b) {
    const Three wanted = motion.point(a, b);
    const double error = surface.Value(a, b).Distance(gp_Pnt(wanted[0], wanted[1], wanted[2]));
    largest = std::isfinite(error) ? std::max(largest, error) : 1e300;
  };
  for (const double a : {motion.u0(), motion.u1()})
    for (const double b : {motion.v0(), motion.v1()}) compare(a, b);
  for (int i = 0; i < count; ++i) compare(u(random), v(random));
  return largest;
}

}  // namespace sweep_checker
