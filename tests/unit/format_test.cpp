#include "support/exchange.h"

using namespace blossom;
using namespace blossom::test;

class FormatTest : public QObject {
  Q_OBJECT

 private slots:
  void findsByExtensionAndId() {
    QVERIFY(formats().find("dxf"));
    QCOMPARE(formats().find(".DXF"), formats().find("dxf"));
    QCOMPARE(formats().find("stp"), formats().find("step"));
    QVERIFY(!formats().find("unknown"));
    QVERIFY(!formats().find(""));
  }

  void everyFormatIsComplete() {
    for (const Format& f : formats().formats()) {
      QVERIFY2(!f.id.empty() && !f.title.empty() && !f.extensions.empty(), f.id.c_str());
      QVERIFY2(f.read || f.write, f.id.c_str());
      QVERIFY2(f.writes.empty() == !f.write, f.id.c_str());
      for (const auto* options : {&f.readOptions, &f.writeOptions})
        for (const ParameterSpec& spec : *options) QVERIFY2(!spec.name.empty() && !spec.help.empty(), f.id.c_str());
    }
  }

  /// The user has enough of it while the points or faces are being written: in any format, as text too.
  void writingAMeshCanBeCancelledOnItsWay() {
    constexpr int side = 60;
    Mesh sheet;
    for (int i = 0; i < side * side; ++i) sheet.points.emplace_back(i % side, i / side, 0.25 * (i % 7));
    for (int i = 0; i + side + 1 < side * side; ++i)
      if (i % side != side - 1) sheet.addFace(std::array<int, 4>{i, i + 1, i + side + 1, i + side});
    for (const char* extension : {"3mf", "obj", "off", "ply", "stl"})
      for (const bool ascii : {false, true}) {
        const bool choice = std::string_view(extension) == "ply" || std::string_view(extension) == "stl";
        if (ascii && !choice) continue;
        const TemporaryFolder folder;
        const fs::path file = folder.path() / (std::string("sheet.") + extension);
        const CancelToken token;
        double told = 0;
        const Progress progress(token, [&](double fraction, const std::string&) {
          QVERIFY(fraction >= told);
          told = fraction;
          if (fraction >= 0.6) token.cancel();
        });
        VERIFY_ERROR(writeShape(formats(), Shape(sheet), file, choice ? Value{{"ascii", ascii}} : Value::object(), progress),
                     ErrorCode::Cancelled);
        QVERIFY2(told < 0.65, extension);
        QVERIFY2(!fs::exists(file), extension);
      }
  }

  void refusesWhatIsNotThere() {
    const TemporaryFolder folder;
    VERIFY_ERROR(readShape(formats(), folder.path() / "none.obj"), ErrorCode::FileNotFound);
    VERIFY_ERROR(readShape(formats(), folder.path()), ErrorCode::FileUnreadable);
    writeText(folder.path() / "a.unknown", "hello");
    VERIFY_ERROR(readShape(formats(), folder.path() / "a.unknown"), ErrorCode::FormatUnknown);
    writeText(folder.path() / "noextension", "hello");
    VERIFY_ERROR(readShape(formats(), folder.path() / "noextension"), ErrorCode::FormatUnknown);
  }

  void emptyFilesAreDamaged() {
    for (const Format& f : formats().formats())
      if (f.read) VERIFY_ERROR(readText("", f.extensions.front()), ErrorCode::FormatDamaged);
  }

  void binaryRubbishIsDamagedInEveryTextFormat() {
    std::mt19937_64 random = seededRandom();
    for (int round = 0; round < 20; ++round) {
      std::string rubbish(500, '\0');
      for (char& c : rubbish) c = static_cast<char>(random());
      for (const char* extension : {"obj", "off", "ply", "stl", "dxf", "svg"})
        VERIFY_ERROR(readText(rubbish, extension), ErrorCode::FormatDamaged);
    }
  }

  void tellsAWrongExtension() {
    const std::string stl =
        "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid a\n";
    try {
      readText(stl, "step");
      QFAIL("did not throw");
    } catch (const Error& error) {
      QCOMPARE(error.code(), ErrorCode::FormatDamaged);
      QVERIFY2(error.message().find("looks like STL") != std::string::npos, error.what());
      QVERIFY2(error.hint().find("stl") != std::string::npos, error.hint().c_str());
    }
    VERIFY_ERROR(readText(stl, "svg"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readText("<svg xmlns=\"http://www.w3.org/2000/svg\"/>", "dxf"), ErrorCode::FormatDamaged);
    VERIFY_ERROR(readText("OFF\n0 0 0\n", "obj"), ErrorCode::FormatDamaged);
  }

  void sniffs_data() {
    QTest::addColumn<QByteArray>("head");
    QTest::addColumn<QString>("format");
    QTest::newRow("step") << QByteArray("ISO-10303-21;\nHEADER;") << "STEP";
    QTest::newRow("step after a comment") << QByteArray("/* made by hand */\nISO-10303-21;") << "STEP";
    QTest::newRow("iges") << QByteArray(QByteArray(72, ' ') + "S      1\n") << "IGES";
    QTest::newRow("brep") << QByteArray("\nCASCADE Topology V1, (c) Matra-Datavision\n") << "BREP";
    QTest::newRow("brep of Draw") << QByteArray("DBRep_DrawableShape\n\nCASCADE Topology V1") << "BREP";
    QTest::newRow("stl") << QByteArray("solid x\n facet normal 0 0 1") << "STL";
    QTest::newRow("obj") << QByteArray("# a comment\n\nv 0 0 1e-3\n") << "OBJ";
    QTest::newRow("off") << QByteArray("# comment\nCOFF\n1 2 3") << "OFF";
    QTest::newRow("ply") << QByteArray("ply\r\nformat ascii 1.0") << "PLY";
    QTest::newRow("dxf") << QByteArray("999\nby hand\n  0\r\nSECTION\r\n") << "DXF";
    QTest::newRow("binary dxf") << QByteArray("AutoCAD Binary DXF\r\n") << "DXF";
    QTest::newRow("svg") << QByteArray("<?xml version='1.0'?>\n<!-- a --><svg>") << "SVG";
    QTest::newRow("png") << QByteArray("\x89PNG\r\n") << "PNG";
    QTest::newRow("nothing") << QByteArray() << "";
    QTest::newRow("prose") << QByteArray("The quick brown fox") << "";
    QTest::newRow("numbers") << QByteArray("1 2 3\n4 5 6\n") << "";
    QTest::newRow("solid prose") << QByteArray("solid as a rock") << "";
  }
  void sniffs() {
    QFETCH(QByteArray, head);
    QFETCH(QString, format);
    QCOMPARE(QString::fromStdString(sniffFormat(std::string_view(head.constData(), static_cast<std::size_t>(head.size())))),
             format);
  }

  void writesAtomically() {
    const TemporaryFolder folder;
    const fs::path path = folder.path() / "a.obj";
    writeText(path, "old");
    const Format* obj = formats().find("obj");
    FormatRegistry failing;
    Format broken = *obj;
    broken.write = [](const Shape&, const fs::path& to, const Value&, const Progress&) {
      writeText(to, "half");
      throw Error(ErrorCode::FileUnwritable, "The disk is full.");
    };
    failing.add(broken);
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    mesh.addFace(std::array{0, 1, 2});
    VERIFY_ERROR(writeShape(failing, mesh, path), ErrorCode::FileUnwritable);
    QCOMPARE(readFile(path), std::string("old"));
    QCOMPARE(std::distance(fs::directory_iterator(folder.path()), fs::directory_iterator()), 1);
  }

  void refusesShapesAFormatCannotHold() {
    const TemporaryFolder folder;
    Mesh mesh;
    VERIFY_ERROR(writeShape(formats(), mesh, folder.path() / "a.dxf"), ErrorCode::OutputNotSupported);
    VERIFY_ERROR(writeShape(formats(), Shape(), folder.path() / "a.stl"), ErrorCode::OutputNotSupported);
    VERIFY_ERROR(writeShape(formats(), mesh, folder.path() / "a.unknown"), ErrorCode::FormatUnknown);
    VERIFY_ERROR(writeShape(formats(), mesh, folder.path() / "a.obj", Value{{"nonsense", 1}}), ErrorCode::InvalidParameter);
    QVERIFY(fs::is_empty(folder.path()));
  }

  void numbersDoNotDependOnTheLocale() {
    const std::string before = setlocale(LC_ALL, nullptr);
    for (const char* name : {"de_DE.UTF-8", "fr_FR.UTF-8", "de_DE"}) setlocale(LC_ALL, name);
    const Imported obj = readText("v 0.5 0 0\nv 1.25 0 0\nv 0 1.75 0\nf 1 2 3\n", "obj");
    const Imported svg = readText("<svg><path d='M0.5 0L1.25 1.75'/></svg>", "svg");
    setlocale(LC_ALL, before.c_str());
    QCOMPARE(obj.shape.get<Mesh>()->points[0].x(), 0.5);
    QCOMPARE(std::get<Line2>(svg.shape.get<Curves>()->paths[0].segments[0]).from.x(), 0.5);
  }
};

BLOSSOM_TEST(FormatTest)
#include "format_test.moc"
