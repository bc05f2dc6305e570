#include "exchange/format/format.h"
#include "support/exchange.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

class XyzTest : public QObject {
  Q_OBJECT

 private slots:
  void pointsOfManyDialects() {
    const Mesh* mesh = nullptr;
    const Imported plain = readText("# x y z\n0 0 0 0 0 1\n10,0,0.5\n10;10;1\n\n-1e1\t2.5 +3\n", "xyz");
    mesh = plain.shape.get<Mesh>();
    QVERIFY(mesh && mesh->faceCount() == 0);
    QCOMPARE(mesh->points.size(), std::size_t(4));
    QVERIFY(mesh->points[3] == Vec3(-10, 2.5, 3));
    QCOMPARE(readText("2\n1 2 3\n4 5 6\n", "xyz").shape.get<Mesh>()->points.size(), std::size_t(2));
    QCOMPARE(readText("X,Y,Z\n1,2,3\n", "xyz").shape.get<Mesh>()->points.size(), std::size_t(1));
  }

  void rubbishIsRefused() {
    for (const char* text : {"# nothing\n", "1 2\n", "1 2 nan\n", "1 2 3\nfour 5 6\n", "1 2 1e999\n"})
      VERIFY_ERROR(readText(text, "xyz"), ErrorCode::FormatDamaged);
  }

  void everyDigitIsKept() {
    auto random = seededRandom();
    std::uniform_real_distribution<double> coordinate(-1e3, 1e3);
    Mesh mesh;
    for (int i = 0; i < 100; ++i) mesh.points.emplace_back(coordinate(random), coordinate(random), coordinate(random));
    QVERIFY(roundTrip(mesh, "xyz").shape.get<Mesh>()->points == mesh.points);
  }
};

BLOSSOM_TEST(XyzTest)
#include "xyz_test.moc"
