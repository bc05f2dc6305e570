#include "kernel/grid/factor_grid.h"

#include <algorithm>

namespace blossom::sweep {

namespace {

/// Eight arrays of one row of poles: components and their v derivatives at a range of the v parameters.
void contractRow(const Vec4* poles, const BasisTable& v, const GridRange& columns, double* planes, std::size_t stride) {
  const std::size_t order = static_cast<std::size_t>(v.degree) + 1;
  for (std::size_t j = columns.begin; j < columns.end; ++j) {
    const Vec4* pole = poles + v.first[j];
    const double *n = v.value.data() + j * order, *dn = v.derivative.data() + j * order;
    Vec4 value = Vec4::Zero(), derivative = Vec4::Zero();
    for (std::size_t b = 0; b < order; ++b) {
      value += n[b] * pole[b];
      derivative += dn[b] * pole[b];
    }
    for (std::size_t c = 0; c < 4; ++c) {
      planes[c * stride + j] = value[static_cast<Eigen::Index>(c)];
      planes[(c + 4) * stride + j] = derivative[static_cast<Eigen::Index>(c)];
    }
  }
}

/// Length of an array of `count` values: whole cache lines and an odd number of them, because arrays that begin at the same
/// place modulo a power of two compete for the same few lines of the first-level cache.
std::size_t arrayLength(std::size_t count) { return ((count + 7) / 8 | 1) * 8; }

}  // namespace

FactorGrid::FactorGrid(const Surface& surface, BasisTable u, BasisTable v)
    : u_(std::move(u)), v_(std::move(v)), stride_(arrayLength(v_.size())) {
  if (u_.size() == 0) return;
  const auto [low, high] = std::minmax_element(u_.first.begin(), u_.first.end());
  firstRow_ = *low;
  rowCount_ = *high - *low + static_cast<std::size_t>(u_.degree) + 1;
  planes_.resize(rowCount_ * 8 * stride_);
  for (std::size_t i = 0; i < rowCount_; ++i)
    contractRow(&surface.pole(firstRow_ + i, 0), v_, {0, v_.size()}, planes_.data() + i * 8 * stride_, stride_);
}

void FactorGrid::updateRow(const Surface& surface, std::size_t row, const GridRange& poles) {
  if (row < firstRow_ || row >= firstRow_ + rowCount_) return;
  contractRow(&surface.pole(row, 0), v_, v_.support(poles), planes_.data() + (row - firstRow_) * 8 * stride_, stride_);
}

}  // namespace blossom::sweep
