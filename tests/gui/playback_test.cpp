#include "ui/timeline/playback.h"

#include <QSignalSpy>
#include <QtTest>

#include "support/test_main.h"

namespace blossom::ui {

class PlaybackTest : public QObject {
  Q_OBJECT
 private slots:
  void longestSequenceGivesTheCount();
  void aShorterSequenceKeepsItsEnds();
  void keepsItsPlaceWhenTheCountChanges();
  void playsToTheEndAndStops();
  void loops();
  void playFromTheEndBeginsAnew();
  void staysWithinTheFrames();
  void whatIsOfferedPlaysOnceItIsThere();
  void framesStayForTheirTime();
};

void PlaybackTest::longestSequenceGivesTheCount() {
  Playback playback;
  playback.setCount(11);
  playback.show(7);
  QCOMPARE(playback.frameOf(11), 7);
  QCOMPARE(playback.frameOf(1), 0);
}

void PlaybackTest::aShorterSequenceKeepsItsEnds() {
  Playback playback;
  playback.setCount(11);
  QCOMPARE(playback.frameOf(3), 0);
  playback.show(5);
  QCOMPARE(playback.frameOf(3), 1);
  playback.show(10);
  QCOMPARE(playback.frameOf(3), 2);
}

void PlaybackTest::keepsItsPlaceWhenTheCountChanges() {
  Playback playback;
  playback.setCount(11);
  playback.show(5);
  playback.setCount(101);
  QCOMPARE(playback.frame(), 50);
  playback.setCount(0);
  QCOMPARE(playback.frame(), 0);
  playback.setCount(101);  // undone
  QCOMPARE(playback.frame(), 50);
  playback.setCount(1);
  playback.setCount(25);  // another one
  QCOMPARE(playback.frame(), 0);
}

void PlaybackTest::playsToTheEndAndStops() {
  Playback playback;
  playback.setCount(4);
  playback.setLooping(false);
  playback.setFramesPerSecond(60);
  QSignalSpy moved(&playback, &Playback::moved);
  playback.setPlaying(true);
  QVERIFY(playback.playing());
  QTRY_VERIFY(!playback.playing());
  QCOMPARE(playback.frame(), 3);
  QCOMPARE(moved.count(), 3);
}

void PlaybackTest::loops() {
  Playback playback;
  playback.setCount(3);
  playback.setFramesPerSecond(60);
  QSignalSpy moved(&playback, &Playback::moved);
  playback.setPlaying(true);
  QTRY_VERIFY(moved.count() >= 7);
  QVERIFY(playback.playing());
  playback.setCount(1);
  QVERIFY(!playback.playing());
}

void PlaybackTest::playFromTheEndBeginsAnew() {
  Playback playback;
  playback.setCount(5);
  playback.show(4);
  playback.setPlaying(true);
  QCOMPARE(playback.frame(), 0);
}

void PlaybackTest::staysWithinTheFrames() {
  Playback playback;
  playback.setPlaying(true);
  QVERIFY(!playback.playing());
  playback.setCount(5);
  playback.show(17);
  QCOMPARE(playback.frame(), 4);
  playback.show(-3);
  QCOMPARE(playback.frame(), 0);
  playback.setFramesPerSecond(1000);
  QCOMPARE(playback.framesPerSecond(), 60);
}

void PlaybackTest::whatIsOfferedPlaysOnceItIsThere() {
  for (const bool forgotten : {false, true}) {
    Playback playback;
    QSignalSpy wanted(&playback, &Playback::wanted);
    playback.setOffered(true);
    playback.setPlaying(true);
    QCOMPARE(wanted.count(), 1);
    QVERIFY(!playback.playing());
    if (forgotten) playback.forgetWish();  // its computing was cancelled
    playback.setCount(5);
    QCOMPARE(playback.playing(), !forgotten);
  }
}

/// The first of three frames takes nine tenths of the run: while it stays, the others would have come at an even pace.
void PlaybackTest::framesStayForTheirTime() {
  Playback playback;
  playback.setPace({0, 0.9, 0.95});
  playback.setCount(3);
  playback.setLooping(false);
  playback.setFramesPerSecond(10);
  QElapsedTimer clock;
  qint64 left = 0;
  connect(&playback, &Playback::moved, this, [&] {
    if (playback.frame() == 1) left = clock.elapsed();
  });
  clock.start();
  playback.setPlaying(true);
  QTRY_VERIFY(!playback.playing());
  QCOMPARE(playback.frame(), 2);
  QVERIFY2(left >= 265, qPrintable(QString::number(left)));  // 270 ms, less what the timer may be early
}

}  // namespace blossom::ui

using blossom::ui::PlaybackTest;
BLOSSOM_TEST(PlaybackTest)
#include "playback_test.moc"
