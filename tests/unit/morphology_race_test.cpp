#include <signal.h>
#include <unistd.h>

#include <QFile>
#include <atomic>
#include <future>
#include <thread>

#include "isolate/race.h"
#include "support/gears.h"
#include "support/modeling.h"
#include "support/polyhedra.h"
#include "worker/worker.h"

using namespace blossom;
using namespace blossom::test;

namespace {

Evaluated answer(double figure) {
  Evaluated made;
  made.stats["figure"] = figure;
  return made;
}

/// Works until it is cancelled.
Evaluated endless(const Progress& progress, std::atomic<bool>& ended) {
  try {
    for (;;) {
      progress.check();
      std::this_thread::yield();
    }
  } catch (const Error&) {
    ended = true;
    throw;
  }
}

Attempt failing(ErrorCode code) {
  return [code](const Progress&) -> Evaluated { throw Error(code, "It failed.", ""); };
}

/// Children of this process that are helpers.
std::vector<pid_t> helpers() {
  std::vector<pid_t> found;
  for (const auto& entry : fs::directory_iterator("/proc")) {
    const std::string name = entry.path().filename();
    if (name.find_first_not_of("0123456789") != std::string::npos) continue;
    QFile stat(QString::fromStdString((entry.path() / "stat").string()));
    if (!stat.open(QIODevice::ReadOnly)) continue;
    const QByteArray line = stat.readAll();
    const QList<QByteArray> after = line.mid(line.lastIndexOf(')') + 2).split(' ');
    if (line.contains("(blossom-worker)") && after.size() > 1 && after[1].toInt() == ::getpid())
      found.push_back(std::stoi(name));
  }
  return found;
}

}  // namespace

/// Two ways to one sum, side by side in two children.
class MorphologyRaceTest : public QObject {
  Q_OBJECT

 private slots:
  void init() { endIdleWorkers(); }

  void theFirstResultWins() {
    std::atomic<bool> started = false, ended = false;
    const Attempt noted = [&](const Progress&) {
      started = true;
      return answer(2);
    };
    const auto quick = [](const Progress&) { return answer(1); };
    QCOMPARE(firstOf(quick, noted, 1e9, Progress::none()).stats.at("figure"), Value(1.0));
    QVERIFY(!started);
    const auto slow = [&](const Progress& progress) { return endless(progress, ended); };
    QCOMPARE(firstOf(slow, noted, 0, Progress::none()).stats.at("figure"), Value(2.0));
    QVERIFY(started && ended);
  }

  void whatTheFirstThrowsEndsTheSecond() {
    std::atomic<bool> ended = false;
    const auto slow = [&](const Progress& progress) { return endless(progress, ended); };
    for (const ErrorCode code :
         {ErrorCode::InvalidInput, ErrorCode::Degenerate, ErrorCode::LimitExceeded, ErrorCode::WorkerDied})
      VERIFY_ERROR(firstOf(failing(code), slow, 0, Progress::none()), code);
    // A result that did not pass its checks: the other may.
    const auto good = [](const Progress&) { return answer(2); };
    QCOMPARE(firstOf(failing(ErrorCode::Internal), good, 1e9, Progress::none()).stats.at("figure"), Value(2.0));
    VERIFY_ERROR(firstOf(failing(ErrorCode::Internal), failing(ErrorCode::LimitExceeded), 0, Progress::none()),
                 ErrorCode::Internal);
  }

  void whatTheSecondThrowsCountsForNothing() {
    std::promise<void> failed;
    const Attempt second = [&](const Progress&) -> Evaluated {
      failed.set_value();
      throw Error(ErrorCode::LimitExceeded, "It failed.", "");
    };
    const Attempt first = [&](const Progress&) {
      failed.get_future().wait();
      return answer(1);
    };
    QCOMPARE(firstOf(first, second, 0, Progress::none()).stats.at("figure"), Value(1.0));
  }

  void cancellingEndsBoth() {
    std::atomic<bool> firstEnded = false, secondEnded = false;
    const CancelToken token;
    const Attempt second = [&](const Progress& progress) {
      token.cancel();
      return endless(progress, secondEnded);
    };
    const Attempt first = [&](const Progress& progress) { return endless(progress, firstEnded); };
    VERIFY_ERROR(firstOf(first, second, 0, Progress(token)), ErrorCode::Cancelled);
    QVERIFY(firstEnded && secondEnded);
  }

  // Gear and channel, which are prisms along different axes: walls in common planes.
  void aSumThatTheFirstWayTakesMinutesOver() {
    const Evaluated sum = made("solid-sum", Value::object(), {gear(6, 2), along(0, uChannel())});
    QCOMPARE(sum.stats.at("way"), Value("nef"));
    endIdleWorkers();  // the child of the second way may be kept
    QVERIFY(helpers().empty());
  }

  void noChildIsLeftOver() {
    const CancelToken token;
    const std::vector<Shape> inputs = minutesOfWork();
    auto work = std::async(std::launch::async, [&] { return made("solid-sum", Value::object(), inputs, Progress(token)); });
    QTRY_VERIFY_WITH_TIMEOUT(helpers().size() == 2, 60000);
    token.cancel();
    VERIFY_ERROR(work.get(), ErrorCode::Cancelled);
    QVERIFY(helpers().empty());
    // The first ended by hand: the whole sum ends, and says so.
    auto again = std::async(std::launch::async, [&] { return made("solid-sum", Value::object(), inputs); });
    QTRY_VERIFY_WITH_TIMEOUT(helpers().size() == 2, 60000);
    for (const pid_t helper : helpers()) ::kill(helper, SIGKILL);
    VERIFY_ERROR(again.get(), ErrorCode::WorkerDied);
    QVERIFY(helpers().empty());
  }
};

BLOSSOM_TEST(MorphologyRaceTest)
#include "morphology_race_test.moc"
