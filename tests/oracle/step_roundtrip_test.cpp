// What Blossom writes as STEP, IGES and BREP, read again with OCCT's plain readers, which share no code with the writers.
#include <netdb.h>
#include <unistd.h>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepTools.hxx>
#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <Geom_RectangularTrimmedSurface.hxx>
#include <IGESControl_Reader.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>

#include <array>
#include <cstdio>
#include <iostream>
#include <numbers>

#include "core/file.h"
#include "exchange/formats.h"
#include "geometry/bspline/bspline.h"
#include "geometry/occt/occt.h"
#include "support/support.h"

using namespace blossom;

namespace {

std::vector<double> clampedKnots(int degree, int spans, std::mt19937_64& random) {
  std::vector<double> knots(static_cast<std::size_t>(degree) + 1, 0.0);
  std::uniform_real_distribution<double> step(0.5, 1.5);
  double at = 0;
  for (int i = 0; i < spans; ++i) knots.push_back(at += step(random));
  knots.insert(knots.end(), static_cast<std::size_t>(degree), at);
  return knots;
}

/// A bumpy sheet of size 10.
Surface randomSheet(int degreeU, int degreeV, int spans, std::mt19937_64& random) {
  Surface surface{degreeU, degreeV, clampedKnots(degreeU, spans, random), clampedKnots(degreeV, spans, random), {}};
  std::uniform_real_distribution<double> bump(-0.3, 0.3), weight(0.5, 2);
  const double stepU = 10.0 / static_cast<double>(surface.countU() - 1),
               stepV = 10.0 / static_cast<double>(surface.countV() - 1);
  for (std::size_t i = 0; i < surface.countU(); ++i)
    for (std::size_t j = 0; j < surface.countV(); ++j) {
      const double w = weight(random);
      surface.poles.emplace_back(w * (static_cast<double>(i) * stepU + bump(random)),
                                 w * (static_cast<double>(j) * stepV + bump(random)), w * bump(random), w);
    }
  return surface;
}

/// Full turn about z of a profile in the xz plane, by the nine-pole rational quadratic circle.
Surface turned(const std::vector<std::pair<double, double>>& profile, const std::vector<double>& knots, int degree) {
  Surface surface{2, degree, {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, knots, {}};
  const double corner = std::numbers::sqrt2 / 2;
  for (int i = 0; i < 9; ++i) {
    const double angle = i * std::numbers::pi / 4, w = i % 2 ? corner : 1.0, reach = i % 2 ? std::numbers::sqrt2 : 1.0;
    for (const auto& [x, z] : profile)
      surface.poles.emplace_back(w * reach * x * std::cos(angle), w * reach * x * std::sin(angle), w * z, w);
  }
  for (std::size_t j = 0; j < profile.size(); ++j) surface.pole(8, j) = surface.pole(0, j);
  return surface;
}

TopoDS_Shape readPlainly(const test::fs::path& path) {
  if (path.extension() == ".step") {
    STEPControl_Reader reader;
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) return {};
    reader.TransferRoots();
    return reader.OneShape();
  }
  if (path.extension() == ".igs") {
    IGESControl_Reader reader;
    if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) return {};
    reader.TransferRoots();
    return reader.OneShape();
  }
  TopoDS_Shape shape;
  BRepTools::Read(shape, path.c_str(), BRep_Builder());
  return shape;
}

TopTools_IndexedMapOfShape facesOf(const TopoDS_Shape& shape) {
  TopTools_IndexedMapOfShape faces;
  if (!shape.IsNull()) TopExp::MapShapes(shape, TopAbs_FACE, faces);
  return faces;
}

/// The B-spline under a face; null when it is something else.
Handle(Geom_BSplineSurface) splineOf(const TopoDS_Shape& face) {
  Handle(Geom_Surface) surface = BRep_Tool::Surface(TopoDS::Face(face));
  if (const auto trimmed = Handle(Geom_RectangularTrimmedSurface)::DownCast(surface)) surface = trimmed->BasisSurface();
  return Handle(Geom_BSplineSurface)::DownCast(surface);
}

std::string contentOf(const test::fs::path& path) { return readFile(path); }

/// Collects what is printed to stdout while it lives.
class StandardOutput {
 public:
  explicit StandardOutput(const test::fs::path& file) : file_(file) {
    std::fflush(stdout);
    before_ = ::dup(STDOUT_FILENO);
    std::FILE* target = std::fopen(file.c_str(), "w");
    ::dup2(::fileno(target), STDOUT_FILENO);
    std::fclose(target);
  }
  std::string end() {
    std::fflush(stdout);
    std::cout.flush();
    ::dup2(before_, STDOUT_FILENO);
    ::close(before_);
    return readFile(file_);
  }

 private:
  test::fs::path file_;
  int before_;
};

}  // namespace

class StepRoundtripTest : public QObject {
  Q_OBJECT

  TemporaryFolder folder_;
  FormatRegistry formats_ = standardFormats();

  test::fs::path write(const Shape& shape, const char* name, const Value& options = Value::object()) {
    const test::fs::path path = folder_.path() / name;
    writeShape(formats_, shape, path, options);
    return path;
  }

  /// Written and read again, the surface is one face with the same degrees and knots, and the same points within
  /// `tolerance`.
  void verifyKept(const Surface& surface, const char* name, double tolerance, const Value& options = Value::object()) {
    const auto faces = facesOf(readPlainly(write(surface, name, options)));
    QCOMPARE(faces.Extent(), 1);
    const auto spline = splineOf(faces(1));
    QVERIFY(!spline.IsNull());
    QCOMPARE(spline->UDegree(), surface.degreeU);
    QCOMPARE(spline->VDegree(), surface.degreeV);
    QCOMPARE(spline->IsURational() || spline->IsVRational(), true);
    // OCCT's readers make closed surfaces periodic; clamped, they have again the ends that stand in the file.
    const Surface back = clamped(fromOcct(spline));
    QCOMPARE(back.knotsU.size(), surface.knotsU.size());
    QCOMPARE(back.knotsV.size(), surface.knotsV.size());
    for (std::size_t i = 0; i < back.knotsU.size(); ++i) COMPARE_NEAR(back.knotsU[i], surface.knotsU[i], 1e-12);
    for (std::size_t i = 0; i < back.knotsV.size(); ++i) COMPARE_NEAR(back.knotsV[i], surface.knotsV[i], 1e-12);
    const auto [u0, u1] = surface.domainU();
    const auto [v0, v1] = surface.domainV();
    double worst = 0;
    for (int i = 0; i <= 40; ++i)
      for (int j = 0; j <= 40; ++j) {
        const double u = u0 + (u1 - u0) * i / 40, v = v0 + (v1 - v0) * j / 40;
        const gp_Pnt there = spline->Value(u, v);
        worst = std::max(worst, (point(surface, u, v) - Vec3(there.X(), there.Y(), there.Z())).norm());
      }
    qInfo("%s: largest error %.2e", name, worst);
    QVERIFY2(worst <= tolerance, qPrintable(QString::number(worst)));
  }

  /// OCCT's AP 203 writer needs it; Blossom says so instead of crashing.
  static bool hostHasAddress() {
    char name[256] = {};
    return ::gethostname(name, sizeof name - 1) == 0 && ::gethostbyname(name);
  }

 private slots:
  void initTestCase() { qputenv("BLOSSOM_WORKER", (test::buildFolder() / "bin/blossom-worker").c_str()); }

  void rationalSurfaceOfDegree9x12() {
    auto random = test::seededRandom();
    for (int round = 0; round < 3; ++round) {
      const Surface sheet = randomSheet(9, 12, 3, random);
      verifyKept(sheet, "sheet.step", 3e-12);
      verifyKept(sheet, "sheet.igs", 3e-12);
      verifyKept(sheet, "sheet.igs", 3e-12, {{"brep", true}});
      verifyKept(sheet, "sheet.brep", 1e-12);
    }
  }

  void closedSurfacesStayOneFace() {
    const Surface tube = turned({{5, 0}, {4, 3}, {6, 6}}, {0, 0, 0, 1, 1, 1}, 2);
    const Surface torus = turned({{5, 0}, {5, 2}, {7, 2}, {9, 2}, {9, 0}, {9, -2}, {7, -2}, {5, -2}, {5, 0}},
                                 {0, 0, 0, 1, 1, 2, 2, 3, 3, 4, 4, 4}, 2);
    for (const char* name : {"closed.step", "closed.igs", "closed.brep"}) {
      verifyKept(tube, name, 3e-12);
      verifyKept(torus, name, 3e-12);
    }
  }

  void surfacesCollapsedToAPointStayOneFace() {
    const Surface ball = turned({{0, -5}, {5, -5}, {5, 5}, {0, 5}}, {0, 0, 0, 0, 1, 1, 1, 1}, 3);
    verifyKept(ball, "ball.step", 3e-12);
    verifyKept(ball, "ball.brep", 3e-12);
  }

  void creasedSurfacesAreNotSplit() {
    Surface roof = randomSheet(3, 3, 2, *std::make_unique<std::mt19937_64>(7));
    const double middle = roof.knotsU[4];
    const Surface creased = insertKnotsU(roof, std::vector<double>{middle, middle});
    verifyKept(creased, "roof.step", 3e-12);
    verifyKept(creased, "roof.igs", 3e-12);
  }

  void aSurfaceComesBackThroughTheWorkerToo() {
    auto random = test::seededRandom();
    const Surface sheet = randomSheet(5, 4, 4, random);
    for (const char* name : {"again.step", "again.igs", "again.brep"}) {
      const Imported imported = readShape(formats_, write(sheet, name));
      QCOMPARE(imported.entities.at("face").get<int>(), 1);
      const auto spline = splineOf(facesOf(imported.shape.get<Brep>()->shape())(1));
      const gp_Pnt there = spline->Value(0.3, 0.7);
      QVERIFY((point(sheet, 0.3, 0.7) - Vec3(there.X(), there.Y(), there.Z())).norm() < 1e-9);
    }
  }

  void solidsKeepTheirVolume() {
    const Shape box = Brep(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "Box", Color{1, 0.5, 0});
    for (const auto& [name, options] : {std::pair<const char*, Value>{"box.step", Value::object()},
                                        {"box.igs", Value::object()},
                                        {"box.brep", Value::object()}}) {
      GProp_GProps properties;
      const TopoDS_Shape shape = readPlainly(write(box, name, options));
      BRepGProp::VolumeProperties(shape, properties);
      COMPARE_NEAR(properties.Mass(), 6, 1e-9);
      QCOMPARE(facesOf(shape).Extent(), 6);
    }
  }

  void igesWritesLooseFacesWhenAsked() {
    const Shape box = Brep(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "Box");
    const TopoDS_Shape loose = readPlainly(write(box, "loose.igs", {{"brep", false}}));
    QCOMPARE(facesOf(loose).Extent(), 6);
    QVERIFY(!TopExp_Explorer(loose, TopAbs_SOLID).More());
  }

  void everyKindIsWritten() {
    const Curve curve{3, {0, 0, 0, 0, 1, 1, 1, 1}, {{0, 0, 0, 1}, {1, 2, 0, 1}, {3, 2, 1, 1}, {4, 0, 0, 1}}};
    const Path circle{{Arc2{{0, 0}, 2, 0, 2 * std::numbers::pi}}, true, "", {}};
    const Mesh tetrahedron = [] {
      Mesh mesh;
      mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
      for (const std::array<int, 3>& face : {std::array{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}) mesh.addFace(face);
      return mesh;
    }();
    for (const char* name : {"kind.step", "kind.igs", "kind.brep"}) {
      QCOMPARE(facesOf(readPlainly(write(curve, name))).Extent(), 0);
      QVERIFY(!readPlainly(write(curve, name)).IsNull());
      QVERIFY(!readPlainly(write(Curves{{circle}, FillRule::EvenOdd}, name)).IsNull());
      GProp_GProps disc;
      BRepGProp::SurfaceProperties(readPlainly(write(Region{{circle}}, name)), disc);
      COMPARE_NEAR(disc.Mass(), 4 * std::numbers::pi, 1e-9);
      QCOMPARE(facesOf(readPlainly(write(tetrahedron, name))).Extent(), 4);
    }
  }

  void hugeMeshesAreRefusedInWords() {
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
    for (int i = 0; i < 100'001; ++i) mesh.addFace(std::array{0, 1, 2});
    VERIFY_ERROR(write(mesh, "huge.step"), ErrorCode::LimitExceeded);
    QVERIFY(!test::fs::exists(folder_.path() / "huge.step"));
  }

  void theHeaderNamesBlossomAndTheSchemaAskedFor() {
    const Shape box = Brep(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "Box");
    for (const auto& [schema, wanted] : {std::pair{"ap203", "CONFIG_CONTROL_DESIGN"},
                                         {"ap214", "AUTOMOTIVE_DESIGN"},
                                         {"ap242", "AP242_MANAGED_MODEL_BASED_3D_ENGINEERING"}}) {
      if (std::string(schema) == "ap203" && !hostHasAddress()) {
        VERIFY_ERROR(write(box, "header.step", {{"schema", schema}}), ErrorCode::OutputNotSupported);
        continue;
      }
      const std::string text = contentOf(write(box, "header.step", {{"schema", schema}}));
      const std::string header = text.substr(0, text.find("DATA;"));
      QVERIFY2(header.find(wanted) != std::string::npos, header.c_str());
      QVERIFY2(header.find("Blossom") != std::string::npos, header.c_str());
      QVERIFY2(text.find("PRODUCT('Box','Box'") != std::string::npos, wanted);
      QCOMPARE(facesOf(readPlainly(folder_.path() / "header.step")).Extent(), 6);
    }
  }

  void anUnnamedShapeIsCalledAlikeEveryTime() {
    const Shape box = Brep(BRepPrimAPI_MakeBox(1, 2, 3).Shape());
    const auto body = [&](const char* name) {
      const std::string text = contentOf(write(box, name));
      return text.substr(text.find("DATA;"));
    };
    QVERIFY(body("first.step") == body("second.step"));
  }

  void nothingIsPrinted() {
    const Shape box = Brep(BRepPrimAPI_MakeBox(1, 2, 3).Shape(), "Box");
    StandardOutput output(folder_.path() / "stdout.txt");
    for (const char* name : {"quiet.step", "quiet.igs", "quiet.brep"}) readShape(formats_, write(box, name));
    const std::string printed = output.end();
    QVERIFY2(printed.empty(), printed.c_str());
  }

  void anEmptyShapeCannotBeWritten() { VERIFY_ERROR(write(Brep(), "empty.step"), ErrorCode::InvalidInput); }

  void aCancelledWriteLeavesNothing() {
    const CancelToken token;
    token.cancel();
    const test::fs::path path = folder_.path() / "cancelled.step";
    VERIFY_ERROR(writeShape(formats_, Brep(BRepPrimAPI_MakeBox(1, 2, 3).Shape()), path, Value::object(), Progress(token)),
                 ErrorCode::Cancelled);
    QVERIFY(!test::fs::exists(path));
  }
};

BLOSSOM_TEST(StepRoundtripTest)
#include "step_roundtrip_test.moc"
