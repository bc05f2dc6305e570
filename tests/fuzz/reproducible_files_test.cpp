// The same input gives the same bytes: in another process, whose addresses are others, and with any number of threads.
#include <QProcess>
#include <QTemporaryDir>
#include <algorithm>

#include "core/file.h"
#include "core/parallel.h"
#include "document/evaluator.h"
#include "support/command_line.h"
#include "support/modeling.h"
#include "support/solids.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// What every feature type takes gladly.
Shape plainShape(ShapeKind kind, double size) {
  switch (kind) {
    case ShapeKind::Region:
      return rectangle(0, 0, size, size);
    case ShapeKind::Curves:
      return Curves{{polygon({{2, 2}, {4, 5}, {8, 6}}, false)}};
    case ShapeKind::Curve:
      return Curve{2, {0, 0, 0, 1, 1, 1}, {{2, 2, 12, 1}, {5, 5, 13, 1}, {8, 6, 12, 1}}};
    case ShapeKind::Brep:
      return made("box").shape;
    case ShapeKind::Mesh:
      return boxMesh({0, 0, 0}, Vec3::Constant(size));
    case ShapeKind::Toolpath: {
      Toolpath path;
      path.cutter.diameter = 2;
      path.start = {0, 0, 5};
      path.moves = {{MoveKind::Rapid, {3, 3, 5}}, {MoveKind::Plunge, {3, 3, -1}}, {MoveKind::Feed, {7, 3, -1}}};
      return path;
    }
    case ShapeKind::Setup:
      return made("setup", {{"stock-below", 20}, {"zero", "drawing"}}, {rectangle(0, 0, 40, 40)}).shape;
    default:
      return {};
  }
}

ShapeKind firstKind(const InputSpec& spec) { return spec.kinds.empty() ? ShapeKind::Brep : spec.kinds.front(); }

std::vector<Shape> plainInputs(const FeatureType& type) {
  std::vector<Shape> given;
  for (const InputSpec& spec : type.inputs)
    for (std::size_t i = 0; i < std::max<std::size_t>(1, spec.minimum); ++i)
      given.push_back(plainShape(firstKind(spec), given.empty() ? 40 : 2));
  return given;
}

/// The bytes of all files that a shape becomes in the first format that can hold it.
std::string bytesOf(const Shape& shape) {
  const TemporaryFolder folder;
  for (const char* extension : {"brep", "off", "dxf", "ngc", "svg", "json"}) {
    const Format* format = theApp().formats->find(extension);
    const bool fits = shape.kind() == ShapeKind::Sequence
                          ? std::string(extension) == "off" || std::string(extension) == "svg"
                          : format && format->write && canStore(*format, shape.kind());
    if (!fits) continue;
    try {
      writeShape(*theApp().formats, shape, folder.path() / ("shape." + std::string(extension)));
    } catch (const Error&) {
      continue;
    }
    std::vector<fs::path> files(fs::directory_iterator(folder.path()), fs::directory_iterator{});
    std::sort(files.begin(), files.end());
    std::string bytes;
    for (const fs::path& file : files) bytes += file.filename().string() + "\n" + readFile(file);
    return bytes;
  }
  return {};
}

/// What comes after lies at other addresses than what came before.
class MovedHeap {
 public:
  explicit MovedHeap(int seed) {
    for (int i = 0; i < 2000; ++i) blocks_.emplace_back(static_cast<std::size_t>(16 + (i * 7919 + seed * 131) % 700), 'x');
    for (std::size_t i = 0; i < blocks_.size(); i += 2) std::string().swap(blocks_[i]);
  }

 private:
  std::vector<std::string> blocks_;
};

/// The file that a sample is written as, by its kind.
QString exported(const QString& folder, const fs::path& document, int run, const QString& extension,
                 const QString& threads) {
  const QString file = QStringLiteral("%1/run%2.%3").arg(folder).arg(run).arg(extension);
  QProcess process;
  auto environment = QProcessEnvironment::systemEnvironment();
  environment.insert("SOURCE_DATE_EPOCH", "1700000000");
  environment.insert("BLOSSOM_TEST_PADDING", QString(run * 977, 'x'));  // moves the stack
  process.setProcessEnvironment(environment);
  process.start(blossomProgram(), {"convert", QString::fromStdString(document.string()), file, "--threads", threads});
  process.waitForFinished(-1);
  return process.exitCode() == 0 ? file : QString();
}

}  // namespace

class ReproducibleFilesTest : public QObject {
  Q_OBJECT

 private slots:
  void samples_data() {
    QTest::addColumn<QString>("name");
    QTest::addColumn<QString>("extension");
    for (const auto& entry : fs::directory_iterator(sourceFolder() / "resources/samples")) {
      if (entry.path().extension() != ".blossom") continue;
      const std::string name = entry.path().filename().string();
      const bool solid = name == "bracket.blossom" || name == "flange.blossom";
      for (const char* extension : {"stl", solid ? "step" : "dxf"})
        QTest::addRow("%s as %s", name.c_str(), extension) << QString::fromStdString(name) << QString(extension);
    }
  }

  void samples() {
    QFETCH(QString, name);
    QFETCH(QString, extension);
    QTemporaryDir folder;
    const fs::path document = sample(name.toStdString());
    const QString once = exported(folder.path(), document, 1, extension, "1");
    const QString again = exported(folder.path(), document, 2, extension, "2");
    QCOMPARE(once.isEmpty(), again.isEmpty());
    const QDir files(folder.path());
    const QStringList first = files.entryList({"run1*"}), second = files.entryList({"run2*"});
    if (first.isEmpty() && second.isEmpty()) return;  // shapes that this format does not hold
    QCOMPARE(first.size(), second.size());
    for (qsizetype i = 0; i < first.size(); ++i)
      QVERIFY2(readFile((folder.path() + "/" + first[i]).toStdString()) ==
                   readFile((folder.path() + "/" + second[i]).toStdString()),
               qPrintable(first[i]));
    ++compared_;
  }

  void featureTypes_data() {
    QTest::addColumn<QString>("type");
    for (const auto& type : theApp().registry->types())
      QTest::addRow("%s", type->id.c_str()) << QString::fromStdString(type->id);
  }

  void featureTypes() {
    QFETCH(QString, type);
    const auto declared = theApp().registry->at(type.toStdString());
    std::vector<std::string> all;
    for (int run = 0; run < 2; ++run) {
      const MovedHeap moved(run);
      setThreadLimit(run + 1);
      try {
        all.push_back(bytesOf(declared
                                  ->evaluate(completed(declared->parameters, Value::object()),
                                             arrangedInputs(*declared, plainInputs(*declared)), Progress::none())
                                  .shape));
      } catch (const Error& error) {
        all.push_back(error.message());  // wants something that has no default
      }
    }
    setThreadLimit(0);
    QVERIFY(all[0] == all[1]);
    ++types_;
  }

  void cleanupTestCase() {
    qInfo("figure samples %d", compared_);
    qInfo("figure types %d", types_);
  }

 private:
  int compared_ = 0, types_ = 0;
};

BLOSSOM_TEST(ReproducibleFilesTest)
#include "reproducible_files_test.moc"
