// Pictures, contact sheets and films of sequences: one camera for all frames.
#include <fmt/format.h>

#include <QImage>
#include <algorithm>
#include <array>
#include <set>

#include "app/picture_format.h"
#include "core/file.h"
#include "scene/film/film.h"
#include "scene/sequence_pictures.h"
#include "support/exchange.h"
#include "support/regions.h"
#include "support/solids.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// A disc that stays where it is, and a rectangle to its right that becomes wider.
Sequence widening(int count) {
  Sequence sequence;
  for (int k = 0; k < count; ++k) {
    Region region = circleRegion(4, {-10, 0});
    region.loops.push_back(rectanglePath({0, -3}, {2.0 + 3 * k, 3}));
    sequence.frames.emplace_back(region);
    sequence.times.push_back(static_cast<double>(k) / std::max(1, count - 1));
  }
  return sequence;
}

Sequence growingBoxes(int count) {
  Sequence sequence;
  for (int k = 0; k < count; ++k) {
    Mesh mesh = boxMesh({-14, -2, -2}, {4, 4, 4});
    const Mesh grown = boxMesh({0, -1.0 - k, -1.0 - k}, Vec3::Constant(2.0 + 2 * k));
    const int before = static_cast<int>(mesh.points.size());
    mesh.points.insert(mesh.points.end(), grown.points.begin(), grown.points.end());
    for (std::size_t face = 0; face < grown.faceCount(); ++face) {
      std::vector<int> corners(grown.face(face).begin(), grown.face(face).end());
      for (int& corner : corners) corner += before;
      mesh.addFace(corners);
    }
    sequence.frames.emplace_back(mesh);
  }
  return sequence;
}

const FormatRegistry& pictures() {
  static const FormatRegistry registry = [] {
    FormatRegistry made;
    made.add(pngFormat());
    made.add(ogvFormat());
    return made;
  }();
  return registry;
}

std::vector<QImage> framesOf(const Sequence& sequence, const Value& options) {
  const TemporaryFolder folder;
  writeShape(pictures(), sequence, folder.path() / "out.png", options);
  std::vector<QImage> images;
  for (std::size_t k = 1; k <= sequence.frames.size(); ++k)
    images.emplace_back(QString::fromStdString((folder.path() / fmt::format("out-{:04}.png", k)).string()));
  return images;
}

/// The first columns, from the left, in which something is drawn: up to the next empty one.
std::pair<int, int> firstDrawnColumns(const QImage& image) {
  const auto drawn = [&](int x) {
    for (int y = 0; y < image.height(); ++y)
      if (qAlpha(image.pixel(x, y)) > 0) return true;
    return false;
  };
  int from = 0;
  while (from < image.width() && !drawn(from)) ++from;
  int to = from;
  while (to < image.width() && drawn(to)) ++to;
  return {from, to};
}

/// Largest difference of a channel between two pictures in the columns before `end`.
int largestDifference(const QImage& a, const QImage& b, int end) {
  int most = 0;
  for (int y = 0; y < a.height(); ++y)
    for (int x = 0; x < end; ++x) {
      const QRgb p = a.pixel(x, y), q = b.pixel(x, y);
      for (const int off : {qRed(p) - qRed(q), qGreen(p) - qGreen(q), qBlue(p) - qBlue(q), qAlpha(p) - qAlpha(q)})
        most = std::max(most, std::abs(off));
    }
  return most;
}

/// Connected parts of what is drawn: their boxes and how many pixels they have, the large ones alone.
struct Part {
  QRect box;
  int pixels = 0;
};

std::vector<Part> largeParts(const QImage& image) {
  std::vector<Part> parts;
  std::vector<char> seen(static_cast<std::size_t>(image.width()) * static_cast<std::size_t>(image.height()), 0);
  const auto index = [&](int x, int y) { return static_cast<std::size_t>(y * image.width() + x); };
  for (int y = 0; y < image.height(); ++y)
    for (int x = 0; x < image.width(); ++x) {
      std::vector<QPoint> waiting{{x, y}};
      Part part;
      while (!waiting.empty()) {
        const QPoint p = waiting.back();
        waiting.pop_back();
        if (!image.rect().contains(p) || seen[index(p.x(), p.y())] || qAlpha(image.pixel(p)) < 128) continue;
        seen[index(p.x(), p.y())] = 1;
        part.box |= QRect(p, QSize(1, 1));
        ++part.pixels;
        for (const QPoint& step : {QPoint(1, 0), QPoint(-1, 0), QPoint(0, 1), QPoint(0, -1)}) waiting.push_back(p + step);
      }
      if (part.pixels > 400) parts.push_back(part);  // not the letters of the times
    }
  return parts;
}

/// What an Ogg file of one stream holds, read page by page.
struct OggFile {
  std::vector<std::string> packets;
  std::uint64_t lastGranule = 0;
  bool ended = false, whole = true;
};

OggFile oggOf(const std::string& bytes) {
  OggFile ogg;
  std::string packet;
  std::size_t at = 0;
  const auto byte = [&](std::size_t place) { return static_cast<unsigned char>(bytes.at(place)); };
  while (at < bytes.size()) {
    if (bytes.compare(at, 4, "OggS") != 0 || at + 27 > bytes.size()) return ogg.whole = false, ogg;
    ogg.ended = (byte(at + 5) & 4) != 0;
    ogg.lastGranule = 0;
    for (std::size_t k = 8; k-- > 0;) ogg.lastGranule = ogg.lastGranule << 8 | byte(at + 6 + k);
    const std::size_t segments = byte(at + 26);
    std::size_t content = at + 27 + segments;
    for (std::size_t k = 0; k < segments; ++k) {
      const std::size_t length = byte(at + 27 + k);
      packet += bytes.substr(content, length);
      content += length;
      if (length < 255) ogg.packets.push_back(std::exchange(packet, {}));
    }
    at = content;
  }
  return ogg;
}

std::size_t bigEndian(const std::string& text, std::size_t at, std::size_t count) {
  std::size_t value = 0;
  for (std::size_t k = 0; k < count; ++k) value = value << 8 | static_cast<unsigned char>(text.at(at + k));
  return value;
}

std::size_t entriesOf(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

class SequencePictureTest : public QObject {
  Q_OBJECT
 private slots:
  void whatStandsStillStaysAtItsPixels_data();
  void whatStandsStillStaysAtItsPixels();
  void theCameraSeesAllFrames();
  void anEmptyFrameIsTheCanvas();
  void aContactSheetHasItsCells_data();
  void aContactSheetHasItsCells();
  void aSheetWithoutRoomIsRefused();
  void aFilmIsTheora();
  void theSameFilmIsTheSameFile();
  void framesOfAFilmLastAsTheirTimesSay();
  void filmsOfSolids();
  void aSingleShapeIsNoFilm();
  void aCancelledFilmLeavesNothing();
};

void SequencePictureTest::whatStandsStillStaysAtItsPixels_data() {
  QTest::addColumn<bool>("solid");
  QTest::addColumn<QString>("view");
  QTest::newRow("drawing") << false << "auto";
  QTest::newRow("solids from the front") << true << "front";
  QTest::newRow("solids") << true << "auto";
}

void SequencePictureTest::whatStandsStillStaysAtItsPixels() {
  QFETCH(bool, solid);
  QFETCH(QString, view);
  const auto images = framesOf(solid ? growingBoxes(4) : widening(4),
                               {{"size", "320x200"}, {"transparent", true}, {"view", view.toStdString()}});
  const auto [from, to] = firstDrawnColumns(images.front());
  QVERIFY(from > 0 && to > from + 10 && to < 160);
  for (const QImage& image : images) {
    QCOMPARE(image.size(), QSize(320, 200));
    // Places are rounded to floats, whose last digit may differ with the size of a frame.
    QVERIFY2(largestDifference(images.front(), image, to) <= 3,
             qPrintable(QString::number(largestDifference(images.front(), image, to))));
  }
  QVERIFY(largestDifference(images.front(), images.back(), 320) > 100);
}

void SequencePictureTest::theCameraSeesAllFrames() {
  const auto images = framesOf(widening(5), {{"size", "320x200"}, {"transparent", true}});
  // From -14 to 14 mm: with a margin of 8 % on each side, the disc begins where the last rectangle ends, mirrored.
  const auto last = [](const QImage& image) { return 319 - firstDrawnColumns(image.mirrored(true, false)).first; };
  const int left = firstDrawnColumns(images.front()).first;
  QVERIFY(std::abs(left - 0.08 * 320) <= 3);
  QVERIFY(std::abs(last(images.back()) - (319 - left)) <= 2);
  const double scale = (319.0 - 2 * left) / 28;  // pixels a millimetre
  for (int k = 0; k < 5; ++k)
    QVERIFY2(std::abs(last(images[static_cast<std::size_t>(k)]) - (left + (14 + 2 + 3 * k) * scale)) <= 2,
             qPrintable(QString::number(k)));
}

void SequencePictureTest::anEmptyFrameIsTheCanvas() {
  Sequence sequence = widening(2);
  sequence.frames.insert(sequence.frames.begin(), Shape(Region{}));
  sequence.times = {0, 0.5, 1};
  const auto images = framesOf(sequence, {{"size", "160x100"}, {"transparent", true}});
  QCOMPARE(firstDrawnColumns(images[0]).first, 160);
  QVERIFY(firstDrawnColumns(images[1]).first < 40);
  const TemporaryFolder folder;
  Sequence nothing;
  nothing.frames = {Shape(Region{}), Shape(Region{})};
  VERIFY_ERROR(writeShape(pictures(), nothing, folder.path() / "no.png"), ErrorCode::InvalidInput);
  QCOMPARE(entriesOf(folder.path()), std::size_t{0});
}

void SequencePictureTest::aContactSheetHasItsCells_data() {
  QTest::addColumn<int>("frames");
  QTest::addColumn<int>("wanted");
  QTest::addColumn<int>("cells");
  QTest::newRow("fewer than there are") << 9 << 6 << 6;
  QTest::newRow("all") << 4 << 4 << 4;
  QTest::newRow("more than there are") << 3 << 20 << 3;
  QTest::newRow("one") << 5 << 1 << 1;
}

void SequencePictureTest::aContactSheetHasItsCells() {
  QFETCH(int, frames);
  QFETCH(int, wanted);
  QFETCH(int, cells);
  Sequence sequence;  // a square that becomes larger and a speck far right that stays: all cells have one camera
  for (int k = 0; k < frames; ++k) {
    sequence.frames.emplace_back(rectangleRegion({0, 0}, {10.0 + k, 10.0 + k}));
    sequence.times.push_back(0.5 * k);
  }
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "sheet.png";
  writeShape(pictures(), sequence, out, {{"size", "640x480"}, {"sheet", wanted}, {"transparent", true}});
  QCOMPARE(entriesOf(folder.path()), std::size_t{1});
  const QImage image(QString::fromStdString(out.string()));
  QCOMPARE(image.size(), QSize(640, 480));
  const auto parts = largeParts(image);
  QCOMPARE(parts.size(), static_cast<std::size_t>(cells));
  // Sides go like those of the frames that were chosen, all of them at one scale; the largest has the last frame.
  std::vector<int> sides;
  for (const Part& part : parts) sides.push_back(part.box.width());
  std::sort(sides.begin(), sides.end());
  const double scale = sides.back() / (10.0 + (cells > 1 ? frames - 1 : 0));
  for (int k = 0; k < cells; ++k) {
    const int frame = cells > 1 ? int(std::lround(double(k) * (frames - 1) / (cells - 1))) : 0;
    QVERIFY2(std::abs(sides[static_cast<std::size_t>(k)] - scale * (10 + frame)) <= 3, qPrintable(QString::number(k)));
  }
}

void SequencePictureTest::aSheetWithoutRoomIsRefused() {
  const TemporaryFolder folder;
  const Value tiny{{"size", "20x20"}, {"sheet", 4}};
  VERIFY_ERROR(writeShape(pictures(), widening(4), folder.path() / "sheet.png", tiny), ErrorCode::InvalidParameter);
  // Cells that have no room are left out, and the others spread over the sequence.
  const std::size_t cells = renderContactSheet(widening(60), folder.path() / "sheet.png", {.width = 150, .height = 100}, 60);
  QVERIFY(cells >= 2 && cells < 20);
}

void SequencePictureTest::aFilmIsTheora() {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "film.ogv";
  writeShape(pictures(), widening(5), out, {{"size", "150x90"}, {"seconds", 1.2}, {"rate", 20}});
  const std::string bytes = readFile(out);
  QVERIFY(bytes.starts_with("OggS"));
  const OggFile ogg = oggOf(bytes);
  QVERIFY(ogg.whole && ogg.ended);
  QCOMPARE(ogg.packets.size(), std::size_t{3 + 24});  // three headers
  const std::string& header = ogg.packets.front();
  QVERIFY(header.starts_with("\x80theora"));
  QCOMPARE(bigEndian(header, 10, 2), std::size_t{10});  // blocks of 16 pixels
  QCOMPARE(bigEndian(header, 12, 2), std::size_t{6});
  QCOMPARE(bigEndian(header, 14, 3), std::size_t{150});  // pixels that are shown
  QCOMPARE(bigEndian(header, 17, 3), std::size_t{90});
  QCOMPARE(bigEndian(header, 20, 1), std::size_t{0});
  QCOMPARE(bigEndian(header, 21, 1), std::size_t{6});                            // below them
  QCOMPARE(bigEndian(header, 22, 4), std::size_t{20});                           // pictures
  QCOMPARE(bigEndian(header, 26, 4), std::size_t{1});                            // per second
  QCOMPARE((ogg.lastGranule >> 6) + (ogg.lastGranule & 63), std::uint64_t{24});  // the number of the last picture
  QCOMPARE(entriesOf(folder.path()), std::size_t{1});
}

void SequencePictureTest::theSameFilmIsTheSameFile() {
  const TemporaryFolder folder;
  std::set<std::string> films;
  for (const char* name : {"a.ogv", "b.ogv"}) {
    writeShape(pictures(), widening(3), folder.path() / name, {{"size", "90x50"}, {"seconds", 0.4}});
    films.insert(readFile(folder.path() / name));
  }
  QCOMPARE(films.size(), std::size_t{1});
}

// A picture that is the same as the one before it takes next to nothing.
void SequencePictureTest::framesOfAFilmLastAsTheirTimesSay() {
  Sequence sequence = widening(3);
  sequence.times = {0, 0.5, 2};  // a sixth, three sixths, two sixths
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "film.ogv";
  writeShape(pictures(), sequence, out, {{"size", "160x96"}, {"seconds", 1.2}, {"rate", 20}});
  const OggFile ogg = oggOf(readFile(out));
  QCOMPARE(ogg.packets.size(), std::size_t{3 + 24});
  std::vector<std::pair<std::size_t, std::size_t>> bySize;
  for (std::size_t k = 0; k < 24; ++k) bySize.emplace_back(ogg.packets[3 + k].size(), k);
  std::sort(bySize.rbegin(), bySize.rend());
  const std::set<std::size_t> largest{bySize[0].second, bySize[1].second, bySize[2].second};
  QCOMPARE(largest, (std::set<std::size_t>{0, 4, 16}));
}

void SequencePictureTest::filmsOfSolids() {
  const TemporaryFolder folder;
  const fs::path out = folder.path() / "solids.ogv";
  writeShape(pictures(), growingBoxes(3), out, {{"size", "64x48"}, {"seconds", 0.2}, {"theme", "light"}});
  QCOMPARE(oggOf(readFile(out)).packets.size(), std::size_t{3 + 5});
}

void SequencePictureTest::aSingleShapeIsNoFilm() {
  const TemporaryFolder folder;
  try {
    writeShape(pictures(), Shape(circleRegion(4)), folder.path() / "film.ogv");
    QFAIL("A single shape was filmed.");
  } catch (const Error& error) {
    QVERIFY(error.code() == ErrorCode::OutputNotSupported);
    QVERIFY(error.hint().find("frames") != std::string::npos);
  }
  for (const char* size : {"0x90", "5000x90", "large"})
    VERIFY_ERROR(writeShape(pictures(), widening(2), folder.path() / "film.ogv", {{"size", size}}),
                 ErrorCode::InvalidParameter);
  VERIFY_ERROR(writeShape(pictures(), widening(2), folder.path() / "none" / "film.ogv", {{"size", "64x48"}}),
               ErrorCode::FileUnwritable);
  QCOMPARE(entriesOf(folder.path()), std::size_t{0});
}

void SequencePictureTest::aCancelledFilmLeavesNothing() {
  const TemporaryFolder folder;
  for (const char* name : {"film.ogv", "sheet.png"}) {
    const CancelToken token;
    const Progress progress(token, [&](double fraction, const std::string&) {
      if (fraction >= 0.5) token.cancel();
    });
    Value options{{"size", "320x240"}};
    if (name == std::string("sheet.png")) options["sheet"] = 4;
    VERIFY_ERROR(writeShape(pictures(), widening(4), folder.path() / name, options, progress), ErrorCode::Cancelled);
  }
  QCOMPARE(entriesOf(folder.path()), std::size_t{0});
}

BLOSSOM_TEST(SequencePictureTest)
#include "sequence_picture_test.moc"
