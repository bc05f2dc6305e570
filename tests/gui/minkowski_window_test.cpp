#include <QAbstractButton>
#include <QDir>
#include <QFile>
#include <QMessageBox>
#include <QSignalSpy>
#include <QSlider>
#include <QToolButton>
#include <algorithm>

#include "document/storage.h"
#include "exchange/format/format.h"
#include "geometry/planar/planar.h"
#include "ui/timeline/playback.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

constexpr int frameCount = 13, lastFrame = frameCount - 1, middleFrame = lastFrame / 2;

/// A square of side 20 around (10, 10) with a square hole of side 12.
const char* const frameDrawing =
    "<svg xmlns='http://www.w3.org/2000/svg' width='20mm' height='20mm' viewBox='0 0 20 20'>"
    "<path fill-rule='evenodd' d='M0 0H20V20H0Z M4 4H16V16H4Z'/></svg>";

/// A rectangle of 40 x 10 around (60, -10).
const char* const slabDrawing =
    "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n4\n70\n1\n10\n40\n20\n-15\n10\n80\n20\n-15\n10\n80\n20\n-5\n10\n40\n"
    "20\n-5\n0\nENDSEC\n0\nEOF\n";

/// (1-t) frame + t slab: the outlines add their sides, and the hole is narrowed by the slab until it is gone.
double areaAt(double t) {
  const double hole = 12 * (1 - t);
  return (20 * (1 - t) + 40 * t) * (20 * (1 - t) + 10 * t) - std::max(0.0, hole - 40 * t) * std::max(0.0, hole - 10 * t);
}

double timeOf(int frame) { return static_cast<double>(frame) / lastFrame; }

}  // namespace

/// Two imported outlines are morphed, moved, played and written: the way of a user through the real window.
class MinkowskiWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init();
  void cleanup() { window_.reset(); }

  void aMorphIsPlayedAndScrubbed();
  void framesAndAnimatedDrawingsAreExported();
  void whatBlossomNumbersReplaceIsTold();
  void aSequenceIsExportedAlone();
  void aControlShapeIsDraggedAndPutBack();
  void theDocumentIsSavedAndOpened();
  void anOpenOutlineIsRefusedAndTheDocumentLivesOn();
  void aSampleIsSeenWithAllItsControlShapes();
  void picturesOfTheMorph();

 private:
  void framesThatAreThereAreAskedAbout();
  void blossomNumbersOfferNoPlay();
  [[nodiscard]] QString path(const char* name) const { return folder_.filePath(QLatin1String(name)); }
  void write(const char* name, const char* text) const;
  void morphBoth();
  void takePictures(const std::string& name, int frame);
  void drag(const Vec3& from, const Vec3& to);
  [[nodiscard]] Vec2 offsetOf(std::size_t shape) const;
  [[nodiscard]] double exportedArea(const QString& file) const;
  [[nodiscard]] Playback& playback() const { return window_->page().playback(); }
  [[nodiscard]] QWidget& timeline() const {
    return *window_->page().view().parentWidget()->findChild<QWidget*>(QStringLiteral("timeline"));
  }
  FeatureId morph_;
};

void MinkowskiWindowTest::write(const char* name, const char* text) const {
  QFile file(path(name));
  QVERIFY(file.open(QIODevice::WriteOnly));
  file.write(text);
}

/// From the two files to the sequence, alone in the view from above.
void MinkowskiWindowTest::morphBoth() {
  write("frame.svg", frameDrawing);
  write("slab.dxf", slabDrawing);
  QVERIFY(drop({path("frame.svg"), path("slab.dxf")}));
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t{2});
  waitUntilComputed();
  const FeatureId frame = window_->page().document().features().front()->id;
  const FeatureId slab = last();
  window_->tree().selectThese({frame, slab});
  run("feature.minkowski.morph");
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t{3});
  morph_ = last();
  QCOMPARE(window_->page().document().at(morph_).inputs, (std::vector<FeatureId>{frame, slab}));
  waitUntilComputed();
  COMPARE_NEAR(measureOf(morph_, "area"), areaAt(0.5), 1e-9);
  edit("frames", std::to_string(frameCount).c_str());
  waitUntilComputed();
  QCOMPARE(measureOf(morph_, "frames"), double(frameCount));
  window_->tree().select(morph_);
  run("edit.isolate");
  run("view.top");
  QTRY_VERIFY(timeline().isVisible());
  QCOMPARE(playback().count(), frameCount);
  QTRY_VERIFY(std::abs(window_->view().camera().turn().pitch - 90) < 1e-9);
}

void MinkowskiWindowTest::init() {
  openWindow();
  run("file.new");
  morphBoth();
}

void MinkowskiWindowTest::drag(const Vec3& from, const Vec3& to) {
  const QPoint start = screenOf(from), end = screenOf(to);
  test::moveMouse(&window_->view(), start);
  QTest::mousePress(&window_->view(), Qt::LeftButton, {}, start);
  for (int i = 1; i <= 8; ++i) test::moveMouse(&window_->view(), start + (end - start) * i / 8);
  QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, end);
}

Vec2 MinkowskiWindowTest::offsetOf(std::size_t shape) const {
  const Value offsets = window_->page().document().at(morph_).parameters.value("offsets", Value::array());
  if (shape >= offsets.size()) return Vec2::Zero();
  return {offsets[shape][0].get<double>(), offsets[shape][1].get<double>()};
}

double MinkowskiWindowTest::exportedArea(const QString& file) const {
  const Imported read = readShape(*window_->session().app().formats, file.toStdString());
  return area(toRegion(*read.shape.get<Curves>()));
}

void MinkowskiWindowTest::aMorphIsPlayedAndScrubbed() {
  auto* const slider = timeline().findChild<QSlider*>();
  for (const int frame : {0, 3, middleFrame, lastFrame}) {
    slider->setValue(frame);
    QCOMPARE(playback().frame(), frame);
    const double t = timeOf(frame);
    const Bounds box = window_->view().extent();
    COMPARE_NEAR(box.high.x() - box.low.x(), 20 * (1 - t) + 40 * t, 1e-6);
    COMPARE_NEAR(box.center().x(), 10 * (1 - t) + 60 * t, 1e-6);
    COMPARE_NEAR(box.center().y(), 10 * (1 - t) - 10 * t, 1e-6);
  }
  auto* const play = timeline().findChild<QToolButton*>(QStringLiteral("play"));
  QTest::mouseClick(play, Qt::LeftButton);
  QVERIFY(playback().playing());
  QTRY_VERIFY(playback().frame() > 0 && playback().frame() < lastFrame);  // begun anew and on its way
  QTest::mouseClick(play, Qt::LeftButton);
  QVERIFY(!playback().playing());
}

/// They name one shape, so that a morph asked for frames besides would fail.
void MinkowskiWindowTest::blossomNumbersOfferNoPlay() {
  const auto give = [this](const Value& numbers) {
    Feature morph = window_->page().document().at(morph_);
    morph.parameters.erase("frames");
    morph.parameters["blossom"] = numbers;
    window_->session().commit(window_->page().document().with(morph), QStringLiteral("Blossom"));
    waitUntilComputed();
  };
  give(Value::array());
  QTRY_VERIFY(playback().playable() && playback().count() < 2);
  give({0.4});
  COMPARE_NEAR(measureOf(morph_, "area"), areaAt(0.4), 1e-9);
  QTRY_VERIFY(!playback().playable());
  give(Value::array());
  QTRY_VERIFY(playback().playable());
}

/// For longer than the mouse rests; and t, which does not count beside them, is not offered.
void MinkowskiWindowTest::whatBlossomNumbersReplaceIsTold() {
  const QSignalSpy told(&window_->page(), &DocumentPage::announced);
  const ParameterField* const t = window_->properties().field(QStringLiteral("t"));
  QVERIFY(!t->isHidden());
  for (auto* button : window_->properties().field(QStringLiteral("blossom"))->findChildren<QToolButton*>())
    if (button->property("role") == QStringLiteral("add")) button->click();
  waitUntilComputed();
  const Value& set = window_->page().document().at(morph_).parameters;
  QVERIFY(!set.at("blossom").empty() && !set.contains("frames"));
  QVERIFY(!told.isEmpty() && told.last().at(0).toString().contains(QStringLiteral("is left out")));
  QVERIFY(t->isHidden());
  window_->session().undo();
  waitUntilComputed();
  QVERIFY(!t->isHidden());
}

/// In one file with other shapes it has no place, which is said, and not that no format takes it.
void MinkowskiWindowTest::aSequenceIsExportedAlone() {
  window_->tree().selectThese({window_->page().document().features().front()->id, morph_});
  run("file.export");
  QVERIFY(!window_->findChild<ExportDialog*>());
  QCOMPARE(window_->errors().message(), QStringLiteral("A sequence is exported alone."));
  QVERIFY(window_->errors().hint().contains(QStringLiteral("not both")));
}

/// The file dialog asks about the name that was chosen, which is not that of a frame.
void MinkowskiWindowTest::framesThatAreThereAreAskedAbout() {
  const QString kept = path("walk-0002.svg");
  for (const bool replace : {false, true}) {
    QFile file(kept);
    QVERIFY(file.open(QIODevice::WriteOnly) && file.write("mine") == 4);
    file.close();
    QString asked;
    QTimer answering;
    connect(&answering, &QTimer::timeout, this, [&] {
      auto* question = window_->findChild<QMessageBox*>();
      if (!question || !question->isVisible()) return;
      asked = question->text();
      for (QAbstractButton* button : question->buttons())
        if ((question->buttonRole(button) == QMessageBox::AcceptRole) == replace) button->click();
    });
    answering.start(20);
    exportAs("svg", path("walk.svg"), {{"animate", false}});
    QVERIFY2(asked.contains(QStringLiteral("13 files, walk-0001.svg to walk-0013.svg")), qPrintable(asked));
    QCOMPARE(QFileInfo(kept).size() == 4, !replace);
  }
}

void MinkowskiWindowTest::framesAndAnimatedDrawingsAreExported() {
  window_->tree().select(morph_);
  for (const char* format : {"svg", "dxf"}) {
    const QString extension = QLatin1String(format);
    exportAs(format, path("walk.") + extension, {{"animate", false}});
    for (int k = 0; k < frameCount; ++k) {
      const QString file = path("walk-") + QStringLiteral("%1.").arg(k + 1, 4, 10, QLatin1Char('0')) + extension;
      QVERIFY2(QFile::exists(file), qPrintable(file));
      COMPARE_NEAR(exportedArea(file), areaAt(timeOf(k)), 1e-6);
    }
    QVERIFY(!QFile::exists(path("walk-0014.") + extension));
  }
  framesThatAreThereAreAskedAbout();
  exportAs("svg", path("playing.svg"), {{"animate", true}});
  QFile svg(path("playing.svg"));
  QVERIFY(svg.open(QIODevice::ReadOnly));
  QCOMPARE(QString::fromUtf8(svg.readAll()).count(QStringLiteral("<animate ")), qsizetype(frameCount));
  COMPARE_NEAR(exportedArea(path("playing.svg")), areaAt(0), 1e-6);
}

void MinkowskiWindowTest::aControlShapeIsDraggedAndPutBack() {
  window_->tree().select(morph_);
  window_->view().fitTo({{-20, -50, 0}, {100, 30, 0}}, false);
  playback().show(lastFrame);
  const double pixel = window_->view().camera().millimetresPerPixel(), near = 8 * pixel;
  const Vec3 drawn(60, -10, 0), wanted(70, 10, 0);
  drag(drawn, wanted);
  waitUntilComputed();
  const Vec2 offset = offsetOf(1);
  COMPARE_NEAR(offset.x(), 10, near);
  COMPARE_NEAR(offset.y(), 20, near);
  QVERIFY(offsetOf(0).isZero());
  const Bounds moved = window_->view().extent();
  COMPARE_NEAR(moved.center().x(), 60 + offset.x(), 1e-6);
  COMPARE_NEAR(moved.center().y(), -10 + offset.y(), 1e-6);
  COMPARE_NEAR(moved.high.x() - moved.low.x(), 40, 1e-6);  // moved, not changed

  // The first shape as well: halfway through, both count a half.
  drag({10, 10, 0}, {0, 0, 0});
  waitUntilComputed();
  playback().show(middleFrame);
  const Vec2 middle = (Vec2(10, 10) + offsetOf(0) + Vec2(60, -10) + offsetOf(1)) / 2;
  COMPARE_NEAR(window_->view().extent().center().x(), middle.x(), 1e-6);
  COMPARE_NEAR(window_->view().extent().center().y(), middle.y(), 1e-6);

  // A drag is one step of undo, and a double click puts a shape back.
  window_->session().undo();
  waitUntilComputed();
  QVERIFY(offsetOf(0).isZero());
  QCOMPARE(offsetOf(1), offset);
  const QPoint handle = screenOf(drawn + Vec3(offset.x(), offset.y(), 0));
  test::moveMouse(&window_->view(), handle);
  QTest::mouseDClick(&window_->view(), Qt::LeftButton, {}, handle);
  waitUntilComputed();
  QVERIFY(offsetOf(1).isZero());

  // Esc in the middle of a drag takes it back.
  const QPoint start = screenOf(drawn);
  test::moveMouse(&window_->view(), start);
  QTest::mousePress(&window_->view(), Qt::LeftButton, {}, start);
  test::moveMouse(&window_->view(), start + QPoint(60, 20));
  QVERIFY(!offsetOf(1).isZero());
  QTest::keyClick(&window_->view(), Qt::Key_Escape);
  QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, start + QPoint(60, 20));
  waitUntilComputed();
  QVERIFY(offsetOf(1).isZero());
}

void MinkowskiWindowTest::theDocumentIsSavedAndOpened() {
  const QString file = path("morph.blossom");
  bool saved = false;
  window_->session().save(file.toStdString(), [&] { saved = true; });
  QTRY_VERIFY(saved);
  QCOMPARE(toJson(openDocument(file.toStdString()).document), toJson(window_->page().document()));
  window_->closePage(0);
  openAndWait(file);
  QCOMPARE(measureOf(morph_, "frames"), double(frameCount));
  QTRY_VERIFY(timeline().isVisible());
}

void MinkowskiWindowTest::anOpenOutlineIsRefusedAndTheDocumentLivesOn() {
  write("open.svg",
        "<svg xmlns='http://www.w3.org/2000/svg' width='20mm' height='20mm' viewBox='0 0 20 20'>"
        "<path fill='none' stroke='black' d='M0 0H20V20'/></svg>");
  QVERIFY(drop({path("open.svg")}));
  QTRY_COMPARE(window_->page().document().features().size(), std::size_t{4});
  waitUntilComputed();
  window_->tree().selectThese({window_->page().document().features().front()->id, last()});
  run("feature.minkowski.morph");  // a sum would take it as a curve
  waitUntilComputed();
  if (window_->page().document().features().size() == 5) {  // taken, and refused when computed
    const auto view = window_->session().view(last());
    QVERIFY(view->result->error);
    QVERIFY(!view->result->error->message().empty() && !view->result->error->hint().empty());
  } else {
    QVERIFY(!window_->errors().isHidden());
  }
  QCOMPARE(measureOf(morph_, "frames"), double(frameCount));
}

void MinkowskiWindowTest::aSampleIsSeenWithAllItsControlShapes() {
  window_.reset();
  openWindow();
  openAndWait(QString::fromStdString(test::sample("triangle-to-star.blossom").string()));
  const auto features = window_->page().document().features();
  morph_ = features.back()->id;
  QTRY_COMPARE(window_->page().properties().shown(), morph_);
  QCOMPARE(features.size(), std::size_t{5});
  for (std::size_t k = 0; k + 1 < features.size(); ++k) {
    const auto result = window_->page().result(features[k]->id);
    QVERIFY(result);
    const Bounds box = bounds(result->evaluated.shape);
    const Vec2 offset = offsetOf(k);
    for (const Vec3& corner : {box.low, box.high})
      QVERIFY2(window_->view().rect().contains(screenOf(corner + Vec3(offset.x(), offset.y(), 0))),
               features[k]->name.c_str());
  }
}

void MinkowskiWindowTest::picturesOfTheMorph() {
  window_->resize(1280, 800);
  takePictures("morph-of-imports", middleFrame);
  for (const char* name : {"triangle-to-star", "phi-to-flower"}) {
    openAndWait(QString::fromStdString(test::sample(name + std::string(".blossom")).string()));
    morph_ = last();
    takePictures(name, 12);
  }
}

/// The morph with its control shapes and an onion skin; kept where BLOSSOM_PICTURES says, to be looked at.
void MinkowskiWindowTest::takePictures(const std::string& name, int frame) {
  window_->tree().select(morph_);
  QTRY_VERIFY(timeline().isVisible());
  if (!playback().onionSkin()) run("timeline.onion-skin");
  playback().show(frame);
  run("view.top");
  QTRY_VERIFY(std::abs(window_->view().camera().turn().pitch - 90) < 1e-9);
  const QImage dark = canvas();
  const Color warm = theme().look().made;
  QVERIFY(colored(dark, QColor::fromRgbF(float(warm.red), float(warm.green), float(warm.blue))) > 0.001);
  const QString folder = qEnvironmentVariable("BLOSSOM_PICTURES");
  for (const ThemeChoice choice : {ThemeChoice::Light, ThemeChoice::Dark}) {
    ThemeManager::instance().apply(choice);
    QVERIFY(!canvas().isNull());  // at rest
    const char* const ending = choice == ThemeChoice::Light ? "-light.png" : "-dark.png";
    const QString file = QDir(folder).filePath(QString::fromStdString(name + ending));
    if (!folder.isEmpty()) QVERIFY(window_->grab().save(file));
  }
  QCOMPARE(canvas(), dark);  // handles follow the theme there and back
}

BLOSSOM_WINDOW_TEST(MinkowskiWindowTest)
#include "minkowski_window_test.moc"
