#include <QRegularExpression>
#include <QTemporaryDir>
#include <QXmlStreamReader>
#include <map>

#include "exchange/format/frames.h"
#include "exchange/formats.h"
#include "geometry/planar/planar.h"
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

QString textOf(const fs::path& path) {
  QFile file(QString::fromStdString(path.string()));
  return file.open(QIODevice::ReadOnly) ? QString::fromUtf8(file.readAll()) : QString();
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
