#include "geometry/shape/soundness.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "geometry/bspline/bspline.h"
#include "geometry/planar/planar.h"

namespace blossom {
namespace {

std::string asText(const Vec2& p) { return fmt::format("({:.6g}, {:.6g})", p.x(), p.y()); }

std::string flawOf(const Line2& s) { return s.from.allFinite() && s.to.allFinite() ? "" : "an end is not a number"; }

std::string flawOf(const Arc2& s) {
  if (!s.center.allFinite() || !std::isfinite(s.radius) || !std::isfinite(s.start) || !std::isfinite(s.sweep))
    return "centre, radius or angle is not a number";
  return s.radius < 0 ? "its radius is negative" : "";
}

/// Of a spline by what `validate` says; a sentence there, a clause here.
template <class Spline>
std::string flawOfSpline(const Spline& spline) {
  try {
    validate(spline);
  } catch (const Error& e) {
    std::string why = e.message();
    if (why.ends_with('.')) why.pop_back();
    return "of its spline: " + why;
  }
  return {};
}

std::string flawOf(const Spline2& s) {
  if (std::any_of(s.poles.begin(), s.poles.end(), [](const Vec3& pole) { return !pole.allFinite(); }))
    return "a pole of its spline is not a number";
  if (std::any_of(s.poles.begin(), s.poles.end(), [](const Vec3& pole) { return pole.z() <= 0; }))
    return "a pole of its spline has no positive weight";
  return flawOfSpline(toCurve(s));
}

std::string flawOf(const std::vector<Path>& paths, const char* what) {
  for (std::size_t k = 0; k < paths.size(); ++k) {
    if (paths[k].segments.empty()) return fmt::format("{} {} has no segments", what, k + 1);
    for (std::size_t i = 0; i < paths[k].segments.size(); ++i) {
      const std::string flaw = std::visit([](const auto& segment) { return flawOf(segment); }, paths[k].segments[i]);
      if (!flaw.empty()) return fmt::format("segment {} of {} {} is broken, {}", i + 1, what, k + 1, flaw);
    }
  }
  return {};
}

struct FlawOf {
  std::string operator()(std::monostate) const { return {}; }
  std::string operator()(const Region& region) const {
    if (std::string flaw = flawOf(region.loops, "loop"); !flaw.empty()) return flaw;
    for (std::size_t k = 0; k < region.loops.size(); ++k)
      if (const Path& loop = region.loops[k]; !loop.closed)
        return fmt::format("loop {} is open, it runs from {} to {}", k + 1, asText(startPoint(loop)),
                           asText(endPoint(loop)));
    return {};
  }
  std::string operator()(const Curves& curves) const { return flawOf(curves.paths, "path"); }
  std::string operator()(const Curve& curve) const { return flawOfSpline(curve); }
  std::string operator()(const Surface& surface) const { return flawOfSpline(surface); }
  std::string operator()(const Brep& brep) const { return brep.shape().IsNull() ? "it holds no face, edge or point" : ""; }
  std::string operator()(const Mesh& mesh) const {
    for (std::size_t i = 0; i < mesh.points.size(); ++i)
      if (!mesh.points[i].allFinite()) return fmt::format("a coordinate of point {} is not a number", i + 1);
    const int count = static_cast<int>(mesh.points.size());
    for (std::size_t f = 0; f < mesh.faceCount(); ++f)
      for (const int v : mesh.face(f))
        if (v < 0 || v >= count)
          return fmt::format("face {} asks for point {}, and there are {} points", f + 1, v + 1, count);
    return {};
  }
  std::string operator()(const Motion&) const { return {}; }  // the sweep made from it reports defects with their place
  std::string operator()(const Sequence& sequence) const {
    for (std::size_t k = 0; k < sequence.frames.size(); ++k)
      if (const std::string flaw = unsoundness(sequence.frames[k]); !flaw.empty())
        return fmt::format("of frame {}: {}", k + 1, flaw);
    return {};
  }
  std::string operator()(const MedialAxis&) const { return {}; }  // only ever computed
  std::string operator()(const Setup& setup) const {
    for (const auto* shapes : {&setup.part, &setup.stock})
      for (const Shape& shape : *shapes)
        if (std::string flaw = unsoundness(shape); !flaw.empty()) return flaw;
    return {};
  }
  std::string operator()(const Toolpath& path) const {
    if (!path.start.allFinite()) return "its start is not a number";
    for (std::size_t i = 0; i < path.moves.size(); ++i)
      if (!path.moves[i].to.allFinite() || !path.moves[i].center.allFinite() || !std::isfinite(path.moves[i].feed))
        return fmt::format("move {} holds something that is not a number", i + 1);
    return {};
  }
};

}  // namespace

std::string unsoundness(const Shape& shape) { return shape.visit(FlawOf()); }

}  // namespace blossom
