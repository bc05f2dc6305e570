#include "kernel/grid/grid_rows.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "core/parallel.h"
#include "kernel/grid/factor_block.h"
#include "kernel/grid/frame_arithmetic.h"
#include "kernel/grid/vector_width.h"

namespace blossom::sweep {

namespace {

/// Rows that one thread evaluates at a time: with a block of columns some tens of microseconds.
constexpr std::size_t bandSize = 64;

BLOSSOM_INLINE Triple unit(const Triple& n) {
  // A vanishing normal stays zero: the smallest double under the root keeps the division finite.
  const double scale = 1 / std::sqrt(n.x * n.x + n.y * n.y + n.z * n.z + std::numeric_limits<double>::min());
  return {n.x * scale, n.y * scale, n.z * scale};
}

/// Three arrays, one for each coordinate, from the first column of a block on.
template <class T>
struct Arrays {
  T *x, *y, *z;
};
BLOSSOM_INLINE void put(const Triple& value, const Arrays<double>& to, std::size_t j) {
  to.x[j] = value.x, to.y[j] = value.y, to.z[j] = value.z;
}

struct TrajectoryBlock {
  Arrays<const double> point, derivative;
};
struct OutputBlock {
  Arrays<double> point, normal, du, dv;
};

/// Order of the coordinates: a cyclic one that makes the axis of p the third, which keeps every formula.
struct Order {
  std::size_t first = 0, second = 1, third = 2;
};
BLOSSOM_INLINE Order endingWith(std::size_t axis) { return {(axis + 1) % 3, (axis + 2) % 3, axis}; }

template <class T, class Vectors>
BLOSSOM_INLINE Arrays<T> arraysAt(Vectors& from, const Order& order, std::size_t at) {
  return {from[order.first].data() + at, from[order.second].data() + at, from[order.third].data() + at};
}

/// Points, normals and derivatives of one block from its two factors, for any p.
template <bool Derivatives>
BLOSSOM_INLINE void combine(const FactorBlock& r, const FactorBlock& s, const Vec3& p, const TrajectoryBlock& t,
                            std::size_t count, const OutputBlock& out) {
  const double p0 = p.x(), p1 = p.y(), p2 = p.z();
  BLOSSOM_INDEPENDENT_STEPS
  for (std::size_t j = 0; j < count; ++j) {
    const double w = r.value[0][j], x = r.value[1][j], y = r.value[2][j], z = r.value[3][j];
    const double inverseSw = 1 / s.value[3][j], two = 2 / (w * w + x * x + y * y + z * z);
    const Triple a = {s.value[0][j] * p0 * inverseSw, s.value[1][j] * p1 * inverseSw, s.value[2][j] * p2 * inverseSw};
    // The rotation matrix R = Q(r) / |r|^2.
    const double x2 = x * two, y2 = y * two, z2 = z * two;
    const double xx = x * x2, yy = y * y2, zz = z * z2, xy = x * y2, xz = x * z2, yz = y * z2;
    const double wx = w * x2, wy = w * y2, wz = w * z2;
    const auto turned = [&](const Triple& b, const Triple& plus) __attribute__((always_inline)) {
      return Triple{plus.x + (1 - yy - zz) * b.x + (xy - wz) * b.y + (xz + wy) * b.z,
                    plus.y + (xy + wz) * b.x + (1 - xx - zz) * b.y + (yz - wx) * b.z,
                    plus.z + (xz - wy) * b.x + (yz + wx) * b.y + (1 - xx - yy) * b.z};
    };
    // Derivative of R a in the moving frame: a_u + W_u x a.
    const auto moved = [&](const double(&dr)[4][blockSize], const double(&ds)[4][blockSize]) __attribute__((always_inline)) {
      const double ew = dr[0][j], ex = dr[1][j], ey = dr[2][j], ez = dr[3][j];
      const Triple turn = {(w * ex - x * ew - y * ez + z * ey) * two, (w * ey - y * ew - z * ex + x * ez) * two,
                           (w * ez - z * ew - x * ey + y * ex) * two};
      const Triple swung = cross(turn, a);
      return Triple{(ds[0][j] * p0 - a.x * ds[3][j]) * inverseSw + swung.x,
                    (ds[1][j] * p1 - a.y * ds[3][j]) * inverseSw + swung.y,
                    (ds[2][j] * p2 - a.z * ds[3][j]) * inverseSw + swung.z};
    };
    put(turned(a, {t.point.x[j], t.point.y[j], t.point.z[j]}), out.point, j);
    const Triple xu = turned(moved(r.du, s.du), {0, 0, 0});
    const Triple xv = turned(moved(r.dv, s.dv), {t.derivative.x[j], t.derivative.y[j], t.derivative.z[j]});
    put(unit(cross(xu, xv)), out.normal, j);
    if constexpr (Derivatives) put(xu, out.du, j), put(xv, out.dv, j);
  }
}

/// The same for p = length * e, e the third axis in the order of the blocks; of the scaling, slots 2 and 3 are needed.
template <bool Derivatives>
BLOSSOM_INLINE void combineOnAxis(const FactorBlock& r, const FactorBlock& s, double length, const TrajectoryBlock& t,
                                  std::size_t count, const OutputBlock& out) {
  BLOSSOM_INDEPENDENT_STEPS
  for (std::size_t j = 0; j < count; ++j) {
    const double w = r.value[0][j], x = r.value[1][j], y = r.value[2][j], z = r.value[3][j], sw = s.value[3][j];
    const double low = x * x + y * y, high = w * w + z * z, d = low + high;
    // One division for both reciprocals.
    const double inverse = 1 / (sw * d), inverseSw = inverse * d, one = inverse * sw, two = one + one;
    const Triple c = {(x * z + w * y) * two, (y * z - w * x) * two, (high - low) * one};
    const double a = s.value[2][j] * length * inverseSw, swing = a * two;
    // x_u = a_u c + a c_u, with vec(r_u e conj(r)) written out.
    const auto moved = [&](const double(&dr)[4][blockSize], const double(&ds)[4][blockSize], const Triple& plus)
        __attribute__((always_inline)) {
      const double ew = dr[0][j], ex = dr[1][j], ey = dr[2][j], ez = dr[3][j];
      const double along = (ds[2][j] * length - a * ds[3][j]) * inverseSw - swing * (w * ew + x * ex + y * ey + z * ez);
      return Triple{plus.x + along * c.x + swing * (y * ew + z * ex + w * ey + x * ez),
                    plus.y + along * c.y + swing * (z * ey - x * ew - w * ex + y * ez),
                    plus.z + along * c.z + swing * (w * ew - x * ex - y * ey + z * ez)};
    };
    put({t.point.x[j] + a * c.x, t.point.y[j] + a * c.y, t.point.z[j] + a * c.z}, out.point, j);
    const Triple xu = moved(r.du, s.du, {0, 0, 0});
    const Triple xv = moved(r.dv, s.dv, {t.derivative.x[j], t.derivative.y[j], t.derivative.z[j]});
    put(unit(cross(xu, xv)), out.normal, j);
    if constexpr (Derivatives) put(xu, out.du, j), put(xv, out.dv, j);
  }
}

/// The axis of the moving frame on which p lies; 3 when it lies on none.
BLOSSOM_INLINE std::size_t axisOf(const Vec3& p) {
  if (p.x() == 0 && p.y() == 0) return 2;
  if (p.y() == 0 && p.z() == 0) return 0;
  return p.z() == 0 && p.x() == 0 ? 1 : 3;
}

BLOSSOM_INLINE OutputBlock outputAt(MotionGrid& grid, const Order& order, std::size_t at) {
  const std::size_t derivative = grid.du[0].empty() ? 0 : at;
  return {arraysAt<double>(grid.point, order, at), arraysAt<double>(grid.normal, order, at),
          arraysAt<double>(grid.du, order, derivative), arraysAt<double>(grid.dv, order, derivative)};
}

/// A block of columns, all rows of the rectangle one after the other: neighbouring ones need the same rows of poles.
template <bool Derivatives>
BLOSSOM_INLINE void evaluateColumns(const GridFactors& factors, const GridRange& rows, std::size_t begin, std::size_t count,
                                    MotionGrid& grid) {
  const std::size_t axis = axisOf(factors.point);
  const Order order = axis < 3 ? endingWith(axis) : Order{};
  const auto& table = factors.trajectory;
  const TrajectoryBlock t = {arraysAt<const double>(table.point, order, begin),
                             arraysAt<const double>(table.derivative, order, begin)};
  const std::size_t turning[4] = {0, order.first + 1, order.second + 1, order.third + 1},
                    scaling[4] = {order.first, order.second, order.third, 3};
  FactorBlock r, s;
  PowerBlock powersOfR, powersOfS;
  for (std::size_t k = rows.begin; k < rows.end; ++k) {
    const OutputBlock out = outputAt(grid, order, k * grid.countV + begin);
    sumFactor<0>(factorRow(factors.orientation, k, begin), turning, count, powersOfR, r);
    if (axis < 3) {
      sumFactor<2>(factorRow(factors.scaling, k, begin), scaling, count, powersOfS, s);
      combineOnAxis<Derivatives>(r, s, factors.point[static_cast<Eigen::Index>(axis)], t, count, out);
    } else {
      sumFactor<0>(factorRow(factors.scaling, k, begin), scaling, count, powersOfS, s);
      combine<Derivatives>(r, s, factors.point, t, count, out);
    }
  }
}

template <bool Derivatives>
BLOSSOM_INLINE void evaluateColumns(const GridFactors& factors, const GridRange& rows, std::size_t begin, MotionGrid& grid) {
  // Nearly all blocks are whole ones: with their constant size the loops need no remainders.
  if (begin + blockSize <= grid.countV) {
    evaluateColumns<Derivatives>(factors, rows, begin, blockSize, grid);
  } else {
    evaluateColumns<Derivatives>(factors, rows, begin, grid.countV - begin, grid);
  }
}

BLOSSOM_FOR_EACH_VECTOR_WIDTH
void evaluateBlock(const GridFactors& factors, const GridRange& rows, std::size_t begin, MotionGrid& grid) {
  if (grid.du[0].empty()) {
    evaluateColumns<false>(factors, rows, begin, grid);
  } else {
    evaluateColumns<true>(factors, rows, begin, grid);
  }
}

FactorGrid tabulate(const Surface& factor, std::span<const double> us, std::span<const double> vs) {
  return {factor, us, tabulateBasis(factor.degreeU, factor.knotsU, us), tabulateBasis(factor.degreeV, factor.knotsV, vs)};
}

}  // namespace

GridFactors tabulateFactors(const Motion& motion, std::span<const double> us, std::span<const double> vs) {
  GridFactors factors{tabulate(motion.orientation, us, vs), tabulate(motion.scaling, us, vs), {}, motion.point};
  const Curve& t = motion.trajectory;
  tabulateTrajectory(t, tabulateBasis(t.degree, t.knots, vs), {0, vs.size()}, factors.trajectory);
  return factors;
}

void evaluateRows(const GridFactors& factors, const GridRectangle& part, MotionGrid& grid) {
  const auto piecesOf = [](const GridRange& range, std::size_t size) { return (range.end - range.begin + size - 1) / size; };
  const std::size_t blocks = piecesOf(part.columns, blockSize), bands = piecesOf(part.rows, bandSize);
  const auto evaluate = [&](std::size_t from, std::size_t to) {
    for (std::size_t piece = from; piece < to; ++piece) {
      const std::size_t first = part.rows.begin + piece % bands * bandSize;
      const GridRange rows{first, std::min(first + bandSize, part.rows.end)};
      evaluateBlock(factors, rows, part.columns.begin + piece / bands * blockSize, grid);
    }
  };
  parallelFor(blocks * bands, 2, Progress::none(), evaluate);
}

GridRange wholeBlocks(const GridRange& columns, std::size_t count) {
  if (columns.empty()) return {};
  return {columns.begin / blockSize * blockSize, std::min((columns.end + blockSize - 1) / blockSize * blockSize, count)};
}

}  // namespace blossom::sweep
