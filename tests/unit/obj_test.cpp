#include "support/exchange.h"

using namespace blossom;
using namespace blossom::test;

namespace {
const std::string squareObj = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";
Mesh meshOf(const std::string& text) { return *readText(text, "obj").shape.get<Mesh>(); }
}  // namespace

class ObjTest : public QObject {
  Q_OBJECT

 private slots:
  void readsEveryFormOfAFace() {
    for (const char* face : {"f 1 2 3 4", "f 1/1 2/1 3/1 4/1", "f 1/1/1 2/1/1 3/1/1 4/1/1", "f 1//1 2//1 3//1 4//1",
                             "f -4 -3 -2 -1", "f 1 2 \\\n3 4 # tail", "f +1 2 3 4"}) {
      const Mesh mesh = meshOf(squareObj + face + "\n");
      QCOMPARE(mesh.faceVertices, (std::vector<int>{0, 1, 2, 3}));
    }
  }

  void negativeIndicesCountFromWhereTheyStand() {
    const Mesh mesh = meshOf(squareObj + "f -4 -3 -2\nv 5 5 5\nf -1 -2 -3\n");
    QCOMPARE(mesh.faceVertices, (std::vector<int>{0, 1, 2, 4, 3, 2}));
  }

  void facesMayComeBeforeTheirVertices() { QCOMPARE(meshOf("f 1 2 3\n" + squareObj).faceCount(), std::size_t(1)); }

  void keepsTags() {
    const Mesh mesh = meshOf(
        squareObj + "o cage\nf 1 2 3 4\nt crease 2/1/0 1 2 4.7\nt corner 1/1/0 0 1.4\nt interpolateboundary 1/0/0 2\n");
    QCOMPARE(mesh.creases, (std::vector<Crease>{{1, 2, 4.7}}));
    QCOMPARE(mesh.corners, (std::vector<Corner>{{0, 1.4}}));
    QCOMPARE(mesh.otherTags, (std::vector<std::string>{"t interpolateboundary 1/0/0 2"}));
    QCOMPARE(mesh.name, std::string("cage"));
  }

  void countsWhatItLeavesOut() {
    const Imported imported = readText(squareObj + "vt 0 0\nvt 1 1\nvn 0 0 1\nusemtl red\nf 1 2 3 4\nl 1 2\n", "obj");
    QCOMPARE(imported.skipped, (Value{{"l", 1}, {"usemtl", 1}, {"vn", 1}, {"vt", 2}}));
    QCOMPARE(imported.entities, (Value{{"vertex", 4}, {"face", 1}}));
    QCOMPARE(imported.warnings.size(), std::size_t(1));
  }

  void refusesDamage_data() {
    QTest::addColumn<QString>("text");
    const QString four = QString::fromStdString(squareObj);
    QTest::newRow("no face") << four;
    QTest::newRow("index too large") << four + "f 1 2 5\n";
    QTest::newRow("index zero") << four + "f 0 1 2\n";
    QTest::newRow("too far back") << four + "f -5 1 2\n";
    QTest::newRow("huge index") << four + "f 1 2 99999999999999\n";
    QTest::newRow("two corners") << four + "f 1 2\n";
    QTest::newRow("not a number") << "v 0 0 nan\n" + four + "f 1 2 3\n";
    QTest::newRow("infinite") << "v 0 0 1e999\n" + four + "f 1 2 3\n";
    QTest::newRow("missing coordinate") << "v 0 0\n" + four + "f 1 2 3\n";
    QTest::newRow("word for a number") << "v 0 0 x\n" + four + "f 1 2 3\n";
    QTest::newRow("words in a face") << four + "f 1 2 3a\n";
    QTest::newRow("crease of nowhere") << four + "f 1 2 3\nt crease 2/1/0 1 9 2\n";
    QTest::newRow("crease without sharpness") << four + "f 1 2 3\nt crease 2/1/0 1 2\n";
    QTest::newRow("not a statement") << four + "f 1 2 3\n<html>\n";
  }
  void refusesDamage() {
    QFETCH(QString, text);
    VERIFY_ERROR(readText(text.toStdString(), "obj"), ErrorCode::FormatDamaged);
  }

  void errorsTellTheLine() {
    try {
      readText(squareObj + "f 1 2 7\n", "obj");
      QFAIL("did not throw");
    } catch (const Error& error) {
      QVERIFY2(error.message().find("Line 5") != std::string::npos, error.what());
      QVERIFY2(error.message().find("7") != std::string::npos, error.what());
    }
  }

  void roundTripIsExact() {
    std::mt19937_64 random = seededRandom();
    std::uniform_real_distribution<double> anywhere(-1e3, 1e3);
    for (int round = 0; round < 20; ++round) {
      Mesh mesh;
      mesh.name = "a name";
      for (int i = 0; i < 50; ++i) mesh.points.emplace_back(anywhere(random), anywhere(random) * 1e-9, 1 / anywhere(random));
      std::uniform_int_distribution<int> vertex(0, 49), size(3, 6);
      for (int f = 0; f < 40; ++f) {
        std::vector<int> face;
        for (int i = size(random); i > 0; --i) face.push_back(vertex(random));
        mesh.addFace(face);
      }
      mesh.creases = {{3, 4, std::abs(anywhere(random))}};
      mesh.corners = {{7, 1.0 / 3}};
      mesh.otherTags = {"t boundary 1/0/0 1"};
      QVERIFY(*roundTrip(mesh, "obj").shape.get<Mesh>() == mesh);
    }
  }
};

BLOSSOM_TEST(ObjTest)
#include "obj_test.moc"
