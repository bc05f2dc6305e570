#include "transport/brep_transport.h"

#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeSphere.hxx>
#include <GProp_GProps.hxx>
#include <TopExp.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <fstream>

#include "core/file.h"
#include "exchange/cad/entity_count.h"
#include "support/support.h"

using namespace blossom;

namespace {

double volumeOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

Brep sentAndReturned(const Brep& brep) {
  const TemporaryFolder folder;
  const Value value = Value::parse(saveBrep(brep, folder.path(), "a").dump());
  return loadBrep(value, folder.path());
}

gp_Trsf shifted(double x) {
  gp_Trsf location;
  location.SetTranslation(gp_Vec(x, 0, 0));
  return location;
}

gp_Trsf turned() {
  gp_Trsf location;
  location.SetRotation(gp_Ax1(gp_Pnt(1, 2, 3), gp_Dir(1, 1, 1)), 0.7);
  return location;
}

/// An assembly in an assembly: a box with a red face used twice, a sphere turned, names with all sorts of letters.
Brep assembly() {
  auto box = std::make_shared<BrepPart>();
  box->name = "Block \"A\"";
  box->shape = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
  box->color = Color{0.1, 0.2, 1.0 / 3};
  TopTools_IndexedMapOfShape faces;
  TopExp::MapShapes(box->shape, TopAbs_FACE, faces);
  box->subShapeColors.emplace_back(faces(4), Color{1, 0, 0});
  auto sphere = std::make_shared<BrepPart>();
  sphere->name = "Kügelchen";
  sphere->shape = BRepPrimAPI_MakeSphere(2).Shape();
  auto pair = std::make_shared<BrepPart>();
  pair->name = "Pair";
  pair->children = {{"left", {}, gp_Trsf(), box}, {"right", Color{0, 1, 0}, shifted(10), box}};
  auto top = std::make_shared<BrepPart>();
  top->children = {{"pair:1", {}, shifted(100), pair}, {"ball", {}, turned(), sphere}};
  return Brep({{"Top", {}, gp_Trsf(), top}});
}

}  // namespace

class BrepTransportTest : public QObject {
  Q_OBJECT

 private slots:
  void structureNamesAndColoursSurvive() {
    const Brep brep = sentAndReturned(assembly());
    QCOMPARE(brep.roots().size(), std::size_t{1});
    const BrepPart& top = *brep.roots()[0].part;
    QCOMPARE(top.children.size(), std::size_t{2});
    QCOMPARE(top.children[0].name, std::string("pair:1"));
    QCOMPARE(top.children[1].part->name, std::string("Kügelchen"));
    QVERIFY(!top.children[1].part->color);
    const BrepPart& pair = *top.children[0].part;
    QCOMPARE(pair.children[0].part.get(), pair.children[1].part.get());
    QVERIFY(!pair.children[0].color);
    QVERIFY((pair.children[1].color == Color{0, 1, 0}));
    QVERIFY((pair.children[0].part->color == Color{0.1, 0.2, 1.0 / 3}));
  }

  void colouredSubShapesAreFacesOfTheirPart() {
    const Brep before = assembly();
    const Brep after = sentAndReturned(before);
    const BrepPart& box = *after.roots()[0].part->children[0].part->children[0].part;
    const BrepPart& original = *before.roots()[0].part->children[0].part->children[0].part;
    QCOMPARE(box.subShapeColors.size(), std::size_t{1});
    const auto& [face, color] = box.subShapeColors[0];
    QVERIFY((color == Color{1, 0, 0}));
    TopTools_IndexedMapOfShape faces, originalFaces;
    TopExp::MapShapes(box.shape, TopAbs_FACE, faces);
    TopExp::MapShapes(original.shape, TopAbs_FACE, originalFaces);
    QCOMPARE(faces.FindIndex(face), 4);
    GProp_GProps here, there;
    BRepGProp::SurfaceProperties(face, here);
    BRepGProp::SurfaceProperties(original.subShapeColors[0].first, there);
    QVERIFY(here.CentreOfMass().IsEqual(there.CentreOfMass(), 1e-15));
  }

  void placesAndVolumesSurvive() {
    const Brep before = assembly();
    const Brep after = sentAndReturned(before);
    QVERIFY(after.roots()[0].location.Form() == gp_Identity);
    const gp_Trsf turn = after.roots()[0].part->children[1].location;
    for (int row = 1; row <= 3; ++row)
      for (int column = 1; column <= 4; ++column) COMPARE_NEAR(turn.Value(row, column), turned().Value(row, column), 1e-15);
    COMPARE_NEAR(volumeOf(after.shape()), 2 * 6 + 4 * M_PI * 8 / 3, 1e-9);
  }

  void mirroredAndScaledPlacesSurvive() {
    gp_Trsf mirror;
    mirror.SetMirror(gp_Ax2(gp_Pnt(1, 0, 0), gp_Dir(1, 0, 0)));
    gp_Trsf scale;
    scale.SetScale(gp_Pnt(1, 1, 1), 2.5);
    for (const gp_Trsf& location : {mirror, scale}) {
      auto box = std::make_shared<BrepPart>();
      box->shape = BRepPrimAPI_MakeBox(1, 2, 3).Shape();
      const Brep after = sentAndReturned(Brep({{"", {}, location, box}}));
      for (int row = 1; row <= 3; ++row)
        for (int column = 1; column <= 4; ++column)
          COMPARE_NEAR(after.roots()[0].location.Value(row, column), location.Value(row, column), 1e-15);
    }
  }

  void entitiesCountEachPartOnce() {
    const Value counts = countEntities(assembly());
    QCOMPARE(counts.at("assembly").get<int>(), 2);
    QCOMPARE(counts.at("part").get<int>(), 2);
    QCOMPARE(counts.at("solid").get<int>(), 2);
    QCOMPARE(counts.at("face").get<int>(), 7);
  }

  void damagedFilesAreAnError() {
    const TemporaryFolder folder;
    const Value value = saveBrep(assembly(), folder.path(), "a");
    std::ofstream(folder.path() / "a.brep") << "rubbish";
    VERIFY_ERROR(loadBrep(value, folder.path()), ErrorCode::Internal);
    test::fs::remove(folder.path() / "a.brep");
    VERIFY_ERROR(loadBrep(value, folder.path()), ErrorCode::Internal);
  }

  void nothingIsRefused() {
    const TemporaryFolder folder;
    VERIFY_ERROR(saveBrep(Brep(), folder.path(), "a"), ErrorCode::InvalidInput);
  }
};

BLOSSOM_TEST(BrepTransportTest)
#include "brep_transport_test.moc"
