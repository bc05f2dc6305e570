// A child that has served one call well serves the next; in all else nobody can tell it from a new one.
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QElapsedTimer>
#include <QTemporaryDir>
#include <array>
#include <atomic>
#include <functional>
#include <future>
#include <set>
#include <sstream>
#include <thread>

#include "cli/cli.h"
#include "core/parallel.h"
#include "core/sanitizers.h"
#include "document/evaluator.h"
#include "support/command_line.h"
#include "support/modeling.h"
#include "support/worker.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// In a thread that has ended when this returns.
int servingPidOfAnotherThread() {
  int pid = 0;
  std::thread([&] { pid = servingPid(); }).join();
  return pid;
}

std::string writtenAs(const char* name, const Shape& shape, const Value& options = Value::object()) {
  const TemporaryFolder folder;
  const fs::path file = folder.path() / name;
  writeShape(*theApp().formats, shape, file, options);
  return readFile(file);
}

/// What several calls of the kinds that OCCT keeps settings for write, in this order.
std::vector<std::string> severalFiles() {
  const Shape box = Brep(made("box").shape.get<Brep>()->shape(), "Klotz", Color{1, 0, 0});
  std::vector<std::string> files;
  for (const char* schema : {"ap214", "ap242"}) files.push_back(writtenAs("a.step", box, {{"schema", schema}}));
  for (const bool solid : {true, false}) files.push_back(writtenAs("a.igs", box, {{"brep", solid}}));
  files.push_back(writtenAs("a.step", box, {{"schema", "ap214"}}));
  files.push_back(writtenAs("a.igs", box, {{"brep", true}}));
  const TemporaryFolder folder;
  writeAtomically(folder.path() / "b.step", files.front());
  files.push_back(writtenAs("b.brep", readShape(*theApp().formats, folder.path() / "b.step").shape));
  files.push_back(writtenAs("c.brep", made("fillet", {{"radius", 3}}, {box}).shape));
  files.push_back(writtenAs(
      "d.brep", made("boolean", {{"operation", "difference"}}, {box, made("sphere", {{"radius", 12}}).shape}).shape));
  return files;
}

}  // namespace

class KeptWorkerTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    qputenv("SOURCE_DATE_EPOCH", "1700000000");
    (void)theApp();
  }
  void init() { endIdleWorkers(); }

  void theSecondCallMeetsTheSameChild() {
    const int first = servingPid();
    QCOMPARE(servingPid(), first);
    QVERIFY(selftest({{"mode", "echo"}, {"number", 1}}).at("number") == Value(1));
    QCOMPARE(servingPid(), first);
  }

  /// The system tells a child when the thread ends that started it.
  void itOutlivesTheThreadThatStartedIt() {
    const int first = servingPidOfAnotherThread();
    QCOMPARE(servingPidOfAnotherThread(), first);
    QCOMPARE(servingPid(), first);
  }

  void callsAtTheSameTimeHaveChildrenOfTheirOwn() {
    const CancelToken token;
    std::promise<int> waiting;
    auto other = std::async(std::launch::async, [&] {
      return failure({{"mode", "wait"}}, whenWaiting(token, [&](int pid) { waiting.set_value(pid); }));
    });
    const int busy = waiting.get_future().get();
    const int first = servingPid();
    QVERIFY(first != busy);
    QCOMPARE(servingPid(), first);
    token.cancel();
    QCOMPARE(other.get().code(), ErrorCode::Cancelled);
    QVERIFY(!exists(busy));
    QVERIFY(exists(first));
  }

  void manyThreadsShareAFewChildren() {
    constexpr int threads = 8, calls = 12;
    std::vector<std::future<bool>> all;
    for (int t = 0; t < threads; ++t)
      all.push_back(std::async(std::launch::async, [t] {
        for (int i = 0; i < calls; ++i)
          if (selftest({{"mode", "echo"}, {"number", t * calls + i}}).at("number") != Value(t * calls + i)) return false;
        return true;
      }));
    for (auto& each : all) QVERIFY(each.get());
  }

  void afterAFailureThereIsANewOne_data() {
    QTest::addColumn<QString>("mode");
    for (const char* mode : {"abort", "throw", "spin", "memory", "unknown"}) QTest::addRow("%s", mode) << QString(mode);
  }
  void afterAFailureThereIsANewOne() {
    QFETCH(QString, mode);
    if (hasShadowMemory && mode == "memory") QSKIP("The address space cannot be limited under a sanitizer.");
    const int first = servingPid();
    WorkerOptions options;
    if (mode == "spin") options.cpuSeconds = 1;
    if (mode == "memory") options.memory = std::uintmax_t{2} << 30;
    (void)failure({{"mode", mode.toStdString()}, {"code", "Degenerate"}, {"message", "It is flat."}}, Progress::none(),
                  options);
    QVERIFY(!exists(first));
    QVERIFY(servingPid() != first);
  }

  void afterACancelledCallThereIsANewOne() {
    const int first = servingPid();
    const CancelToken token;
    std::atomic<int> waiting = 0;
    const Progress canceller = whenWaiting(token, [&](int pid) {
      waiting = pid;
      token.cancel();
    });
    QCOMPARE(failure({{"mode", "wait"}}, canceller).code(), ErrorCode::Cancelled);
    QCOMPARE(waiting.load(), first);
    QVERIFY(!exists(first));
    QVERIFY(servingPid() != first);
  }

  void oneThatSomebodyEndedIsReplaced() {
    const int first = servingPid();
    ::kill(first, SIGKILL);
    siginfo_t ended;
    ::waitid(P_PID, static_cast<id_t>(first), &ended, WEXITED | WNOWAIT);
    QVERIFY(servingPid() != first);
    QVERIFY(!exists(first));
  }

  void theLimitOfThreadsReachesIt() {
    const int first = servingPid();
    for (const int threads : {1, 3, 0}) {
      setThreadLimit(threads);
      QCOMPARE(selftest({{"mode", "threads"}}).get<int>(), threads);
      QCOMPARE(servingPid(), first);
    }
    // From the command line, which sets the limit before it looks for the file.
    std::ostringstream out, err;
    const std::array words{"blossom", "info", "no-such-file.off", "--threads", "2"};
    QCOMPARE(runCli(theApp(), static_cast<int>(words.size()), words.data(), Terminal{out, err, false, {}}), 1);
    QCOMPARE(selftest({{"mode", "threads"}}).get<int>(), 2);
    setThreadLimit(0);
  }

  void anIdleChildEnds() {
    const int first = servingPid({.idleSeconds = 1e-3});
    QTRY_VERIFY(!exists(first));  // no zombie either
    // The time counts from the last call, whatever the one before asked for.
    const int kept = servingPid({.idleSeconds = 1e6});
    QCOMPARE(servingPid({.idleSeconds = 1e-3}), kept);
    QTRY_VERIFY(!exists(kept));
  }

  void anIdleChildEndsWithItsParent() {
#ifdef __SANITIZE_THREAD__
    QSKIP("ThreadSanitizer cannot follow a fork of a program with threads");
#endif
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);  // orphans of our child become ours, so that their end can be waited for
    std::array<int, 2> ends{};
    QCOMPARE(::pipe(ends.data()), 0);
    const pid_t parent = ::fork();
    if (parent == 0) {
      const int pid = servingPid();
      (void)!::write(ends[1], &pid, sizeof pid);
      for (;;) ::pause();
    }
    int child = 0;
    QCOMPARE(::read(ends[0], &child, sizeof child), static_cast<ssize_t>(sizeof child));
    QVERIFY(exists(child));
    ::kill(parent, SIGKILL);
    QCOMPARE(::waitpid(parent, nullptr, 0), parent);
    QCOMPARE(::waitpid(child, nullptr, 0), child);
    for (const int end : ends) ::close(end);
    ::prctl(PR_SET_CHILD_SUBREAPER, 0);
  }

  void oneThatIsNotToBeKeptEndsAtOnce() { QVERIFY(!exists(servingPid({.idleSeconds = 0}))); }

  void onlyAFewAreKept() {
    constexpr std::size_t many = 7;
    std::atomic<std::size_t> arrived = 0;
    std::vector<std::future<int>> calls;
    for (std::size_t i = 0; i < many; ++i)
      calls.push_back(std::async(std::launch::async, [&] {
        // Each call reports progress while all others are under way.
        const TemporaryFolder folder;
        int pid = 0;
        const Progress progress({}, [&](double, const std::string& stage) {
          pid = std::stoi(stage);
          ++arrived;
          while (arrived < many) std::this_thread::yield();
        });
        runInWorker("worker.selftest", {{"mode", "tell"}}, folder.path(), progress);
        return pid;
      }));
    std::set<int> pids;
    for (auto& each : calls) pids.insert(each.get());
    QCOMPARE(pids.size(), many);
    const auto left = std::count_if(pids.begin(), pids.end(), exists);
    QCOMPARE(left, 4);
    endIdleWorkers();
    QVERIFY(std::none_of(pids.begin(), pids.end(), exists));
  }

  /// A new child would meet these.
  void anotherEnvironmentGetsAnotherChild() {
    const int first = servingPid();
    qputenv("BLOSSOM_TEST_WORD", "other");
    const int other = servingPid();
    qunsetenv("BLOSSOM_TEST_WORD");
    QVERIFY(other != first);
    QCOMPARE(servingPid(), first);
    const QTemporaryDir folder;
    const QString before = QDir::currentPath();
    QDir::setCurrent(folder.path());
    const int elsewhere = servingPid();
    QDir::setCurrent(before);
    QVERIFY(elsewhere != first && elsewhere != other);
  }

  void computingTimeCountsFromTheCall() {
    const int first = selftest({{"mode", "spin"}, {"seconds", 1.5}}).get<int>();
    QCOMPARE(servingPid({.cpuSeconds = 1}), first);
    // A limit ends with its call.
    QCOMPARE(selftest({{"mode", "spin"}, {"seconds", 2.5}}).get<int>(), first);
    QCOMPARE(failure({{"mode", "spin"}}, Progress::none(), {.cpuSeconds = 1}).code(), ErrorCode::LimitExceeded);
  }

  void memoryIsLimitedForEachCall() {
    if (hasShadowMemory) QSKIP("The address space cannot be limited under a sanitizer.");
    constexpr std::uintmax_t limit = std::uintmax_t{1} << 30;
    const Value large{{"mode", "memory"}, {"bytes", limit}};
    const int first = servingPid({.memory = limit});
    QCOMPARE(selftest(large).get<int>(), first);
    QCOMPARE(failure(large, Progress::none(), {.memory = limit}).code(), ErrorCode::LimitExceeded);
  }

  void oneThatHoldsMuchMemoryIsNotKept() {
    if (hasShadowMemory) QSKIP("The memory of a process says nothing under a sanitizer.");
    const int first = selftest({{"mode", "hoard"}, {"bytes", 1e6}}).get<int>();
    QCOMPARE(selftest({{"mode", "hoard"}, {"bytes", 200e6}}).get<int>(), first);
    QVERIFY(!exists(first));
    QVERIFY(servingPid() != first);
  }

  /// Modules of several plugins, and the readers and writers, in one child.
  void oneChildServesAllModules() {
    const Shape box = made("box").shape;
    const int first = servingPid();
    QVERIFY(isSound(made("fillet", {}, {box})));
    writtenAs("a.step", box);
    QCOMPARE(servingPid(), first);
  }

  /// OCCT has settings that outlive a call.
  void aKeptChildWritesTheSameBytesAsANewOne() {
    const std::vector<std::string> once = severalFiles();
    const std::vector<std::string> again = severalFiles();
    QCOMPARE(again.size(), once.size());
    for (std::size_t i = 0; i < once.size(); ++i) {
      QVERIFY(!once[i].empty());
      QVERIFY2(once[i] == again[i], qPrintable(QString("file %1 of the kept child").arg(i)));
    }
    QVERIFY(once[0] == once[4] && once[2] == once[5]);
    // The last file of each kind from a child that has written nothing before.
    endIdleWorkers();
    const Shape box = Brep(made("box").shape.get<Brep>()->shape(), "Klotz", Color{1, 0, 0});
    endIdleWorkers();
    QVERIFY(writtenAs("a.igs", box, {{"brep", false}}) == once[3]);
    endIdleWorkers();
    QVERIFY(writtenAs("a.step", box, {{"schema", "ap242"}}) == once[1]);
    endIdleWorkers();
    QVERIFY(writtenAs("c.brep", made("fillet", {{"radius", 3}}, {box}).shape) == once[7]);
  }

  /// Of an evaluation in a child, the kernel's time is told apart from the rest.
  void kernelAndWorkerTimesAreToldApart() {
    Feature box, fillet;
    box.id = "a";
    box.type = "modeling.box";
    fillet.id = "b";
    fillet.type = "modeling.fillet";
    fillet.inputs = {"a"};
    Evaluator evaluator(theApp().registry);
    const Document document = Document().with(box).with(fillet);
    const auto computed = evaluator.evaluate(document, Progress::none()).at("b");
    QVERIFY(!computed->error && !computed->fromCache);
    QVERIFY(computed->kernelMs > 0);
    QVERIFY(computed->evaluated.stats.at("worker_ms").get<double>() > 0);
    QVERIFY(!computed->evaluated.stats.contains("kernel_ms"));
    QVERIFY(!evaluator.evaluate(document, Progress::none()).at("a")->evaluated.stats.contains("worker_ms"));
    const auto cached = evaluator.evaluate(document, Progress::none()).at("b");
    QVERIFY(cached->fromCache);
    QCOMPARE(cached->kernelMs, 0.0);
    QVERIFY(!cached->evaluated.stats.contains("worker_ms"));

    const QTemporaryDir folder;
    const fs::path block = fs::path(folder.path().toStdString()) / "block.step";
    writeShape(*theApp().formats, made("box").shape, block);
    const Answer answer = answerOf(folder.path(), {"fillet", "block.step"});
    QCOMPARE(answer.code, 0);
    const Value& stats = answer.json.at("stats");
    const double kernel = stats.at("kernel_ms"), worker = stats.at("worker_ms"), total = stats.at("total_ms");
    QVERIFY(kernel > 0 && worker > 0 && kernel + worker < total);
  }

  /// Nothing is asserted on these: a busy machine would decide.
  void whatCallsCost() {
    const Shape box = made("box").shape, sphere = made("sphere", {{"radius", 12}}).shape;
    const auto worker = [](const Evaluated& evaluated) { return evaluated.stats.at("worker_ms").get<double>(); };
    const std::vector<std::pair<const char*, std::function<double()>>> calls{
        {"fillet",
         [&] {
           return worker(made("fillet", {{"radius", 3}}, {box}));
         }},
        {"boolean",
         [&] {
           return worker(made("boolean", Value::object(), {box, sphere}));
         }},
        {"echo", [] {
           QElapsedTimer since;
           since.start();
           selftest({{"mode", "echo"}});
           return static_cast<double>(since.nsecsElapsed()) / 1e6;
         }}};
    for (const auto& [name, call] : calls) {
      std::vector<double> first, next;
      for (int i = 0; i < 5; ++i) {
        endIdleWorkers();
        first.push_back(call());
        next.push_back(call());
      }
      std::sort(first.begin(), first.end());
      std::sort(next.begin(), next.end());
      qInfo("figure first_%s_ms %.2f", name, first[2]);
      qInfo("figure next_%s_ms %.2f", name, next[2]);
    }
  }

  /// Orphans of the program would become ours.
  void aProgramThatHasEndedLeavesNoChild() {
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);
    const QTemporaryDir folder;
    const Answer answer =
        answerOf(folder.path(), {"convert", QString::fromStdString(sample("bracket.blossom").string()), "a.step"});
    QCOMPARE(answer.code, 0);
    QCOMPARE(::waitpid(-1, nullptr, WNOHANG), -1);
    QCOMPARE(errno, ECHILD);
    ::prctl(PR_SET_CHILD_SUBREAPER, 0);
  }
};

BLOSSOM_TEST(KeptWorkerTest)
#include "kept_worker_test.moc"
