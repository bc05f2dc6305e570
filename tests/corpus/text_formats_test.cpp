// Every file of the shared data in a text format opens, and holds as many entities as a count that knows nothing of the
// readers.
#include <map>
#include <sstream>

#include "support/exchange.h"

using namespace blossom;
using namespace blossom::test;

namespace {

std::vector<fs::path> filesIn(const fs::path& folder, const std::string& extension) {
  std::vector<fs::path> files;
  if (fs::exists(folder))
    for (const auto& entry : fs::recursive_directory_iterator(folder))
      if (entry.path().extension() == extension) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  return files;
}

std::string stripped(std::string line) {
  line.erase(0, line.find_first_not_of(" \t"));
  line.erase(line.find_last_not_of(" \t\r") + 1);
  return line;
}

/// 0-groups between ENTITIES and ENDSEC by type, without the parts of other entities.
std::map<std::string, int> countDxf(const fs::path& path) {
  std::istringstream stream(readFile(path));
  std::map<std::string, int> counts;
  bool inside = false;
  std::string code, value, last;
  while (std::getline(stream, code) && std::getline(stream, value)) {
    code = stripped(code);
    value = stripped(value);
    if (code == "2" && last == "SECTION") inside = value == "ENTITIES";
    if (code == "0" && value == "ENDSEC") inside = false;
    if (code == "0" && inside && value != "VERTEX" && value != "SEQEND" && value != "ATTRIB") ++counts[value];
    last = code == "0" ? value : "";
  }
  return counts;
}

int countOf(const std::string& text, const std::string& word) {
  int count = 0;
  for (std::size_t at = text.find(word); at != std::string::npos; at = text.find(word, at + word.size())) ++count;
  return count;
}

/// Subpaths of path data: each M or m, and each command that follows a z directly.
int countSubpaths(const std::string& svg) {
  int count = 0;
  for (std::size_t at = svg.find(" d=\""); at != std::string::npos; at = svg.find(" d=\"", at + 4)) {
    bool afterClose = false;
    for (std::size_t i = at + 4; svg[i] != '"'; ++i) {
      const char c = svg[i];
      if (!std::isalpha(static_cast<unsigned char>(c)) || c == 'e' || c == 'E') continue;
      if (c == 'M' || c == 'm' || (afterClose && c != 'z' && c != 'Z')) ++count;
      afterClose = c == 'z' || c == 'Z';
    }
  }
  return count;
}

int linesStarting(const std::string& text, const std::string& start) {
  std::istringstream stream(text);
  std::string line;
  int count = 0;
  while (std::getline(stream, line)) count += line.compare(0, start.size(), start) == 0;
  return count;
}

}  // namespace

class TextFormatsTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    if (!fs::exists(sharedData())) QSKIP("the shared data is not there");
  }

  void dxfEntities_data() { rows("dxf", ".dxf"); }
  void dxfEntities() {
    QFETCH(QString, file);
    const fs::path path = file.toStdString();
    const Imported imported = readShape(formats(), path);
    const auto count = [](const Value& counts, const std::string& type) { return counts.value(type, 0); };
    int total = 0;
    for (const auto& [type, expected] : countDxf(path)) {
      QVERIFY2(count(imported.entities, type) + count(imported.skipped, type) == expected,
               qPrintable(QString::fromStdString(type)));
      total += expected;
    }
    int found = 0;
    for (const Value* counts : {&imported.entities, &imported.skipped})
      for (const auto& [type, n] : counts->items()) found += n.get<int>();
    QCOMPARE(found, total);
    const Curves* curves = imported.shape.get<Curves>();
    QVERIFY(curves);
    QVERIFY(!curves->paths.empty());
  }

  void svgShapes_data() { rows("svg", ".svg"); }
  void svgShapes() {
    QFETCH(QString, file);
    const fs::path path = file.toStdString();
    const std::string text = readFile(path);
    const Imported imported = readShape(formats(), path);
    QCOMPARE(imported.entities.value("path", 0), countOf(text, "<path"));
    const Curves* curves = imported.shape.get<Curves>();
    QVERIFY(curves);
    QCOMPARE(static_cast<int>(curves->paths.size()), countSubpaths(text));
    for (const Path& p : curves->paths) QVERIFY(p.closed);
  }

  void objStatements_data() { rows("subdivision", ".obj"); }
  void objStatements() {
    QFETCH(QString, file);
    const fs::path path = file.toStdString();
    const std::string text = readFile(path);
    const Imported imported = readShape(formats(), path);
    const Mesh* mesh = imported.shape.get<Mesh>();
    QVERIFY(mesh);
    QCOMPARE(static_cast<int>(mesh->points.size()), linesStarting(text, "v "));
    QCOMPARE(static_cast<int>(mesh->faceCount()), linesStarting(text, "f "));
    QCOMPARE(imported.entities.value("face", 0), linesStarting(text, "f "));
    QCOMPARE(static_cast<int>(mesh->creases.size()), linesStarting(text, "t crease"));
    QCOMPARE(static_cast<int>(mesh->corners.size()), linesStarting(text, "t corner"));
    QCOMPARE(static_cast<int>(mesh->otherTags.size()),
             linesStarting(text, "t ") - linesStarting(text, "t crease") - linesStarting(text, "t corner"));
  }

  void offCounts_data() { rows("meshes", ".off"); }
  void offCounts() {
    QFETCH(QString, file);
    const fs::path path = file.toStdString();
    std::istringstream stream(readFile(path));
    std::string word;
    int vertices = 0, faces = 0;
    stream >> word >> vertices >> faces;
    const Imported imported = readShape(formats(), path);
    QCOMPARE(imported.entities.value("vertex", 0), vertices);
    QCOMPARE(imported.entities.value("face", 0), faces);
    QCOMPARE(static_cast<int>(imported.shape.get<Mesh>()->faceCount()), faces);
  }

  void stlFacets_data() { rows("step", ".stl"); }
  void stlFacets() {
    QFETCH(QString, file);
    const fs::path path = file.toStdString();
    const std::string text = readFile(path);
    const bool isText = text.compare(0, 5, "solid") == 0;
    const int facets = isText ? countOf(text, "facet normal") : static_cast<int>((text.size() - 84) / 50);
    const Imported imported = readShape(formats(), path);
    QCOMPARE(imported.entities.value("facet", 0), facets);
    QCOMPARE(static_cast<int>(imported.shape.get<Mesh>()->faceCount()), facets);
  }

 private:
  void rows(const std::string& folder, const std::string& extension) {
    QTest::addColumn<QString>("file");
    const auto files = filesIn(sharedData() / folder, extension);
    QVERIFY(!files.empty());
    for (const fs::path& path : files) QTest::newRow(path.filename().c_str()) << QString::fromStdString(path.string());
  }
};

BLOSSOM_TEST(TextFormatsTest)
#include "text_formats_test.moc"
