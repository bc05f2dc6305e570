#include "worker/worker.h"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <future>

#include "core/sanitizers.h"
#include "support/worker.h"

using namespace blossom;
using namespace blossom::test;

class WorkerTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() { qputenv("BLOSSOM_WORKER", (buildFolder() / "bin/blossom-worker").c_str()); }

  void argumentsComeBackUnchanged() {
    const Value arguments{{"mode", "echo"}, {"number", 0.1}, {"text", "Grüße \"\n\\"}, {"list", {1, 2.5, nullptr, true}}};
    QVERIFY(selftest(arguments) == arguments);
  }

  void largeArgumentsDoNotBlock() {
    const Value arguments{{"mode", "echo"}, {"text", std::string(5'000'000, 'x')}};
    QVERIFY(selftest(arguments) == arguments);
  }

  void errorsKeepCodeMessageAndHint() {
    const Error error =
        failure({{"mode", "throw"}, {"code", "Degenerate"}, {"message", "It is flat."}, {"hint", "Inflate it."}});
    QCOMPARE(error.code(), ErrorCode::Degenerate);
    QCOMPARE(error.message(), std::string("It is flat."));
    QCOMPARE(error.hint(), std::string("Inflate it."));
  }

  void noiseOnStandardOutputIsHarmless() { QVERIFY(selftest({{"mode", "noise"}}) == Value("quiet")); }

  void aCrashIsAnErrorThatNamesTheSignal() {
    const Error error = failure({{"mode", "abort"}}, Progress::none(), {.activity = "reading wheel.step"});
    QCOMPARE(error.code(), ErrorCode::WorkerDied);
    QCOMPARE(error.message(), std::string("The helper process reading wheel.step crashed (SIGABRT)."));
  }

  void beingKilledByHandIsAnErrorThatNamesTheSignal() {
    const Progress killer = whenWaiting({}, [](int pid) { ::kill(pid, SIGKILL); });
    const Error error = failure({{"mode", "wait"}}, killer, {.activity = "reading wheel.step"});
    QCOMPARE(error.code(), ErrorCode::WorkerDied);
    QCOMPARE(error.message(), std::string("The helper process reading wheel.step was ended (SIGKILL)."));
  }

  void cancelEndsTheChildAndLeavesNoZombie() {
    const CancelToken token;
    std::atomic<int> child = 0;
    const Progress canceller = whenWaiting(token, [&](int pid) {
      child = pid;
      token.cancel();
    });
    QCOMPARE(failure({{"mode", "wait"}}, canceller).code(), ErrorCode::Cancelled);
    QVERIFY(child > 0);
    QVERIFY(!exists(child));  // a zombie would still exist
  }

  void aCancelledCallStartsNothing() {
    const CancelToken token;
    token.cancel();
    QCOMPARE(failure({{"mode", "echo"}}, Progress(token)).code(), ErrorCode::Cancelled);
  }

  void callsOfSeveralThreadsDoNotMix() {
    std::vector<std::future<Value>> answers;
    for (int i = 0; i < 6; ++i)
      answers.push_back(std::async(std::launch::async, [i] { return selftest({{"mode", "echo"}, {"number", i}}); }));
    for (int i = 0; i < 6; ++i) QCOMPARE(answers[static_cast<std::size_t>(i)].get().at("number").get<int>(), i);
  }

  void anExceptionOfTheListenerLeavesNoChild() {
    std::atomic<int> child = 0;
    const Progress thrower = whenWaiting({}, [&](int pid) {
      child = pid;
      throw Error(ErrorCode::InUse, "The listener gives up.");
    });
    QCOMPARE(failure({{"mode", "wait"}}, thrower).code(), ErrorCode::InUse);
    QVERIFY(!exists(child));
  }

  void theChildDiesWithItsParent() {
    ::prctl(PR_SET_CHILD_SUBREAPER, 1);  // orphans of our child become ours, so that their end can be waited for
    std::array<int, 2> ends{};
    QCOMPARE(::pipe(ends.data()), 0);
    const pid_t parent = ::fork();
    if (parent == 0) {
      failure({{"mode", "wait"}}, whenWaiting({}, [&](int pid) { (void)!::write(ends[1], &pid, sizeof pid); }));
      ::_exit(0);
    }
    int child = 0;
    QCOMPARE(::read(ends[0], &child, sizeof child), static_cast<ssize_t>(sizeof child));
    ::kill(parent, SIGKILL);
    QCOMPARE(::waitpid(parent, nullptr, 0), parent);
    int status = 0;
    QCOMPARE(::waitpid(child, &status, 0), child);
    QVERIFY(WIFSIGNALED(status) && WTERMSIG(status) == SIGKILL);
    for (const int end : ends) ::close(end);
    ::prctl(PR_SET_CHILD_SUBREAPER, 0);
  }

  void computingTimeIsLimited() {
    QCOMPARE(failure({{"mode", "spin"}}, Progress::none(), {.cpuSeconds = 1}).code(), ErrorCode::LimitExceeded);
  }

  void memoryIsLimited() {
    if (hasShadowMemory) QSKIP("The address space cannot be limited under a sanitizer.");
    const Error error = failure({{"mode", "memory"}}, Progress::none(), {.memory = std::uintmax_t{2} << 30});
    QCOMPARE(error.code(), ErrorCode::LimitExceeded);
  }

  void anUnknownCallIsAnError() {
    const TemporaryFolder folder;
    VERIFY_ERROR(runInWorker("no.such.call", {}, folder.path(), Progress::none()), ErrorCode::Internal);
  }

  void aMissingProgramIsAnError() {
    const QByteArray right = qgetenv("BLOSSOM_WORKER");
    qputenv("BLOSSOM_WORKER", "/nowhere/blossom-worker");
    const Error error = failure({{"mode", "echo"}});
    qputenv("BLOSSOM_WORKER", right);
    QCOMPARE(error.code(), ErrorCode::FileNotFound);
  }

  void noDescriptorIsLeftBehind() {
    const auto descriptors = [] { return std::distance(fs::directory_iterator("/proc/self/fd"), fs::directory_iterator()); };
    endIdleWorkers();
    const auto before = descriptors();
    for (int i = 0; i < 3; ++i) selftest({{"mode", "echo"}});
    failure({{"mode", "abort"}});
    selftest({{"mode", "echo"}});
    endIdleWorkers();
    QCOMPARE(descriptors(), before);
  }
};

BLOSSOM_TEST(WorkerTest)
#include "worker_test.moc"
