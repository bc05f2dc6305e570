#include "exchange/gcode_arcs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include "core/angle.h"

namespace blossom {
namespace {

/// Two ends and a centre, each rounded to half a step in x and y, and the centre to a start that was rounded before.
constexpr double roundedSteps = 4.3;
/// mm; what controls of any kind take for rounding.
constexpr double leastMiss = 0.001, mostMiss = 0.0127;
constexpr std::size_t mostArcDoubts = 3;
/// Arcs that stand for free-form curves are shorter, and their centres may lie anywhere.
constexpr double leastSweep = 0.17 * fullTurn;

/// Points by cells of a grid.
class Cells {
 public:
  explicit Cells(double size) : size_(size) {}
  void add(const Vec2& p, std::size_t index) { cells_[key(p)].push_back(index); }
  /// Calls visit with what may lie within the size of a cell.
  template <class Visit>
  void around(const Vec2& p, const Visit& visit) const {
    const auto [x, y] = key(p);
    for (long long i = x - 1; i <= x + 1; ++i)
      for (long long j = y - 1; j <= y + 1; ++j)
        if (const auto found = cells_.find({i, j}); found != cells_.end())
          for (const std::size_t index : found->second) visit(index);
  }

 private:
  using Key = std::pair<long long, long long>;
  [[nodiscard]] Key key(const Vec2& p) const { return {std::llround(p.x() / size_), std::llround(p.y() / size_)}; }
  double size_;
  std::map<Key, std::vector<std::size_t>> cells_;
};

/// Centres that are one but for rounding.
struct SharedCenter {
  Vec2 at;
  std::size_t arcs = 0;
  std::size_t line = 0;  ///< of the first
};

}  // namespace

void GcodeArcs::number(std::string_view written, double unit) {
  const std::size_t point = written.find('.');
  const std::size_t places = point == std::string_view::npos ? 0 : written.size() - point - 1;
  ++places_[std::min(places, places_.size() - 1)];
  unit_ = unit;
}

void GcodeArcs::join(const Joint& begins) {
  if (joinsArc_) arcs_.back().after = begins;
  joinsArc_ = false;
}

void GcodeArcs::arc(std::size_t line, const Vec2& from, const Vec2& to, const Vec2& center, bool counterclockwise,
                    bool named) {
  const double turn = counterclockwise ? 1 : -1;
  const auto along = [&](const Vec2& p) {
    const Vec2 out = p - center;
    return Joint{turn * Vec2(-out.y(), out.x()).normalized(), out.norm()};
  };
  join(along(from));
  const Vec2 first = from - center, last = to - center;
  double sweep = std::atan2(turn * cross(first, last), first.dot(last));
  if (sweep <= 1e-9) sweep += fullTurn;
  arcs_.push_back({line, from, to, center, named, sweep, last_});
  last_ = along(to);
  joinsArc_ = true;
}

void GcodeArcs::straight(const Vec2& from, const Vec2& to) {
  const double length = (to - from).norm();
  const Joint way = length > 0 ? Joint{(to - from) / length, length} : Joint{};
  join(way);
  last_ = way;
}

/// Some odd numbers with more places than all others are slips rather than a finer step; and where hardly any has places,
/// the numbers are not rounded at all.
double GcodeArcs::step() const {
  const bool inches = unit_ > 1;
  const std::size_t coarsest = inches ? 3 : 2;
  constexpr std::size_t slips = 2, leastShare = 50;
  std::size_t words = 0, finer = 0;
  for (const std::size_t count : places_) words += count;
  for (std::size_t places = places_.size() - 1; places >= coarsest; --places) {
    finer += places_[places];
    if (finer > slips && finer * leastShare >= words) return unit_ * std::pow(10.0, -static_cast<double>(places));
  }
  return unit_ * (inches ? 1e-4 : 1e-3);
}

void GcodeArcs::missedEnds(double step, std::vector<std::pair<std::size_t, std::string>>& found) const {
  const double allowed = std::clamp(roundedSteps * step, leastMiss, mostMiss);
  for (const Arc& arc : arcs_)
    if (arc.named && std::abs(arc.begins() - arc.ends()) > allowed)
      found.emplace_back(
          arc.line, fmt::format("line {}: the arc begins {:.4f} mm from its centre and ends {:.4f} mm from it", arc.line,
                                arc.begins(), arc.ends()));
}

/// Where the way is smooth at both ends of an arc for one and the same centre, that centre was meant.
void GcodeArcs::unsmoothArcs(double step, std::vector<std::pair<std::size_t, std::string>>& found) const {
  constexpr double beside = 0.12, visible = 0.01;  // mm
  for (const Arc& arc : arcs_) {
    const Vec2 chord = arc.to - arc.from;
    const double radius = arc.begins(), bend = chord.norm() / (2 * radius);
    if (!arc.named || arc.before.length == 0 || arc.after.length == 0 || arc.sweep < leastSweep) continue;
    const Vec2 first(-arc.before.direction.y(), arc.before.direction.x());
    const Vec2 last(-arc.after.direction.y(), arc.after.direction.x());
    const double risesFirst = first.dot(chord), risesLast = -last.dot(chord);
    constexpr double leastRise = 0.2;
    const double least = leastRise * chord.norm();
    const bool whole = chord.norm() < visible;
    if (whole || std::abs(risesFirst) < least || std::abs(risesLast) < least) continue;
    const Vec2 fromStart = arc.from + first * (chord.squaredNorm() / (2 * risesFirst));
    const Vec2 fromEnd = arc.to + last * (chord.squaredNorm() / (2 * risesLast));
    const double rounding = step * (2 + 3 * radius / std::min(arc.before.length, arc.after.length)) / bend;
    const double off = (fromStart - arc.center).norm(), apart = (fromStart - fromEnd).norm();
    if (off <= std::max(visible, 3 * rounding) || off > beside || apart > std::min(off / 4, std::max(0.004, 2 * rounding)))
      continue;
    found.emplace_back(arc.line, fmt::format("line {}: the arc would join the moves before and after it smoothly with its "
                                             "centre at ({:.4f}, {:.4f}), {:.4f} mm beside the one it has",
                                             arc.line, fromStart.x(), fromStart.y(), off));
  }
}

void GcodeArcs::strayCenters(double step, std::vector<std::pair<std::size_t, std::string>>& found) const {
  constexpr double beside = 0.1;
  const double same = std::clamp(3 * step, 0.0005, 0.01);
  constexpr std::size_t several = 2;
  std::vector<SharedCenter> centers;
  Cells cells(beside);
  for (const Arc& arc : arcs_) {
    if (!arc.named || arc.sweep < leastSweep) continue;
    std::size_t own = centers.size();
    cells.around(arc.center, [&](std::size_t i) {
      if ((centers[i].at - arc.center).norm() <= same) own = std::min(own, i);
    });
    if (own == centers.size()) {
      centers.push_back({arc.center, 0, arc.line});
      cells.add(arc.center, own);
    }
    ++centers[own].arcs;
  }
  for (const SharedCenter& lone : centers) {
    if (lone.arcs != 1) continue;
    const SharedCenter* near = nullptr;
    cells.around(lone.at, [&](std::size_t i) {
      const SharedCenter& other = centers[i];
      if (other.arcs >= several && (other.at - lone.at).norm() <= beside && (!near || other.arcs > near->arcs))
        near = &other;
    });
    if (near)
      found.emplace_back(lone.line,
                         fmt::format("line {}: the centre of the arc, ({:.4f}, {:.4f}), lies {:.4f} mm beside ({:.4f}, "
                                     "{:.4f}), which is the centre of {} others",
                                     lone.line, lone.at.x(), lone.at.y(), (near->at - lone.at).norm(), near->at.x(),
                                     near->at.y(), near->arcs));
  }
}

std::vector<std::string> GcodeArcs::doubts() const {
  std::vector<std::pair<std::size_t, std::string>> found;
  missedEnds(step(), found);
  strayCenters(step(), found);
  unsmoothArcs(step(), found);
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> sentences;
  std::size_t last = 0;
  for (const auto& [line, what] : found)
    if (line != std::exchange(last, line) && sentences.size() < mostArcDoubts) sentences.push_back(what);
  return sentences;
}

}  // namespace blossom
