#include "kernel/check/strip_area.h"

#include <algorithm>
#include <boost/container/small_vector.hpp>
#include <cmath>
#include <limits>
#include <optional>

namespace blossom::pocket {

namespace {

constexpr double farAway = std::numeric_limits<double>::infinity();

/// Cells hold some 48 curves at most, unless these lie on one another: room for them needs no memory of its own.
template <class T>
using Few = boost::container::small_vector<T, 64>;

/// The ends of a slab's interval at both heights, and what the arcs add to the lines between them.
struct Ends {
  RunningSpan chord;
  double leftBulge = 0, rightBulge = 0;
};

Few<Ends> endsOf(const std::vector<const Slab*>& slabs, double low, double high) {
  Few<Ends> ends;
  ends.reserve(slabs.size());
  for (const Slab* slab : slabs)
    ends.push_back({{slab->left.at(low), slab->left.at(high), slab->right.at(low), slab->right.at(high)}});
  return ends;
}

void findBulges(const std::vector<const Slab*>& slabs, double low, double high, Few<Ends>& ends) {
  for (std::size_t i = 0; i < slabs.size(); ++i) {
    Ends& e = ends[i];
    e.leftBulge = slabs[i]->left.bulge(low, high, e.chord.leftLow, e.chord.leftHigh);
    e.rightBulge = slabs[i]->right.bulge(low, high, e.chord.rightLow, e.chord.rightHigh);
  }
}

/// Wider by the bulges on both sides (+1), or narrower (-1).
RunningSpan moved(const Ends& e, double sign) {
  return {e.chord.leftLow - sign * e.leftBulge, e.chord.leftHigh - sign * e.leftBulge,
          e.chord.rightLow + sign * e.rightBulge, e.chord.rightHigh + sign * e.rightBulge};
}

/// As a box: the widest it is between the heights (+1), or the narrowest (-1).
std::pair<double, double> boxed(const RunningSpan& s, bool widest) {
  return widest ? std::pair(std::min(s.leftLow, s.leftHigh), std::max(s.rightLow, s.rightHigh))
                : std::pair(std::max(s.leftLow, s.leftHigh), std::min(s.rightLow, s.rightHigh));
}

/// The gaps that sorted intervals leave of an interval.
template <class Intervals>
void addGaps(const std::pair<double, double>& whole, const Intervals& covers, std::vector<std::pair<double, double>>& gaps) {
  double reach = whole.first;
  for (const auto& [left, right] : covers) {
    if (left >= whole.second) break;
    if (left > reach) gaps.emplace_back(reach, left);
    reach = std::max(reach, right);
  }
  if (whole.second > reach) gaps.emplace_back(reach, whole.second);
}

std::vector<std::pair<double, double>> gapsOfBoxes(const Few<Ends>& whole, const Few<Ends>& covers, bool most) {
  Few<std::pair<double, double>> boxes;
  std::vector<std::pair<double, double>> gaps;
  for (const Ends& e : covers)
    if (const auto box = boxed(e.chord, !most); box.second > box.first) boxes.push_back(box);
  std::sort(boxes.begin(), boxes.end());
  for (const Ends& e : whole)
    if (const auto box = boxed(e.chord, most); box.second > box.first) addGaps(box, boxes, gaps);
  return gaps;
}

double total(const std::vector<std::pair<double, double>>& gaps) {
  double sum = 0;
  for (const auto& [left, right] : gaps) sum += right - left;
  return sum;
}

/// The area between straight ends, when their order is the same at both heights; nothing otherwise. What is straight and in
/// order at both ends is so between them.
class InOrder {
 public:
  InOrder(const Few<Ends>& whole, const Few<Ends>& covers, bool most, double slack) : slack_(slack) {
    for (const Ends& e : whole) whole_.push_back(moved(e, most ? 1 : -1));
    for (const Ends& e : covers)
      if (const RunningSpan s = moved(e, most ? -1 : 1); s.rightMiddle() > s.leftMiddle()) covers_.push_back(s);
    std::sort(covers_.begin(), covers_.end(),
              [](const RunningSpan& a, const RunningSpan& b) { return a.leftMiddle() < b.leftMiddle(); });
    afterLow_.assign(covers_.size() + 1, farAway);
    afterHigh_ = afterLow_;
    for (std::size_t i = covers_.size(); i-- > 0;) {
      afterLow_[i] = std::min(afterLow_[i + 1], covers_[i].leftLow);
      afterHigh_[i] = std::min(afterHigh_[i + 1], covers_[i].leftHigh);
    }
  }

  std::optional<double> width() {
    double sum = 0;
    for (const RunningSpan& span : whole_) {
      const auto found = widthOf(span);
      if (!found) return std::nullopt;
      sum += *found;
    }
    return sum;
  }

 private:
  struct Edge {
    double low, high;
    [[nodiscard]] double middle() const { return (low + high) / 2; }
  };

  /// Mean width of what is left of one interval.
  std::optional<double> widthOf(const RunningSpan& span) {
    const Edge end{span.rightLow, span.rightHigh};
    Edge reach{span.leftLow, span.leftHigh};
    double sum = 0;
    Few<std::size_t> begun;                                       // covers that may lead on
    std::size_t next = 0;                                         // the first cover that begins beyond what is reached
    double beforeLow = span.leftLow, beforeHigh = span.leftHigh;  // no cover may end before the interval begins
    while (reach.middle() < end.middle()) {
      for (; next < covers_.size() && covers_[next].leftMiddle() <= reach.middle(); ++next) {
        beforeLow = std::max(beforeLow, covers_[next].rightLow);
        beforeHigh = std::max(beforeHigh, covers_[next].rightHigh);
        begun.push_back(next);
      }
      if (const auto farther = extended(reach, begun)) {
        reach = *farther;
        continue;
      }
      const bool last = next == covers_.size() || covers_[next].leftMiddle() >= end.middle();
      const Edge to = last ? end : Edge{covers_[next].leftLow, covers_[next].leftHigh};
      const bool clear = beforeLow <= reach.low + slack_ && beforeHigh <= reach.high + slack_ &&
                         afterLow_[next] >= to.low - slack_ && afterHigh_[next] >= to.high - slack_ &&
                         to.low >= reach.low - slack_ && to.high >= reach.high - slack_ && to.low <= end.low + slack_ &&
                         to.high <= end.high + slack_;
      if (!clear) return std::nullopt;
      sum += to.middle() - reach.middle();
      if (last) return sum;
      reach = {covers_[next].rightLow, covers_[next].rightHigh};
    }
    if (reach.low < end.low - slack_ || reach.high < end.high - slack_) return std::nullopt;
    return sum;
  }

  /// The farthest that a cover leads which surely begins before what is reached. Of those that have begun, it forgets which
  /// lead no farther.
  [[nodiscard]] std::optional<Edge> extended(const Edge& reach, Few<std::size_t>& begun) const {
    const auto isPassed = [&](std::size_t i) { return covers_[i].rightMiddle() <= reach.middle(); };
    begun.erase(std::remove_if(begun.begin(), begun.end(), isPassed), begun.end());
    std::optional<Edge> best;
    for (const std::size_t i : begun) {
      const RunningSpan& c = covers_[i];
      if (best && c.rightMiddle() <= best->middle()) continue;
      if (c.leftLow <= reach.low + slack_ && c.leftHigh <= reach.high + slack_) best = Edge{c.rightLow, c.rightHigh};
    }
    return best;
  }

  double slack_;
  Few<RunningSpan> whole_, covers_;
  Few<double> afterLow_, afterHigh_;  ///< by cover: where this one or a later one begins, at the least
};

}  // namespace

std::vector<std::pair<double, double>> gapsAt(const std::vector<const Slab*>& whole, const std::vector<const Slab*>& covers,
                                              double y) {
  Few<std::pair<double, double>> across;
  std::vector<std::pair<double, double>> gaps;
  for (const Slab* slab : covers) across.emplace_back(slab->left.at(y), slab->right.at(y));
  std::sort(across.begin(), across.end());
  for (const Slab* slab : whole) addGaps({slab->left.at(y), slab->right.at(y)}, across, gaps);
  return gaps;
}

StripArea stripArea(const std::vector<const Slab*>& whole, const std::vector<const Slab*>& covers, double low, double high,
                    double slack) {
  const double height = high - low, middle = (low + high) / 2;
  Few<Ends> parts = endsOf(whole, low, high), cuts = endsOf(covers, low, high);
  StripArea area;
  area.reach = gapsOfBoxes(parts, cuts, true);
  area.maximum = height * total(area.reach);
  area.minimum = area.maximum == 0 ? 0 : height * total(gapsOfBoxes(parts, cuts, false));
  if (area.maximum == 0) return area;
  findBulges(whole, low, high, parts);
  findBulges(covers, low, high, cuts);
  const auto upper = InOrder(parts, cuts, true, slack).width();
  const auto lower = upper ? InOrder(parts, cuts, false, slack).width() : std::nullopt;
  if (upper && lower) {
    const double rounding = 2 * slack * static_cast<double>(parts.size() + area.reach.size());
    area.maximum = std::min(area.maximum, height * (*upper + rounding));
    area.minimum = std::max(area.minimum, height * std::max(0.0, *lower - rounding));
  }
  area.gaps = gapsAt(whole, covers, middle);
  return area;
}

}  // namespace blossom::pocket
