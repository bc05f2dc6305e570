#include "geometry/crossing/smooth_sheets.h"

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <Eigen/Dense>
#include <algorithm>
#include <cmath>
#include <utility>

#include "geometry/numeric/boxes.h"
#include "geometry/occt/occt_vector.h"

namespace blossom {
namespace {

using Row4 = Eigen::Matrix<double, 3, 4>;

Vec3 normalOfFrame(const SurfaceFrame& f) {
  const Vec3 normal = f.du.cross(f.dv);
  const double length = normal.norm(), scale = std::max(f.du.squaredNorm(), f.dv.squaredNorm());
  return length > 1e-9 * scale ? Vec3(normal / length) : Vec3(Vec3::Zero());
}

/// Whether the ends of a surface in one direction are one curve, asked at a few places along it.
bool endsMeet(const Surface& surface, std::pair<double, double> ends, std::pair<double, double> along, bool inU) {
  constexpr int places = 8;
  constexpr double same = 1e-9;  // of what the places span
  Box3 box;
  double gap = 0;
  for (int k = 0; k <= places; ++k) {
    const double t = along.first + (along.second - along.first) * k / places;
    const Vec3 p = inU ? point(surface, ends.first, t) : point(surface, t, ends.first),
               q = inU ? point(surface, ends.second, t) : point(surface, t, ends.second),
               middle = inU ? point(surface, (ends.first + ends.second) / 2, t)
                            : point(surface, t, (ends.first + ends.second) / 2);
    gap = std::max(gap, (q - p).norm());
    box.extend(p).extend(q).extend(middle);
  }
  return gap <= same * box.diagonal().norm();
}

double inverseOf(double speed) { return speed > 0 ? 1 / speed : 0; }

}  // namespace

SmoothSheets::SmoothSheets(const Surface& surface) : surface_(&surface) {
  const auto u = surface.domainU(), v = surface.domainV();
  closures_ = {{Closure{endsMeet(surface, u, v, true), false, u.first, u.second},
                Closure{endsMeet(surface, v, u, false), false, v.first, v.second}}};
}

SmoothSheets::SmoothSheets(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  faces_.reserve(static_cast<std::size_t>(faces.Extent()));
  for (int i = 1; i <= faces.Extent(); ++i) faces_.emplace_back(TopoDS::Face(faces(i)), Standard_False);
  closures_.reserve(faces_.size());
  for (const BRepAdaptor_Surface& face : faces_)
    closures_.push_back({Closure{face.IsUClosed() == Standard_True, face.IsUPeriodic() == Standard_True,
                                 face.FirstUParameter(), face.LastUParameter()},
                         Closure{face.IsVClosed() == Standard_True, face.IsVPeriodic() == Standard_True,
                                 face.FirstVParameter(), face.LastVParameter()}});
}

Vec2 SmoothSheets::withinDomain(int face, const Vec2& at) const {
  Vec2 result = at;
  for (Eigen::Index k = 0; k < 2; ++k) {
    const Closure& c = closures_[static_cast<std::size_t>(face)][static_cast<std::size_t>(k)];
    if (!c.isClosed || c.isPeriodic || (at[k] >= c.from && at[k] <= c.to)) continue;
    const double length = c.to - c.from;
    result[k] = std::clamp(at[k] - length * std::floor((at[k] - c.from) / length), c.from, c.to);
  }
  return result;
}

Vec2 SmoothSheets::apart(int face, const Vec2& a, const Vec2& b) const {
  Vec2 result = (b - a).cwiseAbs();
  for (Eigen::Index k = 0; k < 2; ++k) {
    const Closure& c = closures_[static_cast<std::size_t>(face)][static_cast<std::size_t>(k)];
    if (c.isClosed) result[k] = std::abs(std::remainder(result[k], c.to - c.from));
  }
  return result;
}

bool SmoothSheets::isInDomain(int face, const Vec2& at) const {
  const Vec2 inside = withinDomain(face, at);
  for (Eigen::Index k = 0; k < 2; ++k) {
    const Closure& c = closures_[static_cast<std::size_t>(face)][static_cast<std::size_t>(k)];
    const double slack = 1e-9 * (c.to - c.from);
    if (!c.isPeriodic && !(inside[k] >= c.from - slack && inside[k] <= c.to + slack)) return false;
  }
  return true;
}

SurfaceFrame SmoothSheets::frame(int face, const Vec2& at) const {
  if (surface_) return blossom::frame(*surface_, at.x(), at.y());
  gp_Pnt point;
  gp_Vec du, dv;
  faces_[static_cast<std::size_t>(face)].D1(at.x(), at.y(), point, du, dv);
  return {toVec(point.XYZ()), toVec(du.XYZ()), toVec(dv.XYZ())};
}

std::optional<SheetMeeting> meet(const SmoothSheets& sheets, const SheetPlace& first, const SheetPlace& second, double reach,
                                 double size) {
  constexpr int steps = 25;
  constexpr double closed = 1e-10, nearlyClosed = 1e-8;  // of the size
  SheetMeeting meeting{Vec3::Zero(), first, second, 0};
  std::optional<Vec3> start;
  for (int step = 0; step < steps; ++step) {
    const SurfaceFrame a = sheets.frame(meeting.first.face, meeting.first.at),
                       b = sheets.frame(meeting.second.face, meeting.second.at);
    const Vec3 gap = b.point - a.point;
    if (!gap.allFinite()) return {};
    meeting.point = (a.point + b.point) / 2;
    if (!start) start = meeting.point;
    if ((meeting.point - *start).norm() > reach) return {};
    const bool last = step + 1 == steps;
    if (gap.norm() <= (last ? nearlyClosed : closed) * size) {
      meeting.sine = normalOfFrame(a).cross(normalOfFrame(b)).norm();
      return meeting;
    }
    // In units of length, so that the parametrisation does not matter.
    const Vec4 inverse(inverseOf(a.du.norm()), inverseOf(a.dv.norm()), inverseOf(b.du.norm()), inverseOf(b.dv.norm()));
    Row4 jacobian;
    jacobian << a.du * inverse[0], a.dv * inverse[1], -b.du * inverse[2], -b.dv * inverse[3];
    Eigen::Matrix3d square = jacobian * jacobian.transpose();
    square.diagonal().array() += 1e-12;
    Vec4 move = jacobian.transpose() * square.ldlt().solve(gap);
    const double length = move.norm();
    if (!std::isfinite(length)) return {};
    if (length > reach / 2) move *= reach / 2 / length;
    move = move.cwiseProduct(inverse);
    meeting.first.at += move.head<2>();
    meeting.second.at += move.tail<2>();
  }
  return {};
}

}  // namespace blossom
