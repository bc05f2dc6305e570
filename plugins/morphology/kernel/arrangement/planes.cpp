#include "kernel/arrangement/planes.h"

#include <bit>
#include <utility>

namespace blossom::morphology::arrangement {

namespace {

__extension__ using Unsigned128 = unsigned __int128;

Unsigned128 magnitude(Int128 value) {
  return value < 0 ? -static_cast<Unsigned128>(value) : static_cast<Unsigned128>(value);
}

int trailingZeros(Unsigned128 value) {
  const auto low = static_cast<std::uint64_t>(value);
  return low ? std::countr_zero(low) : 64 + std::countr_zero(static_cast<std::uint64_t>(value >> 64));
}

/// By halving and subtracting (Knuth, The Art of Computer Programming, vol. 2, 4.5.2, algorithm B).
Unsigned128 greatestDivisor(Unsigned128 a, Unsigned128 b) {
  if (a == 0) return b;
  if (b == 0) return a;
  const int common = std::min(trailingZeros(a), trailingZeros(b));
  a >>= trailingZeros(a);
  while (b != 0) {
    b >>= trailingZeros(b);
    if (a > b) std::swap(a, b);
    b -= a;
  }
  return a << common;
}

/// n . p modulo 2^128
Int128 wrappedDot(const Normal3& n, const Grid3& p) {
  Unsigned128 sum = 0;
  for (std::size_t k = 0; k < 3; ++k) sum += static_cast<Unsigned128>(n[k]) * static_cast<Unsigned128>(Int128(p[k]));
  return static_cast<Int128>(sum);
}

/// Of the normal and the offset, which is n . p modulo 2^128.
std::uint64_t hashOf(const Plane& plane) {
  std::uint64_t hash = 0;
  for (const Int128 part : {plane.normal[0], plane.normal[1], plane.normal[2], wrappedDot(plane.normal, plane.point)})
    for (const auto half : {static_cast<std::uint64_t>(part), static_cast<std::uint64_t>(part >> 64)})
      hash = mixedHash(hash, half);
  return hash;
}

Bounded3 aboutNormal(const Normal3& n) { return {rounded(n[0]), rounded(n[1]), rounded(n[2])}; }

std::size_t largest(const Bounded3& n) {
  std::size_t axis = 0;
  for (std::size_t k = 1; k < 3; ++k)
    if (std::abs(n[k].value) > std::abs(n[axis].value)) axis = k;
  return axis;
}

}  // namespace

Planes::Directed Planes::directed(const Normal3& normal, const Grid3& point) {
  const auto divisor = static_cast<Int128>(
      greatestDivisor(greatestDivisor(magnitude(normal[0]), magnitude(normal[1])), magnitude(normal[2])));
  Directed made;
  made.sameWay = normal[0] > 0 || (normal[0] == 0 && (normal[1] > 0 || (normal[1] == 0 && normal[2] > 0)));
  Plane& plane = made.plane;
  for (std::size_t k = 0; k < 3; ++k) plane.normal[k] = (made.sameWay ? normal[k] : -normal[k]) / divisor;
  plane.point = point;
  plane.about = aboutNormal(plane.normal);
  plane.axis = largest(plane.about);
  plane.u = (plane.axis + 1) % 3;
  plane.v = (plane.axis + 2) % 3;
  if (plane.normal[plane.axis] < 0) std::swap(plane.u, plane.v);
  made.hash = hashOf(plane);
  return made;
}

Planes::Added Planes::add(const Directed& given) { return {insert(given.plane, given.hash), given.sameWay}; }

int Planes::find(std::uint64_t hash, const Plane& plane) const {
  if (base_)
    if (const int known = base_->find(hash, plane); known >= 0) return known;
  return index_.find(hash, [&](int number) {
    const Plane& other = (*this)[number];
    if (plane.normal != other.normal) return false;
    const Grid3 away = plane.point - other.point;
    return !dot(plane.about, exactly(away)).decided() && dot(plane.normal, away) == 0;
  });
}

int Planes::insert(const Plane& plane, std::uint64_t hash) {
  if (const int known = find(hash, plane); known >= 0) return known;
  const int made = static_cast<int>(size());
  planes_.push_back(plane);
  index_.add(hash, made);
  return made;
}

int Planes::take(const Planes& part, int plane) {
  return plane < part.first_ ? plane : insert(part[plane], hashOf(part[plane]));
}

int Planes::upright(const Grid3& from, const Grid3& to, std::size_t axis) {
  Grid3 along{};
  along[axis] = 1;
  return add(cross(to - from, along), from).plane;
}

int Planes::side(int plane, const Grid3& p) const {
  const Plane& here = (*this)[plane];
  const Grid3 from = p - here.point;
  const Bounded about = dot(here.about, exactly(from));
  return about.decided() ? signOf(about.value) : signOf(dot(here.normal, from));
}

int Planes::crossSign(int first, int second, std::size_t axis) const {
  const Plane &a = (*this)[first], &b = (*this)[second];
  const std::size_t i = (axis + 1) % 3, j = (axis + 2) % 3;
  const Bounded about = a.about[i] * b.about[j] - a.about[j] * b.about[i];
  if (about.decided()) return signOf(about.value);
  return signOf(Whole(Whole(a.normal[i]) * b.normal[j] - Whole(a.normal[j]) * b.normal[i]));
}

Planes::Line Planes::line(int first, int second) const {
  const std::size_t axis = largest(cross((*this)[first].about, (*this)[second].about));
  for (std::size_t k = 0; k < 3; ++k)
    if (const int sign = crossSign(first, second, (axis + k) % 3); sign != 0) return {(axis + k) % 3, sign};
  return {};
}

}  // namespace blossom::morphology::arrangement
