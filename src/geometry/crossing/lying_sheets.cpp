#include "geometry/crossing/lying_sheets.h"

#include <Eigen/Dense>
#include <array>
#include <cmath>

namespace blossom {
namespace {

constexpr double onSheet = 1e-8;  // of the size
constexpr double widerBy = 20;    // sheets that touch to a high order leave one another only farther away

double parameterStep(double radius, const Vec3& derivative) {
  const double speed = derivative.norm();
  return speed > 0 ? radius / speed : 0;
}

/// Whether a point lies on a sheet, sought by Gauss-Newton steps from a place near it.
bool liesOn(const SmoothSheets& sheets, SheetPlace place, const Vec3& p, double near) {
  constexpr int steps = 20;
  for (int step = 0; step < steps; ++step) {
    const SurfaceFrame f = sheets.frame(place.face, place.at);
    const Vec3 gap = p - f.point;
    if (!gap.allFinite()) return false;
    if (gap.norm() <= near) return sheets.isInDomain(place.face, place.at);
    Eigen::Matrix<double, 3, 2> jacobian;
    jacobian << f.du, f.dv;
    const Vec2 move = jacobian.colPivHouseholderQr().solve(gap);
    if (!move.allFinite()) return false;
    place.at = sheets.withinDomain(place.face, place.at + move);
  }
  return false;
}

/// At that distance from the meeting.
bool coverAt(const SmoothSheets& sheets, const SheetMeeting& meeting, double radius, double near) {
  const SheetPlace& from = meeting.first;
  const SurfaceFrame frame = sheets.frame(from.face, from.at);
  const double u = parameterStep(radius, frame.du), v = parameterStep(radius, frame.dv);
  if (u == 0 || v == 0) return false;
  const auto isCovered = [&](double du, double dv) {
    const Vec2 at = sheets.withinDomain(from.face, from.at + Vec2(du, dv));
    return sheets.isInDomain(from.face, at) && liesOn(sheets, meeting.second, sheets.frame(from.face, at).point, near);
  };
  constexpr std::array<std::array<double, 2>, 4> quarters{{{1, 1}, {-1, 1}, {1, -1}, {-1, -1}}};
  for (const auto& [signU, signV] : quarters)
    if (isCovered(signU * u, 0) && isCovered(0, signV * v) && isCovered(signU * u, signV * v)) return true;
  return false;
}

}  // namespace

bool lieOnEachOther(const SmoothSheets& sheets, const SheetMeeting& meeting, double radius, double size) {
  return coverAt(sheets, meeting, radius, onSheet * size) && coverAt(sheets, meeting, widerBy * radius, onSheet * size);
}

}  // namespace blossom
