#include "kernel/grid/changed_poles.h"

namespace blossom::sweep {

namespace {

bool sameKnots(const Surface& a, const Surface& b) {
  return a.degreeU == b.degreeU && a.degreeV == b.degreeV && a.knotsU == b.knotsU && a.knotsV == b.knotsV;
}

GridRange changedIn(const Vec4* before, const Vec4* after, std::size_t count) {
  std::size_t begin = 0, end = count;
  while (begin < end && before[begin] == after[begin]) ++begin;
  while (end > begin && before[end - 1] == after[end - 1]) --end;
  return {begin, end};
}

std::vector<GridRange> changedRows(const Surface& before, const Surface& after) {
  std::vector<GridRange> rows(before.countU());
  for (std::size_t i = 0; i < rows.size(); ++i) rows[i] = changedIn(&before.pole(i, 0), &after.pole(i, 0), before.countV());
  return rows;
}

}  // namespace

bool haveSameForm(const Motion& a, const Motion& b) {
  return a.closedU == b.closedU && a.point == b.point && a.trajectory.degree == b.trajectory.degree &&
         a.trajectory.knots == b.trajectory.knots && sameKnots(a.orientation, b.orientation) &&
         sameKnots(a.scaling, b.scaling);
}

ChangedPoles changedPoles(const Motion& before, const Motion& after) {
  return {changedRows(before.orientation, after.orientation), changedRows(before.scaling, after.scaling),
          changedIn(before.trajectory.poles.data(), after.trajectory.poles.data(), before.trajectory.poles.size())};
}

}  // namespace blossom::sweep
