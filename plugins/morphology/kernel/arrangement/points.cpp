#include "kernel/arrangement/points.h"

namespace blossom::morphology::arrangement {

namespace {

template <class T, std::size_t n>
std::uint64_t hashOf(const std::array<T, n>& key) {
  std::uint64_t hash = 0;
  for (const T part : key) hash = mixedHash(hash, static_cast<std::uint64_t>(part));
  return hash;
}

/// Larger than the error of a coordinate that is rounded from its exact value.
constexpr double largestError = 0.2 * blur;

/// Points are looked up in cells: equal ones lie in one of them or in neighbours. So large that there are seldom two of
/// these to be looked at, and seldom other points in one.
constexpr double cellSize = 32.0 * blur;

/// An exact quotient in doubles.
Bounded quotient(const Whole& x, const Whole& w) {
  const double value = x.convert_to<double>() / w.convert_to<double>();
  return {value, 2 * roundOff * std::abs(value)};
}

std::int64_t cellOf(double coordinate) { return static_cast<std::int64_t>(std::floor(coordinate / cellSize)); }

bool isRough(const Bounded3& p) {
  return std::any_of(p.begin(), p.end(), [](const Bounded& x) { return !(x.error < largestError); });
}

}  // namespace

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

const Points::Exact& Points::exact(std::unique_ptr<Exact>& kept, const Entry& entry) const {
  if (!kept) kept = std::make_unique<Exact>(computed(entry));
  return *kept;
}

const Points::Exact& Points::exact(int point) {
  if (!isOfBase(point)) return exact(own(point).exact, own(point));
  const Entry& known = entry(point);
  return known.exact ? *known.exact : exact(additions_[point].exact, known);
}

bool Points::same(Entry& a, int other) {
  const Entry& b = entry(other);
  for (std::size_t k = 0; k < 3; ++k)
    if (std::abs(a.about[k].value - b.about[k].value) > a.about[k].error + b.about[k].error + largestError / 100)
      return false;
  if (a.kind == Kind::Grid && b.kind == Kind::Grid) return a.grid == b.grid;
  const Exact &p = exact(a.exact, a), &q = exact(other);
  for (std::size_t k = 0; k < 3; ++k)
    if (p.x[k] * q.w != q.x[k] * p.w) return false;
  return true;
}

void Points::place(Entry& made) const {
  made.about = aboutOf(made);
  if (!isRough(made.about)) return;
  const Exact& known = exact(made.exact, made);
  for (std::size_t k = 0; k < 3; ++k) made.about[k] = quotient(known.x[k], known.w);
}

/// The number of an equal point; -1 when there is none. @param cells the two along each axis where it can lie
int Points::findAmong(const Points& points, const std::array<std::array<std::int64_t, 2>, 3>& cells, Entry& made) {
  for (std::size_t corner = 0; corner < 8; ++corner) {
    Cell cell{};
    bool fresh = true;
    for (std::size_t k = 0; k < 3; ++k) {
      const std::size_t which = corner >> k & 1U;
      cell[k] = cells[k][which];
      if (which == 1 && cells[k][0] == cells[k][1]) fresh = false;
    }
    if (!fresh) continue;
    const int known = points.byPlace_.find(hashOf(cell), [&](int point) { return same(made, point); });
    if (known >= 0) return known;
  }
  return -1;
}

int Points::insert(Entry made) {
  // Equal points lie at most twice the largest error apart, in the same cell or a neighbouring one.
  std::array<std::array<std::int64_t, 2>, 3> near{};
  Cell home{};
  for (std::size_t k = 0; k < 3; ++k) {
    const double value = made.about[k].value;
    home[k] = cellOf(value);
    near[k] = {cellOf(value - 2 * largestError), cellOf(value + 2 * largestError)};
  }
  int known = base_ ? findAmong(*base_, near, made) : -1;
  if (known < 0) known = findAmong(*this, near, made);
  if (known >= 0) {
    for (const int plane : made.planes) note(known, plane);
    return known;
  }
  const int number = static_cast<int>(size());
  byPlace_.add(hashOf(home), number);
  entries_.push_back(std::move(made));
  return number;
}

Points::Origin Points::originOf(const Entry& entry) {
  return {entry.from[0], entry.from[1], entry.from[2], entry.kind == Kind::Edge ? -1 : -2};
}

std::optional<int> Points::find(const Origin& origin) const {
  if (base_)
    if (const auto known = base_->find(origin)) return known;
  const int known =
      byOrigin_.find(hashOf(origin), [&](int k) { return origins_[static_cast<std::size_t>(k)].first == origin; });
  return known < 0 ? std::nullopt : std::optional(origins_[static_cast<std::size_t>(known)].second);
}

int Points::found(const Origin& origin, Entry made) {
  const int number = insert(std::move(made));
  byOrigin_.add(hashOf(origin), static_cast<int>(origins_.size()));
  origins_.emplace_back(origin, number);
  return number;
}

int Points::at(const Grid3& p) {
  Entry made;
  made.grid = p;
  place(made);
  return insert(std::move(made));
}

int Points::onEdge(int from, int to, int plane) {
  if (from > to) std::swap(from, to);
  Entry made;
  made.kind = Kind::Edge;
  made.from = {from, to, plane};
  const auto origin = originOf(made);
  if (const auto known = find(origin)) return *known;
  made.planes = {plane};
  place(made);
  return found(origin, std::move(made));
}

int Points::onThree(int first, int second, int third) {
  Entry made;
  made.kind = Kind::Planes;
  made.from = {first, second, third};
  std::sort(made.from.begin(), made.from.end());
  const auto origin = originOf(made);
  if (const auto known = find(origin)) return *known;
  made.planes.assign(made.from.begin(), made.from.end());
  place(made);
  return found(origin, std::move(made));
}

int Points::take(Points& part, int point, const std::function<int(int)>& numberOf) {
  if (part.isOfBase(point)) return point;
  part.taken_.resize(part.entries_.size(), -1);
  int& number = part.taken_[static_cast<std::size_t>(point - part.first_)];
  if (number >= 0) return number;
  Entry made = std::move(part.own(point));
  for (int& plane : made.planes) plane = numberOf(plane);
  if (made.kind == Kind::Grid) return number = insert(std::move(made));
  if (made.kind == Kind::Edge)  // between points of the base
    made.from[2] = numberOf(made.from[2]);
  else
    for (int& plane : made.from) plane = numberOf(plane);
  if (made.kind == Kind::Planes) std::sort(made.from.begin(), made.from.end());
  const auto origin = originOf(made);
  const auto known = find(origin);
  if (!known) return number = found(origin, std::move(made));
  for (const int plane : made.planes) note(*known, plane);
  return number = *known;
}

void Points::takeNotes(const Points& part, int planes) {
  for (const auto& [point, addition] : part.additions_)
    for (const int plane : addition.planes)
      if (plane < planes) note(point, plane);
}

void Points::note(int point, int plane) {
  if (isKnownOn(point, plane)) return;
  (isOfBase(point) ? additions_[point].planes : own(point).planes).push_back(plane);
}

bool Points::isKnownOn(int point, int plane) const {
  if (entry(point).isOn(plane)) return true;
  if (!isOfBase(point)) return false;
  const auto it = additions_.find(point);
  if (it == additions_.end()) return false;
  const auto& planes = it->second.planes;
  return std::find(planes.begin(), planes.end(), plane) != planes.end();
}

int Points::side(int plane, int point) {
  const Entry& here = entry(point);
  if (here.isOn(plane)) return 0;
  const Plane& there = planes_[plane];
  const Bounded3 from = exactly(there.point);
  const Bounded about = dot(there.about, {here.about[0] - from[0], here.about[1] - from[1], here.about[2] - from[2]});
  if (about.decided()) return signOf(about.value);
  if (isKnownOn(point, plane)) return 0;
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

/// On a second plane all three lie on a line. (Each of its own planes is another one, or the drawing's.)
bool Points::shareAnotherPlane(int plane, int a, int b, int c) const {
  const auto shared = [&](int other) { return other != plane && isKnownOn(b, other) && isKnownOn(c, other); };
  const Entry& here = entry(a);
  if (std::any_of(here.planes.begin(), here.planes.end(), shared)) return true;
  const auto it = isOfBase(a) ? additions_.find(a) : additions_.end();
  return it != additions_.end() && std::any_of(it->second.planes.begin(), it->second.planes.end(), shared);
}

std::optional<int> Points::turnInDoubles(std::size_t u, std::size_t v, int a, int b, int c) const {
  if (a == b || b == c || c == a) return 0;
  const Bounded3 &p = entry(a).about, &q = entry(b).about, &r = entry(c).about;
  const Bounded about = (q[u] - p[u]) * (r[v] - p[v]) - (q[v] - p[v]) * (r[u] - p[u]);
  return about.decided() ? std::optional(signOf(about.value)) : std::nullopt;
}

int Points::exactTurn(std::size_t u, std::size_t v, int a, int b, int c) {
  const Exact &x = exact(a), &y = exact(b), &z = exact(c);
  const auto minor = [&](const Exact& e, const Exact& f) { return Whole(e.x[u] * f.x[v] - e.x[v] * f.x[u]); };
  return signOf(Whole(x.w * minor(y, z) + y.w * minor(z, x) + z.w * minor(x, y)));
}

int Points::turn(int plane, int a, int b, int c) {
  const std::size_t u = planes_[plane].u, v = planes_[plane].v;
  if (const auto sign = turnInDoubles(u, v, a, b, c)) return *sign;
  return shareAnotherPlane(plane, a, b, c) ? 0 : exactTurn(u, v, a, b, c);
}

int Points::turn(std::size_t u, std::size_t v, int a, int b, int c) {
  const auto sign = turnInDoubles(u, v, a, b, c);
  return sign ? *sign : exactTurn(u, v, a, b, c);
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
