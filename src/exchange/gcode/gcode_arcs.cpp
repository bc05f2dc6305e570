#include "exchange/gcode/gcode_arcs.h"

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
/// mm; deviations that every control accepts as rounding.
constexpr double minimumMiss = 0.001, maximumMiss = 0.0127;
/// mm; the same where all other arcs of a program are better.
constexpr double finestMiss = 0.00015;
constexpr std::size_t maximumArcDoubts = 3;
/// Arcs that approximate free-form curves are shorter, and their centres may be anywhere.
constexpr double longSweep = 0.17 * fullTurn, minimumSweep = 0.05 * fullTurn;

/// mm that one wrong number of a centre is taken to be off by.
constexpr double minimumSlip = 0.015, maximumSlip = 0.12;

std::string missedSentence(std::size_t line, double begins, double ends) {
  return fmt::format("line {}: the arc begins {:.4f} mm from its centre and ends {:.4f} mm from it", line, begins, ends);
}

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
  double sweep = 0;      ///< of the first
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
  constexpr std::size_t slips = 2, minimumShare = 50;
  std::size_t words = 0, finer = 0;
  for (const std::size_t count : places_) words += count;
  for (std::size_t places = places_.size() - 1; places >= coarsest; --places) {
    finer += places_[places];
    if (finer > slips && finer * minimumShare >= words) return unit_ * std::pow(10.0, -static_cast<double>(places));
  }
  return unit_ * (inches ? 1e-4 : 1e-3);
}

void GcodeArcs::missedEnds(double step, std::vector<std::pair<std::size_t, std::string>>& found) const {
  const double allowed = std::clamp(roundedSteps * step, minimumMiss, maximumMiss);
  for (const Arc& arc : arcs_)
    if (arc.named && std::abs(arc.begins() - arc.ends()) > allowed)
      found.emplace_back(arc.line, missedSentence(arc.line, arc.begins(), arc.ends()));
}

std::vector<GcodeArcs::Trait> GcodeArcs::traits(const Arc& arc, double step) const {
  const double radius = (arc.begins() + arc.ends()) / 2;
  const Vec2 chord = arc.to - arc.from;
  // A radius of an arc that is nearly half a circle moves the centre by many times its own rounding.
  const double height = (arc.center - (arc.from + arc.to) / 2).norm();
  const double corner = step * std::sqrt(0.5) * (arc.named ? 1 : radius / std::max(height, radius / 1000));
  const Vec2 apart = (arc.from - arc.center) / arc.begins() - (arc.to - arc.center) / arc.ends();
  std::vector<Trait> found{{arc.begins() - arc.ends(), -apart, corner * (apart.norm() + 2)}};
  // The direction of a line depends on two rounded places, that of an arc on a place and a centre.
  const auto smooth = [&](const Joint& joint, const Vec2& end) {
    if (joint.length == 0) return;
    const Trait trait{(end - arc.center).dot(joint.direction), -joint.direction, corner * (2 + 3 * radius / joint.length),
                      true};
    if (std::abs(trait.off) <= maximumSlip + trait.rounding) found.push_back(trait);
  };
  smooth(arc.before, arc.from);
  smooth(arc.after, arc.to);
  const auto share = [&](const Trait& trait) {  // of a circle, which small ones are near by chance
    if (std::abs(trait.off) <= std::min(maximumSlip + trait.rounding, radius / 8)) found.push_back(trait);
  };
  const Vec2 first = arc.from - arc.center, last = arc.to - arc.center;
  const Vec2 aside = Vec2(-chord.y(), chord.x()).normalized();
  if (chord.norm() > maximumSlip) share({first.dot(aside), -aside, 2 * corner});  // half a circle
  share({first.dot(last) / radius, -(first + last) / radius, 4 * corner});        // a quarter
  return found;
}

std::string GcodeArcs::movedSentence(const Arc& arc, const Vec2& meant) {
  const auto said = arc.named ? fmt::format("its centre at ({:.4f}, {:.4f})", meant.x(), meant.y())
                              : fmt::format("a radius of {:.4f} mm and its centre", (arc.from - meant).norm());
  return fmt::format(
      "line {}: the arc would join its neighbours smoothly, or be half or a quarter of a circle, with {}, "
      "{:.4f} mm beside the one it has",
      arc.line, said, (meant - arc.center).norm());
}

std::optional<Vec2> GcodeArcs::meantCenter(const Arc& arc, double step) const {
  constexpr double clearly = 1.2;  // times what rounding explains
  const std::vector<Trait> all = traits(arc, step);
  const Vec2 chord = (arc.to - arc.from).normalized();
  const auto axes = arc.named ? std::vector{Vec2(1, 0), Vec2(0, 1)} : std::vector{Vec2(-chord.y(), chord.x())};
  for (const Vec2& axis : axes) {
    double top = 0, bottom = 0;
    for (const Trait& trait : all) {
      const double slope = trait.slope.dot(axis);
      top -= trait.off * slope / (trait.rounding * trait.rounding);
      bottom += slope * slope / (trait.rounding * trait.rounding);
    }
    const double slip = bottom > 0 ? top / bottom : 0;
    if (std::abs(slip) < minimumSlip || std::abs(slip) > maximumSlip) continue;
    const auto clear = std::count_if(all.begin(), all.end(), [&](const Trait& t) {
      return std::abs(t.slope.dot(axis) * slip) > clearly * t.rounding && std::abs(t.off) > clearly * t.rounding;
    });
    const bool explained = std::all_of(
        all.begin(), all.end(), [&](const Trait& t) { return std::abs(t.off + t.slope.dot(axis) * slip) <= t.rounding; });
    if (clear >= 2 && explained) return arc.center + slip * axis;
  }
  return std::nullopt;
}

/// Where many arcs look like slips, the program is merely not made of smooth ways, or was rounded in some other manner.
void GcodeArcs::slips(double step, std::vector<std::pair<std::size_t, std::string>>& found, const Progress& progress) const {
  std::vector<std::pair<std::size_t, std::string>> missed, moved;
  std::size_t unsmooth = 0;
  for (const Arc& arc : arcs_) {
    progress.check();
    const std::vector<Trait> all = traits(arc, step);
    unsmooth +=
        std::any_of(all.begin(), all.end(), [](const Trait& t) { return t.joint && std::abs(t.off) > t.rounding; }) ? 1 : 0;
    if (const Trait& ends = all.front(); std::abs(ends.off) > std::max(1.3 * ends.rounding, finestMiss))
      missed.emplace_back(arc.line, missedSentence(arc.line, arc.begins(), arc.ends()));
    else if (const std::optional<Vec2> meant = meantCenter(arc, step))
      moved.emplace_back(arc.line, movedSentence(arc, *meant));
  }
  const std::size_t few = std::max<std::size_t>(2, arcs_.size() / 50),
                    maximumUnsmooth = std::max<std::size_t>(6, arcs_.size() / 4);
  if (missed.size() <= few) found.insert(found.end(), missed.begin(), missed.end());
  if (moved.empty() || unsmooth > maximumUnsmooth) return;
  if (moved.size() > few)
    moved = {{moved.front().first,
              fmt::format("{}, as it is with {} of {} arcs", moved.front().second, moved.size(), arcs_.size())}};
  found.insert(found.end(), moved.begin(), moved.end());
}

void GcodeArcs::strayCenters(double step, std::vector<std::pair<std::size_t, std::string>>& found,
                             const Progress& progress) const {
  constexpr double beside = 0.1;
  const double same = std::clamp(3 * step, 0.0005, 0.01);
  constexpr std::size_t several = 2;
  std::vector<SharedCenter> centers;
  Cells cells(same);
  for (const Arc& arc : arcs_) {
    progress.check();
    if (!arc.named || arc.sweep < minimumSweep) continue;
    std::size_t own = centers.size();
    cells.around(arc.center, [&](std::size_t i) {
      if ((centers[i].at - arc.center).norm() <= same) own = std::min(own, i);
    });
    if (own == centers.size()) {
      centers.push_back({arc.center, 0, arc.line, arc.sweep});
      cells.add(arc.center, own);
    }
    ++centers[own].arcs;
  }
  Cells shared(beside);
  for (std::size_t i = 0; i < centers.size(); ++i)
    if (centers[i].arcs >= several) shared.add(centers[i].at, i);
  for (const SharedCenter& lone : centers) {
    progress.check();
    if (lone.arcs != 1) continue;
    const SharedCenter* near = nullptr;
    shared.around(lone.at, [&](std::size_t i) {
      const SharedCenter& other = centers[i];
      const Vec2 off = other.at - lone.at;
      const bool oneNumber = std::min(std::abs(off.x()), std::abs(off.y())) <= same;
      if (off.norm() > beside || (lone.sweep < longSweep && !(oneNumber && off.norm() >= minimumSlip))) return;
      if (!near || other.arcs > near->arcs) near = &other;
    });
    if (near)
      found.emplace_back(lone.line,
                         fmt::format("line {}: the centre of the arc, ({:.4f}, {:.4f}), lies {:.4f} mm beside ({:.4f}, "
                                     "{:.4f}), which is the centre of {} others",
                                     lone.line, lone.at.x(), lone.at.y(), (near->at - lone.at).norm(), near->at.x(),
                                     near->at.y(), near->arcs));
  }
}

std::vector<std::string> GcodeArcs::doubts(const Progress& progress) const {
  std::vector<std::pair<std::size_t, std::string>> found;
  missedEnds(step(), found);
  strayCenters(step(), found, progress);
  slips(step(), found, progress);
  std::stable_sort(found.begin(), found.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> sentences;
  std::size_t last = 0, more = 0;
  for (const auto& [line, what] : found) {
    if (line == std::exchange(last, line)) continue;
    if (sentences.size() < maximumArcDoubts)
      sentences.push_back(what);
    else
      ++more;
  }
  if (more > 0) sentences.back() += fmt::format("; so it is with {} more", more);
  return sentences;
}

}  // namespace blossom
