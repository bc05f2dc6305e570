#include "kernel/edit/least_change.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>
#include <unordered_map>
#include <utility>

#include "core/error.h"
#include "geometry/numeric/union_find.h"

namespace blossom::sweep {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Share of the largest row below which places, and pins, count as dependent on others.
constexpr double dependent = 1e-6, dependentPin = 1e-12;
/// Directions this much weaker than the strongest enlarge rounding; a part of what is wanted that is as small as this is
/// rounding.
constexpr double enlarging = 1e-2, onlyRounding = 1e-13;

/// Places and pins that are tied together by poles that they share, and these poles.
struct Tied {
  std::vector<std::size_t> pole;  ///< increasing
  std::vector<std::size_t> moved;
  std::vector<PlaceRow> pins;
};

/// Those with a moved place, in the order of their first ones.
std::vector<Tied> tiedTogether(std::span<const PlaceRow> moved, std::span<const PlaceRow> pins) {
  const auto row = [&](std::size_t k) -> const PlaceRow& { return k < moved.size() ? moved[k] : pins[k - moved.size()]; };
  UnionFind ties(moved.size() + pins.size());
  std::unordered_map<std::size_t, std::size_t> firstAt;  // of each pole
  for (std::size_t k = 0; k < moved.size() + pins.size(); ++k)
    for (const std::size_t pole : row(k).pole) ties.unite(firstAt.try_emplace(pole, k).first->second, k);
  std::vector<Tied> groups;
  std::unordered_map<std::size_t, std::size_t> groupOf;
  for (std::size_t k = 0; k < moved.size() + pins.size(); ++k) {
    const auto found = groupOf.find(ties.find(k));
    if (k >= moved.size() && found == groupOf.end()) continue;  // a pin that nothing pulls at
    const std::size_t group =
        k < moved.size() ? groupOf.try_emplace(ties.find(k), groups.size()).first->second : found->second;
    if (group == groups.size()) groups.emplace_back();
    Tied& tied = groups[group];
    if (k < moved.size())
      tied.moved.push_back(k);
    else
      tied.pins.push_back(row(k));
    tied.pole.insert(tied.pole.end(), row(k).pole.begin(), row(k).pole.end());
  }
  for (Tied& tied : groups) {
    std::sort(tied.pole.begin(), tied.pole.end());
    tied.pole.erase(std::unique(tied.pole.begin(), tied.pole.end()), tied.pole.end());
  }
  return groups;
}

/// One column for each place, one row for each pole.
MatrixXd columnsOf(std::span<const PlaceRow> places, const std::vector<std::size_t>& poles) {
  MatrixXd columns = MatrixXd::Zero(static_cast<Index>(poles.size()), static_cast<Index>(places.size()));
  for (std::size_t k = 0; k < places.size(); ++k)
    for (std::size_t i = 0; i < places[k].pole.size(); ++i) {
      const auto found = std::lower_bound(poles.begin(), poles.end(), places[k].pole[i]);
      columns(found - poles.begin(), static_cast<Index>(k)) = places[k].share[i];
    }
  return columns;
}

/// Orthonormal columns that span those of a matrix.
MatrixXd spanOf(const MatrixXd& columns) {
  Eigen::ColPivHouseholderQR<MatrixXd> qr(columns);
  qr.setThreshold(dependentPin);
  return qr.householderQ() * MatrixXd::Identity(columns.rows(), qr.rank());
}

void removeSpan(MatrixXd& columns, const MatrixXd& span) {
  // Twice is enough: once more removes what rounding left.
  for (int pass = 0; pass < 2; ++pass) columns -= span * (span.transpose() * columns);
}

/// Places of which no two have the same row, and how many there were of each.
struct Merged {
  std::vector<PlaceRow> rows;
  Eigen::VectorXd count;
  MatrixXd wanted;  ///< the mean
};

Merged merged(std::span<const PlaceRow> moved, const MatrixXd& wanted) {
  Merged result{{}, Eigen::VectorXd::Zero(wanted.rows()), MatrixXd::Zero(wanted.rows(), wanted.cols())};
  for (std::size_t k = 0; k < moved.size(); ++k) {
    const auto same = std::find_if(result.rows.begin(), result.rows.end(), [&](const PlaceRow& row) {
      return row.pole == moved[k].pole && row.share == moved[k].share;
    });
    const Index at = same - result.rows.begin();
    if (same == result.rows.end()) result.rows.push_back(moved[k]);
    result.count[at] += 1;
    result.wanted.row(at) += wanted.row(static_cast<Index>(k));
  }
  const auto rows = static_cast<Index>(result.rows.size());
  result.count.conservativeResize(rows);
  result.wanted = (result.wanted.topRows(rows).array().colwise() / result.count.array()).matrix().eval();
  return result;
}

/// The shortest x that meets columns^T x = wanted in the least-squares sense. Directions of which `wanted` asks nothing but
/// rounding, as a share of `asked`, are left out where they would enlarge it: copies of an edit stay copies.
MatrixXd shortest(const MatrixXd& columns, const MatrixXd& wanted, double smallest, double asked) {
  const Eigen::HouseholderQR<MatrixXd> qr(columns);
  const Index count = std::min(columns.rows(), columns.cols());
  const MatrixXd right = qr.matrixQR().topRows(count).triangularView<Eigen::Upper>();
  // BDCSVD, faster beyond a hundred places, takes half a minute to compile.
  const Eigen::JacobiSVD<MatrixXd> svd(right.transpose(), Eigen::ComputeThinU | Eigen::ComputeThinV);
  const Eigen::VectorXd& values = svd.singularValues();
  MatrixXd along = svd.matrixU().transpose() * wanted;
  for (Index k = 0; k < count; ++k) {
    const bool unasked = values[k] < enlarging * values[0] && along.row(k).norm() <= onlyRounding * asked;
    if (values[k] > smallest && !unasked)
      along.row(k) /= values[k];
    else
      along.row(k).setZero();
  }
  return qr.householderQ() * MatrixXd::Identity(columns.rows(), count) * (svd.matrixV() * along);
}

/// One place and no pins.
PoleChange leastChangeOf(const PlaceRow& row, const MatrixXd& wanted) {
  const Eigen::Map<const Eigen::VectorXd> shares(row.share.data(), static_cast<Index>(row.share.size()));
  return {row.pole, shares / shares.squaredNorm() * wanted.row(0), 0, 0};
}

PoleChange solved(const Tied& tied, const Merged& places, double asked, const Progress& progress) {
  if (places.rows.size() == 1 && tied.pins.empty()) return leastChangeOf(places.rows.front(), places.wanted);
  MatrixXd free = columnsOf(places.rows, tied.pole);
  const double largest = free.colwise().norm().maxCoeff();
  MatrixXd span(free.rows(), 0);
  if (!tied.pins.empty()) {
    span = spanOf(columnsOf(tied.pins, tied.pole));
    removeSpan(free, span);
  }
  progress.check();
  const Eigen::VectorXd weight = places.count.cwiseSqrt();
  MatrixXd by = shortest(free * weight.asDiagonal(), weight.asDiagonal() * places.wanted, dependent * largest, asked);
  removeSpan(by, span);
  return {tied.pole, std::move(by), 0, 0};
}

PoleChange changeOf(const Tied& tied, std::span<const PlaceRow> moved, const MatrixXd& wanted, const Progress& progress) {
  std::vector<PlaceRow> rows;
  MatrixXd here(static_cast<Index>(tied.moved.size()), wanted.cols());
  for (const std::size_t place : tied.moved) {
    here.row(static_cast<Index>(rows.size())) = wanted.row(static_cast<Index>(place));
    rows.push_back(moved[place]);
  }
  const double asked = here.rowwise().norm().maxCoeff();
  if (asked == 0 && here.isZero(0)) return {{}, MatrixXd(0, wanted.cols()), 0, 0};
  if (tied.pole.empty()) return {{}, MatrixXd(0, wanted.cols()), asked, 0};
  PoleChange change = solved(tied, merged(rows, here), here.norm(), progress);
  if (!change.by.allFinite())
    throw Error(ErrorCode::Degenerate, "The change of the poles that this edit needs is beyond all numbers.",
                "Choose nearer targets, or places that are farther apart.");
  change.swing = change.by.rowwise().norm().maxCoeff() / asked;
  if (rows.size() > 1 || !tied.pins.empty())
    change.residual = (columnsOf(rows, tied.pole).transpose() * change.by - here).rowwise().norm().maxCoeff();
  return change;
}

/// Changes of different poles as one, with the poles in order.
PoleChange together(const std::vector<PoleChange>& parts, Index columns) {
  PoleChange all{{}, {}, 0, 0};
  std::vector<std::pair<std::size_t, Eigen::RowVectorXd>> rows;
  for (const PoleChange& part : parts) {
    for (std::size_t k = 0; k < part.pole.size(); ++k) rows.emplace_back(part.pole[k], part.by.row(static_cast<Index>(k)));
    all.residual = std::max(all.residual, part.residual);
    all.swing = std::max(all.swing, part.swing);
  }
  std::sort(rows.begin(), rows.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  all.by.resize(static_cast<Index>(rows.size()), columns);
  for (const auto& [pole, by] : rows) {
    all.by.row(static_cast<Index>(all.pole.size())) = by;
    all.pole.push_back(pole);
  }
  return all;
}

}  // namespace

PoleChange leastChange(std::span<const PlaceRow> moved, const MatrixXd& wanted, std::span<const PlaceRow> pins,
                       const Progress& progress) {
  if (wanted.isZero(0)) return {{}, MatrixXd(0, wanted.cols()), 0, 0};
  std::vector<PoleChange> parts;
  for (const Tied& tied : tiedTogether(moved, pins)) {
    progress.check();
    parts.push_back(changeOf(tied, moved, wanted, progress));
  }
  return parts.size() == 1 ? std::move(parts.front()) : together(parts, wanted.cols());
}

std::size_t applyChange(const PoleChange& change, Curve& trajectory) {
  std::size_t count = 0;
  for (std::size_t k = 0; k < change.pole.size(); ++k) {
    Vec4& pole = trajectory.poles[change.pole[k]];
    const Vec4 before = pole;
    pole.head<3>() += pole[3] * change.by.row(static_cast<Index>(k)).transpose();
    if (pole != before) ++count;
  }
  return count;
}

std::size_t applyChange(const PoleChange& change, Surface& surface, double closure) {
  const std::size_t columns = surface.countV(),
                    free = surface.countU() - (closure == 0 ? 0 : static_cast<std::size_t>(surface.degreeU));
  std::size_t count = 0;
  for (std::size_t k = 0; k < change.pole.size(); ++k) {
    const std::size_t row = change.pole[k] / columns, column = change.pole[k] % columns;
    const Vec4 before = surface.pole(row, column);
    surface.pole(row, column) += change.by.row(static_cast<Index>(k)).transpose();
    if (surface.pole(row, column) == before) continue;
    ++count;
    for (std::size_t i = row + free; i < surface.countU(); i += free)
      surface.pole(i, column) = closure * surface.pole(i - free, column);
  }
  return count;
}

}  // namespace blossom::sweep
