// A disk that is full while a file is written: every format says so, keeps the file that was there and leaves nothing else.
#include <signal.h>
#include <sys/resource.h>

#include "core/file.h"
#include "exchange/format/format.h"
#include "support/modeling.h"
#include "support/solids.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// No file grows beyond so many bytes while this lives: writing fails in the middle, as on a full disk.
class FullDisk {
 public:
  explicit FullDisk(rlim_t bytes) : handler_(::signal(SIGXFSZ, SIG_IGN)) {
    ::getrlimit(RLIMIT_FSIZE, &before_);
    const rlimit limit{bytes, before_.rlim_max};
    ::setrlimit(RLIMIT_FSIZE, &limit);
  }
  ~FullDisk() {
    ::setrlimit(RLIMIT_FSIZE, &before_);
    ::signal(SIGXFSZ, handler_);
  }
  FullDisk(const FullDisk&) = delete;
  FullDisk& operator=(const FullDisk&) = delete;

 private:
  rlimit before_{};
  void (*handler_)(int);
};

Toolpath longProgram() {
  Toolpath path;
  path.cutter.diameter = 2;
  path.moves = {{MoveKind::Rapid, {0, 0, 5}}, {MoveKind::Plunge, {0, 0, -1}, 0, Vec2::Zero(), 100}};
  for (int k = 0; k < 50; ++k) path.moves.push_back({MoveKind::Feed, {1.5 * k, k % 2 * 20.0, -1}, 0, Vec2::Zero(), 600});
  return path;
}

/// Something that takes more than a few hundred bytes to write; empty of the kinds that no feature makes.
Shape shapeOf(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::Region:
      return made("text", {{"text", "Blossom"}}).shape;
    case ShapeKind::Curves:
      return toCurves(*made("text", {{"text", "Blossom"}}).shape.get<Region>());
    case ShapeKind::Curve:
      return Curve{2, {0, 0, 0, 1, 1, 1}, {{2, 2, 12, 1}, {5, 5, 13, 1}, {8, 6, 12, 1}}};
    case ShapeKind::Surface:
      return torusSurface(10, 3);
    case ShapeKind::Brep:
      return made("box").shape;
    case ShapeKind::Mesh:
      return torusMesh(10, 3, 20, 10);
    case ShapeKind::Motion:
      return readShape(*theApp().formats, sample("propeller.json")).shape;
    case ShapeKind::Toolpath:
      return longProgram();
    case ShapeKind::MedialAxis:
      return made("medial-axis", {}, {rectangle(0, 0, 20, 10)}).shape;
    case ShapeKind::Setup:
      return made("setup", Value::object(), {made("box").shape}).shape;
    case ShapeKind::Sequence:
      return Sequence{{rectangle(0, 0, 20, 10), rectangle(0, 0, 30, 10)}, {0, 1}};
    default:
      return {};
  }
}

/// Those that put a sequence into one file.
Value optionsFor(const Format& format, ShapeKind kind) {
  if (kind != ShapeKind::Sequence) return Value::object();
  if (format.id == "svg") return {{"animate", true}};
  if (format.id == "ogv") return {{"size", "64x48"}, {"seconds", 0.2}};
  return {{"sheet", 2}};
}

std::size_t filesIn(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

class FullDiskTest : public QObject {
  Q_OBJECT

 private slots:
  void everyFormatSaysSo_data() {
    QTest::addColumn<QString>("format");
    QTest::addColumn<int>("kind");
    for (const Format& format : theApp().formats->formats())
      for (const ShapeKind kind : format.writes)
        if (format.write)
          QTest::addRow("%s: %s", format.id.c_str(), std::string(shapeKindName(kind)).c_str())
              << QString::fromStdString(format.id) << int(kind);
  }

  void everyFormatSaysSo() {
    QFETCH(QString, format);
    QFETCH(int, kind);
    const Shape shape = shapeOf(static_cast<ShapeKind>(kind));
    QVERIFY(!shape.empty());
    const TemporaryFolder place;
    const Format& written = *theApp().formats->find(format.toStdString());
    const fs::path file = place.path() / ("part." + written.extensions.front());
    const Value options = optionsFor(written, shape.kind());
    writeShape(*theApp().formats, shape, file, options);  // there is a way to write it
    QVERIFY(fs::file_size(file) > limit);
    writeAtomically(file, "old");
    {
      const FullDisk full(limit);
      VERIFY_ERROR(writeShape(*theApp().formats, shape, file, options), ErrorCode::FileUnwritable);
    }
    QCOMPARE(readFile(file), std::string("old"));
    QCOMPARE(filesIn(place.path()), std::size_t(1));
  }

  void documentsSaySo() {
    const TemporaryFolder place;
    const fs::path file = place.path() / "part.blossom";
    writeAtomically(file, "old");
    const Document document = withImported(theApp(), {}, sample("propeller.json"));
    {
      const FullDisk full(limit);
      VERIFY_ERROR(saveDocument(document, file), ErrorCode::FileUnwritable);
    }
    QCOMPARE(readFile(file), std::string("old"));
    QCOMPARE(filesIn(place.path()), std::size_t(1));
  }

 private:
  static constexpr std::size_t limit = 64;
};

BLOSSOM_TEST(FullDiskTest)
#include "full_disk_test.moc"
