// Frames of the view on this machine's graphics, with real window and mouse: run under xvfb-run for software rendering.
#include <QApplication>
#include <QElapsedTimer>
#include <QtTest>
#include <algorithm>
#include <cstdio>
#include <ctime>
#include <numbers>
#include <vector>

#include "core/memory.h"
#include "scene/picking.h"
#include "ui/look/theme.h"
#include "ui/view/view_widget.h"
#include "ui/window/application.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

double milliseconds(const QElapsedTimer& timer) { return static_cast<double>(timer.nsecsElapsed()) / 1e6; }

/// Sphere with waves of 4 n^2 triangles, every octant a face of its own, and 24 meridians as edges.
Tessellation wavySphere(double radius, int n) {
  Tessellation t;
  const auto at = [&](double a, double b) {
    const double r = radius * (1 + 0.06 * std::sin(6 * a) * std::cos(5 * b));
    return Vec3(r * std::sin(a) * std::cos(b), r * std::sin(a) * std::sin(b), r * std::cos(a));
  };
  const double step = std::numbers::pi / n;
  for (int i = 0; i <= n; ++i)
    for (int j = 0; j <= 2 * n; ++j) {
      t.points.push_back(at(i * step, j * step));
      t.normals.push_back(t.points.back().normalized());
    }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < 2 * n; ++j) {
      const int k = i * (2 * n + 1) + j, below = k + 2 * n + 1;
      t.triangles.push_back({k, below, k + 1});
      t.triangles.push_back({k + 1, below, below + 1});
      t.faceOfTriangle.insert(t.faceOfTriangle.end(), 2, 4 * (2 * i / n) + 2 * j / n);
    }
  for (int m = 0; m < 24; ++m) {
    std::vector<Vec3> line;
    for (int i = 0; i <= n; ++i) line.push_back(at(i * step, m * std::numbers::pi / 12));
    t.edges.push_back(line);
    t.edgeIndices.push_back(m);
    t.vertices.push_back(line[static_cast<std::size_t>(n) / 2]);
  }
  return t;
}

/// Of all threads; tells the work where others use the machine too.
double processorMs() { return 1e3 * static_cast<double>(std::clock()) / CLOCKS_PER_SEC; }

void figure(const char* name, double value) { std::printf("figure %s %.3f\n", name, value); }

/// The mouse goes on while frames are drawn, as a hand does: 250 moves a second.
void orbit(ViewWidget& view, int frames) {
  constexpr int moveMs = 4;
  const QPoint from(300, 300);
  std::vector<double> between;
  QElapsedTimer frame;
  const auto seen = QObject::connect(&view, &ViewWidget::framePainted, [&] {
    between.push_back(milliseconds(frame));
    frame.start();
  });
  QTest::mousePress(&view, Qt::LeftButton, {}, from);
  QTest::mouseMove(&view, from + QPoint(10, 0));
  QElapsedTimer all;
  all.start();
  frame.start();
  const double before = processorMs();
  double blocked = 0;
  for (int i = 0; static_cast<int>(between.size()) < frames; ++i) {
    QElapsedTimer turn;
    turn.start();
    QTest::mouseMove(&view, from + QPoint(12 + i % 600, i % 40));
    QTest::qWait(moveMs);
    blocked = std::max(blocked, milliseconds(turn) - moveMs);
  }
  QObject::disconnect(seen);
  figure("orbit_fps", frames / (milliseconds(all) / 1000));
  figure("orbit_processor_ms", (processorMs() - before) / frames);
  std::sort(between.begin(), between.end());
  figure("orbit_median_ms", between[between.size() / 2]);
  figure("orbit_worst_ms", between.back());
  figure("orbit_blocked_ms", blocked);
  QTest::mouseRelease(&view, Qt::LeftButton, {}, from);
}

void hover(ViewWidget& view, int count) {
  double worst = 0, total = 0;
  int met = 0;
  for (int i = 0; i < count; ++i) {
    const QPointF at(200 + (i * 37) % 900, 100 + (i * 53) % 520);
    QElapsedTimer timer;
    timer.start();
    const Pick pick = view.pickAt(at, i % 2 == 0 ? PickMode::Feature : PickMode::Any);
    const double took = milliseconds(timer);
    if (!pick.feature.empty()) ++met;
    worst = std::max(worst, took);
    total += took;
  }
  figure("hover_pick_ms", total / count);
  figure("hover_pick_worst_ms", worst);
  figure("hover_met", met);
}

}  // namespace

int main(int argc, char** argv) {
  blossom::keepFreedMemory();  // as the programs do
  prepareApplication();
  QApplication application(argc, argv);
  setUpApplication();
  ThemeManager::instance().apply(ThemeChoice::Dark);
  QElapsedTimer timer;
  timer.start();
  SceneData scene = toSceneData(wavySphere(50, 181));
  figure("triangles", static_cast<double>(scene.faces->GetNumberOfPolys()));
  timer.restart();
  scene.solid = true;
  scene.picks = std::make_shared<const PickIndex>(scene);
  figure("index_ms", milliseconds(timer));

  timer.restart();
  ViewWidget view;
  view.setLook(theme().look());
  view.resize(1280, 720);
  view.show();
  if (!QTest::qWaitForWindowExposed(&view)) return 1;
  while (view.framesDrawn() == 0) QCoreApplication::processEvents();
  figure("empty_view_ms", milliseconds(timer));

  timer.restart();
  view.setItems({{"sphere", scene, ItemRole::Plain}});
  view.lookFrom(QStringLiteral("iso"), false);
  view.grabFramebuffer();
  figure("first_frame_ms", milliseconds(timer));
  while (!view.sharp()) QCoreApplication::processEvents();
  figure("sharp_frame_ms", view.lastFrameMs());
  orbit(view, 100);
  hover(view, 2000);
  return 0;
}
