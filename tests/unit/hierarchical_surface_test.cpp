#include <array>

#include "geometry/bspline/bspline.h"
#include "geometry/bspline/hierarchical_surface.h"
#include "support/dense.h"
#include "support/motions.h"
#include "support/splines.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using Eigen::MatrixXd;

/// B-splines by their definition (Cox and de Boor), 0/0 = 0; nothing of it is shared with the kernel.
double coxDeBoor(const std::vector<double>& knots, std::size_t i, int degree, double t) {
  if (degree == 0) return t >= knots[i] && t < knots[i + 1] ? 1 : 0;
  const auto p = static_cast<std::size_t>(degree);
  double sum = 0;
  if (const double length = knots[i + p] - knots[i]; length > 0)
    sum += (t - knots[i]) / length * coxDeBoor(knots, i, degree - 1, t);
  if (const double length = knots[i + p + 1] - knots[i + 1]; length > 0)
    sum += (knots[i + p + 1] - t) / length * coxDeBoor(knots, i + 1, degree - 1, t);
  return sum;
}

/// One function of a space with all its copies at a place inside the domain.
double valueOf(const SplineSpace& space, std::size_t function, double t) {
  double sum = 0, sign = 1;
  const std::size_t unwrapped = space.knots.size() - static_cast<std::size_t>(space.degree) - 1;
  for (std::size_t i = function; i < unwrapped; i += space.size(), sign *= space.closure)
    sum += sign * coxDeBoor(space.knots, i, space.degree, t);
  return sum;
}

bool isOver(const SplineSpace& space, std::size_t function, double t) {
  const std::size_t order = static_cast<std::size_t>(space.degree) + 1;
  for (std::size_t i = function; i + order < space.knots.size(); i += space.size())
    if (t > space.knots[i] && t < space.knots[i + order]) return true;
  return false;
}

std::vector<double> breaksOf(const SplineSpace& space) {
  const auto [first, last] = space.domain();
  std::vector<double> breaks{first};
  for (const double knot : space.knots)
    if (knot > breaks.back() && knot <= last) breaks.push_back(knot);
  return breaks;
}

std::vector<double> middlesOf(const SplineSpace& space) {
  const std::vector<double> breaks = breaksOf(space);
  std::vector<double> middles;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i) middles.push_back((breaks[i] + breaks[i + 1]) / 2);
  return middles;
}

/// The two-scale relation from values alone, by least squares.
MatrixXd twoScale(const SplineSpace& coarse, const SplineSpace& fine) {
  const std::vector<double> breaks = breaksOf(fine);
  std::vector<double> at;
  for (std::size_t i = 0; i + 1 < breaks.size(); ++i)
    for (const double x : {0.02, 0.2, 0.5, 0.8, 0.98}) at.push_back(breaks[i] + x * (breaks[i + 1] - breaks[i]));
  const auto collocation = [&](const SplineSpace& space) {
    MatrixXd values(static_cast<Eigen::Index>(at.size()), static_cast<Eigen::Index>(space.size()));
    for (std::size_t i = 0; i < at.size(); ++i)
      for (std::size_t j = 0; j < space.size(); ++j)
        values(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(j)) = valueOf(space, j, at[i]);
    return values;
  };
  return shortestSolution(collocation(fine), collocation(coarse));
}

/// A hierarchy, told twice: to the kernel, and as the definition needs it.
struct Hierarchy {
  std::vector<SplineSpace> u, v;
  std::vector<std::vector<ParameterBox>> boxes;  ///< those of level l at [l - 1]
  HierarchicalSurface surface;

  [[nodiscard]] bool inDomain(std::size_t level, double x, double y) const {
    for (std::size_t l = 1; l <= level; ++l) {
      const bool inBox = std::any_of(boxes[l - 1].begin(), boxes[l - 1].end(), [&](const ParameterBox& box) {
        return x > box.firstU && x < box.lastU && y > box.firstV && y < box.lastV;
      });
      if (!inBox) return false;
    }
    return true;
  }
  /// The support of a function lies in the domain of a level. Looked at in the spans of the finest level.
  [[nodiscard]] bool supportInside(std::size_t of, std::size_t function, std::size_t level) const {
    if (level >= u.size()) return false;
    for (const double x : middlesOf(u.back()))
      for (const double y : middlesOf(v.back()))
        if (isOver(u[of], function / v[of].size(), x) && isOver(v[of], function % v[of].size(), y) && !inDomain(level, x, y))
          return false;
    return true;
  }
};

SplineSpace randomSpace(Random& random, double closure) {
  const int degree = uniformInt(random, 1, 3);
  if (closure == 0) return {degree, randomKnots(random, degree, {.spans = 5, .clamped = true}), 0};
  return {degree, unwrappedKnots(degree, randomPeriod(random, uniformInt(random, 1, 5), degree)), closure};
}

/// Some spans halved, or all, now and then with a knot anywhere; or nothing.
SplineSpace randomFiner(Random& random, const SplineSpace& space) {
  if (uniformInt(random, 0, 2) == 0) return halved(space, 1);
  std::vector<double> more;
  for (const double middle : middlesOf(space))
    if (uniformInt(random, 0, 2) > 0) more.push_back(middle);
  const auto [first, last] = space.domain();
  if (uniformInt(random, 0, 2) == 0) more.push_back(uniform(random, first + 0.01 * (last - first), last));
  std::sort(more.begin(), more.end());
  return withInnerKnots(space, unitedKnots(innerKnots(space), more));
}

ParameterBox randomBox(Random& random, const SplineSpace& u, const SplineSpace& v) {
  const auto range = [&](const SplineSpace& space) {
    const std::vector<double> breaks = breaksOf(space);
    const int last = static_cast<int>(breaks.size()) - 1;
    const int from = uniformInt(random, 0, last / 2), to = uniformInt(random, from + 1, last);
    return std::pair(breaks[static_cast<std::size_t>(from)], breaks[static_cast<std::size_t>(to)]);
  };
  const auto [firstU, lastU] = range(u);
  const auto [firstV, lastV] = range(v);
  return {firstU, lastU, firstV, lastV};
}

std::vector<Vec4> randomCoefficients(Random& random, std::size_t count) {
  std::vector<Vec4> all;
  while (all.size() < count) all.push_back(randomPole(random, 10));
  return all;
}

Hierarchy randomHierarchy(Random& random, double closure) {
  Hierarchy all;
  all.u = {randomSpace(random, closure)}, all.v = {randomSpace(random, 0)};
  all.surface = {all.u[0], all.v[0], randomCoefficients(random, all.u[0].size() * all.v[0].size())};
  for (int l = uniformInt(random, 1, 3); l > 0; --l) {
    all.u.push_back(randomFiner(random, all.u.back()));
    all.v.push_back(randomFiner(random, all.v.back()));
    all.boxes.emplace_back();
    for (int b = uniformInt(random, 1, 2); b > 0; --b)
      all.boxes.back().push_back(randomBox(random, all.u.back(), all.v.back()));
    all.surface.refine(all.u.back(), all.v.back(), all.boxes.back());
  }
  return all;
}

/// Truncated functions by their definition: written in ever finer levels, without the functions inside their domain.
class Truncations {
 public:
  explicit Truncations(const Hierarchy& all) : all_(all) {
    for (std::size_t l = 0; l < all.u.size(); ++l) {
      inside_.emplace_back();
      for (std::size_t f = 0; f < all.u[l].size() * all.v[l].size(); ++f)
        inside_.back().push_back(all.supportInside(l, f, l) ? 1 : 0);
      if (l == 0) continue;
      fromU_.push_back(twoScale(all.u[l - 1], all.u[l]));
      fromV_.push_back(twoScale(all.v[l - 1], all.v[l]));
    }
  }

  [[nodiscard]] bool inside(std::size_t level, std::size_t function) const { return inside_[level][function] != 0; }
  [[nodiscard]] double value(std::size_t level, std::size_t function, double u, double v, bool& whole) const {
    const auto size = [](const SplineSpace& space) { return static_cast<Eigen::Index>(space.size()); };
    const auto columns = all_.v[level].size();
    MatrixXd c = MatrixXd::Zero(size(all_.u[level]), size(all_.v[level]));
    c(static_cast<Eigen::Index>(function / columns), static_cast<Eigen::Index>(function % columns)) = 1;
    for (std::size_t n = level + 1; n < all_.u.size(); ++n) {
      c = fromU_[n - 1] * c * fromV_[n - 1].transpose();
      for (Eigen::Index i = 0; i < c.rows(); ++i)
        for (Eigen::Index j = 0; j < c.cols(); ++j)
          if (inside(n, static_cast<std::size_t>(i * c.cols() + j))) {
            whole = whole && std::abs(c(i, j)) < 1e-9;
            c(i, j) = 0;
          }
    }
    return valuesAt(all_.u.back(), u).dot(c * valuesAt(all_.v.back(), v));
  }

 private:
  static Eigen::VectorXd valuesAt(const SplineSpace& space, double t) {
    Eigen::VectorXd values(static_cast<Eigen::Index>(space.size()));
    for (Eigen::Index i = 0; i < values.size(); ++i) values[i] = valueOf(space, static_cast<std::size_t>(i), t);
    return values;
  }

  const Hierarchy& all_;
  std::vector<std::vector<char>> inside_;
  std::vector<MatrixXd> fromU_, fromV_;
};

/// The tensor product of the finest level.
Surface tensorProduct(const HierarchicalSurface& surface) {
  const SplineSpace &u = surface.spaceU(surface.levels() - 1), &v = surface.spaceV(surface.levels() - 1);
  Surface result{u.degree, v.degree, u.knots, v.knots, surface.finest()};
  while (result.poles.size() < result.countU() * v.size())
    result.poles.emplace_back(u.closure * result.poles[result.poles.size() - u.size() * v.size()]);
  return result;
}

double closureOf(int k) { return std::array{0.0, 1.0, -1.0, 1.5}[static_cast<std::size_t>(k % 4)]; }

MatrixXd denseOf(const SpaceMap& map) {
  MatrixXd dense = MatrixXd::Zero(static_cast<Eigen::Index>(map.rows()), static_cast<Eigen::Index>(map.columns));
  for (std::size_t i = 0; i < map.rows(); ++i)
    for (std::size_t e = map.begin[i]; e < map.begin[i + 1]; ++e)
      dense(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(map.coarse[e])) = map.weight[e];
  return dense;
}

std::pair<double, double> somewhere(Random& random, const HierarchicalSurface& surface) {
  return {randomIn(random, surface.spaceU(0).domain()), randomIn(random, surface.spaceV(0).domain())};
}

}  // namespace

class HierarchicalSurfaceTest : public QObject {
  Q_OBJECT

 private slots:
  void spacesLieInFinerOnes() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 150; ++k) {
      const SplineSpace coarse = randomSpace(random, closureOf(k)), between = randomFiner(random, coarse),
                        fine = randomFiner(random, between);
      const SpaceMap map = embedding(coarse, fine), steps = composed(embedding(coarse, between), embedding(between, fine));
      QCOMPARE(map.rows(), fine.size());
      QCOMPARE(steps.rows(), fine.size());
      const MatrixXd wanted = twoScale(coarse, fine);
      for (const SpaceMap& each : {map, steps}) worst = std::max(worst, (denseOf(each) - wanted).cwiseAbs().maxCoeff());
      for (int i = 0; i < 20; ++i) {
        const double t = randomIn(random, coarse.domain());
        std::vector<double> values(coarse.size(), 0.0);
        for (const FunctionValue& each : functionsAt(coarse, t)) values[each.function] = each.value;
        for (std::size_t j = 0; j < values.size(); ++j) COMPARE_NEAR(values[j], valueOf(coarse, j, t), 1e-14);
      }
      VERIFY_ERROR(embedding(halved(fine, 1), fine), ErrorCode::InvalidInput);
    }
    std::printf("figure two_scale_apart %.3g\n", worst);
    QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
  }

  void whatBothSpacesHaveKeepsItsCoefficient() {
    auto random = seededRandom();
    for (int k = 0; k < 100; ++k) {
      const SplineSpace coarse = randomSpace(random, closureOf(k));
      const SpaceMap same = embedding(coarse, coarse);
      for (std::size_t i = 0; i < same.rows(); ++i) {
        QCOMPARE(same.begin[i + 1] - same.begin[i], std::size_t(1));
        QVERIFY(same.coarse[i] == i && same.weight[i] == 1);
      }
    }
  }

  void coarserSpacesRepeatAndMirror() {
    const SplineSpace ring{3, unwrappedKnots(3, {0, 1, 2, 3, 4, 5, 6, 7, 8, 9, 10, 11, 12}), -1};
    QCOMPARE(innerKnots(coarsened(ring, 1)), (std::vector<double>{2, 4, 6, 8, 10}));
    QCOMPARE(coarsened(ring, 1, 4).size(), std::size_t(4));  // parts of three spans lose both knots
    QCOMPARE(innerKnots(coarsened(ring, 1, 4)), (std::vector<double>{3, 6, 9}));
    QCOMPARE(innerKnots(coarsened(ring, 1, 6)), (std::vector<double>{2, 4, 6, 8, 10}));
    QCOMPARE(coarsened(ring, 9).size(), std::size_t(6));  // the next would have three
    const SplineSpace open{2, {0, 0, 0, 1, 2, 2, 3, 4, 5, 5, 5}, 0};
    QCOMPARE(innerKnots(coarsened(open, 1)), (std::vector<double>{2, 2, 3}));
    QVERIFY(innerKnots(coarsened(open, 9)).empty());
    QCOMPARE(innerKnots(halved(open, 1)), (std::vector<double>{0.5, 1, 1.5, 2, 2, 2.5, 3, 3.5, 4, 4.5}));
  }

  void functionsAreTruncatedAsDefined() {
    auto random = seededRandom();
    double worst = 0;
    std::size_t functions = 0, truncated = 0;
    for (int k = 0; k < 45; ++k) {
      const Hierarchy all = randomHierarchy(random, closureOf(k));
      const Truncations truncations(all);
      const auto [u, v] = somewhere(random, all.surface);
      std::vector<std::vector<double>> values;
      for (std::size_t l = 0; l < all.u.size(); ++l) values.emplace_back(all.u[l].size() * all.v[l].size(), 0.0);
      for (const HierarchicalSurface::ActiveValue& each : all.surface.activeAt(u, v))
        values[each.level][each.function] = each.value;
      for (std::size_t l = 0; l < all.u.size(); ++l)
        for (std::size_t f = 0; f < values[l].size(); ++f) {
          const bool active = truncations.inside(l, f) && !all.supportInside(l, f, l + 1);
          QCOMPARE(all.surface.active(l, f), active);
          if (active) {
            bool whole = true;
            worst = std::max(worst, std::abs(truncations.value(l, f, u, v, whole) - values[l][f]));
            ++functions, truncated += whole ? 0 : 1;
          } else {
            QCOMPARE(values[l][f], 0.0);
          }
        }
    }
    QVERIFY(functions > 1000 && truncated > 50);
    std::printf("figure truncation_apart %.3g\nfigure truncated_functions %zu\n", worst, truncated);
    QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
  }

  void theySumToOne() {
    auto random = seededRandom();
    for (int k = 0; k < 200; ++k) {
      const Hierarchy all = randomHierarchy(random, k % 2);
      for (int i = 0; i < 20; ++i) {
        const auto [u, v] = somewhere(random, all.surface);
        double sum = 0;
        for (const auto& each : all.surface.activeAt(u, v)) {
          QVERIFY(each.value > -1e-15);
          sum += each.value;
        }
        COMPARE_NEAR(sum, 1.0, 1e-13);
      }
    }
  }

  void theHierarchyIsItsTensorProduct() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 300; ++k) {
      Hierarchy all = randomHierarchy(random, closureOf(k));
      for (std::size_t l = 0; l < all.surface.levels(); ++l)
        for (std::size_t f = 0; f < all.u[l].size() * all.v[l].size(); ++f)
          if (all.surface.active(l, f)) all.surface.setCoefficient(l, f, randomPole(random, 10));
      const Surface product = tensorProduct(all.surface);
      validate(product);
      for (int i = 0; i < 30; ++i) {
        const auto [u, v] = somewhere(random, all.surface);
        worst = std::max(worst, (evaluate(product, u, v) - all.surface.evaluate(u, v)).norm() / magnitude(product.poles));
      }
    }
    std::printf("figure hierarchy_share %.3g\n", worst);
    QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
  }

  void refiningChangesNothing() {
    auto random = seededRandom();
    for (int k = 0; k < 200; ++k) {
      Hierarchy all = randomHierarchy(random, closureOf(k));
      const HierarchicalSurface before = all.surface;
      const SplineSpace u = randomFiner(random, all.u.back()), v = randomFiner(random, all.v.back());
      const std::vector<ParameterBox> where{randomBox(random, u, v)};
      all.surface.refine(u, v, where);
      const double size = magnitude(before.finest());
      for (int i = 0; i < 20; ++i) {
        const auto [x, y] = somewhere(random, before);
        QVERIFY((before.evaluate(x, y) - all.surface.evaluate(x, y)).norm() <= 1e-13 * size);
      }
      for (std::size_t l = 0; l < before.levels(); ++l)
        for (std::size_t f = 0; f < all.u[l].size() * all.v[l].size(); ++f)
          if (all.surface.active(l, f)) {
            QVERIFY(before.active(l, f));
            QVERIFY(before.coefficient(l, f) == all.surface.coefficient(l, f));
          }
    }
  }

  void whatDoesNotFitIsRefused() {
    const SplineSpace u{2, {0, 0, 0, 0.5, 1, 1, 1}, 0}, other{2, {0, 0, 0, 0.4, 1, 1, 1}, 0};
    VERIFY_ERROR(HierarchicalSurface(u, u, {}), ErrorCode::InvalidInput);
    HierarchicalSurface surface(u, u, std::vector<Vec4>(16, Vec4::Ones()));
    const std::vector<ParameterBox> all{{0, 1, 0, 1}};
    VERIFY_ERROR((surface.refine(other, u, all), 0), ErrorCode::InvalidInput);
    VERIFY_ERROR((surface.refine(u, {3, {0, 0, 0, 0, 1, 1, 1, 1}, 0}, all), 0), ErrorCode::InvalidInput);
    QCOMPARE(surface.levels(), std::size_t(1));
  }
};

BLOSSOM_TEST(HierarchicalSurfaceTest)
#include "hierarchical_surface_test.moc"
