// What is written: assemblies such as files give (unnamed uses, shared parts, parts that hold nothing) and shapes that no
// feature should make. Every format writes them whole or says why not; nothing else is left, and this process lives on.
#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRep_Builder.hxx>
#include <GProp_GProps.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Solid.hxx>

#include "geometry/measure/measure.h"
#include "support/exchange.h"
#include "support/solids.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using Part = std::shared_ptr<const BrepPart>;

Part partOf(const TopoDS_Shape& shape, std::string name = {}) {
  auto part = std::make_shared<BrepPart>();
  part->shape = shape;
  part->name = std::move(name);
  return part;
}

Part assemblyOf(std::vector<BrepInstance> children, std::string name = {}) {
  auto part = std::make_shared<BrepPart>();
  part->children = std::move(children);
  part->name = std::move(name);
  return part;
}

gp_Trsf shifted(double x, double y = 0, double z = 0) {
  gp_Trsf place;
  place.SetTranslation(gp_Vec(x, y, z));
  return place;
}

TopoDS_Shape emptyCompound() {
  TopoDS_Compound compound;
  BRep_Builder().MakeCompound(compound);
  return compound;
}

TopoDS_Shape emptyShell() {
  TopoDS_Shell shell;
  BRep_Builder().MakeShell(shell);
  return shell;
}

TopoDS_Shape emptySolid() {
  TopoDS_Solid solid;
  BRep_Builder().MakeSolid(solid);
  return solid;
}

TopoDS_Shape faceWithoutSurface() {
  TopoDS_Face face;
  BRep_Builder().MakeFace(face);
  return face;
}

TopoDS_Shape box(double side) { return BRepPrimAPI_MakeBox(side, side, side).Shape(); }

double volumeOf(const TopoDS_Shape& shape) {
  GProp_GProps properties;
  BRepGProp::VolumeProperties(shape, properties);
  return properties.Mass();
}

/// Ten mm cubes and cylinders under names, without names, in assemblies of assemblies.
class RandomAssembly {
 public:
  explicit RandomAssembly(std::mt19937_64& random) : random_(random) {
    parts_ = {partOf(box(10), "Cube"),
              partOf(box(10)),
              partOf(BRepPrimAPI_MakeCylinder(3, 10).Shape(), "Rod"),
              partOf(emptyCompound(), "Nothing"),
              partOf(TopoDS_Shape(), "Less than nothing"),
              nullptr,
              assemblyOf({}, "No parts")};
  }

  Brep make() {
    std::vector<BrepInstance> roots = uses(0);
    roots.push_back(use(parts_.front()));  // something is there
    return Brep(roots);
  }

 private:
  int below(int count) { return static_cast<int>(random_() % static_cast<unsigned>(count)); }

  BrepInstance use(const Part& part) {
    BrepInstance instance;
    if (below(2)) instance.name = "use";
    if (below(4) == 0) instance.color = Color{0.2, 0.4, 0.6};
    instance.location = shifted(20.0 * ++count_);  // what lies twice in one place is one entity in IGES
    if (below(3) == 0) {
      gp_Trsf turned;
      turned.SetRotation(gp_Ax1(), 0.1 * count_);
      instance.location = instance.location * turned;
    }
    instance.part = part;
    return instance;
  }

  std::vector<BrepInstance> uses(int depth) {
    std::vector<BrepInstance> all;
    for (int i = below(4); i >= 0; --i) {
      const bool nested = depth < 3 && below(3) == 0;
      all.push_back(use(nested ? assemblyOf(uses(depth + 1), below(2) ? "Group" : "")
                               : parts_[static_cast<std::size_t>(below(static_cast<int>(parts_.size())))]));
    }
    return all;
  }

  std::mt19937_64& random_;
  std::vector<Part> parts_;
  int count_ = 0;
};

std::vector<std::pair<std::string, Brep>> oddShapes() {
  return {{"nothing at all", Brep(TopoDS_Shape())},
          {"no roots", Brep(std::vector<BrepInstance>())},
          {"a use of no part", Brep(std::vector<BrepInstance>{BrepInstance{}})},
          {"an empty compound", Brep(emptyCompound())},
          {"an empty shell", Brep(emptyShell())},
          {"an empty solid", Brep(emptySolid())},
          {"a face without a surface", Brep(faceWithoutSurface())},
          {"a lone point", Brep(BRepBuilderAPI_MakeVertex(gp_Pnt(1, 2, 3)).Shape())}};
}

std::size_t entriesOf(const fs::path& folder) {
  return static_cast<std::size_t>(std::distance(fs::directory_iterator(folder), fs::directory_iterator()));
}

}  // namespace

class ExportedShapesTest : public QObject {
  Q_OBJECT

  TemporaryFolder folder_;
  int written_ = 0, refused_ = 0;

  /// @returns what was written, or nothing when it was refused with a sentence; either way nothing else lies there
  fs::path exported(const Shape& shape, const Format& format) {
    const fs::path place = folder_.path() / "place", temporaries = folder_.path() / "temporaries";
    fs::remove_all(place);
    fs::create_directories(place);
    fs::create_directories(temporaries);
    qputenv("TMPDIR", temporaries.c_str());
    const fs::path file = place / ("shape." + format.extensions.front());
    bool good = true;
    try {
      writeShape(formats(), shape, file);
    } catch (const Error& error) {
      good = false;
      if (error.message().size() < 10 || !error.message().ends_with('.')) qFatal("%s", error.message().c_str());
    }
    qputenv("TMPDIR", folder_.path().c_str());
    if (entriesOf(temporaries) != 0) qFatal("something is left among the temporary files");
    if (entriesOf(place) != (good ? 1u : 0u)) qFatal("something is left beside the file");
    ++(good ? written_ : refused_);
    return good ? file : fs::path();
  }

 private slots:
  void initTestCase() { qputenv("BLOSSOM_WORKER", (buildFolder() / "bin/blossom-worker").c_str()); }

  /// The writer of IGES asks every use for its name, and fell over those without one.
  void usesWithoutAName() {
    const Part cube = partOf(box(10), "Cube");
    const Brep assembly(std::vector<BrepInstance>{
        {"",
         {},
         shifted(0),
         assemblyOf({{"", {}, shifted(20), cube}, {"", {}, shifted(40), cube}, {"last", {}, shifted(60), cube}})}});
    for (const char* id : {"iges", "step", "brep"}) {
      const fs::path file = exported(assembly, *formats().find(id));
      QVERIFY2(!file.empty(), id);
      const Imported back = readShape(formats(), file);
      COMPARE_NEAR(volumeOf(back.shape.get<Brep>()->shape()), 3000, 1e-6);
    }
  }

  void partsThatHoldNothing() {
    const Part cube = partOf(box(10), "Cube");
    for (const Part& nothing : {Part(), partOf(TopoDS_Shape()), partOf(emptyCompound(), "Empty"), assemblyOf({}, "None"),
                                assemblyOf({{"", {}, gp_Trsf(), partOf(emptyCompound())}}, "None within")}) {
      const Brep assembly(std::vector<BrepInstance>{
          {"all", {}, gp_Trsf(), assemblyOf({{"", {}, shifted(5), nothing}, {"", {}, shifted(20), cube}})}});
      for (const char* id : {"iges", "step", "brep", "stl"}) {
        const fs::path file = exported(assembly, *formats().find(id));
        QVERIFY2(!file.empty(), id);
        const Measures measures = measure(readShape(formats(), file).shape);
        const auto volume = std::find_if(measures.values.begin(), measures.values.end(),
                                         [](const Measure& each) { return each.name == "volume"; });
        QVERIFY(volume != measures.values.end());
        COMPARE_NEAR(std::get<double>(volume->value), 1000, 1e-3);
      }
    }
  }

  void randomAssemblies() {
    auto random = seededRandom();
    RandomAssembly assemblies(random);
    for (int round = 0; round < 12; ++round) {
      const Brep assembly = assemblies.make();
      const double volume = volumeOf(assembly.shape());
      for (const char* id : {"iges", "step", "brep"}) {
        const fs::path file = exported(assembly, *formats().find(id));
        QVERIFY2(!file.empty(), id);
        const double read = volumeOf(readShape(formats(), file).shape.get<Brep>()->shape());
        QVERIFY2(std::abs(read - volume) <= 1e-5 * volume,
                 qPrintable(QString("%1: %2 of %3").arg(id).arg(read).arg(volume)));
      }
    }
  }

  void oddShapesEndNothing() {
    for (const auto& [name, shape] : oddShapes())
      for (const Format& format : formats().formats())
        if (format.write && canStore(format, ShapeKind::Brep)) exported(shape, format);
  }

  void cleanupTestCase() {
    qInfo("figure written %d", written_);
    qInfo("figure refused %d", refused_);
  }
};

BLOSSOM_TEST(ExportedShapesTest)
#include "exported_shapes_test.moc"
