#include "document/journal.h"

#include <fstream>
#include <set>

#include "core/file.h"
#include "document/document_json.h"
#include "document/journal_files.h"
#include "document/journal_text.h"
#include "document/recovery_area.h"
#include "support/random.h"
#include "support/support.h"

using namespace blossom;
namespace fs = std::filesystem;

using test::Random;

namespace {

Feature named(const Document& document, Random& random) {
  Feature feature;
  feature.id = document.freshId("part");
  feature.type = "test.part";
  feature.name = "Part \"" + std::to_string(random() % 1000) + "\"\n\xc3\xa9";
  feature.parameters["size"] = static_cast<double>(random()) / 3.0;
  for (const auto& other : document.features())
    if (random() % 4 == 0) feature.inputs.push_back(other->id);
  return feature;
}

Document withFile(const Document& document, Random& random) {
  auto content = std::make_shared<std::string>(1 + random() % 5000, '\0');
  for (char& byte : *content) byte = static_cast<char>(random());
  const std::string hash = contentHash(*content);
  Feature feature = named(document, random);
  feature.parameters["file"] = Value{{"path", "a.step"}, {"asset", hash}};
  return document.withAsset(hash, std::move(content)).with(std::move(feature));
}

/// Any one edit that a user could make.
Document edited(const Document& document, Random& random) {
  const auto features = document.features();
  if (features.empty() || random() % 3 == 0) return document.with(named(document, random));
  if (random() % 6 == 0) return withFile(document, random);
  if (random() % 9 == 0) return document.withExtra({{"note", random()}, {"units", "mm"}});
  const Feature& any = *features[random() % features.size()];
  if (random() % 4 == 0 && document.usersOf(any.id).empty()) return document.without(any.id);
  if (random() % 4 == 0) {
    try {
      return document.moved(any.id, random() % features.size());
    } catch (const Error&) {
      return document.without(features.back()->id);  // nobody uses the last one
    }
  }
  Feature changed = any;
  changed.parameters["size"] = static_cast<double>(random() % 977) / 7.0;
  changed.visible = random() % 2 == 0;
  return document.with(std::move(changed));
}

JournalOrigin origin() { return {"/somewhere/wheel.blossom", "wheel"}; }

std::string recovered(const fs::path& folder) {
  const OpenedDocument opened = recoverDocument(folder);
  if (!opened.warnings.empty()) return opened.warnings.front();
  return toJson(opened.document);
}

void overwrite(const fs::path& file, std::string_view content) {
  std::ofstream out(file, std::ios::binary | std::ios::trunc);
  out.write(content.data(), static_cast<std::streamsize>(content.size()));
}

}  // namespace

class JournalTest : public QObject {
  Q_OBJECT
 private slots:
  void aLineTellsWhetherItIsWhole();
  void stepsLeadFromOneDocumentToTheNext();
  void whatIsRecordedIsRecovered();
  void cutAnywhereItHoldsTheLastWholeStep();
  void aDamagedFileIsNamedAndTheRestRecovered();
  void aTornBaseLeavesTheOneBefore();
  void snapshotsKeepTheListShort();
  void clearedNothingIsLeft();
  void whatCannotBeWrittenIsToldOnceAndTriedAgain();
  void aRunThatCannotBeReadHidesNoOther();
  void onlyTheDeadLoseDocuments();
};

void JournalTest::aLineTellsWhetherItIsWhole() {
  const Value value{{"what", "Add \"box\"\n"}, {"x", 1.0 / 3}};
  const std::string line = journalLine(value);
  QCOMPARE(std::count(line.begin(), line.end(), '\n'), 1);
  const std::string_view whole(line.data(), line.size() - 1);
  QVERIFY(readJournalLine(whole) == value);
  for (std::size_t n = 0; n < whole.size(); ++n) QVERIFY(!readJournalLine(whole.substr(0, n)));
  for (std::size_t n = 0; n < whole.size(); ++n) {
    std::string changed(whole);
    changed[n] = static_cast<char>(changed[n] ^ 1);
    QVERIFY(!readJournalLine(changed));
  }
}

void JournalTest::stepsLeadFromOneDocumentToTheNext() {
  Random random = test::seededRandom();
  for (int round = 0; round < 40; ++round) {
    Document document;
    Value replayed = documentJson(document);
    for (int i = 0; i < 40; ++i) {
      const Document next = edited(document, random);
      applyJournalStep(replayed, journalStep(document, next));
      document = next;
      Problems problems("It", false);
      QCOMPARE(toJson(readDocumentJson(replayed.dump(), problems)), toJson(document));
    }
    QVERIFY(journalStep(document, document).empty());
  }
}

void JournalTest::whatIsRecordedIsRecovered() {
  Random random = test::seededRandom();
  const TemporaryFolder place;
  const fs::path folder = place.path() / "one";
  Journal journal(folder);
  Document document;
  for (int i = 0; i < 60; ++i) {
    document = edited(document, random);
    journal.record(document, "Step " + std::to_string(i), origin());
    if (random() % 10 == 0) journal.snapshot();
    if (i % 7 != 0) continue;
    journal.settle();
    QCOMPARE(recovered(folder), toJson(document));
    const JournalSummary summary = summarised(folder);
    QCOMPARE(summary.lastStep, "Step " + std::to_string(i));
    QVERIFY(summary.origin == origin());
    QCOMPARE(summary.features, document.features().size());
    QVERIFY(std::abs(summary.milliseconds - QDateTime::currentMSecsSinceEpoch()) < 60000);
  }
  journal.settle();
  // Files are there once, however often they are named.
  std::set<std::string> assets;
  for (const auto& feature : document.features())
    if (feature->parameters.contains("file")) assets.insert(feature->parameters["file"]["asset"].get<std::string>());
  for (const std::string& hash : assets) QVERIFY(fs::exists(journalAssets(folder) / hash));
}

void JournalTest::cutAnywhereItHoldsTheLastWholeStep() {
  Random random = test::seededRandom();
  const TemporaryFolder place;
  const fs::path folder = place.path() / "one", steps = journalSteps(folder, 1);
  Journal journal(folder);
  Document document = edited(Document(), random);
  journal.record(document, "Base", origin());
  journal.settle();
  std::vector<std::pair<std::size_t, std::string>> states{{0, toJson(document)}};
  for (int i = 0; i < 8; ++i) {
    document = edited(document, random);
    journal.record(document, "Step", origin());
    journal.settle();
    states.emplace_back(fs::file_size(steps), toJson(document));
  }
  const std::string whole = readFile(steps);
  QCOMPARE(whole.size(), states.back().first);
  std::size_t state = 0;
  for (std::size_t size = 0; size <= whole.size(); size += 1 + random() % 3) {
    while (state + 1 < states.size() && states[state + 1].first <= size) ++state;
    overwrite(steps, std::string_view(whole).substr(0, size));
    QCOMPARE(recovered(folder), states[state].second);
    // A changed byte ends the list as well, and never makes up a document.
    std::string changed = whole;
    if (size < whole.size()) changed[size] = static_cast<char>(changed[size] ^ (1 << random() % 8));
    overwrite(steps, changed);
    const std::string found = recovered(folder);
    QVERIFY(std::any_of(states.begin(), states.end(), [&](const auto& known) { return known.second == found; }));
  }
}

void JournalTest::aDamagedFileIsNamedAndTheRestRecovered() {
  Random random = test::seededRandom();
  const TemporaryFolder place;
  const fs::path folder = place.path() / "one";
  Journal journal(folder);
  const Document document = withFile(edited(Document(), random), random);
  journal.record(document, "Import", origin());
  journal.settle();
  QCOMPARE(recovered(folder), toJson(document));
  overwrite(journalAssets(folder) / document.assets().begin()->first, "torn");
  const OpenedDocument opened = recoverDocument(folder);
  QCOMPARE(toJson(opened.document), toJson(document));
  QCOMPARE(opened.warnings.size(), std::size_t(1));
}

// A kill between the new base and the removal of the old one, or in the middle of the new one.
void JournalTest::aTornBaseLeavesTheOneBefore() {
  Random random = test::seededRandom();
  const TemporaryFolder place;
  const fs::path folder = place.path() / "one";
  Journal journal(folder);
  const Document document = edited(edited(Document(), random), random);
  journal.record(document, "Step", origin());
  journal.settle();
  const std::string base = readFile(journalBase(folder, 1));
  for (std::size_t size = 0; size < base.size(); size += 7) {
    overwrite(journalBase(folder, 2), std::string_view(base).substr(0, size));
    QCOMPARE(recovered(folder), toJson(document));
  }
  overwrite(journalBase(folder, 2), base);
  QCOMPARE(recovered(folder), toJson(document));
  fs::remove(journalBase(folder, 1));
  overwrite(journalBase(folder, 2), "torn");
  VERIFY_ERROR(recoverDocument(folder), ErrorCode::FileNotFound);
}

void JournalTest::snapshotsKeepTheListShort() {
  Random random = test::seededRandom();
  const TemporaryFolder place;
  const fs::path folder = place.path() / "one";
  Journal journal(folder);
  Document document;
  for (int i = 0; i < 20; ++i) journal.record(document = edited(document, random), "Step", origin());
  journal.settle();
  QVERIFY(fs::file_size(journalSteps(folder, 1)) > 0);
  journal.snapshot();
  journal.snapshot();  // nothing happened since
  journal.settle();
  QCOMPARE(journalGenerations(folder), std::vector<std::size_t>{2});
  QCOMPARE(fs::file_size(journalSteps(folder, 2)), std::uintmax_t(0));
  QVERIFY(!fs::exists(journalSteps(folder, 1)));
  QCOMPARE(recovered(folder), toJson(document));
  // Another file name is another base: it must not be lost.
  journal.record(document = edited(document, random), "Step", {"/elsewhere/b.blossom", "b"});
  journal.settle();
  QCOMPARE(summarised(folder).origin.name, std::string("b"));
  QCOMPARE(recovered(folder), toJson(document));
}

void JournalTest::clearedNothingIsLeft() {
  Random random = test::seededRandom();
  const TemporaryFolder place;
  const fs::path folder = place.path() / "one";
  Document document = withFile(Document(), random);
  {
    Journal journal(folder);
    journal.record(document, "Import", origin());
    journal.clear();
    journal.settle();
    QVERIFY(!fs::exists(folder));
    journal.record(document, "Again", origin());
    journal.settle();
    QCOMPARE(recovered(folder), toJson(document));
    journal.record(document = edited(document, random), "Edit", origin());
  }  // ends without clearing: everything was written
  QCOMPARE(recovered(folder), toJson(document));
}

void JournalTest::whatCannotBeWrittenIsToldOnceAndTriedAgain() {
  Random random = test::seededRandom();
  const TemporaryFolder place;
  const fs::path folder = place.path() / "one";
  overwrite(folder, "a file where the folder should be");
  std::atomic<int> told = 0;
  Journal journal(folder, [&](const Error& error) {
    if (error.code() == ErrorCode::FileUnwritable) ++told;
  });
  Document document;
  for (int i = 0; i < 3; ++i) {
    journal.record(document = edited(document, random), "Step", origin());
    journal.settle();
  }
  QCOMPARE(told.load(), 1);
  fs::remove(folder);
  journal.snapshot();
  journal.settle();
  QCOMPARE(recovered(folder), toJson(document));
}

void JournalTest::aRunThatCannotBeReadHidesNoOther() {
  Random random = test::seededRandom();
  const TemporaryFolder place;
  const fs::path root = place.path() / "recovery";
  {
    RecoveryArea killed(root);
    Journal(killed.newFolder()).record(edited(Document(), random), "Step", origin());
  }
  for (const char* name : {"run-000000", "run-zzzzzz"}) fs::create_directories(root / name / "owner");  // no file to lock
  RecoveryArea next(root);
  const auto lost = next.lost();
  QCOMPARE(lost.size(), std::size_t(1));
  QCOMPARE(lost.front().summary.lastStep, std::string("Step"));
}

void JournalTest::onlyTheDeadLoseDocuments() {
  Random random = test::seededRandom();
  const TemporaryFolder place;
  const fs::path root = place.path() / "recovery";
  const Document document = edited(Document(), random);
  auto first = std::make_unique<RecoveryArea>(root);
  Journal(first->newFolder()).record(document, "Step", origin());
  RecoveryArea second(root);
  QVERIFY(second.lost().empty());  // the first one lives
  QVERIFY(first->lost().empty());
  first.reset();  // with a document in it: as if it had been killed
  auto third = std::make_unique<RecoveryArea>(root);
  const auto lost = second.lost();
  QCOMPARE(lost.size(), std::size_t(1));
  QCOMPARE(lost.front().summary.lastStep, std::string("Step"));
  QVERIFY(third->lost().empty());               // claimed by the second
  QCOMPARE(second.lost().size(), lost.size());  // and told again until somebody decides
  QCOMPARE(recovered(lost.front().folder), toJson(document));
  second.discard(lost.front().folder);
  QVERIFY(second.lost().empty());
  third.reset();
  // The lock, and the folder of the one that still lives.
  QCOMPARE(std::distance(fs::directory_iterator(root), fs::directory_iterator()), std::ptrdiff_t(2));
}

BLOSSOM_TEST(JournalTest)
#include "journal_test.moc"
