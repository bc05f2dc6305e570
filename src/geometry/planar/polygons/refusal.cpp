#include "geometry/planar/polygons/refusal.h"

#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

namespace blossom::planar {
namespace {

constexpr double farthest = 1e9;  // mm

/// Every number of a segment, before anything is computed from them.
bool isFinite(const Segment& segment) {
  if (const auto* line = std::get_if<Line2>(&segment)) return line->from.allFinite() && line->to.allFinite();
  if (const auto* arc = std::get_if<Arc2>(&segment))
    return arc->center.allFinite() && std::isfinite(arc->radius) && std::isfinite(arc->start) && std::isfinite(arc->sweep);
  const auto& spline = std::get<Spline2>(segment);
  return std::all_of(spline.poles.begin(), spline.poles.end(), [](const Vec3& pole) { return pole.allFinite(); }) &&
         std::all_of(spline.knots.begin(), spline.knots.end(), [](double knot) { return std::isfinite(knot); });
}

}  // namespace

std::string at(const Vec2& p) { return fmt::format("({:.6g}, {:.6g})", p.x(), p.y()); }

void refuse(ErrorCode code, const std::string& name, const std::string& what, const std::string& remedy) {
  std::string sentence = fmt::format("{} {}", name, what);
  sentence.front() = static_cast<char>(std::toupper(static_cast<unsigned char>(sentence.front())));
  throw Error(code, sentence, remedy);
}

std::string smallerTolerance(double most) {
  constexpr double share = 0.95;  // two digits may be 5 % more than the number
  return fmt::format("Give a tolerance of at most {:.2g} mm, or none.", share * most);
}

void refuseWhatIsNoNumber(const Path& path, const std::string& pathName, const std::string& name) {
  for (std::size_t i = 0; i < path.segments.size(); ++i)
    if (!isFinite(path.segments[i]))
      refuse(ErrorCode::InvalidInput, name,
             fmt::format("has coordinates that are not numbers, in segment {} of {}.", i + 1, pathName),
             "Draw that segment anew, or repair the file.");
}

void refuseFarAway(const Vec2& p, const std::string& name) {
  if (p.cwiseAbs().maxCoeff() > farthest)
    refuse(ErrorCode::LimitExceeded, name, fmt::format("reaches {}, farther than 1e9 mm from the origin.", at(p)),
           "Check the unit of the drawing, or move it to the origin.");
}

}  // namespace blossom::planar
