#include "kernel/factor_grid.h"

#include <algorithm>

namespace blossom::sweep {

namespace {

/// Eight arrays of one row of poles: components and their v derivatives at all v parameters.
void contractRow(const Vec4* poles, const BasisTable& v, double* planes, std::size_t stride) {
  const std::size_t order = static_cast<std::size_t>(v.degree) + 1;
  for (std::size_t j = 0; j < v.size(); ++j) {
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

}  // namespace

FactorGrid::FactorGrid(const Surface& surface, BasisTable u, const BasisTable& v) : u_(std::move(u)), countV_(v.size()) {
  stride_ = (countV_ + 7) / 8 * 8;
  if (u_.size() == 0) return;
  const auto [low, high] = std::minmax_element(u_.first.begin(), u_.first.end());
  firstRow_ = *low;
  const std::size_t rows = *high - *low + static_cast<std::size_t>(u_.degree) + 1;
  planes_.resize(rows * 8 * stride_);
  for (std::size_t i = 0; i < rows; ++i)
    contractRow(&surface.pole(firstRow_ + i, 0), v, planes_.data() + i * 8 * stride_, stride_);
}

}  // namespace blossom::sweep
