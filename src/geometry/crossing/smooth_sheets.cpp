#include "geometry/crossing/smooth_sheets.h"

#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <Eigen/Dense>
#include <cmath>

#include "geometry/occt/occt_vector.h"

namespace blossom {
namespace {

using Row4 = Eigen::Matrix<double, 3, 4>;

Vec3 normalOfFrame(const SurfaceFrame& f) {
  const Vec3 normal = f.du.cross(f.dv);
  const double length = normal.norm(), scale = std::max(f.du.squaredNorm(), f.dv.squaredNorm());
  return length > 1e-9 * scale ? Vec3(normal / length) : Vec3(Vec3::Zero());
}

double inverseOf(double speed) { return speed > 0 ? 1 / speed : 0; }

}  // namespace

SmoothSheets::SmoothSheets(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(shape, TopAbs_FACE, faces);
  faces_.reserve(static_cast<std::size_t>(faces.Extent()));
  for (int i = 1; i <= faces.Extent(); ++i) faces_.emplace_back(TopoDS::Face(faces(i)), Standard_False);
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
