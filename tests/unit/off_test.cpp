#include "support/exchange.h"

using namespace blossom;
using namespace blossom::test;

class OffTest : public QObject {
  Q_OBJECT

 private slots:
  void readsCommentsColoursAndCountsOnOneLine() {
    const Imported imported = readText(
        "# a comment\nCOFF 4 1 0\n\n0 0 0 255 0 0 255 # red\n1 0 0 0 0 0 0\n1 1 0 0 0 0 0\n0 1 0 0 0 0 0\n4 0 1 2 3 0.5 0.5 "
        "0.5\n",
        "off");
    const Mesh& mesh = *imported.shape.get<Mesh>();
    QCOMPARE(mesh.points.size(), std::size_t(4));
    QCOMPARE(mesh.faceVertices, (std::vector<int>{0, 1, 2, 3}));
    QCOMPARE(imported.entities, (Value{{"vertex", 4}, {"face", 1}}));
  }

  void refusesDamage_data() {
    QTest::addColumn<QString>("text");
    QTest::newRow("no counts") << "OFF\n";
    QTest::newRow("huge counts") << "OFF\n2000000000 2000000000 0\n0 0 0\n";
    QTest::newRow("negative count") << "OFF\n-1 1 0\n";
    QTest::newRow("ends in vertices") << "OFF\n3 1 0\n0 0 0\n1 0 0\n";
    QTest::newRow("ends in faces") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n";
    QTest::newRow("index out of range") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 3\n";
    QTest::newRow("negative index") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1 -1\n";
    QTest::newRow("short face") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n3 0 1\n";
    QTest::newRow("huge face") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2000000000 0 1 2\n";
    QTest::newRow("two corners") << "OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 0\n2 0 1\n";
    QTest::newRow("nan") << "OFF\n3 1 0\nnan 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    QTest::newRow("four dimensions") << "4OFF\n3 1 0\n0 0 0 0\n";
    QTest::newRow("binary") << "OFF BINARY\n";
  }
  void refusesDamage() {
    QFETCH(QString, text);
    VERIFY_ERROR(readText(text.toStdString(), "off"), ErrorCode::FormatDamaged);
  }

  void roundTripIsExact() {
    std::mt19937_64 random = seededRandom();
    std::normal_distribution<double> anywhere(0, 100);
    Mesh mesh;
    for (int i = 0; i < 30; ++i) mesh.points.emplace_back(anywhere(random), anywhere(random), anywhere(random));
    for (int i = 0; i + 4 < 30; ++i) mesh.addFace(std::array{i, i + 1, i + 2, i + 4});
    QVERIFY(*roundTrip(mesh, "off").shape.get<Mesh>() == mesh);
  }
};

BLOSSOM_TEST(OffTest)
#include "off_test.moc"
