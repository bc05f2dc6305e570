// The mean of frames against a plain sum of its own, over random frames whose seed is printed.
#include <QtTest>
#include <array>
#include <random>

#include "support/test_main.h"
#include "ui/view/smoothing.h"

using namespace blossom::ui;

namespace {

constexpr int width = 7, height = 5;
using Frame = std::vector<std::uint32_t>;

Frame randomFrame(std::mt19937& random) {
  Frame frame(width * height);
  for (std::uint32_t& pixel : frame) pixel = static_cast<std::uint32_t>(random());
  return frame;
}

/// What a picture shows of a pixel that OpenGL counts from the lowest line.
std::uint32_t shown(const QImage& picture, std::size_t i) {
  return picture.pixel(static_cast<int>(i) % width, height - 1 - static_cast<int>(i) / width);
}

}  // namespace

class SmoothingTest : public QObject {
  Q_OBJECT
 private slots:
  void thePictureIsTheMeanOfTheFrames();
  void framesLieLessThanAPixelAside();
  void aSmallFrameFillsThePicture();
};

void SmoothingTest::thePictureIsTheMeanOfTheFrames() {
  const unsigned seed = std::random_device()();
  qInfo("seed %u", seed);
  std::mt19937 random(seed);
  Smoothing smoothing;
  QImage picture(width, height, QImage::Format_RGB32);
  for (int round = 0; round < 20; ++round) {
    smoothing.restart();
    std::vector<std::array<unsigned, 3>> sums(width * height, {0, 0, 0});
    for (unsigned count = 1; count <= Smoothing::frames; ++count) {
      const Frame frame = randomFrame(random);
      const bool changed = smoothing.take(frame, picture);
      QCOMPARE(changed, count == 1 || count == 2 || count == 4 || count == 8);
      for (std::size_t i = 0; i < frame.size(); ++i) {
        for (unsigned c = 0; c < 3; ++c) sums[i][c] += frame[i] >> (8 * c) & 0xFF;
        if (!changed) continue;
        for (unsigned c = 0; c < 3; ++c) QCOMPARE(shown(picture, i) >> (8 * c) & 0xFF, (sums[i][c] + count / 2) / count);
      }
    }
    QVERIFY(smoothing.complete());
  }
}

void SmoothingTest::framesLieLessThanAPixelAside() {
  Smoothing smoothing;
  QImage picture(width, height, QImage::Format_RGB32);
  QPointF sum;
  QCOMPARE(smoothing.offset(), QPointF());  // the first lies in place
  while (!smoothing.complete()) {
    const QPointF offset = smoothing.offset();
    QVERIFY(std::abs(offset.x()) <= 0.5 && std::abs(offset.y()) <= 0.5);
    sum += offset;
    smoothing.take(Frame(width * height), picture);
  }
  QVERIFY(std::abs(sum.x()) <= 0.5 && std::abs(sum.y()) <= 0.5);
}

/// Four quarters of one colour each come where they belong: OpenGL counts lines from below.
void SmoothingTest::aSmallFrameFillsThePicture() {
  const std::array<QRgb, 4> colors{qRgb(200, 0, 0), qRgb(0, 200, 0), qRgb(0, 0, 200), qRgb(90, 90, 90)};
  constexpr int half = 6;
  Frame frame;
  for (int y = 0; y < 2 * half; ++y)
    for (int x = 0; x < 2 * half; ++x) frame.push_back(colors[static_cast<std::size_t>(2 * (y / half) + x / half)]);
  for (const double scale : {1.0, 2.0}) {
    QImage picture(4 * half, 4 * half, QImage::Format_RGB32);
    picture.setDevicePixelRatio(scale);
    showEnlarged(frame, {2 * half, 2 * half}, picture);
    QCOMPARE(picture.pixel(half, 3 * half), colors[0]);
    QCOMPARE(picture.pixel(3 * half, 3 * half), colors[1]);
    QCOMPARE(picture.pixel(half, half), colors[2]);
    QCOMPARE(picture.pixel(3 * half, half), colors[3]);
    QCOMPARE(picture.pixel(0, 0), colors[2]);
    QCOMPARE(picture.pixel(4 * half - 1, 4 * half - 1), colors[1]);
  }
}

BLOSSOM_TEST(SmoothingTest)
#include "smoothing_test.moc"
