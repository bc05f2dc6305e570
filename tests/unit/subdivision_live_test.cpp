#include <limits>

#include "core/stopwatch.h"
#include "subdivision/kernel/live_pull.h"
#include "support/cages.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::subdivision;

namespace {

/// Faces round vertex v of a grid: its foot on the limit surface.
Foot footOf(const LimitSurface& surface, const Mesh& cage, int vertex) {
  for (std::size_t f = 0; f < cage.faceCount(); ++f)
    for (std::size_t k = 0; k < cage.face(f).size(); ++k)
      if (cage.face(f)[k] == vertex) return surface.cornerFoot(f, k);
  return {};
}

}  // namespace

/// Points of a limit surface that are dragged.
class SubdivisionLiveTest : public QObject {
  Q_OBJECT

 private slots:
  void cornersAreFeet() {
    auto random = seededRandom();
    for (const auto& [plain, scheme] : {std::pair(prism(5), Scheme::CatmullClark), std::pair(octahedron(), Scheme::Loop)}) {
      const Mesh cage = jittered(plain, random, 0.2);
      const LimitSurface surface(cage, scheme);
      for (std::size_t f = 0; f < cage.faceCount(); ++f)
        for (std::size_t k = 0; k < cage.face(f).size(); ++k)
          QVERIFY(
              (combined(surface.row(surface.cornerFoot(f, k)), cage.points) - combined(surface.cornerRow(f, k), cage.points))
                  .norm() < 1e-12);
    }
  }

  /// Dragged live, or deformed when the mouse is let go: the same points.
  void draggingGivesWhatDeformGives() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> offset(-1, 1);
    const Mesh cage = jittered(gridCage(12, 12), random, 0.2);
    const LimitSurface surface(cage, Scheme::CatmullClark);
    const Foot first = footOf(surface, cage, 70), second = footOf(surface, cage, 97);
    const Vec3 at1 = combined(surface.row(first), cage.points), at2 = combined(surface.row(second), cage.points);
    LivePull live(surface, cage.points, {{first, at1}, {second, at2}}, {});
    QVERIFY((live.points()[70] - cage.points[70]).norm() < 1e-12);
    for (int k = 0; k < 5; ++k) {
      const Vec3 to1 = at1 + Vec3(offset(random), offset(random), offset(random)), to2 = at2 + Vec3(0, 0, offset(random));
      live.drag(0, to1);
      live.drag(1, to2);
      const DeformResult made = deform(surface, cage.points, {}, {.pulls = {{at1, to1}, {at2, to2}}});
      QCOMPARE(made.freePoints, live.freePoints());
      for (std::size_t i = 0; i < cage.points.size(); ++i) QVERIFY((made.points[i] - live.points()[i]).norm() < 1e-9);
      QVERIFY((combined(surface.row(first), live.points()) - to1).norm() < 0.01);
      QVERIFY(made.after.rms < 0.01 * made.before.rms);
      QCOMPARE(made.outsideChange, 0.0);
    }
    for (std::size_t i = 0; i < cage.points.size(); ++i)
      if (!std::binary_search(live.freePoints().begin(), live.freePoints().end(), static_cast<int>(i)))
        QVERIFY(live.points()[i] == cage.points[i]);
  }

  /// What is drawn while dragging is the limit surface of the points.
  void theSamplesLieOnTheSurface() {
    auto random = seededRandom();
    for (const auto& [plain, scheme] :
         {std::pair(gridCage(8, 8), Scheme::CatmullClark), std::pair(octahedron(), Scheme::Loop)}) {
      const Mesh cage = jittered(plain, random, 0.2);
      const LimitSurface surface(cage, scheme);
      const Foot foot = footOf(surface, cage, scheme == Scheme::Loop ? 2 : 40);
      LivePull live(surface, cage.points, {{foot, Vec3(0, 0, 0)}}, {});
      live.drag(0, combined(surface.row(foot), cage.points) + Vec3(0.3, 0.2, 1));
      double worst = 0;
      std::size_t met = 0;
      for (std::size_t p = 0; p < surface.patchCount(); ++p) {
        const Vec3 here = combined(surface.row({static_cast<int>(p), 0.25, 0.5}), live.points());
        if ((here - combined(surface.row({static_cast<int>(p), 0.25, 0.5}), cage.points)).norm() == 0) continue;
        double nearest = std::numeric_limits<double>::infinity();
        for (const Vec3& sample : live.samples()) nearest = std::min(nearest, (sample - here).norm());
        worst = std::max(worst, nearest);
        ++met;
      }
      QVERIFY(met > 0);
      QVERIFY2(worst < 1e-12, qPrintable(QString::number(worst)));
    }
  }

  /// Prints what a frame costs; what is checked is the mathematics.
  void aCageOf5000FacesIsDragged() {
    auto random = seededRandom();
    const Mesh cage = jittered(torusCage(100, 50), random, 0.002);
    QCOMPARE(cage.faceCount(), std::size_t(5000));
    Stopwatch watch;
    const LimitSurface surface(cage, Scheme::CatmullClark);
    const double made = watch.lapMs();
    const Foot foot = footOf(surface, cage, 2525);
    const Vec3 at = combined(surface.row(foot), cage.points);
    LivePull live(surface, cage.points, {{foot, at}}, {.free = {.rings = 6}});
    const double ready = watch.lapMs();
    constexpr int moves = 500;
    for (int k = 1; k <= moves; ++k) live.drag(0, at + Vec3(0, 0, 0.5 * k / moves));
    const double done = watch.lapMs();
    qInfo("figure surface_ms %.3f", made);
    qInfo("figure grab_ms %.3f", ready);
    qInfo("figure move_ms %.4f", done / moves);
    qInfo("figure free_points %zu", live.freePoints().size());
    qInfo("figure triangles %zu", live.triangles().size());
    const double left = (combined(surface.row(foot), live.points()) - (at + Vec3(0, 0, 0.5))).norm();
    QVERIFY2(left < 0.005, qPrintable(QString::number(left)));
    for (std::size_t i = 0; i < cage.points.size(); ++i)
      if (!std::binary_search(live.freePoints().begin(), live.freePoints().end(), static_cast<int>(i)))
        QVERIFY(live.points()[i] == cage.points[i]);
  }
};

BLOSSOM_TEST(SubdivisionLiveTest)
#include "subdivision_live_test.moc"
