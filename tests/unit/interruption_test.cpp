// The first signal ends a program with all that it has started and laid down, whether or not its work looks at Progress.
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <QTemporaryDir>
#include <array>
#include <fstream>
#include <thread>

#include "cli/interruption.h"
#include "core/file.h"
#include "core/temporaries.h"
#include "support/command_line.h"
#include "support/worker.h"

using namespace blossom;
using namespace blossom::test;

namespace {

std::size_t entriesIn(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

/// Ended ones that nobody has waited for yet do not live.
bool lives(pid_t pid) {
  std::ifstream stat("/proc/" + std::to_string(pid) + "/stat");
  std::string text;
  std::getline(stat, text);
  const std::size_t end = text.rfind(") ");
  return end != std::string::npos && text[end + 2] != 'Z' && text[end + 2] != 'X';
}

std::string lineFrom(int descriptor) {
  std::string line;
  for (char c = 0; ::read(descriptor, &c, 1) == 1 && c != '\n';) line += c;
  return line;
}

/// Work that does not end by itself; tells a line when it has begun.
using Work = std::function<void(const std::function<void(const std::string&)>& tell)>;

/// A process of its own that does the work, watched for signals or not.
class Program {
 public:
  Program(bool watched, const Work& work) {
    std::array<int, 2> ends{};
    if (::pipe(ends.data()) != 0) qFatal("no pipe");
    pid_ = ::fork();
    if (pid_ == 0) run(watched, work, ends[1]);
    ::close(ends[1]);
    first_ = lineFrom(ends[0]);
    ::close(ends[0]);
  }
  [[nodiscard]] const std::string& first() const { return first_; }
  /// @returns the status as of waitpid
  int endedBy(int signal) {
    ::kill(pid_, signal);
    int status = 0;
    ::waitpid(pid_, &status, 0);
    return status;
  }

 private:
  [[noreturn]] static void run(bool watched, const Work& work, int descriptor) {
    const auto tell = [descriptor](const std::string& line) {
      const std::string text = line + "\n";
      if (::write(descriptor, text.data(), text.size()) < 0) ::_exit(3);
    };
    ::signal(SIGHUP, SIG_DFL);  // ignored where the tests run under nohup
    std::unique_ptr<Interruption> interruption;
    if (watched) interruption = std::make_unique<Interruption>(CancelToken(), [] {});
    work(tell);
    ::_exit(2);
  }

  pid_t pid_ = -1;
  std::string first_;
};

/// Looks at nothing and never ends.
[[noreturn]] void deafWork() {
  volatile bool always = true;  // or the compiler might take an empty loop away
  while (always) {
  }
  ::_exit(2);
}

void holdFolder(const std::function<void(const std::string&)>& tell) {
  const TemporaryFolder folder;
  writeAtomically(folder.path() / "part", "something");
  tell(folder.path().string());
  deafWork();
}

}  // namespace

class InterruptionTest : public QObject {
  Q_OBJECT

  QTemporaryDir made_;  // not one of ours, which a program below would take for its own and remove
  fs::path folder_ = made_.path().toStdString();

 private slots:
  void init() { qputenv("TMPDIR", folder_.c_str()); }

  void everySignalEndsDeafWork_data() {
    QTest::addColumn<int>("number");
    for (const int number : {SIGINT, SIGTERM, SIGQUIT, SIGHUP}) QTest::addRow("%s", ::strsignal(number)) << number;
  }
  void everySignalEndsDeafWork() {
    QFETCH(int, number);
    Program program(true, holdFolder);
    QVERIFY(fs::is_directory(program.first()));
    const int status = program.endedBy(number);
    QVERIFY(WIFEXITED(status));
    QCOMPARE(WEXITSTATUS(status), 1);
    QCOMPARE(entriesIn(folder_), std::size_t(0));
  }

  void unfinishedFilesGo() {
    const fs::path target = folder_ / "target.stl";
    Program program(true, [&](const auto& tell) {
      writeAtomically(target, [&](const fs::path& temporary) {
        tell(temporary.string());
        deafWork();
      });
    });
    QVERIFY(fs::exists(program.first()));
    program.endedBy(SIGTERM);
    QCOMPARE(entriesIn(folder_), std::size_t(0));
  }

  void helpersGoToo() {
    qputenv("BLOSSOM_WORKER", (buildFolder() / "bin/blossom-worker").c_str());
    Program program(true, [](const auto& tell) {
      std::thread waiting([&] {
        const TemporaryFolder folder;
        const Progress progress({}, [&](double, const std::string& stage) { tell(stage); });
        runInWorker("worker.selftest", {{"mode", "wait"}}, folder.path(), progress);
      });
      deafWork();
    });
    const pid_t helper = std::stoi(program.first());
    QVERIFY(lives(helper));
    program.endedBy(SIGTERM);
    QVERIFY(!lives(helper));
    QCOMPARE(entriesIn(folder_), std::size_t(0));
  }

  /// Those that wait for a further call, too.
  void idleHelpersGoToo() {
    qputenv("BLOSSOM_WORKER", (buildFolder() / "bin/blossom-worker").c_str());
    Program program(true, [](const auto& tell) {
      tell(std::to_string(servingPid()));
      deafWork();
    });
    const pid_t helper = std::stoi(program.first());
    QVERIFY(lives(helper));
    program.endedBy(SIGTERM);
    QVERIFY(!lives(helper));
  }

  /// After a kill that nothing can follow, the next program tidies up; the folders of the living stay.
  void abandonedFoldersGoLater() {
    Program killed(false, holdFolder), living(false, holdFolder);
    killed.endedBy(SIGKILL);
    QVERIFY(fs::is_directory(killed.first()));
    const fs::path foreign = folder_ / "blossom-Ab3dEf", plain = folder_ / "blossom-temporary-pictures";
    for (const fs::path& other : {foreign, plain}) {
      fs::create_directory(other);
      fs::permissions(other, fs::perms::owner_all);
    }
    removeAbandonedFolders();
    QVERIFY(!fs::exists(killed.first()));
    QVERIFY(fs::is_directory(living.first()));
    QVERIFY(fs::is_directory(foreign) && fs::is_directory(plain));
    living.endedBy(SIGKILL);
    removeAbandonedFolders();
    QVERIFY(!fs::exists(living.first()));
  }

  void aMissingTemporaryFolderIsNamed() {
    qputenv("TMPDIR", "/no/such/folder");
    try {
      const TemporaryFolder folder;
      QFAIL("it was made");
    } catch (const Error& error) {
      QVERIFY(error.code() == ErrorCode::FileUnwritable);
      QVERIFY(error.message().find("/no/such/folder") != std::string::npos);
      QVERIFY(error.hint().find("TMPDIR") != std::string::npos);
    }
  }

  /// The user has never heard of the file beside his own.
  void messagesNameTheUsersFile() {
    const fs::path target = folder_ / "mine.stl";
    try {
      writeAtomically(target, [](const fs::path& temporary) {
        throw Error(ErrorCode::FileUnwritable, "The file " + temporary.string() + " cannot be written.");
      });
      QFAIL("it was written");
    } catch (const Error& error) {
      QCOMPARE(error.message(), "The file " + target.string() + " cannot be written.");
    }
  }
};

BLOSSOM_TEST(InterruptionTest)
#include "interruption_test.moc"
