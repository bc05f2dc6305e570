#include "kernel/begin/curve_chain.h"

#include <fmt/format.h>

#include <algorithm>
#include <limits>

#include "core/error.h"
#include "geometry/bspline/bspline.h"

namespace blossom::sweep {

namespace {

Vec3 placeOf(const Vec4& pole) { return pole.head<3>() / pole.w(); }

double polygonLength(const Curve& curve) {
  double sum = 0;
  for (std::size_t i = 1; i < curve.poles.size(); ++i) sum += (placeOf(curve.poles[i]) - placeOf(curve.poles[i - 1])).norm();
  return sum;
}

/// Appends a clamped part of the same degree; its first pole is the last one there is.
void appendPart(Curve& chain, const Curve& part, double length) {
  const auto degree = static_cast<std::size_t>(chain.degree);
  const auto [from, to] = part.domain();
  const double start = chain.knots.empty() ? 0 : chain.knots.back(), step = length / (to - from);
  if (chain.knots.empty()) chain.knots.assign(degree + 1, 0.0);
  for (std::size_t i = degree + 1; i + degree + 1 < part.knots.size(); ++i)
    chain.knots.push_back(start + step * (part.knots[i] - from));
  chain.knots.insert(chain.knots.end(), degree, start + length);
  const double scale = chain.poles.empty() ? 1 : chain.poles.back().w() / part.poles.front().w();
  for (std::size_t i = chain.poles.empty() ? 0 : 1; i < part.poles.size(); ++i) chain.poles.push_back(scale * part.poles[i]);
}

Vec3 startOf(const Curve& curve) { return placeOf(clamped(curve).poles.front()); }
Vec3 endOf(const Curve& curve) { return placeOf(clamped(curve).poles.back()); }

/// From a place to the nearest end of another part.
double distanceToOthers(const Vec3& place, std::size_t owner, std::span<const Curve> parts) {
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < parts.size(); ++k)
    if (k != owner) nearest = std::min({nearest, (startOf(parts[k]) - place).norm(), (endOf(parts[k]) - place).norm()});
  return nearest;
}

/// Puts a part first that begins at a free end, farther than `gap` from all others; of several the one from whose other end
/// the way goes on most nearly.
void beginAtFreeEnd(std::vector<Curve>& parts, double gap) {
  std::size_t first = 0;
  bool turned = false;
  double nearest = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < parts.size(); ++k) {
    const double fromStart = distanceToOthers(startOf(parts[k]), k, parts),
                 fromEnd = distanceToOthers(endOf(parts[k]), k, parts);
    for (const bool turns : {false, true}) {
      const double begin = turns ? fromEnd : fromStart, on = turns ? fromStart : fromEnd;
      if (begin <= gap || on >= nearest) continue;
      nearest = on;
      first = k;
      turned = turns;
    }
  }
  if (turned) parts[first] = turnedRound(parts[first]);
  std::swap(parts.front(), parts[first]);
}

}  // namespace

Curve turnedRound(const Curve& curve) {
  Curve result = curve;
  const auto [from, to] = curve.domain();
  std::reverse(result.poles.begin(), result.poles.end());
  for (std::size_t i = 0; i < curve.knots.size(); ++i)
    result.knots[i] = from + (to - curve.knots[curve.knots.size() - 1 - i]);
  return result;
}

std::vector<Curve> inOrder(std::vector<Curve> parts, double gap) {
  if (parts.size() < 2) return parts;
  beginAtFreeEnd(parts, gap);
  for (std::size_t next = 1; next < parts.size(); ++next) {
    const Vec3 place = endOf(parts[next - 1]);
    const auto distance = [&](const Curve& each) {
      return std::min((startOf(each) - place).norm(), (endOf(each) - place).norm());
    };
    const auto rest = parts.begin() + static_cast<std::ptrdiff_t>(next);
    std::iter_swap(rest, std::min_element(rest, parts.end(),
                                          [&](const Curve& a, const Curve& b) { return distance(a) < distance(b); }));
    if ((endOf(*rest) - place).norm() < (startOf(*rest) - place).norm()) *rest = turnedRound(*rest);
  }
  return parts;
}

Curve chained(std::span<const Curve> parts, double gap) {
  if (parts.empty()) throw Error(ErrorCode::InvalidInput, "There are no parts of a curve to join.");
  Curve chain;
  for (const Curve& part : parts) chain.degree = std::max(chain.degree, part.degree);
  double total = 0;
  for (const Curve& part : parts) total += polygonLength(part);
  if (!(total > 0)) throw Error(ErrorCode::Degenerate, "The curve is a single point.", "Give a curve that has a length.");
  for (const Curve& part : parts) {
    const Curve same = part.degree < chain.degree ? elevateDegree(part, chain.degree - part.degree) : clamped(part);
    const double length = polygonLength(part) / total;
    if (!(length > 0)) continue;
    if (!chain.poles.empty()) {
      const Vec3 end = placeOf(chain.poles.back());
      const double distance = (placeOf(same.poles.front()) - end).norm();
      if (distance > gap)
        throw Error(ErrorCode::InvalidInput,
                    fmt::format("The parts of the curve lie {:.3g} mm apart at ({:.6g}, {:.6g}, {:.6g}).", distance, end.x(),
                                end.y(), end.z()),
                    "Join them first; of edges, choose those between as well.");
    }
    appendPart(chain, same, length);
  }
  const double end = chain.knots.back();
  for (double& knot : chain.knots) knot = knot == end ? 1 : knot / end;
  chain.knots.push_back(1);
  const Vec3 start = placeOf(chain.poles.front());
  Vec4& last = chain.poles.back();
  if ((placeOf(last) - start).norm() <= gap) last.head<3>() = last.w() * start;
  return chain;
}

}  // namespace blossom::sweep
