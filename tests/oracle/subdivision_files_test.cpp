#include <BRepAdaptor_Curve.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <fstream>
#include <sstream>

#include "app/app.h"
#include "support/command_line.h"
#include "support/support.h"

/// Deformations as they stand in the files that are written, read by other means than those that wrote them.
using namespace blossom;
using namespace blossom::test;

namespace {

/// An open polyline in the plane z = 0.
void writeDrawing(const fs::path& file, const std::vector<Vec2>& points, bool closed) {
  std::ofstream out(file);
  out << "0\nSECTION\n2\nENTITIES\n0\nLWPOLYLINE\n8\n0\n90\n" << points.size() << "\n70\n" << (closed ? 1 : 0) << '\n';
  for (const Vec2& p : points) out << "10\n" << p.x() << "\n20\n" << p.y() << '\n';
  out << "0\nENDSEC\n0\nEOF\n";
}

void writeCloud(const fs::path& file, const std::vector<Vec3>& points) {
  std::ofstream out(file);
  out.precision(17);
  for (const Vec3& p : points) out << p.x() << ' ' << p.y() << ' ' << p.z() << '\n';
}

/// The vertices of the polylines of a DXF file: groups of two lines each, nothing else is known of it.
std::vector<Vec3> verticesOf(const fs::path& file) {
  std::ifstream in(file);
  std::string code, value, entity;
  std::vector<Vec3> vertices;
  while (std::getline(in, code) && std::getline(in, value)) {
    const int group = std::stoi(code);
    if (group == 0) entity = value.substr(0, value.find('\r'));
    const bool vertex = entity == "VERTEX" || entity == "LWPOLYLINE";
    if (!vertex || (group != 10 && group != 20 && group != 30)) continue;
    if (group == 10) vertices.emplace_back(0, 0, 0);
    vertices.back()[group / 10 - 1] = std::stod(value);
  }
  return vertices;
}

/// Points of the uniform cubic B-spline of an open polygon whose ends are mirrored, by its blending functions.
std::vector<Vec3> cubicCurve(const std::vector<Vec3>& polygon) {
  std::vector<Vec3> p{2 * polygon[0] - polygon[1]};
  p.insert(p.end(), polygon.begin(), polygon.end());
  p.push_back(2 * polygon[polygon.size() - 1] - polygon[polygon.size() - 2]);
  std::vector<Vec3> points;
  for (std::size_t i = 0; i + 3 < p.size(); ++i)
    for (int k = 0; k <= 400; ++k) {
      const double t = k / 400.0, s = 1 - t;
      points.push_back((s * s * s * p[i] + (3 * t * t * t - 6 * t * t + 4) * p[i + 1] +
                        (-3 * t * t * t + 3 * t * t + 3 * t + 1) * p[i + 2] + t * t * t * p[i + 3]) /
                       6);
    }
  return points;
}

double rmsTo(const std::vector<Vec3>& curve, const std::vector<Vec3>& target) {
  double sum = 0;
  for (const Vec3& p : target) {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Vec3& q : curve) nearest = std::min(nearest, (p - q).squaredNorm());
    sum += nearest;
  }
  return std::sqrt(sum / static_cast<double>(target.size()));
}

/// Points along all edges of a STEP file, as OCCT reads it.
std::vector<Vec3> pointsOfStep(const fs::path& file) {
  STEPControl_Reader reader;
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone) return {};
  reader.TransferRoots();
  std::vector<Vec3> points;
  for (TopExp_Explorer edges(reader.OneShape(), TopAbs_EDGE); edges.More(); edges.Next()) {
    const BRepAdaptor_Curve curve(TopoDS::Edge(edges.Current()));
    constexpr int parts = 3000;
    for (int k = 0; k <= parts; ++k) {
      const gp_Pnt p = curve.Value(curve.FirstParameter() + (curve.LastParameter() - curve.FirstParameter()) * k / parts);
      points.emplace_back(p.X(), p.Y(), p.Z());
    }
  }
  return points;
}

}  // namespace

class SubdivisionFilesTest : public QObject {
  Q_OBJECT

  QTemporaryDir folder_;
  [[nodiscard]] fs::path path(const char* name) const { return fs::path(folder_.path().toStdString()) / name; }
  const App app_ = loadApp();
  [[nodiscard]] Shape evaluated(const char* name, const Value& parameters, const std::vector<Shape>& inputs) const {
    const auto type = app_.registry->at(name);
    std::vector<std::vector<Shape>> bySpec(type->inputs.size());
    for (std::size_t i = 0; i < inputs.size(); ++i) bySpec[i].push_back(inputs[i]);
    return type->evaluate(completed(type->parameters, parameters), Inputs(std::move(bySpec)), Progress::none()).shape;
  }
  [[nodiscard]] Answer run(const QStringList& arguments) const { return answerOf(folder_.path(), arguments); }

 private slots:
  void aDrawingThatLeavesItsPlaneIsWrittenInSpace() {
    writeDrawing(path("polygon.dxf"), {{0, 0}, {10, 12}, {22, -6}, {34, 10}, {45, 0}, {56, 8}}, false);
    std::vector<Vec3> target;
    for (int i = 0; i <= 20; ++i) target.emplace_back(14 + i, 3 + 0.1 * i, 5);
    writeCloud(path("target.xyz"), target);
    // The control polygon in one, its limit curve in the other.
    const Answer answer = run({"deform", "polygon.dxf", "target.xyz", "--scheme", "cubic", "-o", "lifted.dxf"});
    QCOMPARE(answer.code, 0);
    QCOMPARE(run({"deform", "polygon.dxf", "target.xyz", "--scheme", "cubic", "-o", "lifted.step"}).code, 0);
    const double said = answer.result("rms_after"), before = answer.result("rms_before");
    QVERIFY(before > 5 && said < 1);
    const double inDxf = rmsTo(cubicCurve(verticesOf(path("lifted.dxf"))), target),
                 inStep = rmsTo(pointsOfStep(path("lifted.step")), target);
    COMPARE_NEAR(inDxf, said, 1e-3);
    COMPARE_NEAR(inStep, said, 1e-3);
    std::printf("figure planar_said_mm %.6g\nfigure planar_dxf_mm %.6g\nfigure planar_step_mm %.6g\n", said, inDxf, inStep);
  }

  void aDrawingThatStaysInItsPlaneIsADrawing() {
    writeDrawing(path("polygon.dxf"), {{0, 0}, {10, 12}, {22, -6}, {34, 10}, {45, 0}, {56, 8}}, false);
    writeDrawing(path("wanted.dxf"), {{12, 4}, {17, 6}, {22, 7}, {28, 7}, {34, 5}}, false);
    const Answer answer = run({"deform", "polygon.dxf", "wanted.dxf", "--scheme", "cubic", "-o", "flat.dxf,flat.svg"});
    QCOMPARE(answer.code, 0);
    QCOMPARE(verticesOf(path("flat.dxf")).size(), std::size_t(6));
  }

  /// The scheme counts for the poles of a spline, too.
  void splinesFollowTheScheme() {
    const auto stroke = evaluated("subdivision.stroke", {{"points", {{0, 0, 0}, {10, 8, 0}, {20, -4, 2}, {30, 6, 0}}}}, {});
    const Curve spline = *stroke.get<Curve>();
    QCOMPARE(spline.degree, 3);
    std::vector<Vec3> poles;
    for (const Vec4& pole : spline.poles) poles.emplace_back(pole.head<3>());
    const auto limit = [&](const char* scheme) {
      return *evaluated("subdivision.subdivide", {{"scheme", scheme}, {"as", "limit"}, {"levels", 5}}, {stroke})
                  .get<Curve>();
    };
    // A cubic spline is its own limit.
    for (const char* scheme : {"catmull-clark", "cubic"}) QVERIFY(limit(scheme) == spline);
    // Four-point passes through its points, here the poles: refined five times, every 32nd vertex is one.
    const Curve through = limit("four-point");
    QCOMPARE(through.degree, 1);
    QCOMPARE(through.poles.size(), 32 * (poles.size() - 1) + 1);
    for (std::size_t i = 0; i < poles.size(); ++i) QVERIFY((through.poles[32 * i].head<3>() - poles[i]).norm() < 1e-12);
    // Chaikin's corner cutting ends where the polygon ends, and comes to the middle of every edge.
    const Curve cut = limit("quadratic");
    for (std::size_t i = 0; i + 1 < poles.size(); ++i) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vec4& p : cut.poles) nearest = std::min(nearest, (p.head<3>() - (poles[i] + poles[i + 1]) / 2).norm());
      QVERIFY2(nearest < 0.05, qPrintable(QString::number(nearest)));
    }
    // A deformation moves the curve of the scheme: through the target it passes where that lies on a pole of it.
    const Shape target = evaluated("subdivision.stroke", {{"points", {{10, 9, 0}, {10.5, 9, 0}}}, {"smooth", false}}, {});
    const Shape moved = evaluated("subdivision.deform", {{"scheme", "four-point"}, {"lambda", 1e-6}}, {stroke, target});
    QCOMPARE(moved.get<Curve>()->degree, 1);
    QCOMPARE(moved.get<Curve>()->poles.size(), poles.size());
  }

  void whatMovesFarIsTold() {
    // A vertex that the target touches with next to nothing, and nothing else to move.
    writeDrawing(path("polygon.dxf"), {{0, 0}, {10, 0}, {20, 0}, {30, 0}, {40, 0}, {50, 0}}, false);
    writeCloud(path("near-end.xyz"), {{10.01, 0.5, 0}, {10.02, -0.5, 0}, {19.99, 0.5, 0}});
    const Answer far = run({"deform", "polygon.dxf", "near-end.xyz", "--scheme", "cubic", "--lambda", "0", "-o", "far.dxf"});
    QCOMPARE(far.code, 0);
    QVERIFY2(far.json["warnings"].dump().find("Control point") != std::string::npos, far.json.dump().c_str());
    const Answer calm = run({"deform", "polygon.dxf", "near-end.xyz", "--scheme", "cubic", "-o", "calm.dxf"});
    QCOMPARE(calm.code, 0);
    QVERIFY2(calm.json["warnings"].dump().find("Control point") == std::string::npos, calm.json.dump().c_str());
  }
};

BLOSSOM_TEST(SubdivisionFilesTest)
#include "subdivision_files_test.moc"
