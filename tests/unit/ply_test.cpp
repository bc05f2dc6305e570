#include <cstring>

#include "support/exchange.h"

using namespace blossom;
using namespace blossom::test;

namespace {

const std::string header =
    "element vertex 3\nproperty float x\nproperty float y\nproperty float z\nproperty uchar red\nelement edge 1\nproperty "
    "int vertex1\nproperty int vertex2\n"
    "element face 1\nproperty uchar flags\nproperty list uchar int vertex_indices\nend_header\n";

template <class T>
void appendNumber(std::string& out, T value, bool big) {
  char raw[sizeof(T)];
  std::memcpy(raw, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i) out += raw[big ? sizeof(T) - 1 - i : i];
}

std::string binary(bool big) {
  std::string out = std::string("ply\nformat binary_") + (big ? "big" : "little") + "_endian 1.0\n" + header;
  for (const float x : {0.F, 0.F, 0.F, 1.5F, 0.F, 0.F, 0.F, 2.5F, 0.F}) {
    appendNumber(out, x, big);
    static int n = 0;
    if (++n % 3 == 0) out += '\x80';
  }
  appendNumber(out, std::int32_t(0), big);
  appendNumber(out, std::int32_t(1), big);
  out += std::string("\x07\x03", 2);
  for (const std::int32_t v : {0, 1, 2}) appendNumber(out, v, big);
  return out;
}

}  // namespace

class PlyTest : public QObject {
  Q_OBJECT

 private slots:
  void allThreeEncodingsGiveTheSame() {
    const std::string text =
        "ply\nformat ascii 1.0\ncomment by hand\n" + header + "0 0 0 128\n1.5 0 0 128\n0 2.5 0 128\n0 1\n7 3 0 1 2\n";
    const Imported ascii = readText(text, "ply");
    const Mesh& mesh = *ascii.shape.get<Mesh>();
    QCOMPARE(mesh.points, (std::vector<Vec3>{{0, 0, 0}, {1.5, 0, 0}, {0, 2.5, 0}}));
    QCOMPARE(mesh.faceVertices, (std::vector<int>{0, 1, 2}));
    QCOMPARE(ascii.skipped, (Value{{"edge", 1}}));
    QVERIFY(*readText(binary(false), "ply").shape.get<Mesh>() == mesh);
    QVERIFY(*readText(binary(true), "ply").shape.get<Mesh>() == mesh);
  }

  void everyTruncationIsDamaged() {
    const std::string whole = binary(false);
    for (std::size_t size = 1; size < whole.size(); ++size)
      VERIFY_ERROR(readText(whole.substr(0, size), "ply"), ErrorCode::FormatDamaged);
  }

  void refusesDamage_data() {
    QTest::addColumn<QString>("text");
    const QString vertices = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const QString faces = "element face 1\nproperty list uchar int vertex_indices\nend_header\n",
                  data = "0 0 0 1 0 0 0 1 0 ";
    QTest::newRow("no format") << "ply\n" + vertices + faces + data + "3 0 1 2\n";
    QTest::newRow("unknown format") << "ply\nformat ebcdic 1.0\n" + vertices + faces + data + "3 0 1 2\n";
    QTest::newRow("unknown type") << "ply\nformat ascii 1.0\nelement vertex 1\nproperty quad x\nend_header\n0\n";
    QTest::newRow("no z") << "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\n" + faces +
                                 "0 0 3 0 0 0\n";
    QTest::newRow("huge count")
        << "ply\nformat ascii 1.0\nelement vertex 2000000000\nproperty float x\nproperty float y\nproperty float z\n" +
               faces + data;
    QTest::newRow("huge list") << "ply\nformat ascii 1.0\n" + vertices +
                                      "element face 1\nproperty list int int vertex_indices\nend_header\n" + data +
                                      "2000000000 0 1 2\n";
    QTest::newRow("negative list") << "ply\nformat ascii 1.0\n" + vertices + faces + data + "-3 0 1 2\n";
    QTest::newRow("index out of range") << "ply\nformat ascii 1.0\n" + vertices + faces + data + "3 0 1 3\n";
    QTest::newRow("negative index") << "ply\nformat ascii 1.0\n" + vertices + faces + data + "3 0 1 -1\n";
    QTest::newRow("nan") << "ply\nformat ascii 1.0\n" + vertices + faces + "0 0 nan 1 0 0 0 1 0 3 0 1 2\n";
    QTest::newRow("no faces") << "ply\nformat ascii 1.0\n" + vertices + "end_header\n" + data;
    QTest::newRow("no end") << "ply\nformat ascii 1.0\n" + vertices;
    QTest::newRow("property first") << "ply\nformat ascii 1.0\nproperty float x\nend_header\n";
  }
  void refusesDamage() {
    QFETCH(QString, text);
    VERIFY_ERROR(readText(text.toStdString(), "ply"), ErrorCode::FormatDamaged);
  }

  void roundTripIsExact() {
    std::mt19937_64 random = seededRandom();
    std::normal_distribution<double> anywhere(0, 100);
    Mesh mesh;
    for (int i = 0; i < 300; ++i) mesh.points.emplace_back(anywhere(random), anywhere(random), anywhere(random));
    for (int i = 0; i + 4 < 300; ++i) mesh.addFace(std::array{i, i + 1, i + 2, i + 4});
    for (const bool ascii : {false, true}) QVERIFY(*roundTrip(mesh, "ply", {{"ascii", ascii}}).shape.get<Mesh>() == mesh);
  }
};

BLOSSOM_TEST(PlyTest)
#include "ply_test.moc"
