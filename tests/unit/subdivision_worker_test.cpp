#include <BRepAdaptor_Surface.hxx>
#include <BRepBuilderAPI_MakeEdge.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>

#include "geometry/occt/occt.h"
#include "subdivision/kernel/bspline_faces.h"
#include "subdivision/kernel/deform.h"
#include "subdivision/kernel/limit_surface.h"
#include "subdivision/kernel/samples.h"
#include "support/cages.h"
#include "support/fake_worker.h"
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::subdivision;

namespace {

Mesh hull() {
  Mesh mesh = cubeCage();
  mesh.name = "Hull";
  mesh.color = Color{0.2, 0.4, 0.6};
  return mesh;
}

/// A target with a name, over the cage.
Shape edgeAbove() { return Brep(BRepBuilderAPI_MakeEdge(gp_Pnt(-0.5, 0, 1.2), gp_Pnt(0.5, 0.1, 1.3)).Edge(), "Rail"); }

Value pulledUp() {
  const Value pull{{"at", {0.0, 0.0, 1.0}}, {"to", {0.0, 0.0, 1.5}}};
  return {{"pulls", Value::array({pull})}};
}

using Numbers = std::array<double, 4>;

void addPoles(const Surface& surface, std::vector<Numbers>& poles) {
  for (const Vec4& pole : surface.poles) poles.push_back({pole[0], pole[1], pole[2], pole[3]});
}

std::vector<Numbers> polesOf(const Shape& shape) {
  std::vector<Numbers> poles;
  for (TopExp_Explorer faces(shape.get<Brep>()->shape(), TopAbs_FACE); faces.More(); faces.Next())
    addPoles(fromOcct(BRepAdaptor_Surface(TopoDS::Face(faces.Current()), Standard_False).BSpline()), poles);
  std::sort(poles.begin(), poles.end());
  return poles;
}

}  // namespace

/// What OCCT makes of cages is made in a process of its own, everything else in this one.
class SubdivisionWorkerTest : public QObject {
  Q_OBJECT
 private slots:
  void aCrashIsAnErrorOfTheFeature() {
    const FakeWorker crashing(crashingWorker);
    VERIFY_REFUSED(refusal("subdivide", {{"as", "faces"}}, {hull()}), ErrorCode::WorkerDied,
                   "for the faces of the cage crashed (SIGSEGV)");
    Value faces = pulledUp();
    faces["as"] = "faces";
    VERIFY_REFUSED(refusal("deform", faces, {hull()}), ErrorCode::WorkerDied, "for the deformation crashed");
    VERIFY_REFUSED(refusal("deform", Value::object(), {hull(), edgeAbove()}), ErrorCode::WorkerDied, "for the deformation");
  }

  void cagesAndLimitMeshesNeedNoWorker() {
    const FakeWorker crashing(crashingWorker);
    QVERIFY(made("subdivide", Value::object(), {hull()}).shape.get<Mesh>());
    QVERIFY(made("subdivide", {{"as", "limit"}}, {hull()}).shape.get<Mesh>());
    QVERIFY(made("deform", pulledUp(), {hull()}).shape.get<Mesh>());
    const Shape stroke = made("stroke").shape;
    QVERIFY(made("subdivide", {{"as", "faces"}, {"scheme", "cubic"}}, {stroke}).shape.get<Curve>());
  }

  void whatHangsIsCancelled() {
    const FakeWorker hanging(hangingWorker);
    const CancelToken token;
    VERIFY_ERROR(made("subdivide", {{"as", "faces"}}, {hull()}, cancellingWhenItHangs(token)), ErrorCode::Cancelled);
  }

  void facesAreTheSameToTheBit() {
    const Evaluated faces = made("subdivide", {{"as", "faces"}}, {hull()});
    QVERIFY(isSound(faces));
    QVERIFY(faces.stats.contains("worker_ms"));
    std::vector<Numbers> wanted;
    const FacesResult here = bsplineFaces(hull());
    for (const Surface& face : here.faces) addPoles(face, wanted);
    std::sort(wanted.begin(), wanted.end());
    QVERIFY(polesOf(faces.shape) == wanted);
    QCOMPARE(faces.stats.at("deviation_mm").get<double>(), here.deviation);
    QCOMPARE(faces.stats.at("exact_faces").get<std::size_t>(), here.exactFaces);
  }

  void namesAndColoursAreTheCages() {
    const auto rootOf = [](const Evaluated& made) { return made.shape.get<Brep>()->roots().front(); };
    const auto colorOf = [](const BrepInstance& root) { return root.color ? root.color : root.part->color; };
    const BrepInstance named = rootOf(made("subdivide", {{"as", "faces"}}, {hull()}));
    QCOMPARE(QString::fromStdString(named.name), QString("Hull"));
    QVERIFY(colorOf(named) == hull().color);
    // A cage without a name does not take that of its target.
    const BrepInstance plain = rootOf(made("deform", {{"as", "faces"}}, {cubeCage(), edgeAbove()}));
    QVERIFY(plain.name.empty() && !colorOf(plain));
  }

  void deformationsAreTheSameToTheBit() {
    const Mesh cage = gridCage(8, 8);
    const Shape target = Brep(BRepBuilderAPI_MakeEdge(gp_Pnt(3, 4, 0.3), gp_Pnt(5, 4.2, 0.4)).Edge(), "Rail");
    const Evaluated pulled = made("deform", {{"samples", 20}}, {cage, target});
    QVERIFY(pulled.stats.contains("worker_ms"));
    const DeformResult here = deform(LimitSurface(cage, Scheme::CatmullClark), cage.points, samplesOf(target, 20), {});
    QVERIFY(pulled.shape.get<Mesh>()->points == here.points);
    for (const Measure& each : pulled.figures)
      if (each.name == "rms_after") QCOMPARE(std::get<double>(each.value), here.after.rms);
  }
};

BLOSSOM_TEST(SubdivisionWorkerTest)
#include "subdivision_worker_test.moc"
