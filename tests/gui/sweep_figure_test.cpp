// Fig. 7 of Yoon & Lee 2009 by hand, from an empty document: a cylinder becomes a propeller. The mouse sends X events over
// the real view; commands come from the menu.
#include <QDir>
#include <QRegularExpression>
#include <QSlider>
#include <cmath>
#include <numbers>

#include "menu_clicks.h"
#include "support/command_line.h"
#include "ui/page/page.h"
#include "ui/plugin/tool.h"
#include "ui/timeline/playback.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::ui;

namespace {

// Of the propeller among the samples.
constexpr double hubHeight = 36, bladeReach = 62, bladePitch = 62;
const Vec3 middle(0, 0, hubHeight / 2);

/// Along blade 0 to 3.
Vec3 outward(int blade) {
  const double angle = std::numbers::pi * (1 + 2 * blade) / 4;
  return {std::cos(angle), std::sin(angle), 0};
}

/// The one that points to the viewer, and to the right, when looked at from the front.
constexpr int nearBlade = 3;

}  // namespace

class SweepFigureTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() {
    openNewDocument();
    window_->resize(1280, 720);
    mouse_ = std::make_unique<XMouse>();
    QVERIFY2(mouse_->there(), "The X server takes no events: libXtst.so.6 is not there.");
  }
  void cleanup() {
    mouse_.reset();
    window_.reset();
  }

  void thePropellerIsMadeByHand();
  void theStagesOpenWithoutAWord_data();
  void theStagesOpenWithoutAWord();
  void theGrowthIsScrubbed();

 private:
  [[nodiscard]] ViewWidget& view() { return window_->view(); }
  [[nodiscard]] const Document& document() { return window_->page().document(); }
  [[nodiscard]] QString hint() { return window_->page().tool() ? window_->page().tool()->hint() : QString(); }
  /// The last feature of a type; empty: none.
  [[nodiscard]] FeatureId lastOf(const char* type);
  static Vec3 vectorOf(const Value& p) { return {p[0].get<double>(), p[1].get<double>(), p[2].get<double>()}; }
  void menu(const char* command) {
    clickMenu(*mouse_, *window_, QStringLiteral("Sweep"), command);
    waitUntilComputed();
  }
  void key(Qt::Key key) { QTest::keyClick(&view(), key); }
  /// A key that switches: pressed when the hint does not say yet what it is for.
  void choose(Qt::Key key, const char* said);
  void hover(const QPoint& at);
  void dragTo(const QPoint& from, const QPoint& to);
  void letGo();
  [[nodiscard]] double shownAngle();
  void keepPicture(const char* name);
  [[nodiscard]] QString outputFolder() const;

  void makeCylinder();
  void seeAllFromTheFront();
  void pullOutBlades();
  void turnTwoBlades();
  void twistBlades();
  void compareWithTheSample(const QString& folder);

  std::unique_ptr<XMouse> mouse_;
};

FeatureId SweepFigureTest::lastOf(const char* type) {
  FeatureId found;
  for (const auto& feature : document().features())
    if (feature->type == type) found = feature->id;
  return found;
}

void SweepFigureTest::choose(Qt::Key which, const char* said) {
  if (!hint().contains(QLatin1String(said))) key(which);
  QVERIFY2(hint().contains(QLatin1String(said)), qPrintable(hint()));
}

/// Until the surface can be taken hold of there. X tells nothing of a pointer that stays, so it moves to and fro.
void SweepFigureTest::hover(const QPoint& at) {
  const auto over = [&] {
    mouse_->moveTo(&view(), at + QPoint(1, 0));
    mouse_->moveTo(&view(), at);
    return !hint().isEmpty() && !hint().startsWith(QStringLiteral("Drag a place"));
  };
  QTRY_VERIFY2_WITH_TIMEOUT(over(), qPrintable("the surface cannot be taken hold of: " + hint()), 60000);
}

void SweepFigureTest::dragTo(const QPoint& from, const QPoint& to) {
  constexpr int steps = 8;
  for (int k = 1; k <= steps; ++k) mouse_->moveTo(&view(), from + (to - from) * k / steps);
}

void SweepFigureTest::letGo() {
  mouse_->release();
  waitUntilComputed();
}

double SweepFigureTest::shownAngle() {
  static const QRegularExpression number(QStringLiteral("(-?[0-9.]+)°"));
  return number.match(hint()).captured(1).toDouble();
}

QString SweepFigureTest::outputFolder() const {
  const QString pictures = qEnvironmentVariable("BLOSSOM_PICTURES");
  return pictures.isEmpty() ? folder_.path() : pictures;
}

void SweepFigureTest::keepPicture(const char* name) {
  QVERIFY(!canvas().isNull());
  const QString folder = qEnvironmentVariable("BLOSSOM_PICTURES");
  if (folder.isEmpty()) return;
  QVERIFY(window_->grab().save(QDir(folder).filePath(QLatin1String(name) + QStringLiteral(".png"))));
}

void SweepFigureTest::makeCylinder() {
  menu("feature.sweep.primitive");
  edit("radius", "10");
  edit("height", "36");
  edit("rows", "16");
  edit("columns", "14");
  waitUntilComputed();
  menu("feature.sweep.sweep");
  QCOMPARE(document().at(sweep()).inputs, std::vector<FeatureId>{lastOf("sweep.primitive")});
  window_->tree().select(sweep());
}

/// So far away that the blades will have room.
void SweepFigureTest::seeAllFromTheFront() {
  view().lookFrom(QStringLiteral("front"), false);
  const auto hasRoom = [&] {
    const QRect inside = view().rect().adjusted(60, 60, -60, -60);
    for (int blade = 0; blade < 4; ++blade)
      if (!inside.contains(screenOf(middle + bladeReach * outward(blade)))) return false;
    return true;
  };
  for (int k = 0; k < 60 && !hasRoom(); ++k) view().zoomBy(1.1);
  QVERIFY(hasRoom());
  QTRY_VERIFY(view().sharp());
  view().setFocus();
}

/// Fig. 7 a and b, by one drag of four copies along the normal.
void SweepFigureTest::pullOutBlades() {
  const QPoint from = screenOf(middle + 10 * outward(nearBlade)), to = screenOf(middle + bladeReach * outward(nearBlade));
  hover(from);
  choose(Qt::Key_S, "by scaling alone");
  choose(Qt::Key_4, "4 copies");
  keepPicture("figure-7-a");
  mouse_->press();
  mouse_->holdShift(true);
  dragTo(from, to);
  QVERIFY2(hint().startsWith(QStringLiteral("Let go to pull")), qPrintable(hint()));
  letGo();
  mouse_->holdShift(false);
  const Value& parameters = document().at(lastOf("sweep.pull")).parameters;
  QCOMPARE(parameters["fold"].get<int>(), 4);
  QCOMPARE(parameters["scale"].get<double>(), 1.0);
  QCOMPARE(parameters["rotate"].get<double>(), 0.0);
  const Vec3 tip = vectorOf(parameters["pulls"][0]["to"]);
  QVERIFY2(std::abs(tip.head<2>().norm() - bladeReach) < 1, qPrintable(QString::number(tip.head<2>().norm())));
  keepPicture("figure-7-b");
}

/// Fig. 7 c and d: two opposite tips are turned up, which is then taken back.
void SweepFigureTest::turnTwoBlades() {
  const FeatureId blades = lastOf("sweep.pull");
  const Vec3 tip = vectorOf(document().at(blades).parameters["pulls"][0]["to"]);
  const QPoint from = screenOf(tip);
  hover(from);
  choose(Qt::Key_R, "by turning alone");
  choose(Qt::Key_2, "2 copies");
  mouse_->press();
  dragTo(from, from - QPoint(0, 90));
  keepPicture("figure-7-c");
  letGo();
  const FeatureId turn = lastOf("sweep.pull");
  QVERIFY(turn != blades);
  QCOMPARE(document().at(turn).inputs, std::vector<FeatureId>{blades});
  const Vec3 turned = vectorOf(document().at(turn).parameters["pulls"][0]["to"]);
  QVERIFY(std::abs((turned - middle).norm() - (tip - middle).norm()) < 0.3);  // the place is that far from half the height
  QVERIFY(turned.z() > tip.z() + 5);
  keepPicture("figure-7-d");
  window_->session().undo();
  waitUntilComputed();
  QVERIFY(lastOf("sweep.pull") == blades);
}

/// Fig. 7 e and f: about the axis through each tip, by an angle that is read while dragging.
void SweepFigureTest::twistBlades() {
  const QPoint from = screenOf(vectorOf(document().at(lastOf("sweep.pull")).parameters["pulls"][0]["to"]));
  hover(from);
  choose(Qt::Key_W, "Drag to twist");
  choose(Qt::Key_A, "the arm");
  choose(Qt::Key_4, "4 copies");
  keepPicture("figure-7-e");
  mouse_->press();
  mouse_->moveTo(&view(), from + QPoint(0, 20));
  const int down = shownAngle() < 0 ? -1 : 1;
  int best = 20;
  double apart = std::abs(shownAngle() - bladePitch);
  for (int pixels = 21; pixels < 120; ++pixels) {
    mouse_->moveTo(&view(), from + QPoint(0, down * pixels));
    const double now = std::abs(shownAngle() - bladePitch);
    if (now > apart) break;
    best = pixels, apart = now;
  }
  mouse_->moveTo(&view(), from + QPoint(0, down * best));
  QVERIFY2(apart < 2, qPrintable(hint()));
  letGo();
  const Value& parameters = document().at(lastOf("sweep.twist")).parameters;
  QCOMPARE(parameters["fold"].get<int>(), 4);
  QVERIFY(std::abs(parameters["angle"].get<double>() - bladePitch) < 2);
  QVERIFY((vectorOf(parameters["axis"]) - outward(nearBlade)).norm() < 0.05);
  keepPicture("figure-7-f");
}

/// What was saved from the window, run by the command line.
void SweepFigureTest::compareWithTheSample(const QString& folder) {
  const Answer made = answerOf(folder, {"sweep", "figure-7.json", "--solid", "-o", "figure-7.step"});
  QVERIFY2(made.code == 0, made.code == 1 ? made.message().c_str() : "");
  const double volume = made.result("volume");
  const Answer read = answerOf(folder, {"info", "figure-7.step"});
  COMPARE_NEAR(read.result("volume"), volume, 1e-9 * volume);
  const Answer shipped = answerOf(folder_.path(), {"sweep", propeller(), "--solid", "-o", "shipped.step"});
  QCOMPARE(shipped.code, 0);
  const double share = volume / shipped.result("volume") - 1;
  qInfo("figure figure_volume_share %.5f", std::abs(share));
  QVERIFY2(std::abs(share) < 0.02, qPrintable(QString::number(share)));
}

void SweepFigureTest::thePropellerIsMadeByHand() {
  makeCylinder();
  seeAllFromTheFront();
  pullOutBlades();
  turnTwoBlades();
  twistBlades();
  QVERIFY(!window_->session().view(sweep())->result->error);
  qInfo("figure figure_clicks %d", mouse_->clicks());

  const QString folder = outputFolder();
  window_->tree().select(lastOf("sweep.twist"));
  exportAs("motion", QDir(folder).filePath(QStringLiteral("figure-7.json")));
  compareWithTheSample(folder);
}

void SweepFigureTest::theStagesOpenWithoutAWord_data() {
  QTest::addColumn<QString>("name");
  for (const char* name :
       {"propeller-a-drags", "propeller-b-blades", "propeller-c-turns", "propeller-d-turned", "propeller-e-axes",
        "propeller-f-twisted", "propeller-growing", "moving-frame", "pulled-trajectory", "pulled-scaling",
        "drag-in-two-parts", "pulled-orientation", "twisted-tower", "blade-with-hub", "scarf"})
    QTest::newRow(name) << QString::fromLatin1(name);
}

void SweepFigureTest::theStagesOpenWithoutAWord() {
  QFETCH(QString, name);
  openAndWait(QString::fromStdString(sample(name.toStdString() + ".blossom").string()));
  for (const auto& feature : document().features()) {
    const auto view = window_->session().view(feature->id);
    if (!view) continue;
    QVERIFY2(!view->result->error, feature->id.c_str());
    QVERIFY2(view->result->evaluated.warnings.empty(), feature->id.c_str());
  }
  keepPicture(("sample-" + name).toLatin1().constData());
}

void SweepFigureTest::theGrowthIsScrubbed() {
  openAndWait(QString::fromStdString(sample("propeller-growing.blossom").string()));
  auto* const slider = window_->findChild<QWidget*>(QStringLiteral("timeline"))->findChild<QSlider*>();
  QCOMPARE(window_->page().playback().count(), 25);
  const auto width = [&] {
    const Bounds box = view().extent();
    return box.high.x() - box.low.x();
  };
  slider->setValue(0);
  COMPARE_NEAR(width(), 20.0, 1e-4);
  const double tipToTip = 2 * bladeReach * outward(0).x();
  slider->setValue(1);  // on its way
  QVERIFY(width() > 20 && width() < tipToTip - 5);
  slider->setValue(12);  // four drags are done
  QVERIFY(width() >= tipToTip - 1e-4);
  slider->setValue(24);
  const auto frames = window_->session().view(last())->result->evaluated.shape.get<Sequence>()->frames;
  QCOMPARE(frames.size(), std::size_t(25));
  QVERIFY(*frames.back().get<Mesh>() != *frames[12].get<Mesh>());
}

BLOSSOM_WINDOW_TEST(SweepFigureTest)
#include "sweep_figure_test.moc"
