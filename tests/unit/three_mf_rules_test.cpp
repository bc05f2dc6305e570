// What the 3MF Core Specification and its Materials Extension forbid is told or refused; what they allow is read in silence.
// The cases are those of the consortium's own suites, written anew.
#include <Eigen/Geometry>

#include "core/zip_archive.h"
#include "geometry/measure/measure.h"
#include "support/exchange.h"

using namespace blossom;
using namespace blossom::test;

namespace {

const std::string types =
    R"(<?xml version="1.0" encoding="UTF-8"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types">
<Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/>
<Default Extension="png" ContentType="image/png"/>
<Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)";

const std::string packageRelations =
    R"(<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/3D/3dmodel.model" Id="r1" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/>
<Relationship Target="/Metadata/picture.png" Id="r2" Type="http://schemas.openxmlformats.org/package/2006/relationships/metadata/thumbnail"/>
</Relationships>)";

const std::string modelRelations =
    R"(<?xml version="1.0" encoding="UTF-8"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships">
<Relationship Target="/Metadata/ticket.xml" Id="t1" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/printticket"/>
</Relationships>)";

const std::string model = R"(<?xml version="1.0" encoding="UTF-8"?>
<model unit="millimeter" xml:lang="en-US" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02" xmlns:m="http://schemas.microsoft.com/3dmanufacturing/material/2015/02" xmlns:v="http://example.com/vendor">
 <metadata name="Title">Tetrahedra</metadata>
 <metadata name="v:Shelf">7</metadata>
 <resources>
  <basematerials id="1"><base name="Wood" displaycolor="#804000"/><base name="Tin" displaycolor="#C0C0C0FF"/></basematerials>
  <m:colorgroup id="2"><m:color color="#FF0000"/><m:color color="#00FF00"/></m:colorgroup>
  <m:texture2d id="3" path="/3D/Textures/picture.png" contenttype="image/png"/>
  <m:texture2dgroup id="4" texid="3"><m:tex2coord u="0" v="0"/><m:tex2coord u="1" v="0"/></m:texture2dgroup>
  <m:compositematerials id="5" matid="1" matindices="0 1"><m:composite values="0.5 0.5"/></m:compositematerials>
  <m:multiproperties id="6" pids="5 2"><m:multi pindices="0 0"/></m:multiproperties>
  <object id="7" type="model" pid="1" pindex="0"><mesh>
   <vertices><vertex x="0" y="0" z="0"/><vertex x="1" y="0" z="0"/><vertex x="0" y="1" z="0"/><vertex x="0" y="0" z="1"/></vertices>
   <triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3" pid="2" p1="0" p2="1" p3="0"/>
    <triangle v1="1" v2="2" v3="3" p1="1"/><triangle v1="2" v2="0" v3="3" pid="6" p1="0"/></triangles>
  </mesh></object>
  <object id="8" type="model"><components><component objectid="7" transform="1 0 0 0 1 0 0 0 1 5 0 0"/></components></object>
  <object id="9" type="other"><components><component objectid="7"/></components></object>
 </resources>
 <build><item objectid="7"/><item objectid="8"/></build>
</model>)";

/// A package in which one piece of text is another.
struct Case {
  const char* name;
  const char* from;
  const char* to;
};

constexpr Case cases[] = {
    {"a relationship to a model that is missing", "Target=\"/3D/3dmodel.model\" Id=\"r1\"",
     "Target=\"/3D/3dmodel.model\" Id=\"r1\" "
     "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel\"/><Relationship Target=\"/3D/no.model\" "
     "Id=\"r9\""},
    {"the model is missing", "Target=\"/3D/3dmodel.model\"", "Target=\"/3D/other.model\""},
    {"the model lies outside", "Id=\"r1\"", "Id=\"r1\" TargetMode=\"External\""},
    {"the thumbnail is missing", "Target=\"/Metadata/picture.png\"", "Target=\"/Metadata/lost.png\""},
    {"two print tickets", "Id=\"t1\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/printticket\"/>",
     "Id=\"t1\" Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/printticket\"/><Relationship "
     "Target=\"/Metadata/ticket.xml\" Id=\"t2\" "
     "Type=\"http://schemas.microsoft.com/3dmanufacturing/2013/01/printticket\"/>"},
    {"relationships of one id", "Id=\"r2\"", "Id=\"r1\""},
    {"no content type of the model", "Extension=\"model\"", "Extension=\"modell\""},
    {"a wrong content type", "3dmanufacturing-3dmodel+xml", "3dmanufacturing-something+xml"},
    {"another encoding", "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<model",
     "<?xml version=\"1.0\" encoding=\"ISO-8859-1\"?>\n<model"},
    {"a document type", "?>\n<model", "?>\n<!DOCTYPE model [<!ENTITY a \"b\">]>\n<model"},
    {"an undefined prefix", "<resources>", "<resources><w:thing/>"},
    {"an undefined prefix of an attribute", "<object id=\"7\"", "<object w:thing=\"1\" id=\"7\""},
    {"an element that 3MF has not", "<resources>", "<resources><things/>"},
    {"an attribute that 3MF has not", "<object id=\"7\"", "<object colour=\"red\" id=\"7\""},
    {"an attribute of XML Schema", "xmlns:v=\"http://example.com/vendor\"",
     "xmlns:v=\"http://example.com/vendor\" xmlns:xsi=\"http://www.w3.org/2001/XMLSchema-instance\" xsi:schemaLocation=\"a "
     "b\""},
    {"white space kept", "<metadata name=\"Title\"", "<metadata xml:space=\"preserve\" name=\"Title\""},
    {"metadata without a name", "<metadata name=\"Title\"", "<metadata"},
    {"metadata of no namespace", "name=\"Title\"", "name=\"Undefined\""},
    {"metadata of an undefined prefix", "name=\"v:Shelf\"", "name=\"w:Shelf\""},
    {"metadata twice", "name=\"v:Shelf\"", "name=\"Title\""},
    {"two models", "</model>", "</model><model/>"},
    {"another unit", "unit=\"millimeter\"", "unit=\"furlong\""},
    {"another namespace", "xmlns=\"http://schemas.microsoft.com/3dmanufacturing/core/2015/02\"",
     "xmlns=\"http://example.com/core\""},
    {"an unknown extension that is required", "unit=\"millimeter\"", "unit=\"millimeter\" requiredextensions=\"v\""},
    {"no build", "<build><item objectid=\"7\"/><item objectid=\"8\"/></build>", ""},
    {"two builds", "</build>", "</build><build/>"},
    {"no resources", "resources>", "m:resources>"},
    {"an item that is missing", "<item objectid=\"8\"/>", "<item objectid=\"80\"/>"},
    {"an item of the type other", "<item objectid=\"8\"/>", "<item objectid=\"9\"/>"},
    {"an unknown type of object", "id=\"7\" type=\"model\"", "id=\"7\" type=\"thing\""},
    {"an object without an id", "<object id=\"9\"", "<object"},
    {"an id that is no number", "<object id=\"9\"", "<object id=\"nine\""},
    {"an id of 0", "<object id=\"9\"", "<object id=\"0\""},
    {"objects of one id", "<object id=\"9\"", "<object id=\"8\""},
    {"resources of one id", "<m:colorgroup id=\"2\"", "<m:colorgroup id=\"1\""},
    {"groups of textures of one id", "<m:texture2dgroup id=\"4\"", "<m:texture2dgroup id=\"3\""},
    {"base materials of one id", "<resources>",
     "<resources><basematerials id=\"1\"><base name=\"Wood\" displaycolor=\"#804000\"/></basematerials>"},
    {"a colour that is missing", "<m:color color=\"#FF0000\"/>", "<m:color/>"},
    {"a colour that is none", "<m:color color=\"#FF0000\"/>", "<m:color color=\"red\"/>"},
    {"a base material without a colour", " displaycolor=\"#804000\"", ""},
    {"a texture without a path", "path=\"/3D/Textures/picture.png\"", ""},
    {"a texture that is missing", "path=\"/3D/Textures/picture.png\"", "path=\"/3D/Textures/no.png\""},
    {"a texture of another content type", "contenttype=\"image/png\"", "contenttype=\"image/bmp\""},
    {"a group of no texture", " texid=\"3\"", ""},
    {"a mixture of no materials", " matid=\"1\" matindices=\"0 1\"", ""},
    {"a mixture of colours", "matid=\"1\"", "matid=\"2\""},
    {"a mixture without indices", " matindices=\"0 1\"", ""},
    {"a mixture beyond its materials", "matindices=\"0 1\"", "matindices=\"0 2\""},
    {"layers that are missing", " pids=\"5 2\"", ""},
    {"two layers of materials", "pids=\"5 2\"", "pids=\"5 1\""},
    {"two layers of colours", "pids=\"5 2\"", "pids=\"2 2\""},
    {"a layer of layers", "pids=\"5 2\"", "pids=\"6 2\""},
    {"properties that are missing", "pid=\"1\" pindex=\"0\"", "pid=\"11\" pindex=\"0\""},
    {"a property beyond its group", "pid=\"1\" pindex=\"0\"", "pid=\"1\" pindex=\"2\""},
    {"a property of no group", "pid=\"1\" pindex=\"0\"", "pindex=\"0\""},
    {"a group without a property", "pid=\"1\" pindex=\"0\"", "pid=\"1\""},
    {"a triangle with properties of no group", "type=\"model\" pid=\"1\" pindex=\"0\"", "type=\"model\""},
    {"a triangle beyond its group", "p1=\"0\" p2=\"1\" p3=\"0\"", "p1=\"0\" p2=\"2\" p3=\"0\""},
    {"a triangle with some properties", "p1=\"0\" p2=\"1\" p3=\"0\"", "p2=\"1\" p3=\"0\""},
    {"equal corners", "v1=\"0\" v2=\"2\" v3=\"1\"", "v1=\"0\" v2=\"2\" v3=\"2\""},
    {"a corner beyond the vertices", "v1=\"0\" v2=\"2\" v3=\"1\"", "v1=\"0\" v2=\"2\" v3=\"4\""},
    {"a coordinate that is none", "x=\"1\" y=\"0\" z=\"0\"", "x=\"nan\" y=\"0\" z=\"0\""},
    {"a coordinate that is missing", "x=\"1\" y=\"0\" z=\"0\"", "x=\"1\" y=\"0\""},
    {"an object made of a later one", "<component objectid=\"7\" transform", "<component objectid=\"9\" transform"},
    {"a transform that mirrors", "transform=\"1 0 0", "transform=\"-1 0 0"},
    {"a transform without volume", "transform=\"1 0 0", "transform=\"0 0 0"},
    {"a transform that is not finite", "transform=\"1 0 0", "transform=\"inf 0 0"},
    {"a transform that is too short", "transform=\"1 0 0 0", "transform=\"1 0 0"},
};

Imported readPackage(const Case* changed, const std::string& modelText = model) {
  const auto apply = [&](std::string text) {
    if (!changed) return text;
    const std::string from = changed->from;
    for (std::size_t at = text.find(from); at != std::string::npos;
         at = text.find(from, at + std::string(changed->to).size()))
      text.replace(at, from.size(), changed->to);
    return text;
  };
  const std::string t = apply(types), r = apply(packageRelations), m = apply(modelText), mr = apply(modelRelations);
  if (changed && t + r + m + mr == types + packageRelations + modelText + modelRelations)
    qFatal("nothing changed: %s", changed->name);
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "part.3mf";
  writeZip(file,
           {{"[Content_Types].xml", t},
            {"_rels/.rels", r},
            {"3D/3dmodel.model", m},
            {"3D/_rels/3dmodel.model.rels", mr},
            {"3D/Textures/picture.png", "png"},
            {"Metadata/picture.png", "png"},
            {"Metadata/ticket.xml", "<ticket/>"}},
           Progress::none());
  return readShape(formats(), file);
}

}  // namespace

class ThreeMfRulesTest : public QObject {
  Q_OBJECT

  int refused_ = 0, told_ = 0;

 private slots:
  void whatIsAllowedIsReadInSilence() {
    const Imported imported = readPackage(nullptr);
    QVERIFY2(imported.warnings.empty(), imported.warnings.empty() ? "" : imported.warnings.front().c_str());
    QCOMPARE(imported.shape.get<Mesh>()->faceCount(), std::size_t(8));
  }

  void whatBlossomWritesIsAllowed() {
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
    for (const auto& face : {std::array{0, 2, 1}, std::array{0, 1, 3}, std::array{1, 2, 3}, std::array{2, 0, 3}})
      mesh.addFace(face);
    QVERIFY(roundTrip(mesh, "3mf").warnings.empty());
  }

  void whatIsForbiddenIsToldOrRefused_data() {
    QTest::addColumn<int>("number");
    for (int i = 0; i < static_cast<int>(std::size(cases)); ++i) QTest::addRow("%s", cases[i].name) << i;
  }
  void whatIsForbiddenIsToldOrRefused() {
    QFETCH(int, number);
    try {
      QVERIFY(!readPackage(&cases[number]).warnings.empty());
      ++told_;
    } catch (const Error& error) {
      QVERIFY(error.code() == ErrorCode::FormatDamaged);
      ++refused_;
    }
  }

  void aThousandFaultsAreFewSentences() {
    std::string many = model;
    std::string metadata;
    for (int i = 0; i < 1000; ++i) metadata += fmt::format("<metadata name=\"Thing{}\"/>", i);
    many.insert(many.find("<resources>"), metadata);
    const Imported imported = readPackage(nullptr, many);
    QVERIFY(!imported.warnings.empty() && imported.warnings.size() < 12);
  }

  void elementsWithoutEndInOneAnother() {
    std::string deep, closing;
    for (int i = 0; i < 100'000; ++i) {
      deep += "<v:a>";
      closing += "</v:a>";
    }
    std::string nested = model;
    nested.insert(nested.find("<resources>") + 11, deep + closing);
    QVERIFY(!readPackage(nullptr, nested).warnings.empty());
  }

  void latticesAreNamed() {
    std::string lattice = model;
    const std::size_t from = lattice.find("<triangles>"), to = lattice.find("</triangles>");
    lattice.replace(from, to + 12 - from, "<v:beamlattice/>");
    try {
      readPackage(nullptr, lattice);
      QFAIL("it was read");
    } catch (const Error& error) {
      QVERIFY2(error.message().find("lattices") != std::string::npos, error.message().c_str());
    }
  }

  void triangleStripsOfPly() {
    const auto strips = [](const char* lists) {
      return readText(
          std::string("ply\nformat ascii 1.0\nelement vertex 6\nproperty float x\nproperty float y\nproperty float z\n"
                      "element tristrips 1\nproperty list int int vertex_indices\nend_header\n"
                      "0 0 0\n0 1 0\n1 0 0\n1 1 0\n2 0 0\n2 1 0\n") +
              lists,
          "ply");
    };
    // A strip of four triangles, two of two, and two joined by corners named twice.
    for (const auto& [lists, faces] :
         {std::pair("6 0 2 1 4 3 5\n", 4), std::pair("7 0 2 1 -1 2 4 3\n", 2), std::pair("9 0 2 1 1 2 2 2 4 3\n", 2)}) {
      const Mesh mesh = *strips(lists).shape.get<Mesh>();
      QCOMPARE(int(mesh.faceCount()), faces);
      for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
        const auto at = [&](std::size_t k) { return mesh.points[static_cast<std::size_t>(mesh.face(f)[k])]; };
        QVERIFY((at(1) - at(0)).cross(at(2) - at(0)).z() > 0);  // all look the same way
      }
    }
    VERIFY_ERROR(strips("3 0 1 9\n"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(strips("3 0 1 -2\n"), ErrorCode::FormatDamaged);
  }

  void cleanupTestCase() {
    qInfo("figure told %d", told_);
    qInfo("figure refused %d", refused_);
  }
};

BLOSSOM_TEST(ThreeMfRulesTest)
#include "three_mf_rules_test.moc"
