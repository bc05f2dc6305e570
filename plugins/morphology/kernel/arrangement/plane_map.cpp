#include "kernel/arrangement/plane_map.h"

#include <deque>

#include "core/error.h"

namespace blossom::morphology::arrangement {

namespace {

std::size_t next(std::size_t k) { return (k + 1) % 3; }
std::size_t previous(std::size_t k) { return (k + 2) % 3; }

Cover sumOf(const Cover& a, const Cover& b) { return {a.sameWay + b.sameWay, a.otherWay + b.otherWay}; }
Cover negated(const Cover& a) { return {-a.sameWay, -a.otherWay}; }

[[noreturn]] void lost() {
  throw Error(ErrorCode::Internal, "The facets of a sum of solids could not be divided along their intersections.",
              "Please report the two shapes.");
}

Cover coverOf(const Facet& facet) { return facet.sameWay ? Cover{1, 0} : Cover{0, 1}; }

/// Corners counter-clockwise in the drawing of the plane.
std::vector<int> drawn(const Facet& facet) {
  std::vector<int> corners(facet.corners.begin(), facet.corners.begin() + static_cast<std::ptrdiff_t>(facet.count));
  if (!facet.sameWay) std::reverse(corners.begin(), corners.end());
  return corners;
}

}  // namespace

PlaneMap::PlaneMap(int plane, const std::vector<const Facet*>& facets, Planes& planes, Points& points)
    : plane_(plane), planes_(planes), points_(points) {
  if (facets.size() == 1)
    startWith(*facets.front());
  else
    startAround(facets);
}

void PlaneMap::startWith(const Facet& facet) {
  first_ = coverOf(facet);
  const std::vector<int> corners = drawn(facet);
  const std::size_t count = corners.size() - 2;
  for (std::size_t k = 0; k < count; ++k) {
    Triangle made;
    made.corners = {corners[0], corners[k + 1], corners[k + 2]};
    if (k > 0) made.sides[0].beyond = static_cast<int>(k) - 1;
    if (k + 1 < count) made.sides[2].beyond = static_cast<int>(k) + 1;
    triangles_.push_back(made);
    remember(static_cast<int>(k));
  }
  for (std::size_t k = 0; k < corners.size(); ++k) {
    const int from = corners[k], to = corners[(k + 1) % corners.size()];
    const EdgeOf border = edge(from, to);
    at(border.triangle).sides[border.side].line =
        planes_.upright(points_.grid(from), points_.grid(to), planes_[plane_].axis);
  }
}

void PlaneMap::startAround(const std::vector<const Facet*>& facets) {
  const Plane& plane = planes_[plane_];
  constexpr std::int64_t far = std::int64_t{1} << 61;
  constexpr std::array<std::array<std::int64_t, 2>, 3> corners{{{-far, -far}, {2 * far, -far}, {-far, 2 * far}}};
  Triangle whole;
  for (std::size_t k = 0; k < 3; ++k) {
    Grid3 corner{};
    corner[plane.u] = corners[k][0];
    corner[plane.v] = corners[k][1];
    whole.corners[k] = frame_[k] = points_.at(corner);
  }
  triangles_.push_back(whole);
  remember(0);
  const std::size_t axis = plane.axis;
  for (const Facet* facet : facets) {
    const std::vector<int> outline = drawn(*facet);
    for (std::size_t k = 0; k < outline.size(); ++k) {
      const int from = outline[k], to = outline[(k + 1) % outline.size()];
      const int line = planes_.upright(points_.grid(from), points_.grid(to), axis);
      points_.note(from, line);
      points_.note(to, line);
      insert(from);
      insert(to);
      add(segment(from, to, line, coverOf(*facet)));
    }
  }
}

void PlaneMap::cut(int from, int to, int otherPlane) {
  insert(from);
  if (to == from) return;
  insert(to);
  add(segment(from, to, otherPlane, {}));
}

void PlaneMap::remember(int triangle) {
  for (const int corner : at(triangle).corners) triangleAt_[corner] = triangle;
}

void PlaneMap::replaceBeyond(int triangle, int before, int after) {
  if (triangle == none) return;
  for (Side& side : at(triangle).sides)
    if (side.beyond == before) {
      side.beyond = after;
      return;
    }
  lost();
}

void PlaneMap::insert(int point) {
  if (triangleAt_.contains(point)) return;
  int triangle = last_;
  const std::size_t patience = 20 * triangles_.size() + 100;
  for (std::size_t steps = 0; steps < patience; ++steps) {
    const Triangle& here = at(triangle);
    random_ = random_ * 1664525U + 1013904223U;
    const std::size_t first = (random_ >> 16) % 3;
    int beyond = none;
    std::size_t on = 3;
    for (std::size_t j = 0; j < 3 && beyond == none; ++j) {
      const std::size_t k = (first + j) % 3;
      const int side = turn(here.corners[k], here.corners[next(k)], point);
      if (side == 0) on = k;
      if (side < 0) {
        beyond = here.sides[k].beyond;
        if (beyond == none) lost();
      }
    }
    if (beyond == none) {
      if (on < 3)
        divideEdge({triangle, on}, point);
      else
        divideTriangle(triangle, point);
      last_ = triangle;
      return;
    }
    triangle = beyond;
  }
  lost();
}

void PlaneMap::divideTriangle(int triangle, int point) {
  const Triangle old = at(triangle);
  const int first = static_cast<int>(triangles_.size());
  const std::array<int, 3> numbers{triangle, first, first + 1};
  triangles_.resize(triangles_.size() + 2);
  for (std::size_t k = 0; k < 3; ++k) {
    Triangle made;
    made.corners = {old.corners[k], old.corners[next(k)], point};
    made.sides[0] = old.sides[k];
    made.sides[1].beyond = numbers[next(k)];
    made.sides[2].beyond = numbers[previous(k)];
    at(numbers[k]) = made;
  }
  for (std::size_t k = 1; k < 3; ++k) replaceBeyond(old.sides[k].beyond, triangle, numbers[k]);
  for (const int number : numbers) remember(number);
}

void PlaneMap::divideEdge(EdgeOf edge, int point) {
  // The triangle (p, q, r) becomes (p, x, r) and (x, q, r); the one beyond, (q, p, s), becomes (q, x, s) and (x, p, s).
  const auto halve = [&](int triangle, std::size_t k) {
    const Triangle old = at(triangle);
    const int made = static_cast<int>(triangles_.size());
    Triangle front, back;
    front.corners = {old.corners[k], point, old.corners[previous(k)]};
    back.corners = {point, old.corners[next(k)], old.corners[previous(k)]};
    front.sides = {old.sides[k], Side{made, none, {}}, old.sides[previous(k)]};
    back.sides = {old.sides[k], old.sides[next(k)], Side{triangle, none, {}}};
    at(triangle) = front;
    triangles_.push_back(back);
    replaceBeyond(old.sides[next(k)].beyond, triangle, made);
    remember(triangle);
    remember(made);
    return made;
  };
  const int beyond = at(edge.triangle).sides[edge.side].beyond;
  std::size_t facing = 0;
  if (beyond != none)
    while (at(beyond).sides[facing].beyond != edge.triangle ||
           at(beyond).corners[facing] != at(edge.triangle).corners[next(edge.side)])
      if (++facing == 3) lost();
  const int back = halve(edge.triangle, edge.side);
  if (beyond == none) return;
  const int beyondBack = halve(beyond, facing);
  // (p, x) faces (x, p) and (x, q) faces (q, x).
  at(edge.triangle).sides[0].beyond = beyondBack;
  at(beyondBack).sides[0].beyond = edge.triangle;
  at(back).sides[0].beyond = beyond;
  at(beyond).sides[0].beyond = back;
}

/// The triangles (p, q, r) and (q, p, s) become (s, q, r) and (p, s, r).
void PlaneMap::flip(EdgeOf edge) {
  const Triangle one = at(edge.triangle);
  const std::size_t k = edge.side;
  const int beyond = one.sides[k].beyond;
  const Triangle two = at(beyond);
  std::size_t l = 0;
  while (two.corners[l] != one.corners[next(k)]) ++l;
  const int p = one.corners[k], q = one.corners[next(k)], r = one.corners[previous(k)], s = two.corners[previous(l)];
  Triangle first, second;
  first.corners = {s, q, r};
  first.sides = {two.sides[previous(l)], one.sides[next(k)], Side{beyond, none, {}}};
  second.corners = {p, s, r};
  second.sides = {two.sides[next(l)], Side{edge.triangle, none, {}}, one.sides[previous(k)]};
  at(edge.triangle) = first;
  at(beyond) = second;
  replaceBeyond(first.sides[0].beyond, beyond, edge.triangle);
  replaceBeyond(second.sides[2].beyond, edge.triangle, beyond);
  remember(edge.triangle);
  remember(beyond);
}

/// All triangles around a point, each by its edge that leaves the point.
std::vector<PlaneMap::EdgeOf> PlaneMap::edgesFrom(int point) const {
  std::vector<EdgeOf> found;
  const auto sideFrom = [&](int triangle) {
    const auto& corners = at(triangle).corners;
    return corners[0] == point ? std::size_t{0} : corners[1] == point ? std::size_t{1} : std::size_t{2};
  };
  const int start = triangleAt_.at(point);
  for (const bool counterClockwise : {true, false}) {
    int triangle = start;
    do {
      const std::size_t k = sideFrom(triangle);
      if (counterClockwise || triangle != start) found.push_back({triangle, k});
      triangle = at(triangle).sides[counterClockwise ? previous(k) : k].beyond;
    } while (triangle != none && triangle != start);
    if (triangle == start) break;
  }
  return found;
}

PlaneMap::EdgeOf PlaneMap::edge(int from, int to) const {
  for (const EdgeOf& edge : edgesFrom(from))
    if (at(edge.triangle).corners[next(edge.side)] == to) return edge;
  return {};
}

PlaneMap::Segment PlaneMap::segment(int from, int to, int line, Cover gain) {
  const Planes::Line meeting = planes_.line(plane_, line);
  Segment made{from, to, line, points_.order(meeting.axis, from, to), meeting.axis, 1, gain};
  made.left = -meeting.sign * made.way;
  if (made.left == 0) lost();
  return made;
}

int PlaneMap::sideOf(const Segment& segment, int point) {
  // Points of the frame have no place in space.
  if (isFrame(point)) return turn(segment.from, segment.to, point);
  return segment.left * points_.side(segment.line, point);
}

bool PlaneMap::isAhead(const Segment& segment, int here, int point) {
  return !isFrame(point) && points_.order(segment.axis, here, point) == segment.way;
}

void PlaneMap::add(const Segment& segment) {
  for (int here = segment.from; here != segment.to;) here = advanced(segment, here);
}

/// Makes the first part of the rest of a segment an edge. @returns its end
int PlaneMap::advanced(const Segment& segment, int here) {
  for (const EdgeOf& edge : edgesFrom(here)) {
    const Triangle& triangle = at(edge.triangle);
    const int right = triangle.corners[next(edge.side)], left = triangle.corners[previous(edge.side)];
    const int sideOfRight = sideOf(segment, right), sideOfLeft = sideOf(segment, left);
    for (const auto& [point, side] : {std::pair{right, sideOfRight}, {left, sideOfLeft}})
      if (side == 0 && isAhead(segment, here, point)) {
        mark(segment, here, point);
        return point;
      }
    if (sideOfRight < 0 && sideOfLeft > 0) return wayThrough(segment, here, {edge.triangle, next(edge.side)});
  }
  lost();
}

/// From a point through the edge of a triangle opposite to it, to the next point on the segment or the next segment.
int PlaneMap::wayThrough(const Segment& segment, int here, EdgeOf first) {
  std::vector<std::array<int, 2>> crossed;
  EdgeOf at_ = first;
  for (;;) {
    const Side& side = at(at_.triangle).sides[at_.side];
    const int right = at(at_.triangle).corners[at_.side], left = at(at_.triangle).corners[next(at_.side)];
    if (side.line != none) {
      const int crossing = points_.onThree(plane_, segment.line, side.line);
      if (triangleAt_.contains(crossing)) lost();
      divideEdge(at_, crossing);
      clear(segment, here, crossing, std::move(crossed));
      mark(segment, here, crossing);
      return crossing;
    }
    crossed.push_back({right, left});
    if (side.beyond == none) lost();
    const Triangle& beyond = at(side.beyond);
    std::size_t k = 0;
    while (beyond.corners[k] != left) ++k;
    const int facing = beyond.corners[previous(k)];
    const int sideOfFacing = sideOf(segment, facing);
    if (sideOfFacing == 0) {
      clear(segment, here, facing, std::move(crossed));
      mark(segment, here, facing);
      return facing;
    }
    // The edges of the triangle beyond after (left, right) are (right, facing) and (facing, left).
    at_ = {side.beyond, sideOfFacing > 0 ? next(k) : previous(k)};
  }
}

/// Flips the edges between two points until none crosses the straight line (Sloan, "A fast algorithm for generating
/// constrained Delaunay triangulations", 1993).
void PlaneMap::clear(const Segment& segment, int here, int target, std::vector<std::array<int, 2>> crossed) {
  std::deque<std::array<int, 2>> open(crossed.begin(), crossed.end());
  for (std::size_t patience = 100 + 20 * open.size() * open.size(); !open.empty(); --patience) {
    if (patience == 0) lost();
    const auto [p, q] = open.front();
    open.pop_front();
    const EdgeOf shared = edge(p, q);
    if (shared.triangle == none) lost();
    const Triangle& one = at(shared.triangle);
    const Triangle& two = at(one.sides[shared.side].beyond);
    std::size_t l = 0;
    while (two.corners[l] != q) ++l;
    const int r = one.corners[previous(shared.side)], s = two.corners[previous(l)];
    if (turn(s, q, r) <= 0 || turn(p, s, r) <= 0) {
      open.push_back({p, q});
      continue;
    }
    flip(shared);
    const bool arrived = (r == here && s == target) || (r == target && s == here);
    if (!arrived && sideOf(segment, r) * sideOf(segment, s) < 0) open.push_back({s, r});
  }
}

void PlaneMap::mark(const Segment& segment, int here, int next_) {
  const EdgeOf forth = edge(here, next_), back = edge(next_, here);
  if (forth.triangle == none && back.triangle == none) lost();
  for (const auto& [edge, gain] : {std::pair{forth, segment.gain}, {back, negated(segment.gain)}}) {
    if (edge.triangle == none) continue;
    Side& side = at(edge.triangle).sides[edge.side];
    if (side.line == none) side.line = segment.line;
    side.gain = sumOf(side.gain, gain);
  }
}

PlaneMap::Divided PlaneMap::divided() const {
  Divided made;
  made.pieces.resize(triangles_.size());
  for (std::size_t t = 0; t < triangles_.size(); ++t) {
    made.pieces[t].corners = triangles_[t].corners;
    made.pieces[t].patch = none;
    for (std::size_t k = 0; k < 3; ++k) made.pieces[t].isCut[k] = triangles_[t].sides[k].line != none;
  }
  // Nothing covers the frame, and all of a single facet is covered alike.
  const int start = frame_[0] == none ? 0 : triangleAt_.at(frame_[0]);
  std::vector<std::pair<int, Cover>> waiting{{start, first_}};
  while (!waiting.empty()) {
    const auto [seed, cover] = waiting.back();
    waiting.pop_back();
    if (made.pieces[static_cast<std::size_t>(seed)].patch != none) continue;
    const int patch = static_cast<int>(made.covers.size());
    made.covers.push_back(cover);
    std::vector<int> inside{seed};
    made.pieces[static_cast<std::size_t>(seed)].patch = patch;
    while (!inside.empty()) {
      const int triangle = inside.back();
      inside.pop_back();
      for (const Side& side : at(triangle).sides) {
        if (side.beyond == none || made.pieces[static_cast<std::size_t>(side.beyond)].patch != none) continue;
        if (side.line == none) {
          made.pieces[static_cast<std::size_t>(side.beyond)].patch = patch;
          inside.push_back(side.beyond);
        } else {
          waiting.emplace_back(side.beyond, sumOf(cover, negated(side.gain)));
        }
      }
    }
  }
  return made;
}

}  // namespace blossom::morphology::arrangement
