#include "kernel/edit/least_change.h"

#include <Eigen/QR>
#include <Eigen/SVD>
#include <algorithm>

#include "core/error.h"

namespace blossom::sweep {

namespace {

using Eigen::Index;
using Eigen::MatrixXd;

/// Share of the largest row below which places, and pins, count as dependent on others.
constexpr double dependent = 1e-6, dependentPin = 1e-12;
/// Directions this much weaker than the strongest enlarge rounding; a part of what is wanted that is as small as this is
/// rounding.
constexpr double enlarging = 1e-2, onlyRounding = 1e-13;

/// The poles that may change, and the pins that restrict them.
struct Involved {
  std::vector<std::size_t> pole;  ///< increasing
  std::vector<PlaceRow> pins;
};

bool touches(const PlaceRow& row, const std::vector<std::size_t>& poles) {
  return std::any_of(row.pole.begin(), row.pole.end(),
                     [&](std::size_t each) { return std::binary_search(poles.begin(), poles.end(), each); });
}

void include(const PlaceRow& row, std::vector<std::size_t>& poles) {
  poles.insert(poles.end(), row.pole.begin(), row.pole.end());
  std::sort(poles.begin(), poles.end());
  poles.erase(std::unique(poles.begin(), poles.end()), poles.end());
}

/// The poles under the moved places, and those by which pins among them can be held, and so on.
Involved involved(std::span<const PlaceRow> moved, std::span<const PlaceRow> pins) {
  Involved result;
  for (const PlaceRow& row : moved) include(row, result.pole);
  std::vector<const PlaceRow*> waiting;
  for (const PlaceRow& pin : pins) waiting.push_back(&pin);
  for (bool grown = true; grown;) {
    grown = false;
    for (const PlaceRow*& pin : waiting) {
      if (!pin || !touches(*pin, result.pole)) continue;
      include(*pin, result.pole);
      result.pins.push_back(*pin);
      pin = nullptr, grown = true;
    }
  }
  return result;
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
  return {row.pole, shares / shares.squaredNorm() * wanted.row(0), 0};
}

PoleChange solved(const Involved& all, const Merged& places, double asked, const Progress& progress) {
  if (places.rows.size() == 1 && all.pins.empty()) return leastChangeOf(places.rows.front(), places.wanted);
  MatrixXd free = columnsOf(places.rows, all.pole);
  const double largest = free.colwise().norm().maxCoeff();
  MatrixXd span(free.rows(), 0);
  if (!all.pins.empty()) {
    span = spanOf(columnsOf(all.pins, all.pole));
    removeSpan(free, span);
  }
  progress.check();
  const Eigen::VectorXd weight = places.count.cwiseSqrt();
  MatrixXd by = shortest(free * weight.asDiagonal(), weight.asDiagonal() * places.wanted, dependent * largest, asked);
  removeSpan(by, span);
  return {all.pole, std::move(by), 0};
}

}  // namespace

PoleChange leastChange(std::span<const PlaceRow> moved, const MatrixXd& wanted, std::span<const PlaceRow> pins,
                       const Progress& progress) {
  if (wanted.isZero(0)) return {{}, MatrixXd(0, wanted.cols()), 0};
  const Involved all = involved(moved, pins);
  if (all.pole.empty()) return {{}, MatrixXd(0, wanted.cols()), wanted.rowwise().norm().maxCoeff()};
  progress.check();
  PoleChange change = solved(all, merged(moved, wanted), wanted.norm(), progress);
  if (!change.by.allFinite())
    throw Error(ErrorCode::Degenerate, "The change of the poles that this edit needs is beyond all numbers.",
                "Choose nearer targets, or places that are farther apart.");
  if (moved.size() > 1 || !all.pins.empty())
    change.residual = (columnsOf(moved, all.pole).transpose() * change.by - wanted).rowwise().norm().maxCoeff();
  return change;
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
