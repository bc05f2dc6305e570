#include <Eigen/Dense>

#include "exchange/formats.h"
#include "geometry/bspline/bspline.h"
#include "support/dense.h"
#include "support/motion_sizes.h"
#include "support/motions.h"
#include "support/support.h"
#include "support/symmetric_motions.h"
#include "sweep/kernel/edit/pull.h"
#include "sweep/kernel/edit/twist.h"
#include "sweep/kernel/grid/motion_point.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::sweep;
using Eigen::MatrixXd;

namespace {

std::size_t freeRows(const Motion& motion, const Surface& s) {
  return s.countU() - (motion.closedU == ClosedU::No ? 0 : static_cast<std::size_t>(s.degreeU));
}

/// The rows of the basis at places, found by evaluating the surface with one pole at a time.
MatrixXd basisRows(const Motion& motion, const Surface& surface, double sign, const std::vector<MotionPlace>& places) {
  const std::size_t free = freeRows(motion, surface), columns = surface.countV();
  MatrixXd rows(places.size(), free * columns);
  Surface one = surface;
  for (std::size_t i = 0; i < free; ++i)
    for (std::size_t j = 0; j < columns; ++j) {
      std::fill(one.poles.begin(), one.poles.end(), Vec4::Zero());
      double turned = 1;
      for (std::size_t k = i; k < one.countU(); k += free, turned *= sign) one.pole(k, j) = Vec4(turned, 0, 0, 0);
      for (std::size_t p = 0; p < places.size(); ++p)
        rows(static_cast<Eigen::Index>(p), static_cast<Eigen::Index>(i * columns + j)) =
            evaluate(one, places[p].u, places[p].v)[0];
    }
  return rows;
}

MatrixXd polesTogether(const Motion& motion, const Surface& surface) {
  const std::size_t count = freeRows(motion, surface) * surface.countV();
  MatrixXd poles(count, 4);
  for (std::size_t i = 0; i < count; ++i) poles.row(static_cast<Eigen::Index>(i)) = surface.poles[i].transpose();
  return poles;
}

/// The shortest solution by singular values, dense: of all changes that leave the pins, those that meet the places best.
MatrixXd shortestChange(const MatrixXd& places, const MatrixXd& wanted, const MatrixXd& pins) {
  MatrixXd null = MatrixXd::Identity(places.cols(), places.cols());
  if (pins.rows() > 0) null = nullSpace(pins, 1e-11);
  return null * shortestSolution(places * null, wanted, 1e-9);
}

/// Places at even distances and at random ones between, none too near another.
std::vector<MotionPlace> placesApart(Random& random, const Motion& motion, int count) {
  std::vector<MotionPlace> places;
  const auto [u0, u1] = motion.domainU();
  const auto [v0, v1] = motion.domainV();
  for (int k = 0; k < count; ++k)
    places.push_back({u0 + (u1 - u0) * (k + uniform(random, 0.2, 0.8)) / count, uniform(random, v0, v1)});
  return places;
}

/// A motion whose point has no small component: a scaling known in mm is known as a factor.
Motion plainMotion(Random& random, int k, bool cubic, int period) {
  Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3), cubic, period);
  for (double& each : motion.point) each += each < 0 ? -0.5 : 0.5;
  return motion;
}

}  // namespace

class SweepTogetherTest : public QObject {
  Q_OBJECT

 private slots:
  void severalPlacesTakeTheShortestChange() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 120; ++k) {
      const Motion motion = plainMotion(random, k, k % 2 == 0, k % 4 == 0 ? 3 : 9);
      const int moved = uniformInt(random, 1, 4);
      std::vector<MotionPlace> places = placesApart(random, motion, moved + uniformInt(random, 0, 3));
      std::shuffle(places.begin(), places.end(), random);
      MotionPull edit;
      edit.at.assign(places.begin(), places.begin() + moved);
      edit.pins.assign(places.begin() + moved, places.end());
      edit.weights = {0, 0, 1};
      MatrixXd wanted(moved, 4);
      for (int i = 0; i < moved; ++i) {
        const MotionPlace& at = edit.at[static_cast<std::size_t>(i)];
        const Vec4 s = evaluate(motion.scaling, at.u, at.v), q = evaluate(motion.orientation, at.u, at.v);
        const Vec3 change = anyVector(random, 2);
        const Vec3 inFrame = (s.head<3>() + change).cwiseProduct(motion.point) / s[3];
        edit.to.emplace_back(blossom::point(motion.trajectory, at.v) +
                             Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized() * inFrame);
        wanted.row(i) << change.transpose(), 0;
      }
      const EditResult result = pull(motion, edit);
      const MatrixXd change = shortestChange(basisRows(motion, motion.scaling, 1, edit.at), wanted,
                                             basisRows(motion, motion.scaling, 1, edit.pins)),
                     got = polesTogether(motion, result.motion.scaling) - polesTogether(motion, motion.scaling);
      const double size = 1 + change.cwiseAbs().maxCoeff();
      worst = std::max(worst, (got - change).cwiseAbs().maxCoeff() / size);
      for (const MotionPlace& pin : edit.pins) {
        const double off = (evaluate(result.motion, pin.u, pin.v).point - evaluate(motion, pin.u, pin.v).point).norm();
        QVERIFY(off <= 1e-12 * sizeOfPoles(result.motion, pin.u, pin.v));
      }
      QVERIFY(repeatsItsRows(result.motion));
    }
    std::printf("figure shortest_change_apart %.3g\n", worst);
    QVERIFY2(worst <= 1e-10, qPrintable(QString::number(worst)));
  }

  void placesArriveTogetherByAnyShares() {
    auto random = seededRandom();
    double worst = 0;
    int solved = 0;
    for (int k = 0; k < 300; ++k) {
      const Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3), true);
      MotionPull edit;
      const auto places = placesApart(random, motion, 4);
      edit.at = {places[0], places[2]}, edit.pins = {places[1], places[3]};
      edit.to = {anyVector(random, 20), anyVector(random, 20)};
      edit.weights = {uniform(random, 0, 1), uniform(random, 0, 1), 1};
      const EditResult result = pull(motion, edit);
      if (!result.obstacles.empty()) continue;
      ++solved;
      for (std::size_t i = 0; i < 2; ++i) {
        const auto off = [&](const MotionPlace& at, const Vec3& to) {
          worst = std::max(worst,
                           (evaluate(result.motion, at.u, at.v).point - to).norm() / sizeOfPoles(result.motion, at.u, at.v));
        };
        off(edit.at[i], edit.to[i]);
        off(edit.pins[i], evaluate(motion, edit.pins[i].u, edit.pins[i].v).point);
      }
    }
    QVERIFY(solved > 250);
    std::printf("figure together_miss_share %.3g\n", worst);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
  }

  void whatContradictsItselfIsMetByLeastSquares() {
    auto random = seededRandom();
    double worst = 0;
    for (int k = 0; k < 60; ++k) {
      // One row all around: x(u, v) depends on u by nothing, and four places share the few poles along v.
      const Motion motion = plainMotion(random, static_cast<int>(ClosedU::Periodic), false, 1);
      MotionTwist edit{placesApart(random, motion, 4), Vec3(1, 2, 3), 25};
      for (MotionPlace& at : edit.at) at.v = edit.at.front().v;
      edit.pins = {{0.5, 0.5}};
      const EditResult same = twist(motion, edit);
      // The same turn everywhere is no contradiction.
      if (std::abs(edit.at.front().v - 0.5) > 0.1) QVERIFY(same.remainder < 1e-6);
      MotionPull apart;
      apart.at = edit.at, apart.weights = {0, 0, 1};
      MatrixXd wanted(4, 4);
      for (int i = 0; i < 4; ++i) {
        const MotionPlace& at = apart.at[static_cast<std::size_t>(i)];
        const Vec4 s = evaluate(motion.scaling, at.u, at.v), q = evaluate(motion.orientation, at.u, at.v);
        const Vec3 change = anyVector(random, 2);
        apart.to.emplace_back(blossom::point(motion.trajectory, at.v) +
                              Eigen::Quaterniond(q[0], q[1], q[2], q[3]).normalized() *
                                  Vec3((s.head<3>() + change).cwiseProduct(motion.point) / s[3]));
        wanted.row(i) << change.transpose(), 0;
      }
      const EditResult result = pull(motion, apart);
      // Normal equations, without any decomposition: all rows are one, so the mean is what fits best.
      const MatrixXd row = basisRows(motion, motion.scaling, 1, {apart.at.front()});
      const MatrixXd change = row.transpose() / row.squaredNorm() * wanted.colwise().mean();
      const MatrixXd got = polesTogether(motion, result.motion.scaling) - polesTogether(motion, motion.scaling);
      worst = std::max(worst, (got - change).cwiseAbs().maxCoeff() / (1 + change.cwiseAbs().maxCoeff()));
      QVERIFY(!result.obstacles.empty());
      double left = 0;
      for (int i = 0; i < 4; ++i) {
        const MotionPlace& at = apart.at[static_cast<std::size_t>(i)];
        left = std::max(left, (evaluate(result.motion, at.u, at.v).point - apart.to[static_cast<std::size_t>(i)]).norm());
      }
      COMPARE_NEAR(result.remainder, left, 1e-12 * (1 + left));
    }
    std::printf("figure least_squares_apart %.3g\n", worst);
    QVERIFY2(worst <= 1e-12, qPrintable(QString::number(worst)));
  }

  void pinsFarAwayChangeNothing() {
    auto random = seededRandom();
    const Imported tube = motionFormat().read(sample("twisted-tube.json"), Value::object(), Progress::none());
    const Motion& motion = *tube.shape.get<Motion>();
    const MotionPlace at{0.05, 0.5}, far{0.55, 0.5};
    const Vec3 to = anyVector(random, 20);
    const EditResult alone = pull(motion, {{at}, {to}, {0, 1, 1}}),
                     pinned = pull(motion, {{at}, {to}, {0, 1, 1}, Vec3::Zero(), {far}});
    // 24 even rows of degree 3: those over one place are four.
    QVERIFY(sameBits(alone.motion.orientation.poles, pinned.motion.orientation.poles));
    QVERIFY(sameBits(alone.motion.scaling.poles, pinned.motion.scaling.poles));
  }

  void twistsTurnEveryPlace() {
    auto random = seededRandom();
    for (int k = 0; k < 200; ++k) {
      const Motion motion = randomMotion(random, static_cast<ClosedU>(k % 3), true);
      MotionTwist edit{placesApart(random, motion, 3), anyVector(random, 1), uniform(random, -170, 170)};
      const EditResult result = twist(motion, edit);
      QVERIFY(result.obstacles.empty());
      for (const MotionPlace& at : edit.at) {
        const Vec3 centre = blossom::point(motion.trajectory, at.v), arm = evaluate(motion, at.u, at.v).point - centre;
        const Vec3 wanted = Eigen::AngleAxisd(edit.angle * std::numbers::pi / 180, edit.axis.normalized()) * arm;
        QVERIFY((evaluate(result.motion, at.u, at.v).point - centre - wanted).norm() <
                1e-12 * sizeOfPoles(result.motion, at.u, at.v));
        COMPARE_NEAR(evaluate(result.motion.orientation, at.u, at.v).norm(), evaluate(motion.orientation, at.u, at.v).norm(),
                     1e-12 * magnitude(result.motion.orientation.poles));
      }
    }
  }
};

BLOSSOM_TEST(SweepTogetherTest)
#include "sweep_together_test.moc"
