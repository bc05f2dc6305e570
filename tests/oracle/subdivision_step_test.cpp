#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepCheck_Analyzer.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <BRepGProp.hxx>
#include <BRep_Tool.hxx>
#include <GProp_GProps.hxx>
#include <Geom_BSplineSurface.hxx>
#include <STEPControl_Reader.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>

#include "app/app.h"
#include "exchange/format/format.h"
#include "geometry/mesh/mesh_topology.h"
#include "subdivision/kernel/subdivide.h"
#include "support/cages.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::subdivision;

namespace {

/// What a program that knows nothing of subdivision finds in a file.
struct Found {
  TopoDS_Shape shape;
  int faces = 0, solids = 0;
  double volume = 0;
  bool valid = false, bicubic = true;
};

Found readBack(const fs::path& file) {
  Found found;
  STEPControl_Reader reader;
  if (reader.ReadFile(file.c_str()) != IFSelect_RetDone || reader.TransferRoots() == 0) return found;
  found.shape = reader.OneShape();
  found.valid = BRepCheck_Analyzer(found.shape).IsValid();
  for (TopExp_Explorer solids(found.shape, TopAbs_SOLID); solids.More(); solids.Next()) ++found.solids;
  for (TopExp_Explorer faces(found.shape, TopAbs_FACE); faces.More(); faces.Next(), ++found.faces) {
    const auto surface = Handle(Geom_BSplineSurface)::DownCast(BRep_Tool::Surface(TopoDS::Face(faces.Current())));
    found.bicubic = found.bicubic && !surface.IsNull() && surface->UDegree() == 3 && surface->VDegree() == 3;
  }
  GProp_GProps properties;
  BRepGProp::VolumeProperties(found.shape, properties, 1e-9);
  found.volume = properties.Mass();
  return found;
}

/// Volume of the limit surface: that of meshes with their vertices on it falls short by a fourth as much at each level.
double limitVolume(const Mesh& cage) {
  const auto at = [&](int levels) {
    return signedVolume(triangulated(subdivide(cage, {.levels = levels, .limit = true}).mesh).first);
  };
  const double coarse = at(4), fine = at(5);
  return fine + (fine - coarse) / 3;
}

/// Largest distance of limit points to the shape.
double offShape(const Mesh& cage, const TopoDS_Shape& shape, int levels) {
  double worst = 0;
  const std::vector<Vec3> points = subdivide(cage, {.levels = levels, .limit = true}).mesh.points;
  for (std::size_t i = 0; i < points.size(); i += 4) {  // each takes OCCT milliseconds
    const Vec3& p = points[i];
    const TopoDS_Shape point = BRepBuilderAPI_MakeVertex(gp_Pnt(p.x(), p.y(), p.z())).Shape();
    worst = std::max(worst, BRepExtrema_DistShapeShape(shape, point).Value());
  }
  return worst;
}

}  // namespace

/// STEP files of subdivision surfaces as OCCT's own reader, checker and integrals see them.
class SubdivisionStepTest : public QObject {
  Q_OBJECT

 private slots:
  void initTestCase() {
    qputenv("BLOSSOM_WORKER", (test::buildFolder() / "bin/blossom-worker").c_str());
    app_ = loadApp({buildFolder() / "lib/blossom/plugins"});
    QVERIFY(app_.registry->find("subdivision.subdivide"));
  }

  void closedCagesAreValidSolids() {
    auto random = seededRandom();
    const auto scaled = [](Mesh mesh, double size) {
      for (Vec3& p : mesh.points) p *= size;
      return mesh;
    };
    double worst = 0, worstExact = 0;
    for (const int n : {3, 4, 5, 7}) {
      const Mesh cage = jittered(scaled(prism(n), 10), random, 1);
      const Found found = written(cage, 1e-3);
      QVERIFY(found.valid && found.bicubic);
      QCOMPARE(found.solids, 1);
      COMPARE_NEAR(found.volume, limitVolume(cage), 1e-4 * limitVolume(cage));
      worst = std::max(worst, offShape(cage, found.shape, 2));
    }
    for (const auto& [columns, rows] : {std::pair(6, 5), std::pair(9, 4)}) {
      const Mesh cage = jittered(scaled(torusCage(columns, rows), 5), random, 0.5);
      const Found found = written(cage, 1e-3);
      QVERIFY(found.valid && found.bicubic);
      QCOMPARE(found.solids, 1);
      QVERIFY(found.faces <= 4);
      COMPARE_NEAR(found.volume, limitVolume(cage), 1e-4 * limitVolume(cage));
      worstExact = std::max(worstExact, offShape(cage, found.shape, 2));
    }
    qInfo("figure step_deviation_mm %.2g", worst);
    qInfo("figure step_regular_deviation_mm %.2g", worstExact);
    QVERIFY2(worst <= 1e-3, qPrintable(QString::number(worst)));
    QVERIFY2(worstExact <= 1e-6, qPrintable(QString::number(worstExact)));
  }

  void realCagesAreExported() {
    NEED_SHARED_DATA();
    int written = 0, solids = 0;
    for (const auto& entry : fs::directory_iterator(sharedData() / "subdivision")) {
      const std::string name = entry.path().stem().string();
      if (!name.starts_with("catmark")) continue;
      if (name == "catmark_gregory_test4") continue;  // touches itself at a vertex, and is refused for it
      const Mesh cage = *readShape(*app_.formats, entry.path()).shape.get<Mesh>();
      const Found found = this->written(cage, 0.01);
      QVERIFY2(found.faces > 0, name.c_str());
      QVERIFY2(found.valid && found.bicubic, name.c_str());
      ++written;
      if (!meshTopology(cage).closed()) continue;
      QVERIFY2(found.solids > 0, name.c_str());
      ++solids;
    }
    qInfo("figure step_real_cages %d", written);
    QVERIFY(written >= 16 && solids >= 5);
  }

 private:
  /// Made and written as the command line does it.
  Found written(const Mesh& cage, double tolerance) {
    const auto type = app_.registry->at("subdivide");
    const Value parameters = completed(type->parameters, {{"as", "faces"}, {"tolerance", tolerance}});
    const std::vector<Shape> inputs{cage};
    const Evaluated made = type->evaluate(parameters, arrangedInputs(*type, inputs), Progress::none());
    const fs::path file = fs::path(folder_.path().toStdString()) / "limit.step";
    writeShape(*app_.formats, made.shape, file);
    return readBack(file);
  }

  App app_;
  QTemporaryDir folder_;
};

BLOSSOM_TEST(SubdivisionStepTest)
#include "subdivision_step_test.moc"
