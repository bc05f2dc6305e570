#include <algorithm>
#include <cmath>

#include "drag_frames.h"
#include "minkowski/kernel/morph/control_centre.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

/// How quickly morphs follow when a control shape of a sample is dragged. What is told is judged by tests/acceptance.
class MinkowskiFramesWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openWindow(); }
  void cleanup() { window_.reset(); }
  void framesAreMeasured_data();
  void framesAreMeasured();

 private:
  [[nodiscard]] const Document& document() const { return window_->page().document(); }
  [[nodiscard]] std::vector<FeatureId> morphs() const {
    std::vector<FeatureId> ids;
    for (const auto& feature : document().features())
      if (feature->type == "minkowski.morph") ids.push_back(feature->id);
    return ids;
  }
  /// Where the first control shape of a morph is held.
  [[nodiscard]] Vec3 handleOf(const FeatureId& morph) const {
    const Feature& feature = document().at(morph);
    const Vec2 centre = minkowski::centreOf(*window_->session().shape(feature.inputs.front())->get<Region>());
    const Value offsets = feature.parameters.value("offsets", Value::array());
    const Vec2 by = offsets.empty() ? Vec2(0, 0) : Vec2(offsets[0][0].get<double>(), offsets[0][1].get<double>());
    return {centre.x() + by.x(), centre.y() + by.y(), 0};
  }
};

void MinkowskiFramesWindowTest::framesAreMeasured_data() {
  QTest::addColumn<int>("which");  // of the morphs in the sample
  for (const char* sample :
       {"triangle-to-star", "phi-to-flower", "figure-4-triangle-to-square", "figure-6-rounded-by-a-circle"})
    QTest::newRow(sample) << 0;
  QTest::newRow("figure-5-five-pairs") << 5;  // after five stills of the first pair
}

void MinkowskiFramesWindowTest::framesAreMeasured() {
  QFETCH(int, which);
  const QString sample = QString::fromLatin1(QTest::currentDataTag());
  window_->resize(1280, 720);
  openAndWait(QString::fromStdString(test::sample((sample + ".blossom").toStdString()).string()));
  const FeatureId morph = morphs().at(static_cast<std::size_t>(which));
  window_->tree().select(morph);
  waitUntilComputed();
  const QPoint from = screenOf(handleOf(morph));
  const Value before = document().at(morph).parameters.value("offsets", Value::array());
  mouse(QEvent::MouseMove, from);
  mouse(QEvent::MouseButtonPress, from);
  QPoint now = from;
  const test::DragFrames frames(window_->view(), 250, [&](int k) {
    now = from + QPoint(qRound(40 * std::sin(k * 0.05)), qRound(30 * (1 - std::cos(k * 0.07))));
    mouse(QEvent::MouseMove, now);
  });
  mouse(QEvent::MouseButtonRelease, now);
  waitUntilComputed();
  QVERIFY2(document().at(morph).parameters.value("offsets", Value::array()) != before, "nothing was dragged");
  QVERIFY(frames.count() > 5);
  const QByteArray name = QByteArray("morph_frames_") + sample.toUtf8().replace('-', '_');
  qInfo("figure %s_percent %.1f", name.constData(), frames.shareWithin(33));
  qInfo("figure %s_95_ms %.1f", name.constData(), frames.slowestOf(95));
}

BLOSSOM_WINDOW_TEST(MinkowskiFramesWindowTest)
#include "minkowski_frames_window_test.moc"
