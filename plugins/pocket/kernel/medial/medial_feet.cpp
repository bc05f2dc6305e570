#include "kernel/medial/medial_feet.h"

#include <algorithm>

#include "kernel/medial/contact.h"

namespace blossom::pocket {

namespace {

/// The last piece of a piece's curve, forwards or backwards. A closed curve ends where it begins anew.
std::size_t lastOfCurve(const Boundary& boundary, std::size_t piece, bool forwards) {
  const auto& pieces = boundary.pieces();
  const auto after = [&](std::size_t i) { return forwards ? pieces[i].next : pieces[i].previous; };
  for (std::size_t i = after(piece); pieces[i].curve == pieces[piece].curve; i = after(i)) {
    if ((pieces[i].t0 > pieces[piece].t0) != forwards) break;
    piece = i;
  }
  return piece;
}

}  // namespace

BoundaryFoot footAt(const Boundary& boundary, std::size_t curve, double parameter) {
  const CurveSource& source = boundary.sources()[curve];
  const double t = std::clamp(parameter, 0.0, 1.0);
  return {source.loop, source.segment, source.from + t * (source.to - source.from), boundary.curves()[curve].point(t)};
}

BoundaryFoot footOf(const Boundary& boundary, const Site& site, const Vec2& x) {
  const auto& pieces = boundary.pieces();
  Contact contact = contactOf(boundary, site, x);
  if (!contact.curve) return footAt(boundary, pieces[site.piece].curve, pieces[site.piece].t0);
  footOn(contact, x);
  std::size_t curve = pieces[site.piece].curve;
  double t = contact.parameter;
  const bool isAfter = t > 1;
  if (isAfter || t < 0) {
    const std::size_t last = lastOfCurve(boundary, site.piece, isAfter);
    const std::size_t beyond = isAfter ? pieces[last].next : pieces[last].previous;
    if (pieces[isAfter ? last : beyond].end == Joint::Smooth) {
      curve = pieces[beyond].curve;
      t = boundary.curves()[curve].foot(x, isAfter ? 0 : 1, 0);
    }
  }
  return footAt(boundary, curve, t);
}

}  // namespace blossom::pocket
