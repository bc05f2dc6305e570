#include "kernel/arrangement/points.h"

#include <bit>

namespace blossom::morphology::arrangement {

namespace {

std::uint64_t mixed(std::uint64_t sum, std::uint64_t value) { return (std::rotl(sum, 5) ^ value) * 0x9E3779B97F4A7C15ULL; }

/// Larger than the error of a coordinate that is rounded from its exact value. Points are looked up in cells as large as the
/// blur: equal ones then lie in one of them or in neighbours.
constexpr double largestError = 0.2 * blur;

/// An exact quotient in doubles.
Bounded quotient(const Whole& x, const Whole& w) {
  const double value = x.convert_to<double>() / w.convert_to<double>();
  return {value, 2 * roundOff * std::abs(value)};
}

std::int64_t cellOf(double coordinate) { return static_cast<std::int64_t>(std::floor(coordinate / blur)); }

bool isRough(const Bounded3& p) {
  return std::any_of(p.begin(), p.end(), [](const Bounded& x) { return !(x.error < largestError); });
}

}  // namespace

std::size_t Points::Hash::operator()(const std::array<std::int64_t, 3>& cell) const {
  std::uint64_t sum = 0;
  for (const std::int64_t part : cell) sum = mixed(sum, static_cast<std::uint64_t>(part));
  return sum;
}
std::size_t Points::Hash::operator()(const std::array<int, 4>& key) const {
  std::uint64_t sum = 0;
  for (const int part : key) sum = mixed(sum, static_cast<std::uint64_t>(part));
  return sum;
}

Bounded3 Points::aboutOf(const Entry& entry) const {
  if (entry.kind == Kind::Grid) return exactly(entry.grid);
  if (entry.kind == Kind::Edge) {
    const Grid3 &p = grid(entry.from[0]), &q = grid(entry.from[1]);
    const Plane& plane = planes_[entry.from[2]];
    const Bounded above = dot(plane.about, exactly(p - plane.point)), below = dot(plane.about, exactly(q - plane.point));
    const Bounded share = above / (above - below);
    Bounded3 about;
    for (std::size_t k = 0; k < 3; ++k) about[k] = exactly(p[k]) + exactly(q[k] - p[k]) * share;
    return about;
  }
  // Seen from a point of the first plane, whose offset then is 0.
  const Plane &a = planes_[entry.from[0]], &b = planes_[entry.from[1]], &c = planes_[entry.from[2]];
  const Bounded offsetB = dot(b.about, exactly(b.point - a.point)), offsetC = dot(c.about, exactly(c.point - a.point));
  const Bounded3 ca = cross(c.about, a.about), ab = cross(a.about, b.about);
  const Bounded det = dot(a.about, cross(b.about, c.about));
  Bounded3 about;
  for (std::size_t k = 0; k < 3; ++k) about[k] = exactly(a.point[k]) + (offsetB * ca[k] + offsetC * ab[k]) / det;
  return about;
}

Points::Exact Points::computed(const Entry& entry) const {
  Exact exact;
  if (entry.kind == Kind::Grid) {
    for (std::size_t k = 0; k < 3; ++k) exact.x[k] = entry.grid[k];
    exact.w = 1;
    return exact;
  }
  if (entry.kind == Kind::Edge) {
    const Grid3 &p = grid(entry.from[0]), &q = grid(entry.from[1]);
    const Plane& plane = planes_[entry.from[2]];
    const Whole above = dot(plane.normal, p - plane.point), below = dot(plane.normal, q - plane.point);
    exact.w = above - below;
    for (std::size_t k = 0; k < 3; ++k) exact.x[k] = exact.w * p[k] + above * (q[k] - p[k]);
  } else {
    const Plane &a = planes_[entry.from[0]], &b = planes_[entry.from[1]], &c = planes_[entry.from[2]];
    const auto across = [](const Normal3& m, const Normal3& n, std::size_t k) {
      const std::size_t i = (k + 1) % 3, j = (k + 2) % 3;
      return Whole(Whole(m[i]) * n[j] - Whole(m[j]) * n[i]);
    };
    const Whole offsetB = dot(b.normal, b.point - a.point), offsetC = dot(c.normal, c.point - a.point);
    exact.w = 0;
    for (std::size_t k = 0; k < 3; ++k) exact.w += across(b.normal, c.normal, k) * a.normal[k];
    for (std::size_t k = 0; k < 3; ++k)
      exact.x[k] = exact.w * a.point[k] + offsetB * across(c.normal, a.normal, k) + offsetC * across(a.normal, b.normal, k);
  }
  if (exact.w < 0) {
    exact.w = -exact.w;
    for (Whole& x : exact.x) x = -x;
  }
  return exact;
}

const Points::Exact& Points::exact(Entry& entry) const {
  if (!entry.exact) entry.exact = std::make_unique<Exact>(computed(entry));
  return *entry.exact;
}

bool Points::same(Entry& a, Entry& b) const {
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(a.about[k].value - b.about[k].value) > a.about[k].error + b.about[k].error + largestError / 100)
      return false;
  if (a.kind == Kind::Grid && b.kind == Kind::Grid) return a.grid == b.grid;
  const Exact &p = exact(a), &q = exact(b);
  for (std::size_t k = 0; k < 3; ++k)
    if (p.x[k] * q.w != q.x[k] * p.w) return false;
  return true;
}

int Points::insert(Entry made) {
  made.about = aboutOf(made);
  if (isRough(made.about)) {
    const Exact& known = exact(made);
    for (std::size_t k = 0; k < 3; ++k) made.about[k] = quotient(known.x[k], known.w);
  }
  // Equal points lie at most twice the largest error apart, in the same cell or a neighbouring one.
  std::array<std::array<std::int64_t, 2>, 3> near{};
  Cell home{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = made.about[k].value;
    home[k] = cellOf(value);
    near[k] = {cellOf(value - 2 * largestError), cellOf(value + 2 * largestError)};
  }
  for (std::size_t corner = 0; corner < 8; ++corner) {
    Cell cell{};
    bool fresh = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t which = corner >> k & 1U;
      cell[k] = near[k][which];
      if (which == 1 && near[k][0] == near[k][1]) fresh = false;
    }
    if (!fresh) continue;
    const auto [from, to] = byPlace_.equal_range(cell);
    for (auto it = from; it != to; ++it) {
      Entry& other = entries_[static_cast<std::size_t>(it->second)];
      if (!same(made, other)) continue;
      for (const int plane : made.planes) note(it->second, plane);
      return it->second;
    }
  }
  const int number = static_cast<int>(entries_.size());
  byPlace_.emplace(home, number);
  entries_.push_back(std::move(made));
  return number;
}

int Points::found(const std::array<int, 4>& key, Entry made) {
  if (const auto it = byOrigin_.find(key); it != byOrigin_.end()) return it->second;
  const int number = insert(std::move(made));
  byOrigin_.emplace(key, number);
  return number;
}

int Points::at(const Grid3& p) {
  Entry made;
  made.grid = p;
  return insert(std::move(made));
}

int Points::onEdge(int from, int to, int plane) {
  if (from > to) std::swap(from, to);
  Entry made;
  made.kind = Kind::Edge;
  made.from = {from, to, plane};
  made.planes = {plane};
  return found({from, to, plane, -1}, std::move(made));
}

int Points::onThree(int first, int second, int third) {
  std::array<int, 3> planes{first, second, third};
  std::sort(planes.begin(), planes.end());
  Entry made;
  made.kind = Kind::Planes;
  made.from = planes;
  made.planes.assign(planes.begin(), planes.end());
  return found({planes[0], planes[1], planes[2], -2}, std::move(made));
}

void Points::note(int point, int plane) {
  std::vector<int>& planes = entries_[static_cast<std::size_t>(point)].planes;
  if (std::find(planes.begin(), planes.end(), plane) == planes.end()) planes.push_back(plane);
}

int Points::side(int plane, int point) {
  const Entry& here = entry(point);
  if (std::find(here.planes.begin(), here.planes.end(), plane) != here.planes.end()) return 0;
  const Plane& there = planes_[plane];
  const Bounded3 from = exactly(there.point);
  const Bounded about = dot(there.about, {here.about[0] - from[0], here.about[1] - from[1], here.about[2] - from[2]});
  if (about.decided()) return signOf(about.value);
  int sign = 0;
  if (here.kind == Kind::Grid) {
    sign = planes_.side(plane, here.grid);
  } else {
    const Exact& p = exact(point);
    Whole sum = 0;
    for (std::size_t k = 0; k < 3; ++k) sum += Whole(there.normal[k]) * (p.x[k] - p.w * there.point[k]);
    sign = signOf(sum);
  }
  if (sign == 0) note(point, plane);
  return sign;
}

int Points::order(std::size_t axis, int a, int b) {
  if (a == b) return 0;
  const Bounded about = entry(b).about[axis] - entry(a).about[axis];
  if (about.decided()) return signOf(about.value);
  const Exact &p = exact(a), &q = exact(b);
  return signOf(Whole(q.x[axis] * p.w - p.x[axis] * q.w));
}

int Points::turn(int plane, int a, int b, int c) {
  // On a second plane all three lie on a line. (Each of its own planes is another one, or the drawing's.)
  for (const int other : entry(a).planes) {
    if (other == plane) continue;
    const auto isOn = [&](int point) {
      const auto& planes = entry(point).planes;
      return std::find(planes.begin(), planes.end(), other) != planes.end();
    };
    if (isOn(b) && isOn(c)) return 0;
  }
  return turn(planes_[plane].u, planes_[plane].v, a, b, c);
}

int Points::turn(std::size_t u, std::size_t v, int a, int b, int c) {
  if (a == b || b == c || c == a) return 0;
  const Bounded3 &p = entry(a).about, &q = entry(b).about, &r = entry(c).about;
  const Bounded about = (q[u] - p[u]) * (r[v] - p[v]) - (q[v] - p[v]) * (r[u] - p[u]);
  if (about.decided()) return signOf(about.value);
  const Exact &x = exact(a), &y = exact(b), &z = exact(c);
  const auto minor = [&](const Exact& e, const Exact& f) { return Whole(e.x[u] * f.x[v] - e.x[v] * f.x[u]); };
  return signOf(Whole(x.w * minor(y, z) + y.w * minor(z, x) + z.w * minor(x, y)));
}

std::array<double, 3> Points::nearest(int point) {
  std::array<double, 3> rounded{};
  const Entry& here = entry(point);
  for (std::size_t k = 0; k < 3; ++k) {
    rounded[k] = here.about[k].value;
    // Away from 0 the error is below that of rounding unless the planes are nearly parallel.
    if (here.about[k].error > 4 * roundOff * std::abs(rounded[k]) && here.kind != Kind::Grid)
      rounded[k] = quotient(exact(point).x[k], exact(point).w).value;
  }
  return rounded;
}

}  // namespace blossom::morphology::arrangement
