#include "kernel/grid/second_order.h"

#include <algorithm>

namespace blossom::sweep {

namespace {

constexpr std::size_t planesPerRow = 12;

struct RowWeights {
  double value, derivative, second;
};

/// Adds one row of poles to a block.
BLOSSOM_FOR_EACH_VECTOR_WIDTH
void addRow(const double* planes, std::size_t stride, const RowWeights& n, std::size_t count, FactorJets& out) {
  for (std::size_t c = 0; c < 4; ++c) {
    const double *value = planes + c * stride, *slope = value + 4 * stride, *bend = slope + 4 * stride;
    auto& part = out.part;
    BLOSSOM_INDEPENDENT_STEPS
    for (std::size_t j = 0; j < count; ++j) {
      part[FactorJets::Value][c][j] += n.value * value[j];
      part[FactorJets::U][c][j] += n.derivative * value[j];
      part[FactorJets::V][c][j] += n.value * slope[j];
      part[FactorJets::UU][c][j] += n.second * value[j];
      part[FactorJets::UV][c][j] += n.derivative * slope[j];
      part[FactorJets::VV][c][j] += n.value * bend[j];
    }
  }
}

}  // namespace

SecondOrderGrid::SecondOrderGrid(const Surface& surface, std::span<const double> us, std::span<const double> vs)
    : u_(tabulateBasis(surface.degreeU, surface.knotsU, us, KnotSide::Right, 2)), stride_(vs.size()) {
  const BasisTable v = tabulateBasis(surface.degreeV, surface.knotsV, vs, KnotSide::Right, 2);
  const std::size_t order = static_cast<std::size_t>(v.degree) + 1;
  const std::vector<double>* const tables[3] = {&v.value, &v.derivative, &v.second};
  planes_.resize(surface.countU() * planesPerRow * stride_);
  for (std::size_t i = 0; i < surface.countU(); ++i)
    for (std::size_t d = 0; d < 3; ++d)
      for (std::size_t l = 0; l < stride_; ++l) {
        Vec4 sum = Vec4::Zero();
        for (std::size_t b = 0; b < order; ++b) sum += (*tables[d])[l * order + b] * surface.pole(i, v.first[l] + b);
        for (std::size_t c = 0; c < 4; ++c)
          planes_[(i * planesPerRow + d * 4 + c) * stride_ + l] = sum[static_cast<Eigen::Index>(c)];
      }
}

void SecondOrderGrid::evaluate(std::size_t k, std::size_t begin, std::size_t count, FactorJets& out) const {
  out = {};
  for (std::size_t a = 0; a <= static_cast<std::size_t>(u_.degree); ++a) {
    const double* planes = planes_.data() + (u_.first[k] + a) * planesPerRow * stride_ + begin;
    addRow(planes, stride_, {u_.values(k)[a], u_.derivatives(k)[a], u_.seconds(k)[a]}, count, out);
  }
}

}  // namespace blossom::sweep
