#include "kernel/solid/upright_edges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <utility>

#include "core/error.h"

namespace blossom::minkowski {
namespace {

constexpr double slackOfHeight = 1e-9;  // of t, far more than rounding

}  // namespace

UprightEdges::UprightEdges(const LoftScene& scene)
    : scene_(scene), predicates_(scene.predicates), nearJ_(scene.loft.facets.size(), false) {}

/// Where a line passes between the ends of a facet, perhaps a little more.
UprightEdges::Window UprightEdges::windowOf(int facet, int line) const {
  const LoftRamp from = predicates_.sideRamp(line, facet, 0), to = predicates_.sideRamp(line, facet, 1);
  std::array<double, 4> cuts{0, 1, 1, 1};
  std::size_t count = 1;
  for (const LoftRamp* ramp : {&from, &to}) {
    const double zero = ramp->at[0] / (ramp->at[0] - ramp->at[1]);
    if (zero > 0 && zero < 1) cuts[count++] = zero;
  }
  std::sort(cuts.begin(), cuts.begin() + static_cast<std::ptrdiff_t>(count));
  cuts[count] = 1;
  Window window{2, -1};
  for (std::size_t k = 0; k < count; ++k) {
    const double middle = (cuts[k] + cuts[k + 1]) / 2;
    if (from.signAt(middle, slackOfHeight) * to.signAt(middle, slackOfHeight) > 0) continue;
    window = {std::min(window.low, cuts[k]), std::max(window.high, cuts[k + 1])};
  }
  return window;
}

LoftPredicates::ExactRamp UprightEdges::exactRamp(const Event& event) const {
  return event.kind == Event::Kind::End ? predicates_.exactSide(event.line, event.facet, event.end)
                                        : predicates_.exactMeeting(i_, j_, event.facet);
}

LoftTime UprightEdges::timeOfEvent(const Event& event) const {
  if (event.kind == Event::Kind::Level) return scene_.levels[static_cast<std::size_t>(event.facet)];
  const LoftPredicates::ExactRamp ramp = exactRamp(event);
  return timeOf(ramp[1], Wide512(-ramp[0]));
}

bool UprightEdges::addZero(const LoftRamp& ramp, Event event, std::vector<Event>& out) const {
  const int low = ramp.signAt(0), high = ramp.signAt(1);
  if (low != 0 && low == high) return false;
  const double difference = std::abs(ramp.at[0] - ramp.at[1]);
  constexpr double certain = 1e6;
  if (difference > certain * ramp.bound()) {
    event.t = ramp.at[0] / (ramp.at[0] - ramp.at[1]);
    event.error = 2 * ramp.bound() / difference + 1e-15;
  } else {
    const LoftPredicates::ExactRamp exact = exactRamp(event);
    const int first = exact[0].sign(), second = exact[1].sign();
    if (first == 0 && second == 0) return true;
    if (first * second > 0) return false;
    event.t = timeOf(exact[1], Wide512(-exact[0])).t;
    event.error = 1e-14;
  }
  if (event.t >= -slackOfHeight && event.t <= 1 + slackOfHeight) out.push_back(event);
  return false;
}

int UprightEdges::compareEvents(const Event& a, const Event& b) const {
  if (std::abs(a.t - b.t) > a.error + b.error) return a.t < b.t ? -1 : 1;
  if (a.kind == b.kind && a.line == b.line && a.facet == b.facet && a.end == b.end) return 0;
  return compare(timeOfEvent(a), timeOfEvent(b));
}

LoftTime UprightEdges::betweenEvents(const Event& a, const Event& b) const {
  if (b.t - a.t > 4 * (a.error + b.error) + slackOfHeight) return timeOf((a.t + b.t) / 2);
  return between(timeOfEvent(a), timeOfEvent(b));
}

std::vector<std::size_t> UprightEdges::sortedGroups(std::vector<Event>& events) const {
  std::sort(events.begin(), events.end(), [this](const Event& a, const Event& b) { return compareEvents(a, b) < 0; });
  std::vector<std::size_t> groups;
  for (std::size_t k = 0; k < events.size(); ++k)
    if (k == 0 || compareEvents(events[k - 1], events[k]) < 0) groups.push_back(k);
  groups.push_back(events.size());
  return groups;
}

void UprightEdges::addOwnEvents() {
  events_.clear();
  for (std::size_t level = 0; level < scene_.levels.size(); ++level) {
    Event event;
    event.t = scene_.levels[level].t;
    event.error = 1e-15;
    event.facet = static_cast<int>(level);
    events_.push_back(event);
  }
  for (const auto& [line, facet] : {std::pair(j_, i_), std::pair(i_, j_)})
    for (const int end : {0, 1}) {
      Event event;
      event.kind = Event::Kind::End;
      event.line = line;
      event.facet = facet;
      event.end = end;
      addZero(predicates_.sideRamp(line, facet, end), event, events_);
    }
}

bool UprightEdges::onFacet(int k, int line, const LoftTime& time) const {
  return predicates_.side(line, k, 0, time) * predicates_.side(line, k, 1, time) <= 0;
}

/// Keeps the events from where the two facets first meet to where they last do.
bool UprightEdges::cutToCommonPart() {
  const std::vector<std::size_t> groups = sortedGroups(events_);
  std::size_t first = events_.size(), last = 0;
  for (std::size_t g = 0; g + 2 < groups.size(); ++g) {
    const Event &low = events_[groups[g]], &high = events_[groups[g + 1]];
    if (high.t < -slackOfHeight || low.t > 1 + slackOfHeight) continue;
    const LoftTime time = betweenEvents(low, high);
    if (time.first <= 0 || time.second <= 0) continue;  // below the bottom or above the top
    if (!onFacet(i_, j_, time) || !onFacet(j_, i_, time)) continue;
    first = std::min(first, groups[g]);
    last = groups[g + 2];
    low_ = first == groups[g] ? low : low_;
    high_ = high;
  }
  if (first >= last) return false;
  events_.erase(events_.begin() + static_cast<std::ptrdiff_t>(last), events_.end());
  events_.erase(events_.begin(), events_.begin() + static_cast<std::ptrdiff_t>(first));
  return true;
}

void UprightEdges::addCrossing(int k) {
  Event event;
  event.kind = Event::Kind::Crossing;
  event.facet = k;
  const LoftRamp ramp = predicates_.meetingRamp(i_, j_, k);
  const std::size_t before = events_.size();
  if (addZero(ramp, event, events_)) {
    through_.push_back(k);
    for (const int end : {0, 1}) {
      event.kind = Event::Kind::End;
      event.line = lineFor(k);
      event.end = end;
      addZero(predicates_.sideRamp(event.line, k, end), event, events_);
    }
  } else if (events_.size() > before) {
    Event& added = events_.back();
    const int line = lineFor(k);
    const double reach = added.error + slackOfHeight;
    const int from = predicates_.sideRamp(line, k, 0).signAt(added.t, reach),
              to = predicates_.sideRamp(line, k, 1).signAt(added.t, reach);
    if (from * to > 0) {  // the line passes beside the facet
      events_.pop_back();
      return;
    }
    added.plain = from * to < 0;
    // The line's place lies on the side sign(ramp) turn(i, j), and goes to the other one.
    added.jump = scene_.facet(k).count * predicates_.turn(i_, j_) * (ramp.at[1] > ramp.at[0] ? 1 : -1);
  }
  std::size_t kept = before;
  for (std::size_t e = before; e < events_.size(); ++e)
    if (compareEvents(low_, events_[e]) < 0 && compareEvents(events_[e], high_) < 0) events_[kept++] = events_[e];
  events_.resize(kept);
}

/// What a facet covers between two times, seen from above.
Box2 UprightEdges::extentOf(int facet, double low, double high) const {
  const LoftFacet& here = scene_.facet(facet);
  Box2 extent;
  for (const double t : {low, high})
    for (const auto& end : {here.from, here.to}) {
      const double x = (1 - t) * static_cast<double>(end[0].x) + t * static_cast<double>(end[1].x),
                   y = (1 - t) * static_cast<double>(end[0].y) + t * static_cast<double>(end[1].y);
      extent.extend(Vec2(x, y));
    }
  return extent;
}

/// Where the common part of i and j lies; far more is added than rounding can amount to.
Box2 UprightEdges::commonExtent(double low, double high) const {
  Box2 common = extentOf(i_, low, high).intersection(extentOf(j_, low, high));
  const double slack = 1 + slackOfHeight * std::max(common.min().cwiseAbs().maxCoeff(), common.max().cwiseAbs().maxCoeff());
  common.min().array() -= slack;
  common.max().array() += slack;
  return common;
}

void UprightEdges::addOtherEvents() {
  const double low = low_.t - low_.error - slackOfHeight, high = high_.t + high_.error + slackOfHeight;
  const Box2 common = commonExtent(low, high);
  through_.clear();
  const std::vector<int>& ofJ = scene_.near(j_);
  work_ += static_cast<double>(scene_.near(i_).size() + ofJ.size());
  for (const int k : ofJ) nearJ_[static_cast<std::size_t>(k)] = true;
  for (const int k : scene_.near(i_))
    if (k != j_ && nearJ_[static_cast<std::size_t>(k)] && common.intersects(extentOf(k, low, high))) {
      work_ += 10;
      addCrossing(k);
    }
  for (const int k : ofJ) nearJ_[static_cast<std::size_t>(k)] = false;
}

std::vector<int> UprightEdges::facetsAt(const LoftTime& time, int slab) const {
  std::vector<int> on{i_, j_};
  for (const int k : through_)
    if (scene_.counts(k, slab) && onFacet(k, lineFor(k), time)) on.push_back(k);
  return on;
}

bool UprightEdges::isOurs(const std::vector<int>& on) const {
  return std::all_of(on.begin(), on.end(), [&](int k) {
    if (!scene_.facet(k).mayBound) return true;
    return k >= i_ && (k >= j_ || predicates_.turn(i_, k) == 0);
  });
}

/// Counter-clockwise, first what follows the direction of facet i, last that direction itself. Those in one direction are
/// one.
std::vector<UprightEdges::Ray> UprightEdges::raysOf(const std::vector<int>& on, const LoftTime& time) const {
  std::vector<Ray> rays;
  for (const int k : on) {
    const int line = k == i_ ? j_ : k == j_ ? i_ : lineFor(k), count = scene_.facet(k).count;
    if (predicates_.side(line, k, 1, time) != 0) rays.push_back({k, true, count});
    if (predicates_.side(line, k, 0, time) != 0) rays.push_back({k, false, -count});
  }
  const auto part = [this](const Ray& ray) {
    const int turn = predicates_.turn(i_, ray.facet) * (ray.forward ? 1 : -1);
    return turn > 0 ? 0 : turn < 0 ? 2 : ray.forward ? 3 : 1;
  };
  const auto before = [&](const Ray& a, const Ray& b) {
    const int ofA = part(a), ofB = part(b);
    if (ofA != ofB) return ofA < ofB;
    return predicates_.turn(a.facet, b.facet) * (a.forward == b.forward ? 1 : -1) > 0;
  };
  std::sort(rays.begin(), rays.end(), before);
  std::vector<Ray> joined;
  for (const Ray& ray : rays)
    if (!joined.empty() && !before(joined.back(), ray))
      joined.back().jump += ray.jump;
    else
      joined.push_back(ray);
  return joined;
}

void UprightEdges::emit(const std::vector<Ray>& rays, int winding, std::size_t group, std::vector<LoftSide>& out) const {
  struct Bounding {
    int plane;
    bool outsideLeft, upwards;
  };
  std::vector<Bounding> bounding;
  int now = winding;
  for (const Ray& ray : rays) {
    const bool before = now > 0;
    now += ray.jump;
    if (before == (now > 0)) continue;
    // Clockwise of the ray lies what comes before it.
    bounding.push_back({scene_.facet(ray.facet).plane, before == ray.forward, before});
  }
  if (now != winding)
    throw Error(ErrorCode::Internal, "The facets of the solid do not close around an edge.",
                "Please report the two shapes.");
  if (bounding.empty()) return;
  if (bounding.size() == 2 && bounding[0].plane == bounding[1].plane && bounding[0].outsideLeft == bounding[1].outsideLeft)
    return;
  const LoftPredicates::Place low = predicates_.placeOfMeeting(i_, j_, timeOfEvent(events_[groups_[group]])),
                              high = predicates_.placeOfMeeting(i_, j_, timeOfEvent(events_[groups_[group + 1]]));
  for (const Bounding& b : bounding)
    out.push_back(b.upwards ? LoftSide{low, high, b.plane, b.outsideLeft} : LoftSide{high, low, b.plane, b.outsideLeft});
}

void UprightEdges::walk(std::vector<LoftSide>& out) {
  std::optional<int> winding;  // beyond the line in the direction of facet i, to its left
  for (std::size_t g = 0; g + 2 < groups_.size(); ++g) {
    const LoftTime time = betweenEvents(events_[groups_[g]], events_[groups_[g + 1]]);
    const auto passed = std::count_if(scene_.levels.begin(), scene_.levels.end(),
                                      [&](const LoftTime& level) { return compare(level, time) < 0; });
    const int slab = static_cast<int>(passed) - 1;
    for (std::size_t e = groups_[g]; e < groups_[g + 1] && winding; ++e)
      if (!events_[e].plain)
        winding.reset();
      else if (scene_.counts(events_[e].facet, slab))
        *winding += events_[e].jump;
    if (!scene_.counts(i_, slab) || !scene_.counts(j_, slab)) continue;
    const std::vector<int> on = facetsAt(time, slab);
    if (!isOurs(on)) continue;
    if (!winding) {
      work_ += static_cast<double>(scene_.loft.facets.size());
      winding = scene_.windingBeyond(i_, {j_, -1}, time, slab);
    }
    emit(raysOf(on, time), *winding, g, out);
  }
}

void UprightEdges::pair(int i, int j, std::vector<LoftSide>& out) {
  i_ = i;
  j_ = j;
  if (predicates_.turn(i, j) == 0) return;
  const Window ofI = windowOf(i, j), ofJ = windowOf(j, i);
  if (std::max(ofI.low, ofJ.low) > std::min(ofI.high, ofJ.high) + slackOfHeight) return;
  addOwnEvents();
  if (!cutToCommonPart()) return;
  addOtherEvents();
  groups_ = sortedGroups(events_);
  walk(out);
}

void UprightEdges::find(int i, std::vector<LoftSide>& out, const Progress& progress) {
  for (const int j : scene_.near(i)) {
    progress.check();
    if (j > i && scene_.facet(j).mayBound) pair(i, j, out);
  }
}

}  // namespace blossom::minkowski
