#include <Eigen/Geometry>
#include <QXmlStreamReader>

#include "core/zip_archive.h"
#include "geometry/measure/measure.h"
#include "geometry/mesh/mesh_topology.h"
#include "geometry/occt/occt.h"
#include "geometry/shape/brep.h"
#include "support/exchange.h"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr const char* relationsXml =
    "<Relationships xmlns='http://schemas.openxmlformats.org/package/2006/relationships'><Relationship "
    "Target='/3D/3dmodel.model' Id='r' Type='http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel'/>"
    "</Relationships>";

/// The unit cube from the origin, its corners by the bits of their number.
const std::string cubeMesh = [] {
  std::string text = "<mesh><vertices>";
  for (int i = 0; i < 8; ++i) text += fmt::format("<vertex x='{}' y='{}' z='{}'/>", i & 1, i >> 1 & 1, i >> 2);
  text += "</vertices><triangles>";
  for (const auto& [a, b, c, d] : std::initializer_list<std::array<int, 4>>{
           {0, 2, 3, 1}, {4, 5, 7, 6}, {0, 1, 5, 4}, {2, 6, 7, 3}, {0, 4, 6, 2}, {1, 3, 7, 5}}) {
    text += fmt::format("<triangle v1='{}' v2='{}' v3='{}'/>", a, b, c);
    text += fmt::format("<triangle v1='{}' v2='{}' v3='{}'/>", a, c, d);
  }
  return text + "</triangles></mesh>";
}();

std::string modelXml(const std::string& resources, const std::string& build, const std::string& attributes = "") {
  return fmt::format(
      "<?xml version='1.0'?><model xmlns='http://schemas.microsoft.com/3dmanufacturing/core/2015/02' {}><resources>{}"
      "</resources><build>{}</build></model>",
      attributes, resources, build);
}

std::string object(int id, const std::string& content, const std::string& attributes = "") {
  return fmt::format("<object id='{}' {}>{}</object>", id, attributes, content);
}

constexpr const char* contentTypes =
    "<Types xmlns='http://schemas.openxmlformats.org/package/2006/content-types'>"
    "<Default Extension='rels' ContentType='application/vnd.openxmlformats-package.relationships+xml'/>"
    "<Default Extension='model' ContentType='application/vnd.ms-package.3dmanufacturing-3dmodel+xml'/></Types>";

Imported readZipped(std::vector<ZipEntry> entries) {
  entries.push_back({"[Content_Types].xml", contentTypes});
  const TemporaryFolder folder;
  writeZip(folder.path() / "a.3mf", entries, Progress::none());
  return readShape(formats(), folder.path() / "a.3mf");
}

Imported readModel(const std::string& text) {
  return readZipped({{"_rels/.rels", relationsXml}, {"3D/3dmodel.model", text}});
}

const Mesh& meshIn(const Imported& imported) { return *imported.shape.get<Mesh>(); }

Vec3 highest(const Mesh& mesh) {
  Vec3 high = mesh.points.front();
  for (const Vec3& p : mesh.points) high = high.cwiseMax(p);
  return high;
}

}  // namespace

class ThreeMfTest : public QObject {
  Q_OBJECT

 private slots:
  void roundTripIsExact() {
    std::mt19937_64 random = seededRandom();
    std::normal_distribution<double> anywhere(0, 100);
    Mesh mesh;
    mesh.name = "A <name> & \"more\"";
    for (int i = 0; i < 300; ++i) mesh.points.emplace_back(anywhere(random), anywhere(random), anywhere(random));
    for (int i = 0; i + 2 < 300; ++i) mesh.addFace(std::array{i, i + 1, i + 2});
    QVERIFY(meshIn(roundTrip(mesh, "3mf")) == mesh);
  }

  void closedSolidsStayClosed() {
    const Brep solid(toShape(meshIn(readModel(modelXml(object(1, cubeMesh), "<item objectid='1'/>")))), "cube");
    const Mesh mesh = meshIn(roundTrip(solid, "3mf"));
    QVERIFY(meshTopology(mesh).closed());
    COMPARE_NEAR(signedVolume(mesh), 1, 1e-12);
  }

  /// Read by Qt's XML reader: the volume of what stands in the file, and the parts that a package needs.
  void othersReadWhatIsWritten() {
    Mesh prism;  // a pentagon pulled up: polygons become triangles
    for (int i = 0; i < 10; ++i)
      prism.points.emplace_back(std::cos(i % 5 * 0.4 * M_PI), std::sin(i % 5 * 0.4 * M_PI), i < 5 ? 0 : 2);
    prism.addFace(std::array{4, 3, 2, 1, 0});
    prism.addFace(std::array{5, 6, 7, 8, 9});
    for (int i = 0; i < 5; ++i) prism.addFace(std::array{i, (i + 1) % 5, (i + 1) % 5 + 5, i + 5});
    const TemporaryFolder folder;
    writeShape(formats(), prism, folder.path() / "a.3mf");
    const ZipContent zip = readZip(readFile(folder.path() / "a.3mf"), [](std::string_view) { return true; });
    QVERIFY(zip.entries.contains("[Content_Types].xml") && zip.entries.contains("_rels/.rels"));
    QXmlStreamReader xml(QByteArray::fromStdString(zip.entries.at("3D/3dmodel.model")));
    std::vector<Vec3> points;
    double volume = 0;
    QString type, unit;
    while (!xml.atEnd()) {
      if (xml.readNext() != QXmlStreamReader::StartElement) continue;
      const QXmlStreamAttributes all = xml.attributes();
      const auto number = [&](const char* name) { return all.value(QLatin1String(name)).toDouble(); };
      if (xml.name() == QLatin1String("model")) unit = all.value("unit").toString();
      if (xml.name() == QLatin1String("object")) type = all.value("type").toString();
      if (xml.name() == QLatin1String("vertex")) points.emplace_back(number("x"), number("y"), number("z"));
      if (xml.name() != QLatin1String("triangle")) continue;
      const auto corner = [&](const char* name) { return points.at(static_cast<std::size_t>(number(name))); };
      volume += corner("v1").dot(corner("v2").cross(corner("v3"))) / 6;
    }
    QVERIFY(!xml.hasError());
    QCOMPARE(unit, QString("millimeter"));
    QCOMPARE(type, QString("model"));
    QCOMPARE(points.size(), std::size_t{10});
    COMPARE_NEAR(volume, 5 * std::sin(0.4 * M_PI), 1e-12);  // area of the pentagon 2.5 sin 72, times 2
  }

  void openShapesAreSurfaces() {
    Mesh open;
    open.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    open.addFace(std::array{0, 1, 2});
    const TemporaryFolder folder;
    writeShape(formats(), open, folder.path() / "a.3mf");
    const ZipContent zip = readZip(readFile(folder.path() / "a.3mf"), [](std::string_view) { return true; });
    QVERIFY(zip.entries.at("3D/3dmodel.model").find("type=\"surface\"") != std::string::npos);
  }

  void unitsBecomeMillimetres() {
    for (const auto& [unit, size] : {std::pair{"micron", 1e-3},
                                     {"millimeter", 1.0},
                                     {"centimeter", 10.0},
                                     {"inch", 25.4},
                                     {"foot", 304.8},
                                     {"meter", 1000.0}}) {
      const Imported read = readModel(modelXml(
          object(1, cubeMesh), "<item objectid='1' transform='1 0 0 0 1 0 0 0 1 2 0 0'/>", fmt::format("unit='{}'", unit)));
      COMPARE_NEAR(signedVolume(meshIn(read)), size * size * size, 1e-12 * size * size * size);
      COMPARE_NEAR(highest(meshIn(read)).x(), 3 * size, 1e-12 * size);
    }
  }

  void everythingStandsInItsPlace() {
    // a pair of cubes, the second mirrored in x; the pair is turned by 90 degrees about z, and moved
    const std::string pair = object(1, cubeMesh) + object(2,
                                                          "<components><component objectid='1'/><component objectid='1' "
                                                          "transform='-1 0 0 0 1 0 0 0 1 -3 0 0'/></components>");
    const Imported read =
        readModel(modelXml(pair, "<item objectid='2' transform='0 1 0 -1 0 0 0 0 1 10 20 30'/><item objectid='1'/>"));
    const Mesh& mesh = meshIn(read);
    QVERIFY(meshTopology(mesh).closed());
    QCOMPARE(meshTopology(mesh).components.size(), std::size_t{3});
    COMPARE_NEAR(signedVolume(mesh), 3, 1e-12);
    QCOMPARE(read.entities["object"], Value(3));
    QVERIFY((highest(mesh) - Vec3(10, 21, 31)).norm() < 1e-12);
    Vec3 low = mesh.points.front();
    for (const Vec3& p : mesh.points) low = low.cwiseMin(p);
    QVERIFY((low - Vec3(0, 0, 0)).norm() < 1e-12);
    // row vectors: (-4, 0, 0), the mirrored cube's far corner, turns to (0, -4, 0) and moves to (10, 16, 30)
    QVERIFY(std::any_of(mesh.points.begin(), mesh.points.end(),
                        [](const Vec3& p) { return (p - Vec3(10, 16, 30)).norm() < 1e-12; }));
  }

  void objectsOfOtherPartsAreFound() {
    const std::string root =
        modelXml(object(1, "<components><component objectid='7' p:path='/3D/Objects/One.model'/></components>"),
                 "<item objectid='1'/>",
                 "requiredextensions='p' xmlns:p='http://schemas.microsoft.com/3dmanufacturing/production/2015/06'");
    const Imported read = readZipped({{"_rels/.rels", relationsXml},
                                      {"3D/3dmodel.model", root},
                                      {"3D/Objects/one.model", modelXml(object(7, cubeMesh), "")}});
    COMPARE_NEAR(signedVolume(meshIn(read)), 1, 1e-12);
    QVERIFY(read.warnings.empty());
  }

  void whatIsNoShapeIsCounted() {
    const Imported read =
        readModel(modelXml("<basematerials id='9'><base name='a' displaycolor='#FF0000'/></basematerials>" +
                               object(1, cubeMesh, "name='Part'") + object(2, cubeMesh, "type='support'"),
                           "<item objectid='1'/><item objectid='2'/>",
                           "requiredextensions='b' xmlns:b='http://schemas.microsoft.com/3dmanufacturing/"
                           "beamlattice/2017/02'"));
    QCOMPARE(meshIn(read).name, std::string("Part"));
    COMPARE_NEAR(signedVolume(meshIn(read)), 1, 1e-12);
    QCOMPARE(read.skipped, (Value{{"basematerials", 1}, {"support", 1}}));
    QCOMPARE(read.warnings.size(), std::size_t{1});
    QVERIFY(read.warnings.front().find("beamlattice") != std::string::npos);
  }

  void namespacesMayHavePrefixes() {
    std::string text = modelXml(object(1, cubeMesh), "<item objectid='1'/>");
    for (std::size_t at = 0; (at = text.find('<', at)) != std::string::npos; ++at)
      if (text[at + 1] != '?') text.insert(at + (text[at + 1] == '/' ? 2 : 1), "c:");
    COMPARE_NEAR(signedVolume(meshIn(readModel(text))), 1, 1e-12);
  }

  void aFileThatBuildsNothingGivesItsObjects() {
    const std::string whole = object(1, cubeMesh) + object(2, "<components><component objectid='1'/></components>");
    const Imported read = readModel(modelXml(whole, ""));
    COMPARE_NEAR(signedVolume(meshIn(read)), 1, 1e-12);
    QCOMPARE(read.warnings.size(), std::size_t{1});
  }

  void trianglesWithoutAreaAreLeftOut() {
    std::string mesh = cubeMesh;
    mesh.insert(mesh.find("</triangles>"), "<triangle v1='0' v2='1' v3='0'/>");
    const Imported read = readModel(modelXml(object(1, mesh), "<item objectid='1'/>"));
    QCOMPARE(meshIn(read).faceCount(), std::size_t{12});
    QCOMPARE(read.warnings.size(), std::size_t{1});
  }

  void refusesDamage_data() {
    QTest::addColumn<QString>("text");
    QTest::addColumn<QString>("said");
    const auto row = [](const char* name, const std::string& text, const char* said) {
      QTest::newRow(name) << QString::fromStdString(text) << said;
    };
    const std::string item = "<item objectid='1'/>";
    const auto broken = [&](const std::string& from, const std::string& to) {
      std::string mesh = cubeMesh;
      mesh.replace(mesh.find(from), from.size(), to);
      return modelXml(object(1, mesh), item);
    };
    row("no xml", "rubbish", "3d/3dmodel.model");
    row("cut off", modelXml(object(1, cubeMesh), item).substr(0, 300), "damaged");
    row("no model", "<html/>", "not a model");
    row("no unit", modelXml(object(1, cubeMesh), item, "unit='furlong'"), "furlong");
    row("no object", modelXml(object(2, cubeMesh), item), "object \"1\"");
    row("ids twice", modelXml(object(1, cubeMesh) + object(1, cubeMesh), item), "two objects");
    row("no number", broken("x='1'", "x='one'"), "x of vertex 1");
    row("not finite", broken("x='1'", "x='nan'"), "x of vertex 1");
    row("vertex beyond", broken("v2='2'", "v2='8'"), "triangle 0 uses vertex \"8\"; there are 8");
    row("negative vertex", broken("v2='2'", "v2='-2'"), "triangle 0");
    row("no triangles", modelXml(object(1, "<mesh/>"), item), "no face");
    row("short transform", modelXml(object(1, cubeMesh), "<item objectid='1' transform='1 2 3'/>"), "twelve");
    row("flat transform", modelXml(object(1, cubeMesh), "<item objectid='1' transform='1 0 0 0 1 0 0 0 0 0 0 0'/>"),
        "volume");
    row("part of itself", modelXml(object(1, "<components><component objectid='1'/></components>"), item), "itself");
    row("empty", modelXml("", ""), "no face");
  }
  void refusesDamage() {
    QFETCH(QString, text);
    QFETCH(QString, said);
    try {
      readModel(text.toStdString());
      QFAIL("did not throw");
    } catch (const Error& error) {
      QCOMPARE(error.code(), ErrorCode::FormatDamaged);
      QVERIFY2(QString::fromStdString(error.message()).contains(said), error.what());
    }
  }

  void otherZipsAreRefused() {
    VERIFY_ERROR(readZipped({{"readme", "no model"}}), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readZipped({{"_rels/.rels", relationsXml}}), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readText("PK\3\4 and nothing more", "3mf"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readText("solid a\nendsolid a\n", "3mf"), ErrorCode::FormatDamaged);
  }

  /// Components that double thirty times over.
  void smallFilesDoNotFillTheMemory() {
    std::string objects = object(1, cubeMesh);
    for (int i = 2; i < 32; ++i)
      objects +=
          object(i, fmt::format("<components><component objectid='{0}'/><component objectid='{0}'/></components>", i - 1));
    VERIFY_ERROR(readModel(modelXml(objects, "<item objectid='31'/>")), ErrorCode::LimitExceeded);
  }
};

BLOSSOM_TEST(ThreeMfTest)
#include "three_mf_test.moc"
