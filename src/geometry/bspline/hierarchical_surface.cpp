#include "geometry/bspline/hierarchical_surface.h"

#include <algorithm>
#include <cmath>
#include <map>

#include "core/error.h"

namespace blossom {

namespace {

/// The spans of a space in one direction, for questions about what lies over them.
class SpanLine {
 public:
  explicit SpanLine(const SplineSpace& space) : closed_(space.closure != 0), domain_(space.domain()) {
    double from = domain_.first;
    for (const double knot : space.knots)
      if (knot > from && knot <= domain_.second) {
        middles_.push_back(from + (knot - from) / 2);
        ends_.push_back(knot);
        from = knot;
      }
  }

  [[nodiscard]] std::size_t count() const { return middles_.size(); }
  [[nodiscard]] double middle(std::size_t span) const { return middles_[span]; }
  [[nodiscard]] double end(std::size_t span) const { return ends_[span]; }
  /// Spans over a range, which in a closed direction may pass beyond the domain.
  [[nodiscard]] std::vector<std::size_t> within(double from, double to) const {
    std::vector<std::size_t> spans;
    const double period = domain_.second - domain_.first;
    if (!closed_) {
      addWithin(from, to, spans);
    } else if (to - from >= period) {
      addWithin(domain_.first, domain_.second, spans);
    } else {
      const double turns = std::floor((from - domain_.first) / period);
      for (const double back : {turns + 1, turns}) addWithin(from - back * period, to - back * period, spans);
    }
    return spans;
  }

 private:
  /// Those with their middles inside a range, in order.
  void addWithin(double from, double to, std::vector<std::size_t>& spans) const {
    auto middle = std::upper_bound(middles_.begin(), middles_.end(), from);
    for (; middle != middles_.end() && *middle < to; ++middle)
      spans.push_back(static_cast<std::size_t>(middle - middles_.begin()));
  }

  bool closed_;
  std::pair<double, double> domain_;
  std::vector<double> middles_, ends_;
};

/// The spans under each function.
std::vector<std::vector<std::size_t>> supports(const SplineSpace& functions, const SpanLine& spans) {
  std::vector<std::vector<std::size_t>> all;
  const std::size_t order = static_cast<std::size_t>(functions.degree) + 1;
  for (std::size_t i = 0; i < functions.size(); ++i)
    all.push_back(spans.within(functions.knots[i], functions.knots[i + order]));
  return all;
}

/// Which functions have all spans under them in the domain.
std::vector<char> functionsInside(const SplineSpace& u, const SplineSpace& v, const SpanLine& spansU, const SpanLine& spansV,
                                  const std::vector<char>& domain) {
  const auto overU = supports(u, spansU), overV = supports(v, spansV);
  std::vector<char> inside;
  inside.reserve(overU.size() * overV.size());
  for (const auto& a : overU)
    for (const auto& b : overV)
      inside.push_back(std::all_of(a.begin(), a.end(), [&](std::size_t i) {
        return std::all_of(b.begin(), b.end(), [&](std::size_t j) { return domain[i * spansV.count() + j] != 0; });
      }));
  return inside;
}

/// For each span the one of the level above that it lies in.
std::vector<std::size_t> spansAbove(const SpanLine& spans, const SpanLine& above) {
  std::vector<std::size_t> index(spans.count());
  for (std::size_t i = 0, k = 0; i < index.size(); index[i++] = k)
    while (k + 1 < above.count() && spans.middle(i) > above.end(k)) ++k;
  return index;
}

/// The spans of a level that lie in one of the boxes, and in the domain of the level above.
std::vector<char> spansInBoxes(const SpanLine& u, const SpanLine& v, std::span<const ParameterBox> where,
                               const SpanLine& aboveU, const SpanLine& aboveV, const std::vector<char>& above) {
  std::vector<char> domain(u.count() * v.count(), 0);
  for (const ParameterBox& box : where)
    for (const std::size_t i : u.within(box.firstU, box.lastU))
      for (const std::size_t j : v.within(box.firstV, box.lastV)) domain[i * v.count() + j] = 1;
  const std::vector<std::size_t> inU = spansAbove(u, aboveU), inV = spansAbove(v, aboveV);
  for (std::size_t i = 0; i < u.count(); ++i)
    for (std::size_t j = 0; j < v.count(); ++j)
      if (!above[inU[i] * aboveV.count() + inV[j]]) domain[i * v.count() + j] = 0;
  return domain;
}

}  // namespace

HierarchicalSurface::HierarchicalSurface(SplineSpace u, SplineSpace v, std::vector<Vec4> coefficients) {
  const std::size_t functions = u.size() * v.size(), spans = SpanLine(u).count() * SpanLine(v).count();
  if (coefficients.size() != functions)
    throw Error(ErrorCode::InvalidInput, "A hierarchical surface needs one coefficient for each function.");
  levels_.push_back({std::move(u),
                     std::move(v),
                     {},
                     {},
                     std::vector<char>(spans, 1),
                     std::vector<char>(functions, 1),
                     std::vector<char>(functions, 0),
                     std::move(coefficients)});
}

void HierarchicalSurface::refine(SplineSpace u, SplineSpace v, std::span<const ParameterBox> where) {
  Level& above = levels_.back();
  Level level{u, v, embedding(above.u, u), embedding(above.v, v), {}, {}, {}, {}};
  const SpanLine spansU(u), spansV(v);
  level.domain = spansInBoxes(spansU, spansV, where, SpanLine(above.u), SpanLine(above.v), above.domain);
  level.inside = functionsInside(u, v, spansU, spansV, level.domain);
  level.covered.assign(level.inside.size(), 0);
  level.coefficients = mapped(level.fromU, level.fromV, finest());
  for (std::size_t k = 0; k < level.inside.size(); ++k)
    if (!level.inside[k]) level.coefficients[k].setZero();
  above.covered = functionsInside(above.u, above.v, spansU, spansV, level.domain);
  for (std::size_t k = 0; k < above.covered.size(); ++k)
    if (above.covered[k]) above.coefficients[k].setZero();
  levels_.push_back(std::move(level));
}

std::vector<Vec4> HierarchicalSurface::finest() const {
  std::vector<Vec4> all = levels_.front().coefficients;
  for (std::size_t l = 1; l < levels_.size(); ++l) {
    const Level& level = levels_[l];
    all = mapped(level.fromU, level.fromV, all);
    for (std::size_t k = 0; k < all.size(); ++k)
      if (level.inside[k]) all[k] = level.coefficients[k];
  }
  return all;
}

std::vector<HierarchicalSurface::ActiveValue> HierarchicalSurface::activeAt(double u, double v) const {
  // What the functions of a level are worth at the place, those left out that are written in finer ones. From the finest
  // level on, what a function is worth that is not of its level is what its coefficient takes from the coarser ones.
  std::map<std::size_t, double> worth;
  const std::vector<FunctionValue> inU = functionsAt(levels_.back().u, u), inV = functionsAt(levels_.back().v, v);
  for (const FunctionValue& a : inU)
    for (const FunctionValue& b : inV) worth[a.function * levels_.back().v.size() + b.function] = a.value * b.value;

  std::vector<ActiveValue> result;
  for (std::size_t l = levels_.size(); l-- > 0;) {
    const Level& level = levels_[l];
    std::map<std::size_t, double> above;
    for (const auto& [function, value] : worth) {
      if (active(l, function) && value != 0) result.push_back({l, function, value});
      if (level.inside[function]) continue;
      const std::size_t i = function / level.v.size(), j = function % level.v.size();
      for (std::size_t a = level.fromU.begin[i]; a < level.fromU.begin[i + 1]; ++a)
        for (std::size_t b = level.fromV.begin[j]; b < level.fromV.begin[j + 1]; ++b)
          above[level.fromU.coarse[a] * level.fromV.columns + level.fromV.coarse[b]] +=
              value * (level.fromU.weight[a] * level.fromV.weight[b]);
    }
    worth = std::move(above);
  }
  return result;
}

Vec4 HierarchicalSurface::evaluate(double u, double v) const {
  Vec4 sum = Vec4::Zero();
  for (const ActiveValue& each : activeAt(u, v)) sum += each.value * coefficient(each.level, each.function);
  return sum;
}

}  // namespace blossom
