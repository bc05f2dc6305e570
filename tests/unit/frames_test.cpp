#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <map>
#include <set>
#include <sstream>

#include "exchange/format/frames.h"
#include "exchange/formats.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/contact_sheet.h"
#include "geometry/shape/frame_times.h"
#include "support/regions.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

Sequence growing(int count) {
  Sequence sequence;
  for (int k = 0; k < count; ++k) {
    sequence.frames.emplace_back(rectangleRegion({0, 0}, {1.0 + k, 2}));
    sequence.times.push_back(static_cast<double>(k) / std::max(1, count - 1));
  }
  return sequence;
}

/// A circle that stays where it is beside a rectangle that becomes wider.
Sequence growingBesideACircle(int count) {
  Sequence sequence = growing(count);
  for (Shape& frame : sequence.frames) {
    Region region = *frame.get<Region>();
    region.loops.push_back(circleRegion(2, {-5, 1}).loops.front());
    frame = region;
  }
  return sequence;
}

QString textOf(const fs::path& path) {
  QFile file(QString::fromStdString(path.string()));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
}

/// What a file says of its page.
std::string pageOf(const fs::path& path) {
  QFile file(QString::fromStdString(path.string()));
  if (!file.open(QIODevice::ReadOnly)) return {};
  const QByteArray content = file.readAll();
  QByteArray all = content;
  if (path.extension() == ".pdf")  // Cairo 1.18 has the page in a stream
    for (qsizetype from = 0; (from = content.indexOf("stream\n", from)) >= 0;) {
      const qsizetype to = content.indexOf("endstream", from += 7);
      all += qUncompress(QByteArray(4, '\0').append(content.mid(from, to - from)));
      from = to + 10;
    }
  const QRegularExpression page("viewBox=\"[^\"]*\"|/MediaBox \\[[^\\]]*\\]|%%BoundingBox: [-0-9 ]+");
  return page.match(QString::fromLatin1(all)).captured().toStdString();
}

/// Which frames an animated file shows at a share of its run, by the keys of its animations.
std::vector<int> shownAt(const QString& svg, double share) {
  std::vector<int> shown;
  int frame = -1;
  QXmlStreamReader xml(svg);
  while (!xml.atEnd()) {
    xml.readNext();
    if (!xml.isStartElement()) continue;
    if (xml.name() == u"g" && xml.attributes().hasAttribute("display")) ++frame;
    if (xml.name() != u"animate") continue;
    const QStringList values = xml.attributes().value("values").toString().split(';');
    const QStringList keys = xml.attributes().value("keyTimes").toString().split(';');
    QString value;
    for (int i = 0; i < keys.size(); ++i)
      if (keys[i].toDouble() <= share) value = values[i];
    if (value == "inline") shown.push_back(frame);
  }
  return shown;
}

}  // namespace

/// Sequences in files: a frame a file, or all of them playing in one.
class FramesTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { qputenv("BLOSSOM_WORKER", (buildFolder() / "bin/blossom-worker").c_str()); }

  void aFrameAFileWhereTheFormatHoldsOne() {
    for (const std::string extension : {"dxf", "svg", "step"}) {
      const fs::path out = folder() / ("row." + extension);
      writeShape(formats_, growing(3), out);
      QVERIFY(!fs::exists(out));
      for (int k = 1; k <= 3; ++k) {
        const fs::path frame = folder() / ("row-000" + std::to_string(k) + "." + extension);
        QVERIFY2(fs::exists(frame), frame.c_str());
        if (extension == "step") continue;
        const Imported read = readShape(formats_, frame);
        COMPARE_NEAR(area(toRegion(*read.shape.get<Curves>())), 2.0 * k, 1e-9);
      }
      QVERIFY(!fs::exists(folder() / ("row-0004." + extension)));
    }
  }

  void oneFramePlaysAtATime() {
    const fs::path out = folder() / "playing.svg";
    writeShape(formats_, growing(5), out, {{"animate", true}, {"seconds", 3}});
    const QString svg = textOf(out);
    QCOMPARE(svg.count("<animate "), 5);
    QCOMPARE(svg.count("dur=\"3s\" repeatCount=\"indefinite\""), 5);
    for (int k = 0; k < 5; ++k)
      for (const double within : {0.01, 0.5, 0.99}) QCOMPARE(shownAt(svg, (k + within) / 5), std::vector<int>{k});
    // The page holds the largest frame, and a reader sees the first one.
    QVERIFY(svg.contains("width=\"5mm\" height=\"2mm\""));
    COMPARE_NEAR(area(toRegion(*readShape(formats_, out).shape.get<Curves>())), 2, 1e-9);
  }

  void framesStayAsLongAsTheirTimesSay() {
    Sequence sequence = growing(3);
    sequence.times = {10, 11, 14};
    const fs::path out = folder() / "uneven.svg";
    writeShape(formats_, sequence, out, {{"animate", true}});
    const QString svg = textOf(out);  // 1, 3 and, for the last, the mean 2: a sixth, three sixths, two sixths
    QCOMPARE(shownAt(svg, 0.16), std::vector<int>{0});
    QCOMPARE(shownAt(svg, 0.17), std::vector<int>{1});
    QCOMPARE(shownAt(svg, 0.66), std::vector<int>{1});
    QCOMPARE(shownAt(svg, 0.67), std::vector<int>{2});
    writeShape(formats_, growing(1), out, {{"animate", true}});
    QVERIFY(!textOf(out).contains("animate"));
  }

  void framesShareThePage() {
    const int count = 4;
    for (const std::string extension : {"svg", "pdf", "ps"}) {
      const fs::path out = folder() / ("beside." + extension);
      writeShape(formats_, growingBesideACircle(count), out);
      std::set<std::string> pages;
      for (int k = 1; k <= count; ++k) pages.insert(pageOf(folder() / ("beside-000" + std::to_string(k) + "." + extension)));
      QCOMPARE(pages.size(), std::size_t{1});
      QVERIFY2(!pages.begin()->empty(), extension.c_str());
    }
    std::istringstream numbers(pageOf(folder() / "beside-0001.svg").substr(9));  // the box of all frames
    for (const double wanted : {-7, -1, 11, 4}) {
      double found = 0;
      numbers >> found;
      COMPARE_NEAR(found, wanted, 0.03);
    }
    // The circle stands still in all frames.
    std::set<QString> circles;
    for (int k = 1; k <= count; ++k) {
      const QString svg = textOf(folder() / ("beside-000" + std::to_string(k) + ".svg"));
      circles.insert(QRegularExpression("M-3,[^M]*Z").match(svg).captured());
    }
    QCOMPARE(circles.size(), std::size_t{1});
    QVERIFY(circles.begin()->contains('A'));
  }

  void aShapeAloneKeepsAPageOfItsOwn() {
    const fs::path out = folder() / "alone.svg";
    writeShape(formats_, growing(3).frames.front(), out);
    QCOMPARE(pageOf(out), std::string("viewBox=\"0 0 1 2\""));
  }

  void aFrameThatCannotBeWrittenIsNamed() {
    Sequence sequence = growing(3);
    sequence.frames[1] = Region();
    const fs::path out = folder() / "gap.step";
    std::string told;
    try {
      writeShape(formats_, sequence, out);
    } catch (const Error& error) {
      told = error.message();
    }
    QVERIFY2(told.starts_with("Frame 2 of 3: "), told.c_str());
    QVERIFY(fs::exists(folder() / "gap-0001.step") && !fs::exists(folder() / "gap-0002.step"));
  }

  void aContactSheetShowsSomeFramesInTrueSize() {
    const fs::path out = folder() / "sheet.svg";
    writeShape(formats_, growing(9), out, {{"sheet", 5}});
    const QString svg = textOf(out);
    QCOMPARE(svg.count("<g transform="), 5);
    VERIFY_ERROR(writeShape(formats_, growing(9), out, {{"sheet", 5}, {"animate", true}}), ErrorCode::InvalidParameter);
    for (const char* time : {">0<", ">0.25<", ">0.5<", ">0.75<", ">1<"}) QCOMPARE(svg.count(time), 1);
    // Frames 0, 2, 4, 6 and 8 of the areas 2 (1 + k), and no two of them meet.
    const Imported read = readShape(formats_, out);
    const Curves& drawn = *read.shape.get<Curves>();
    QCOMPARE(drawn.paths.size(), std::size_t{5});
    COMPARE_NEAR(area(toRegion(drawn)), 2.0 * (1 + 3 + 5 + 7 + 9), 1e-9);
    for (const char* extension : {"pdf", "ps"}) {
      const fs::path page = folder() / (std::string("sheet.") + extension);
      writeShape(formats_, growing(9), page, {{"sheet", 5}});
      QVERIFY(!pageOf(page).empty());
      writeShape(formats_, growing(2).frames.front(), page, {{"sheet", 5}});  // which is no sequence
    }
  }

  void framesAreChosenEvenly() {
    for (std::size_t count = 1; count <= 40; ++count)
      for (std::size_t wanted = 1; wanted <= count; ++wanted) {
        const auto chosen = spreadFrames(count, wanted);
        QCOMPARE(chosen.size(), wanted);
        QCOMPARE(chosen.front(), std::size_t{0});
        if (wanted > 1) QCOMPARE(chosen.back(), count - 1);
        std::set<std::size_t> steps;
        for (std::size_t k = 1; k < wanted; ++k) steps.insert(chosen[k] - chosen[k - 1]);
        QVERIFY(steps.empty() || (*steps.begin() > 0 && *steps.rbegin() - *steps.begin() <= 1));
      }
    QCOMPARE(spreadFrames(3, 10), (std::vector<std::size_t>{0, 1, 2}));
    QVERIFY(spreadFrames(0, 10).empty());
  }

  void theGridMakesItsPicturesLargest() {
    for (std::size_t cells = 1; cells <= 30; ++cells)
      for (const double aspect : {0.2, 1.0, 1.6, 7.0}) {
        const SheetGrid grid = sheetGrid(cells, {aspect, 1}, {4, 3});
        const auto scale = [&](int columns, int rows) { return std::min(4 / (columns * aspect), 3.0 / rows); };
        QVERIFY(grid.columns * grid.rows >= int(cells) && grid.columns * (grid.rows - 1) < int(cells));
        for (int columns = 1; columns <= int(cells); ++columns)
          QVERIFY(scale(grid.columns, grid.rows) >= scale(columns, (int(cells) + columns - 1) / columns) * (1 - 1e-12));
      }
  }

  void theFrameOfATime() {
    Sequence sequence = growing(3);
    sequence.times = {10, 11, 14};
    const auto begins = frameBeginnings(sequence);
    const std::vector<std::pair<double, std::size_t>> shown{{0, 0}, {0.16, 0}, {0.17, 1}, {0.66, 1}, {0.67, 2}, {1, 2}};
    for (const auto& [share, frame] : shown) QCOMPARE(frameAt(begins, share), frame);
    QCOMPARE(frameLabel(sequence, 1), std::string("11"));
    sequence.times.clear();
    QCOMPARE(frameLabel(sequence, 1), std::string("2"));
  }

  void whatCannotBeDrawnIsRefused() {
    Sequence sequence = growing(2);
    sequence.frames.emplace_back(Mesh{});
    VERIFY_ERROR(writeShape(formats_, sequence, folder() / "bad.svg", {{"animate", true}}), ErrorCode::OutputNotSupported);
    VERIFY_ERROR(writeShape(formats_, sequence, folder() / "bad.dxf"), ErrorCode::OutputNotSupported);
    VERIFY_ERROR(writeShape(formats_, Sequence{}, folder() / "bad.dxf"), ErrorCode::OutputNotSupported);
    for (const auto& entry : fs::directory_iterator(folder())) QVERIFY(!entry.path().filename().string().starts_with("bad"));
  }

 private:
  fs::path folder() const { return folder_.path().toStdString(); }
  QTemporaryDir folder_;
  FormatRegistry formats_ = standardFormats();
};

BLOSSOM_TEST(FramesTest)
#include "frames_test.moc"
