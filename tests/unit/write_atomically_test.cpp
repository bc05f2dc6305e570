#include <sys/stat.h>

#include <fstream>

#include "core/file.h"
#include "support/support.h"

using namespace blossom;
namespace fs = std::filesystem;

namespace {

std::size_t countOfFiles(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

class WriteAtomicallyTest : public QObject {
  Q_OBJECT
 private slots:
  void whatFailsLeavesTheOldFileAlone();
  void modeAndLinksAreKept();
  void protectedFilesAreRefused();
  void leftoversOfTheDeadGo();
};

void WriteAtomicallyTest::whatFailsLeavesTheOldFileAlone() {
  const TemporaryFolder place;
  const fs::path file = place.path() / "a.txt";
  writeAtomically(file, "old");
  VERIFY_ERROR(writeAtomically(file,
                               [](const fs::path& temporary) {
                                 std::ofstream(temporary) << "half";
                                 throw Error(ErrorCode::Cancelled, "Cancelled.");
                               }),
               ErrorCode::Cancelled);
  QCOMPARE(readFile(file), std::string("old"));
  QCOMPARE(countOfFiles(place.path()), std::size_t(1));
  VERIFY_ERROR(writeAtomically(place.path() / "no" / "folder.txt", "x"), ErrorCode::FileUnwritable);
  VERIFY_ERROR(writeAtomically(place.path(), "x"), ErrorCode::FileUnwritable);
  // A pipe stands for the devices that must not be replaced by a file.
  const fs::path pipe = place.path() / "pipe";
  QCOMPARE(::mkfifo(pipe.c_str(), 0600), 0);
  VERIFY_ERROR(writeAtomically(pipe, "x"), ErrorCode::FileUnwritable);
  QVERIFY(fs::is_fifo(pipe));
}

void WriteAtomicallyTest::modeAndLinksAreKept() {
  const TemporaryFolder place;
  const fs::path file = place.path() / "real" / "a.txt", link = place.path() / "link.txt";
  fs::create_directory(file.parent_path());
  writeAtomically(file, "old");
  fs::permissions(file, fs::perms::owner_read | fs::perms::owner_write);
  fs::create_symlink(file, link);
  writeAtomically(link, "new");
  QVERIFY(fs::is_symlink(link));
  QCOMPARE(readFile(file), std::string("new"));
  QVERIFY(fs::status(file).permissions() == (fs::perms::owner_read | fs::perms::owner_write));
}

void WriteAtomicallyTest::protectedFilesAreRefused() {
  const TemporaryFolder place;
  const fs::path file = place.path() / "a.txt";
  writeAtomically(file, "old");
  fs::permissions(file, fs::perms::owner_read);
  VERIFY_ERROR(writeAtomically(file, "new"), ErrorCode::FileUnwritable);
  QCOMPARE(readFile(file), std::string("old"));
}

void WriteAtomicallyTest::leftoversOfTheDeadGo() {
  const TemporaryFolder place;
  const fs::path file = place.path() / "a.txt", dead = place.path() / ".blossom-writing-a-x1y2z3.txt",
                 other = place.path() / ".blossom-writing-ab-x1y2z3.txt";
  for (const fs::path& each : {dead, other}) std::ofstream(each) << "half";
  // One writer inside the other: the first still lives while the second tidies up.
  writeAtomically(file, [&](const fs::path& temporary) {
    std::ofstream(temporary) << "outer";
    writeAtomically(file, "inner");
    QVERIFY(fs::exists(temporary));
  });
  QCOMPARE(readFile(file), std::string("outer"));
  QVERIFY(!fs::exists(dead));
  QVERIFY(fs::exists(other));
}

BLOSSOM_TEST(WriteAtomicallyTest)
#include "write_atomically_test.moc"
