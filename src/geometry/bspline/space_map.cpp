// How a space of splines lies in a finer one.
#include <algorithm>
#include <map>

#include "core/error.h"
#include "geometry/bspline/bspline_rows.h"
#include "geometry/bspline/spline_space.h"

namespace blossom {

namespace {

using detail::PoleRows;

/// One period of a closed space, u0..un, and the knots of a run of periods: u0 of period t is at index t * n of all.
class PeriodicKnots {
 public:
  explicit PeriodicKnots(const SplineSpace& space)
      : period_(space.knots.begin() + space.degree, space.knots.end() - space.degree) {}

  [[nodiscard]] std::size_t count() const { return period_.size() - 1; }
  /// Knots with indices `from` .. `to`, the end not among them.
  [[nodiscard]] std::vector<double> run(long from, long to) const {
    const long n = static_cast<long>(count());
    std::vector<double> knots;
    for (long i = from; i < to; ++i) {
      const long turns = i >= 0 ? i / n : -((-i + n - 1) / n);
      knots.push_back(shifted(period_[static_cast<std::size_t>(i - turns * n)], turns));
    }
    return knots;
  }

 private:
  /// Depends on the value and the period alone, so that a knot has the same copies at every level. The end is the start.
  [[nodiscard]] double shifted(double knot, long turns) const {
    const double first = period_.front(), last = period_.back();
    if (knot == last) knot = first, ++turns;
    if (turns == 0) return knot;
    return turns == 1 && knot == first ? last : knot + static_cast<double>(turns) * (last - first);
  }

  std::vector<double> period_;
};

void requireNested(const SplineSpace& coarse, const SplineSpace& fine) {
  const auto part = [](const SplineSpace& space) {
    const std::ptrdiff_t outside = space.closure == 0 ? 0 : space.degree;
    return std::pair(space.knots.begin() + outside, space.knots.end() - outside);
  };
  const auto [fineBegin, fineEnd] = part(fine);
  const auto [coarseBegin, coarseEnd] = part(coarse);
  if (coarse.degree != fine.degree || coarse.closure != fine.closure || coarse.domain() != fine.domain() ||
      !std::includes(fineBegin, fineEnd, coarseBegin, coarseEnd))
    throw Error(ErrorCode::InvalidInput, "A space of splines does not hold the coarser one.",
                "Give both the same degree, domain and closure, and the finer one all knots of the coarser.");
}

/// A function that both spaces have keeps its coefficient to the last bit, which quotients of knots would not.
PoleRows exactWhereEqual(PoleRows rows, const std::vector<double>& from, const std::vector<double>& to) {
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const auto begin = rows.weights.begin() + static_cast<std::ptrdiff_t>(i * rows.width),
               end = begin + static_cast<std::ptrdiff_t>(rows.width), largest = std::max_element(begin, end);
    const auto knots = to.begin() + static_cast<std::ptrdiff_t>(i);
    const auto function = static_cast<std::ptrdiff_t>(rows.first[i]) + (largest - begin);
    if (!std::equal(knots, knots + static_cast<std::ptrdiff_t>(rows.width) + 1, from.begin() + function)) continue;
    std::fill(begin, end, 0.0);
    *largest = 1;
  }
  return rows;
}

PoleRows rowsBetween(int degree, const std::vector<double>& from, const std::vector<double>& to) {
  return exactWhereEqual(detail::refinementRows(degree, from, to), from, to);
}

void closeRow(SpaceMap& map) { map.begin.push_back(map.weight.size()); }

SpaceMap openMap(const PoleRows& rows, std::size_t columns) {
  SpaceMap map{columns};
  for (std::size_t i = 0; i < rows.size(); ++i, closeRow(map))
    for (std::size_t k = 0; k < rows.width; ++k) {
      const double weight = rows.weights[i * rows.width + k];
      if (weight == 0) continue;
      map.coarse.push_back(rows.first[i] + k);
      map.weight.push_back(weight);
    }
  return map;
}

SpaceMap closedMap(const SplineSpace& coarse, const SplineSpace& fine) {
  const PeriodicKnots wide(coarse), narrow(fine);
  const long p = fine.degree, m = static_cast<long>(wide.count()), n = static_cast<long>(narrow.count());
  // As far as the functions of one fine period and those above them reach.
  const long periods = (2 * p + 2) / std::min(m, n) + 2, start = -periods * m;
  const PoleRows rows = rowsBetween(fine.degree, wide.run(start, periods * m + 1), narrow.run(-p, n + 1));
  SpaceMap map{static_cast<std::size_t>(m)};
  std::vector<std::pair<std::size_t, double>> sums;  // columns of one row, some of them copies of one another
  for (std::size_t i = 0; i < rows.size(); ++i, closeRow(map)) {
    sums.clear();
    for (std::size_t k = 0; k < rows.width; ++k) {
      const long row = start + p + static_cast<long>(rows.first[i] + k);  // of the unwrapped poles
      const long turns = row >= 0 ? row / m : -((-row + m - 1) / m);
      const double weight = rows.weights[i * rows.width + k];
      const auto column = static_cast<std::size_t>(row - turns * m);
      const auto known = std::find_if(sums.begin(), sums.end(), [&](const auto& each) { return each.first == column; });
      double& sum = known == sums.end() ? sums.emplace_back(column, 0.0).second : known->second;
      sum += afterPeriods(coarse.closure, turns) * weight;
    }
    std::sort(sums.begin(), sums.end());
    for (const auto& [column, sum] : sums) {
      if (sum == 0) continue;
      map.coarse.push_back(column);
      map.weight.push_back(sum);
    }
  }
  return map;
}

/// The first entry is not added to 0, which would lose the sign of a zero.
void combineRow(const SpaceMap& map, std::size_t row, const Vec4* coarse, std::size_t length, Vec4* fine) {
  for (std::size_t e = map.begin[row]; e < map.begin[row + 1]; ++e)
    for (std::size_t j = 0; j < length; ++j) {
      const Vec4 part = map.weight[e] * coarse[map.coarse[e] * length + j];
      fine[j] = e == map.begin[row] ? part : Vec4(fine[j] + part);
    }
}

}  // namespace

SpaceMap embedding(const SplineSpace& coarse, const SplineSpace& fine) {
  requireNested(coarse, fine);
  if (fine.closure != 0) return closedMap(coarse, fine);
  return openMap(rowsBetween(fine.degree, coarse.knots, fine.knots), coarse.size());
}

SpaceMap composed(const SpaceMap& first, const SpaceMap& second) {
  SpaceMap map{first.columns};
  for (std::size_t i = 0; i < second.rows(); ++i, closeRow(map)) {
    std::map<std::size_t, double> row;
    for (std::size_t e = second.begin[i]; e < second.begin[i + 1]; ++e)
      for (std::size_t f = first.begin[second.coarse[e]]; f < first.begin[second.coarse[e] + 1]; ++f)
        row[first.coarse[f]] += second.weight[e] * first.weight[f];
    for (const auto& [column, weight] : row) {
      if (weight == 0) continue;
      map.coarse.push_back(column);
      map.weight.push_back(weight);
    }
  }
  return map;
}

std::vector<Vec4> mapped(const SpaceMap& map, const std::vector<Vec4>& coefficients) {
  std::vector<Vec4> fine(map.rows(), Vec4::Zero());
  for (std::size_t i = 0; i < fine.size(); ++i) combineRow(map, i, coefficients.data(), 1, &fine[i]);
  return fine;
}

std::vector<Vec4> mapped(const SpaceMap& u, const SpaceMap& v, const std::vector<Vec4>& coefficients) {
  std::vector<Vec4> along(u.columns * v.rows(), Vec4::Zero()), fine(u.rows() * v.rows(), Vec4::Zero());
  for (std::size_t i = 0; i < u.columns; ++i)
    for (std::size_t j = 0; j < v.rows(); ++j) combineRow(v, j, &coefficients[i * v.columns], 1, &along[i * v.rows() + j]);
  for (std::size_t i = 0; i < u.rows(); ++i) combineRow(u, i, along.data(), v.rows(), &fine[i * v.rows()]);
  return fine;
}

}  // namespace blossom
