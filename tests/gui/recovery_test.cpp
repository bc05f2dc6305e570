// A process that edits and saves without pause is killed at random moments; what it leaves must hold all but the last
// second. The process is this program itself with other arguments; it has no window, but the sessions, journals and files of
// one.
#include <QCoreApplication>
#include <QProcess>
#include <QTemporaryDir>
#include <QTimer>
#include <chrono>
#include <csignal>
#include <fstream>
#include <map>

#include "document/recovery_area.h"
#include "support/random.h"
#include "support/support.h"
#include "ui/session/recovery.h"
#include "ui/session/session.h"

using namespace blossom;
using namespace blossom::ui;
namespace fs = std::filesystem;

using test::Random;

namespace {

constexpr std::int64_t maximumLostMs = 1000;

std::int64_t monotonicMs() {
  using namespace std::chrono;  // the same clock in every process
  return duration_cast<milliseconds>(steady_clock::now().time_since_epoch()).count();
}

std::string identity(const Document& document) { return contentHash(toJson(document)); }

Document partNamed(const std::string& name) {
  Feature feature;
  feature.id = "a";
  feature.type = "test.part";
  feature.name = name;
  return Document().with(std::move(feature));
}

struct Place {
  explicit Place(const fs::path& folder)
      : recovery(folder / "recovery"), file(folder / "wheel.blossom"), log(folder / "states.txt") {}
  fs::path recovery, file, log;
};

/// The process that is killed: edits every few milliseconds, saves now and then, and writes down every state it had.
class Editor : public QObject {
 public:
  Editor(const fs::path& folder, std::uint64_t seed)
      : place_(folder), random_(seed), log_(place_.log, std::ios::app), session_(loadApp({})) {
    Recovery::instance().start(place_.recovery);
    note("state");  // the empty document may be the first that is saved
    QTimer::singleShot(0, this, &Editor::step);
  }

 private:
  void step() {
    const auto dice = random_() % 20;
    const bool saves = dice == 0 && !session_.job().running();
    if (saves)
      session_.save(place_.file, [this] { note("saved"); });
    else if (dice == 1)
      session_.undo();
    else if (dice == 2)
      session_.redo();
    else
      session_.commit(edited(), QStringLiteral("Edit %1").arg(++edits_));
    if (!saves) note("state");
    QTimer::singleShot(static_cast<int>(random_() % 12), this, &Editor::step);
  }

  Document edited() {
    const Document& document = session_.document();
    Feature feature;
    feature.type = "test.part";
    feature.name = "Part";
    feature.parameters["edit"] = edits_;
    const auto count = document.features().size();
    if (count > 12) return document.without(document.features().back()->id);
    if (count > 0 && random_() % 3 != 0) {
      feature.id = document.features()[random_() % count]->id;
      feature.parameters = document.at(feature.id).parameters;
      feature.parameters["edit"] = edits_;
      return document.with(std::move(feature));
    }
    feature.id = document.freshId("part");
    if (random_() % 8 != 0) return document.with(std::move(feature));
    auto content = std::make_shared<std::string>(1 << 20, '\0');  // does not pack, so that saving takes its time
    for (std::size_t i = 0; i + 8 <= content->size(); i += 8) {
      const std::uint64_t noise = random_();
      std::memcpy(content->data() + i, &noise, 8);
    }
    const std::string hash = contentHash(*content);
    feature.parameters["file"] = Value{{"path", "noise.step"}, {"asset", hash}};
    return document.withAsset(hash, std::move(content)).with(std::move(feature));
  }

  void note(const char* what) {
    log_ << what << ' ' << monotonicMs() << ' ' << identity(session_.document()) << '\n' << std::flush;
  }

  Place place_;
  Random random_;
  std::ofstream log_;
  Session session_;
  int edits_ = 0;
};

/// Recovers what it finds, and is killed meanwhile.
class Recoverer : public QObject {
 public:
  explicit Recoverer(const fs::path& folder) : session_(loadApp({})) {
    connect(&Recovery::instance(), &Recovery::changed, this, [this] {
      if (!Recovery::instance().lost().empty() && !session_.job().running() && !session_.modified())
        session_.recover(Recovery::instance().lost().front());
    });
    Recovery::instance().start(Place(folder).recovery);
  }

 private:
  Session session_;
};

/// What the killed process had written down.
struct States {
  struct State {
    std::int64_t milliseconds = 0;
    std::string hash;
  };
  std::vector<State> all;
  std::map<std::string, std::size_t> latest;  ///< place of a hash
  std::size_t saved = 0;                      ///< place of the last state known to be in the file

  explicit States(const fs::path& log) {
    std::ifstream in(log);
    for (std::string line; std::getline(in, line) && !in.eof();) {
      std::istringstream words(line);
      std::string what;
      State state;
      words >> what >> state.milliseconds >> state.hash;
      latest[state.hash] = all.size();
      if (what == "saved") saved = all.size();
      all.push_back(state);
    }
  }
  /// The last state that a kill at this moment must not lose.
  [[nodiscard]] std::size_t mustHave(std::int64_t killed) const {
    std::size_t place = 0;
    for (std::size_t i = 0; i < all.size(); ++i)
      if (all[i].milliseconds <= killed - maximumLostMs) place = i;
    return place;
  }
};

}  // namespace

class RecoveryTest : public QObject {
  Q_OBJECT
 private slots:
  void aKillLosesNoMoreThanASecond();
  void aProcessThatIsStillEndingIsWaitedFor();
  void savedAndClosedNothingIsOffered();
  void withoutSafetyCopiesNothingIsKept();

 private:
  std::int64_t killAfter(const QStringList& arguments, int milliseconds);
  void oneRound(Random&, int round);
  std::int64_t worst_ = 0;
  int killedWhileSaving_ = 0, recoveredUnsaved_ = 0, killedWhileRecovering_ = 0;
};

std::int64_t RecoveryTest::killAfter(const QStringList& arguments, int milliseconds) {
  QProcess process;
  process.setProcessChannelMode(QProcess::ForwardedChannels);
  process.start(QCoreApplication::applicationFilePath(), QStringList{QStringLiteral("recovery_test")} + arguments);
  if (!process.waitForStarted()) return -1;
  process.waitForFinished(milliseconds);
  const std::int64_t killed = monotonicMs();
  ::kill(static_cast<pid_t>(process.processId()), SIGKILL);
  process.waitForFinished();
  return killed;
}

void RecoveryTest::oneRound(Random& random, int round) {
  QTemporaryDir folder;
  const Place place(folder.path().toStdString());
  const std::uint64_t seed = random();
  const std::int64_t killed =
      killAfter({QStringLiteral("--edit"), folder.path(), QString::number(seed)}, 150 + static_cast<int>(random() % 1700));
  QVERIFY(killed > 0);
  const States states(place.log);
  for (const fs::directory_entry& entry : fs::directory_iterator(folder.path().toStdString()))
    if (entry.path().filename().string().starts_with(".blossom-writing-wheel-")) {
      ++killedWhileSaving_;
      break;
    }

  // The file is the old one or the new one, and whole.
  std::size_t have = 0;
  if (fs::exists(place.file)) {
    const std::string hash = identity(openDocument(place.file).document);
    QVERIFY2(states.latest.contains(hash), "the saved file holds a document that never was");
    have = states.latest.at(hash);
    QVERIFY(have >= states.saved);
  }

  if (random() % 2 == 0) {
    QVERIFY(killAfter({QStringLiteral("--recover"), folder.path()}, static_cast<int>(random() % 500)) > 0);
    ++killedWhileRecovering_;
  }
  RecoveryArea area(place.recovery);
  for (const LostDocument& lost : area.lost()) {
    const OpenedDocument opened = recoverDocument(lost.folder);
    QVERIFY2(opened.warnings.empty(), opened.warnings.empty() ? "" : opened.warnings.front().c_str());
    const std::string hash = identity(opened.document);
    // The state after the last one that was written down may have been kept already.
    if (!states.latest.contains(hash)) {
      have = states.all.size();
      continue;
    }
    have = std::max(have, states.latest.at(hash));
    ++recoveredUnsaved_;
  }
  const std::size_t needed = states.mustHave(killed);
  QVERIFY2(have >= needed, qPrintable(QStringLiteral("round %1, seed %2: state %3 of %4 is left, %5 was older than a second")
                                          .arg(round)
                                          .arg(seed)
                                          .arg(have)
                                          .arg(states.all.size())
                                          .arg(needed)));
  if (have + 1 < states.all.size()) worst_ = std::max(worst_, killed - states.all[have + 1].milliseconds);
}

void RecoveryTest::aKillLosesNoMoreThanASecond() {
  Random random = test::seededRandom();
  const int rounds = qEnvironmentVariableIsSet("BLOSSOM_KILLS") ? qEnvironmentVariableIntValue("BLOSSOM_KILLS") : 50;
  for (int round = 0; round < rounds; ++round) {
    oneRound(random, round);
    if (QTest::currentTestFailed()) return;
  }
  qInfo("figure kills %d", rounds);
  qInfo("figure kills_while_saving %d", killedWhileSaving_);
  qInfo("figure kills_while_recovering %d", killedWhileRecovering_);
  qInfo("figure unsaved_documents_recovered %d", recoveredUnsaved_);
  qInfo("figure most_lost_ms %lld", static_cast<long long>(worst_));
  QVERIFY(recoveredUnsaved_ > 0);
}

/// Its lock is released only when the system has taken all of it down, which takes longer than a new start.
void RecoveryTest::aProcessThatIsStillEndingIsWaitedFor() {
  QTemporaryDir folder;
  const Place place(folder.path().toStdString());
  QProcess process;
  process.start(QCoreApplication::applicationFilePath(),
                {QStringLiteral("recovery_test"), QStringLiteral("--edit"), folder.path(), QStringLiteral("5")});
  QVERIFY(process.waitForStarted());
  QTRY_VERIFY(fs::exists(place.log) && fs::file_size(place.log) > 500);
  Recovery& recovery = Recovery::instance();
  recovery.start(place.recovery);
  QTest::qWait(500);
  QVERIFY(recovery.lost().empty());
  process.kill();
  process.waitForFinished();
  QTRY_VERIFY_WITH_TIMEOUT(!recovery.lost().empty(), 20000);
  recovery.stop();
}

void RecoveryTest::savedAndClosedNothingIsOffered() {
  QTemporaryDir folder;
  const Place place(folder.path().toStdString());
  Recovery::instance().start(place.recovery);
  {
    Session session(loadApp({}));
    session.commit(partNamed("A"), QStringLiteral("Add A"));
    bool saved = false;
    session.save(place.file, [&] { saved = true; });
    QTRY_VERIFY(saved);
    session.commit(Document(), QStringLiteral("Delete A"));
    session.abandon();  // closed without saving: nobody wants it
  }
  Recovery::instance().stop();
  QVERIFY(RecoveryArea(place.recovery).lost().empty());
  QCOMPARE(openDocument(place.file).document.features().size(), std::size_t(1));
}

void RecoveryTest::withoutSafetyCopiesNothingIsKept() {
  Session session(loadApp({}));
  session.commit(partNamed("A"), QStringLiteral("Add A"));
  QVERIFY(session.modified());
  QVERIFY(!Recovery::instance().newJournal({}));
}

static int runRecoveryTest(int argc, char** argv) {
  QCoreApplication application(argc, argv);
  QCoreApplication::setOrganizationName(QStringLiteral("Blossom test"));
  const QStringList arguments = QCoreApplication::arguments();
  if (arguments.value(1) == QLatin1String("--edit")) {
    Editor editor(arguments.value(2).toStdString(), arguments.value(3).toULongLong());
    return QCoreApplication::exec();
  }
  if (arguments.value(1) == QLatin1String("--recover")) {
    Recoverer recoverer(arguments.value(2).toStdString());
    return QCoreApplication::exec();
  }
  RecoveryTest test;
  return QTest::qExec(&test, argc, argv);
}
BLOSSOM_TEST_RUN(RecoveryTest, runRecoveryTest)
#include "recovery_test.moc"
