#include "kernel/motion_grid.h"

#include <cmath>
#include <limits>

#include "kernel/factor_grid.h"

// One source, compiled for several vector widths; the loader picks. Sanitizers do not get along with such symbols.
#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && \
    !defined(__SANITIZE_THREAD__)
#define BLOSSOM_FOR_EACH_VECTOR_WIDTH __attribute__((target_clones("avx512f", "fma", "default")))
#else
#define BLOSSOM_FOR_EACH_VECTOR_WIDTH
#endif
#define BLOSSOM_INLINE inline __attribute__((always_inline))

namespace blossom::sweep {

namespace {

/// What a row of the grid needs of a factor at one u.
struct FactorRow {
  const double* rows;
  const double* n;
  const double* dn;
  std::size_t stride;
  int degree;
};

/// The trajectory as Euclidean points and derivatives, one array for each coordinate.
struct TrajectoryTable {
  std::array<std::vector<double>, 3> point, derivative;
};

struct OutputRow {
  double *px, *py, *pz, *nx, *ny, *nz;
  double* derivatives[6];
};

template <int Degree>
BLOSSOM_INLINE void sumRows(const FactorRow& row, std::size_t begin, std::size_t count, FactorBlock& out) {
  for (std::size_t c = 0; c < 4; ++c) {
    const double* value = row.rows + c * row.stride + begin;
    const double* slope = value + 4 * row.stride;
    const std::size_t next = 8 * row.stride;
    double *f = out.value[c], *fu = out.du[c], *fv = out.dv[c];
    for (std::size_t j = 0; j < count; ++j) {
      double a = 0, b = 0, d = 0;
      for (int k = 0; k <= Degree; ++k) {
        const double x = value[static_cast<std::size_t>(k) * next + j];
        a += row.n[k] * x;
        b += row.dn[k] * x;
        d += row.n[k] * slope[static_cast<std::size_t>(k) * next + j];
      }
      f[j] = a, fu[j] = b, fv[j] = d;
    }
  }
}

BLOSSOM_INLINE void sumRowsOfAnyDegree(const FactorRow& row, std::size_t begin, std::size_t count, FactorBlock& out) {
  for (std::size_t c = 0; c < 4; ++c) {
    double *f = out.value[c], *fu = out.du[c], *fv = out.dv[c];
    for (std::size_t j = 0; j < count; ++j) f[j] = fu[j] = fv[j] = 0;
    for (int k = 0; k <= row.degree; ++k) {
      const double* value = row.rows + (static_cast<std::size_t>(k) * 8 + c) * row.stride + begin;
      const double* slope = value + 4 * row.stride;
      const double n = row.n[k], dn = row.dn[k];
      for (std::size_t j = 0; j < count; ++j) {
        f[j] += n * value[j];
        fu[j] += dn * value[j];
        fv[j] += n * slope[j];
      }
    }
  }
}

BLOSSOM_INLINE void sumRows(const FactorRow& row, std::size_t begin, std::size_t count, FactorBlock& out) {
  if (row.degree == 3) {
    sumRows<3>(row, begin, count, out);
  } else {
    sumRowsOfAnyDegree(row, begin, count, out);
  }
}

struct Triple {
  double x, y, z;
};
BLOSSOM_INLINE Triple cross(const Triple& a, const Triple& b) {
  return {a.y * b.z - a.z * b.y, a.z * b.x - a.x * b.z, a.x * b.y - a.y * b.x};
}

/// Points, normals and derivatives of one block from its two factors.
BLOSSOM_INLINE void combine(const FactorBlock& r, const FactorBlock& s, const Vec3& p, const TrajectoryTable& t,
                            std::size_t begin, std::size_t count, const OutputRow& out, bool derivatives) {
  const double *tx = t.point[0].data() + begin, *ty = t.point[1].data() + begin, *tz = t.point[2].data() + begin;
  const double *dtx = t.derivative[0].data() + begin, *dty = t.derivative[1].data() + begin,
               *dtz = t.derivative[2].data() + begin;
  double* __restrict px = out.px + begin, * __restrict py = out.py + begin, * __restrict pz = out.pz + begin;
  double* __restrict nx = out.nx + begin, * __restrict ny = out.ny + begin, * __restrict nz = out.nz + begin;
  alignas(64) double slopes[6][blockSize];
  const double p0 = p.x(), p1 = p.y(), p2 = p.z();
#pragma GCC ivdep
  for (std::size_t j = 0; j < count; ++j) {
    const double w = r.value[0][j], x = r.value[1][j], y = r.value[2][j], z = r.value[3][j];
    const double inverseSw = 1 / s.value[3][j], d = w * w + x * x + y * y + z * z, two = 2 / d;
    const Triple a = {s.value[0][j] * p0 * inverseSw, s.value[1][j] * p1 * inverseSw, s.value[2][j] * p2 * inverseSw};
    // The rotation matrix R = Q(r) / |r|^2.
    const double xx = x * x * two, yy = y * y * two, zz = z * z * two, xy = x * y * two, xz = x * z * two, yz = y * z * two;
    const double wx = w * x * two, wy = w * y * two, wz = w * z * two;
    const double r11 = 1 - yy - zz, r12 = xy - wz, r13 = xz + wy, r21 = xy + wz, r22 = 1 - xx - zz, r23 = yz - wx,
                 r31 = xz - wy, r32 = yz + wx, r33 = 1 - xx - yy;
    px[j] = tx[j] + r11 * a.x + r12 * a.y + r13 * a.z;
    py[j] = ty[j] + r21 * a.x + r22 * a.y + r23 * a.z;
    pz[j] = tz[j] + r31 * a.x + r32 * a.y + r33 * a.z;
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
    const Triple bu = moved(r.du, s.du), bv = moved(r.dv, s.dv);
    const Triple xu = {r11 * bu.x + r12 * bu.y + r13 * bu.z, r21 * bu.x + r22 * bu.y + r23 * bu.z,
                       r31 * bu.x + r32 * bu.y + r33 * bu.z};
    const Triple xv = {dtx[j] + r11 * bv.x + r12 * bv.y + r13 * bv.z, dty[j] + r21 * bv.x + r22 * bv.y + r23 * bv.z,
                       dtz[j] + r31 * bv.x + r32 * bv.y + r33 * bv.z};
    const Triple n = cross(xu, xv);
    const double square = n.x * n.x + n.y * n.y + n.z * n.z;
    // A vanishing normal stays zero: the smallest double under the root keeps the division finite.
    const double scale = 1 / std::sqrt(square + std::numeric_limits<double>::min());
    nx[j] = n.x * scale, ny[j] = n.y * scale, nz[j] = n.z * scale;
    slopes[0][j] = xu.x, slopes[1][j] = xu.y, slopes[2][j] = xu.z;
    slopes[3][j] = xv.x, slopes[4][j] = xv.y, slopes[5][j] = xv.z;
  }
  if (!derivatives) return;
  for (std::size_t k = 0; k < 6; ++k)
    for (std::size_t j = 0; j < count; ++j) out.derivatives[k][begin + j] = slopes[k][j];
}

BLOSSOM_FOR_EACH_VECTOR_WIDTH
void evaluateRow(const FactorRow& orientation, const FactorRow& scaling, const Vec3& p, const TrajectoryTable& t,
                 std::size_t countV, const OutputRow& out, bool derivatives) {
  FactorBlock r, s;
  for (std::size_t begin = 0; begin < countV; begin += blockSize) {
    const std::size_t count = std::min(blockSize, countV - begin);
    sumRows(orientation, begin, count, r);
    sumRows(scaling, begin, count, s);
    combine(r, s, p, t, begin, count, out, derivatives);
  }
}

TrajectoryTable tabulate(const Curve& trajectory, std::span<const double> vs) {
  const BasisTable basis = tabulateBasis(trajectory.degree, trajectory.knots, vs);
  TrajectoryTable table;
  for (auto* part : {&table.point, &table.derivative})
    for (auto& coordinate : *part) coordinate.resize(vs.size());
  for (std::size_t l = 0; l < vs.size(); ++l) {
    Vec4 value = Vec4::Zero(), derivative = Vec4::Zero();
    for (std::size_t b = 0; b <= static_cast<std::size_t>(trajectory.degree); ++b) {
      value += basis.values(l)[b] * trajectory.poles[basis.first[l] + b];
      derivative += basis.derivatives(l)[b] * trajectory.poles[basis.first[l] + b];
    }
    for (std::size_t c = 0; c < 3; ++c) {
      const auto k = static_cast<Eigen::Index>(c);
      table.point[c][l] = value[k] / value[3];
      table.derivative[c][l] = (derivative[k] - table.point[c][l] * derivative[3]) / value[3];
    }
  }
  return table;
}

FactorRow factorRow(const FactorGrid& grid, std::size_t k) {
  return {grid.rows(k), grid.basisU(k), grid.basisDerivativesU(k), grid.stride(), grid.degreeU()};
}

FactorGrid prepare(const Surface& factor, std::span<const double> us, std::span<const double> vs) {
  return {factor, tabulateBasis(factor.degreeU, factor.knotsU, us), tabulateBasis(factor.degreeV, factor.knotsV, vs)};
}

}  // namespace

void evaluateGrid(const Motion& motion, std::span<const double> us, std::span<const double> vs, MotionGrid& grid,
                  GridDerivatives wanted, const Progress& progress) {
  const bool derivatives = wanted == GridDerivatives::Yes;
  grid.countU = us.size(), grid.countV = vs.size();
  const std::size_t total = us.size() * vs.size();
  for (std::size_t c = 0; c < 3; ++c) {
    grid.point[c].resize(total), grid.normal[c].resize(total);
    grid.du[c].resize(derivatives ? total : 0), grid.dv[c].resize(derivatives ? total : 0);
  }
  const FactorGrid orientation = prepare(motion.orientation, us, vs), scaling = prepare(motion.scaling, us, vs);
  const TrajectoryTable trajectory = tabulate(motion.trajectory, vs);
  for (std::size_t k = 0; k < us.size(); ++k) {
    if (k % 64 == 0) progress.check();
    const std::size_t at = k * vs.size();
    OutputRow out{grid.point[0].data() + at,
                  grid.point[1].data() + at,
                  grid.point[2].data() + at,
                  grid.normal[0].data() + at,
                  grid.normal[1].data() + at,
                  grid.normal[2].data() + at,
                  {}};
    if (derivatives)
      for (std::size_t c = 0; c < 3; ++c)
        out.derivatives[c] = grid.du[c].data() + at, out.derivatives[c + 3] = grid.dv[c].data() + at;
    evaluateRow(factorRow(orientation, k), factorRow(scaling, k), motion.point, trajectory, vs.size(), out, derivatives);
  }
}

std::vector<double> evenParameters(std::pair<double, double> domain, std::size_t count) {
  std::vector<double> result(count);
  for (std::size_t i = 0; i < count; ++i)
    result[i] = i + 1 == count ? domain.second
                               : domain.first + (domain.second - domain.first) * static_cast<double>(i) /
                                                    static_cast<double>(count - 1);
  return result;
}

}  // namespace blossom::sweep
