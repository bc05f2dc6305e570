#include "kernel/solid/loft_predicates.h"

#include <algorithm>
#include <cmath>

namespace blossom::minkowski {
namespace {

constexpr double roundingOfSums = 1e-15;  // of a few operations, relative to the sizes of what is added

Wide512 wide(Wide w) {
  return Wide512(static_cast<std::int64_t>(w >> 64)) * (Wide512(1) << 64) + static_cast<std::uint64_t>(w);
}

int signOfWide(const Wide512& w) { return w.sign(); }

/// The largest integer not above the fraction.
std::int64_t floorOf(Wide512 over, Wide512 under) {
  if (under < 0) {
    over = -over;
    under = -under;
  }
  Wide512 quotient = over / under;
  if (over < 0 && quotient * under != over) quotient -= 1;
  return quotient.convert_to<std::int64_t>();
}

double ratio(const Wide512& over, const Wide512& under) { return over.convert_to<double>() / under.convert_to<double>(); }

std::size_t numberOf(int index) { return static_cast<std::size_t>(index); }

}  // namespace

LoftTime timeOf(Wide512 first, Wide512 second) {
  if (first + second < 0) {
    first = -first;
    second = -second;
  }
  const double t = ratio(second, first + second);
  return {std::move(first), std::move(second), t};
}

LoftTime timeOf(const LoftLevel& level) { return timeOf(Wide512(level.first), Wide512(level.second)); }

LoftTime timeOf(double t) {
  constexpr int bits = 60;
  const std::int64_t second = std::llround(std::ldexp(t, bits));
  return timeOf(LoftLevel{(std::int64_t(1) << bits) - second, second});
}

int compare(const LoftTime& a, const LoftTime& b) {
  if (std::abs(a.t - b.t) > 8 * roundingOfSums) return a.t < b.t ? -1 : 1;
  return signOfWide(a.second * b.first - b.second * a.first);
}

LoftTime between(const LoftTime& a, const LoftTime& b) {
  if (b.t - a.t > 1e-9) return timeOf((a.t + b.t) / 2);
  return timeOf(a.first + b.first, a.second + b.second);
}

LoftPredicates::LoftPredicates(std::span<const LoftFacet> facets) : facets_(facets) {
  rounded_.reserve(facets.size());
  double reach = 0;
  for (const LoftFacet& f : facets) {
    Rounded r{};
    r.alongX = static_cast<double>(f.along.x);
    r.alongY = static_cast<double>(f.along.y);
    for (const std::size_t end : {0, 1}) {
      r.offset[end] = static_cast<double>(f.offset[end]);
      r.fromX[end] = static_cast<double>(f.from[end].x);
      r.fromY[end] = static_cast<double>(f.from[end].y);
      r.toX[end] = static_cast<double>(f.to[end].x);
      r.toY[end] = static_cast<double>(f.to[end].y);
    }
    rounded_.push_back(r);
    for (const double* of : {r.fromX, r.fromY, r.toX, r.toY}) reach = std::max({reach, std::abs(of[0]), std::abs(of[1])});
  }
  for (Rounded& r : rounded_) r.bound = 16 * roundingOfSums * (std::abs(r.alongX) + std::abs(r.alongY)) * reach;
}

int LoftPredicates::turn(int i, int j) const {
  const Wide w = cross(facets_[numberOf(i)].along, facets_[numberOf(j)].along);
  return w > 0 ? 1 : w < 0 ? -1 : 0;
}

LoftRamp LoftPredicates::sideRamp(int i, int k, int end) const {
  const Rounded &line = rounded_[numberOf(i)], &f = rounded_[numberOf(k)];
  LoftRamp ramp;
  for (const std::size_t t : {0, 1}) {
    const double x = end == 0 ? f.fromX[t] : f.toX[t], y = end == 0 ? f.fromY[t] : f.toY[t];
    ramp.at[t] = line.alongX * y - line.alongY * x - line.offset[t];
    ramp.error[t] = roundingOfSums * (std::abs(line.alongX * y) + std::abs(line.alongY * x) + std::abs(line.offset[t]));
  }
  return ramp;
}

LoftPredicates::ExactRamp LoftPredicates::exactSide(int i, int k, int end) const {
  const LoftFacet &line = facets_[numberOf(i)], &f = facets_[numberOf(k)];
  ExactRamp ramp;
  for (const std::size_t t : {0, 1}) ramp[t] = wide(cross(line.along, end == 0 ? f.from[t] : f.to[t]) - line.offset[t]);
  return ramp;
}

LoftRamp LoftPredicates::meetingRamp(int i, int j, int k) const {
  const LoftFacet &a = facets_[numberOf(i)], &b = facets_[numberOf(j)], &c = facets_[numberOf(k)];
  const double bc = static_cast<double>(cross(b.along, c.along)), ca = static_cast<double>(cross(c.along, a.along)),
               ab = static_cast<double>(cross(a.along, b.along));
  LoftRamp ramp;
  for (const std::size_t t : {0, 1}) {
    const double x = rounded_[numberOf(i)].offset[t] * bc, y = rounded_[numberOf(j)].offset[t] * ca,
                 z = rounded_[numberOf(k)].offset[t] * ab;
    ramp.at[t] = -(x + y + z);
    ramp.error[t] = roundingOfSums * (std::abs(x) + std::abs(y) + std::abs(z));
  }
  return ramp;
}

LoftPredicates::ExactRamp LoftPredicates::exactMeeting(int i, int j, int k) const {
  const LoftFacet &a = facets_[numberOf(i)], &b = facets_[numberOf(j)], &c = facets_[numberOf(k)];
  const Wide512 bc = wide(cross(b.along, c.along)), ca = wide(cross(c.along, a.along)), ab = wide(cross(a.along, b.along));
  ExactRamp ramp;
  for (const std::size_t t : {0, 1}) ramp[t] = -(wide(a.offset[t]) * bc + wide(b.offset[t]) * ca + wide(c.offset[t]) * ab);
  return ramp;
}

LoftRamp LoftPredicates::distanceRamp(int i, int j) const {
  const Rounded &a = rounded_[numberOf(i)], &b = rounded_[numberOf(j)];
  const bool flat = std::abs(a.alongX) > std::abs(a.alongY);
  const double ofA = flat ? a.alongX : a.alongY, ofB = flat ? b.alongX : b.alongY;
  LoftRamp ramp;
  for (const std::size_t t : {0, 1}) {
    ramp.at[t] = ofA * b.offset[t] - ofB * a.offset[t];
    ramp.error[t] = roundingOfSums * (std::abs(ofA * b.offset[t]) + std::abs(ofB * a.offset[t]));
  }
  return ramp;
}

LoftPredicates::ExactRamp LoftPredicates::exactDistance(int i, int j) const {
  const LoftFacet &a = facets_[numberOf(i)], &b = facets_[numberOf(j)];
  const bool flat = std::abs(a.along.x) > std::abs(a.along.y);
  const Wide512 ofA = flat ? a.along.x : a.along.y, ofB = flat ? b.along.x : b.along.y;
  ExactRamp ramp;
  for (const std::size_t t : {0, 1}) ramp[t] = ofA * wide(b.offset[t]) - ofB * wide(a.offset[t]);
  return ramp;
}

int LoftPredicates::closeSide(int i, int k, int end, const LoftTime& time) const {
  if (const int known = sideRamp(i, k, end).signAt(time.t, 4 * roundingOfSums)) return known;
  const ExactRamp ramp = exactSide(i, k, end);
  return signOfWide(time.first * ramp[0] + time.second * ramp[1]);
}

int LoftPredicates::sideOfMeeting(int i, int j, int k, const LoftTime& time) const {
  const int turned = turn(i, j);
  if (const int known = meetingRamp(i, j, k).signAt(time.t, 4 * roundingOfSums)) return known * turned;
  const ExactRamp ramp = exactMeeting(i, j, k);
  return signOfWide(time.first * ramp[0] + time.second * ramp[1]) * turned;
}

int LoftPredicates::ahead(int i, int k, int endOfK, int m, int endOfM, const LoftTime& time) const {
  const LoftFacet &line = facets_[numberOf(i)], &f = facets_[numberOf(k)], &g = facets_[numberOf(m)];
  ExactRamp ramp;
  for (const std::size_t t : {0, 1})
    ramp[t] = wide(dot(line.along, (endOfK == 0 ? f.from[t] : f.to[t]) - (endOfM == 0 ? g.from[t] : g.to[t])));
  return signOfWide(time.first * ramp[0] + time.second * ramp[1]);
}

Wide512 LoftPredicates::offsetAt(int i, const LoftTime& time) const {
  return time.first * wide(facets_[numberOf(i)].offset[0]) + time.second * wide(facets_[numberOf(i)].offset[1]);
}

namespace {

constexpr int placeBits = 12, heightBits = 60;

std::int64_t heightOf(const LoftTime& time) { return floorOf(time.second << heightBits, time.first + time.second); }

Wide512 shifted(const Wide512& w) { return w * (1 << placeBits); }

}  // namespace

LoftPredicates::Place LoftPredicates::placeOfMeeting(int i, int j, const LoftTime& time) const {
  const LoftFacet &a = facets_[numberOf(i)], &b = facets_[numberOf(j)];
  const Wide512 ofA = offsetAt(i, time), ofB = offsetAt(j, time);
  const Wide512 under = wide(cross(a.along, b.along)) * (time.first + time.second);
  return {floorOf(shifted(ofA * b.along.x - ofB * a.along.x), under),
          floorOf(shifted(ofA * b.along.y - ofB * a.along.y), under), heightOf(time)};
}

LoftPredicates::Place LoftPredicates::placeOfEnd(int k, int end, const LoftTime& time) const {
  const LoftFacet& f = facets_[numberOf(k)];
  const auto& p = end == 0 ? f.from : f.to;
  const Wide512 under = time.first + time.second;
  return {floorOf(shifted(time.first * p[0].x + time.second * p[1].x), under),
          floorOf(shifted(time.first * p[0].y + time.second * p[1].y), under), heightOf(time)};
}

}  // namespace blossom::minkowski
