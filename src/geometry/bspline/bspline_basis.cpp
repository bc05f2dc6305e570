#include <algorithm>
#include <array>

#include "geometry/bspline/bspline.h"

namespace blossom {

std::size_t findSpan(int degree, std::span<const double> knots, double t) {
  const auto first = knots.begin() + degree, last = knots.end() - degree - 1;
  if (t < *first) t = *first;
  auto above = std::upper_bound(first, last, t);
  if (above == last) above = std::lower_bound(first, last, *last);  // at the end, and beyond it
  return static_cast<std::size_t>(above - knots.begin()) - 1;
}

namespace {

using Row = std::array<double, kMaximumDegree + 1>;

/// The Cox-de Boor triangle of one span: basis functions of all degrees above the diagonal, knot differences below it.
struct Triangle {
  std::array<Row, kMaximumDegree + 1> value;
};

void fillTriangle(Triangle& triangle, int degree, std::span<const double> knots, std::size_t span, double t) {
  auto& n = triangle.value;
  Row left, right;
  n[0][0] = 1;
  for (int j = 1; j <= degree; ++j) {
    left[j] = t - knots[span + 1 - j];
    right[j] = knots[span + j] - t;
    double saved = 0;
    for (int r = 0; r < j; ++r) {
      n[j][r] = right[r + 1] + left[j - r];
      // two quotients instead of one: at the ends of a clamped domain they are exactly 0 and 1
      n[r][j] = saved + n[r][j - 1] * (right[r + 1] / n[j][r]);
      saved = n[r][j - 1] * (left[j - r] / n[j][r]);
    }
    n[j][j] = saved;
  }
}

/// Values alone, without keeping the triangle; two quotients for the same reason.
void basisValues(int degree, std::span<const double> knots, std::size_t span, double t, double* out) {
  Row left, right;
  out[0] = 1;
  for (int j = 1; j <= degree; ++j) {
    left[j] = t - knots[span + 1 - j];
    right[j] = knots[span + j] - t;
    double saved = 0;
    for (int r = 0; r < j; ++r) {
      const double length = right[r + 1] + left[j - r], old = out[r];
      out[r] = saved + old * (right[r + 1] / length);
      saved = old * (left[j - r] / length);
    }
    out[j] = saved;
  }
}

}  // namespace

void basisDerivatives(int degree, std::span<const double> knots, std::size_t span, double t, int order,
                      std::span<double> out) {
  if (order == 0) return basisValues(degree, knots, span, t, out.data());
  Triangle triangle;
  fillTriangle(triangle, degree, knots, span, t);
  const auto& n = triangle.value;
  const int p = degree, width = degree + 1;
  std::fill(out.begin(), out.begin() + static_cast<std::ptrdiff_t>(order + 1) * width, 0.0);
  for (int j = 0; j <= p; ++j) out[j] = n[j][p];

  std::array<Row, 2> a;
  for (int r = 0; r <= p; ++r) {
    int current = 0, next = 1;
    a[0][0] = 1;
    for (int k = 1; k <= std::min(order, p); ++k) {
      double sum = 0;
      const int rk = r - k, pk = p - k;
      if (r >= k) {
        a[next][0] = a[current][0] / n[pk + 1][rk];
        sum = a[next][0] * n[rk][pk];
      }
      const int from = rk >= -1 ? 1 : -rk, to = r - 1 <= pk ? k - 1 : p - r;
      for (int j = from; j <= to; ++j) {
        a[next][j] = (a[current][j] - a[current][j - 1]) / n[pk + 1][rk + j];
        sum += a[next][j] * n[rk + j][pk];
      }
      if (r <= pk) {
        a[next][k] = -a[current][k - 1] / n[pk + 1][r];
        sum += a[next][k] * n[r][pk];
      }
      out[k * width + r] = sum;
      std::swap(current, next);
    }
  }
  double factor = p;
  for (int k = 1; k <= std::min(order, p); ++k) {
    for (int j = 0; j <= p; ++j) out[k * width + j] *= factor;
    factor *= p - k;
  }
}

}  // namespace blossom
