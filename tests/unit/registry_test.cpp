#include "feature/registry.h"

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <gp_Pln.hxx>

#include "feature/acceptance.h"
#include "feature/frame_keys.h"
#include "geometry/planar/planar.h"
#include "support/support.h"

using namespace blossom;

namespace {

enum class FeatureMode { Exact, Cubic };

struct Parameters {
  double t = 0.5;
  int copies = 3;
  FeatureMode mode = FeatureMode::Cubic;
  std::string title = "none";
  Vec3 axis{0, 0, 1};
  std::vector<double> widths{1, 2};
};

FeatureBuilder<Parameters> builder(std::string id = "test.thing") {
  using Fields = Parameters;
  auto b = feature<Fields>(std::move(id), "Thing", "A thing to test with.");
  b.parameter("t", &Fields::t, ratio(), "Where.")
      .parameter("copies", &Fields::copies, count(1), "How many.")
      .parameter("mode", &Fields::mode, choice({"exact", "cubic"}), "How.")
      .parameter("title", &Fields::title, text(), "Name.")
      .parameter("axis", &Fields::axis, blossom::vector(), "Direction.")
      .parameter("widths", &Fields::widths, list(number(0.0)), "Widths.");
  return b;
}

FeatureType thingType(std::string id = "test.thing") {
  return builder(std::move(id)).evaluate([](const Parameters& p, const Inputs&, const Progress&) -> Evaluated {
    return {Mesh{},
            {{"t", p.t},
             {"copies", p.copies},
             {"cubic", p.mode == FeatureMode::Cubic},
             {"title", p.title},
             {"z", p.axis.z()},
             {"sum", p.widths.at(0) + p.widths.at(1)}},
            {}};
  });
}

FeatureType withInputs(std::vector<InputSpec> inputs) {
  FeatureType type = thingType();
  type.title = "Morph";
  type.inputs = std::move(inputs);
  return type;
}

ParameterSpec namedWithDefault(ParameterSpec spec, std::string name, Value fallback) {
  spec.name = std::move(name);
  spec.help = "To test.";
  spec.fallback = std::move(fallback);
  return spec;
}

/// A closed circle.
Curves closedCircle() {
  Curves curves;
  curves.paths.push_back({{Arc2{Vec2(0, 0), 2, 0, 2 * M_PI}}, true, {}, {}});
  return curves;
}

std::string refusalOf(const std::function<void()>& work) {
  try {
    work();
  } catch (const Error& e) {
    return e.message();
  }
  return "nothing was thrown";
}

}  // namespace

class RegistryTest : public QObject {
  Q_OBJECT

 private slots:
  void aDeclarationCarriesDefaultsAndBinds() {
    const FeatureType type = thingType();
    QCOMPARE(type.command, std::string("thing"));
    const Value all = completed(type.parameters, {{"t", 1}, {"mode", "exact"}});
    QCOMPARE(all, (Value{{"t", 1.0},
                         {"copies", 3},
                         {"mode", "exact"},
                         {"title", "none"},
                         {"axis", {0.0, 0.0, 1.0}},
                         {"widths", {1.0, 2.0}}}));
    const Evaluated made = type.evaluate(all, Inputs(), Progress::none());
    QCOMPARE(made.stats, (Value{{"t", 1.0}, {"copies", 3}, {"cubic", false}, {"title", "none"}, {"z", 1.0}, {"sum", 3.0}}));
  }

  void typesAreFoundByCommandAndId() {
    Registry registry;
    registry.addAll(thingType(), thingType("test.other"));
    QCOMPARE(registry.at("thing")->id, std::string("test.thing"));
    QCOMPARE(registry.at("test.other")->command, std::string("other"));
    QVERIFY(registry.find("nothing") == nullptr);
    try {
      (void)registry.at("thign");
      QFAIL("found");
    } catch (const Error& e) {
      QCOMPARE(e.code(), ErrorCode::NotFound);
      QCOMPARE(e.hint(), std::string("Did you mean thing?"));
    }
  }

  void contradictoryDeclarationsAreRefused() {
    Registry registry;
    registry.add(thingType());
    VERIFY_ERROR(registry.add(thingType()), ErrorCode::PluginBroken);
    const auto refused = [&](const std::function<void(FeatureType&)>& change) {
      FeatureType type = thingType("test.changed");
      change(type);
      VERIFY_ERROR(registry.add(type), ErrorCode::PluginBroken);
    };
    refused([](FeatureType& t) { t.command = "thing"; });
    refused([](FeatureType& t) { t.command = "Two Words"; });
    refused([](FeatureType& t) { t.id = "nodot"; });
    refused([](FeatureType& t) { t.evaluate = {}; });
    refused([](FeatureType& t) { t.summary = ""; });
    refused([](FeatureType& t) { t.parameters.push_back(t.parameters[0]); });
    refused([](FeatureType& t) { t.parameters[0].fallback = 2; });
    refused([](FeatureType& t) { t.parameters[0].name = "-t"; });
    refused([](FeatureType& t) { t.parameters[0].name = "json"; });
    refused([](FeatureType& t) { t.parameters[0].name = "no-copies"; });
    refused([](FeatureType& t) { t.parameters[2].choices.clear(); });
    const auto conditional = [&](std::size_t parameter, const std::string& choice, const std::vector<std::string>& values) {
      refused([&](FeatureType& t) { t.parameters[parameter] = onlyFor(t.parameters[parameter], choice, values); });
    };
    conditional(0, "nothing", {"cubic"});
    conditional(0, "copies", {"3"});  // no choice
    conditional(0, "mode", {"cubic", "square"});
    conditional(0, "mode", {});
    conditional(0, "", {"cubic"});
    conditional(2, "mode", {"cubic"});  // of itself
    refused([](FeatureType& t) {
      t.parameters[0] = onlyFor(t.parameters[0], "other", {"a"});
      t.parameters.push_back(onlyFor(namedWithDefault(choice({"a", "b"}), "other", "a"), "mode", {"cubic"}));
    });
    refused([](FeatureType& t) { t.parameters[5].fields[0] = onlyFor(t.parameters[5].fields[0], "mode", {"cubic"}); });
    const auto filled = [&](const ParameterSpec& list) {
      refused([&](FeatureType& t) {
        t.inputs = {{"base", "", {}, 1, anyNumber}};
        t.parameters.push_back(namedWithDefault(list, "each", Value::array()));
      });
    };
    filled(onePer(list(number()), "other"));               // no input
    filled(onePer(list(number()), "base", 0, "nothing"));  // no parameter
    filled(onePer(list(number()), "base", 0, "mode"));     // of another kind
    filled(onePer(number(), "base"));                      // no list
    filled(list(onePer(list(number()), "other")));         // items of it
    filled(list(list(onePer(list(number()), "base"))));    // items of items
    filled(record({namedWithDefault(onePer(list(number()), "base"), "inner", Value::array())}));
    refused([](FeatureType& t) { t.inputs.push_back({"shape", "", {}, 2, 1}); });
    const InputSpec edited{.name = "shape", .help = "", .kinds = {}, .use = InputUse::Edited};
    refused([&](FeatureType& t) { t.inputs = {edited, {"other", "", {}}}; });
    refused([&](FeatureType& t) {
      t.inputs = {edited};
      t.inputs.front().maximum = 2;
    });
    refused([](FeatureType& t) { t.inputByFlags.asks = "title"; });
    refused([](FeatureType& t) {
      t.produces = {ShapeKind::Mesh};
      t.inputByFlags.asks = "words";
    });
    refused([](FeatureType& t) {
      t.produces = {ShapeKind::Mesh};
      t.inputByFlags = {.asks = "title", .plain = {"font"}};
    });
    refused([](FeatureType& t) {
      t.produces = {ShapeKind::Mesh};
      t.inputByFlags.asks = "title";
      t.inputs.push_back({"shape", "", {}});
    });
    QCOMPARE(registry.types().size(), std::size_t{1});
  }

  void parametersMayApplyWithOrWithoutAnInput() {
    for (const char* name : {"shape", "nothing"}) {
      for (const std::size_t minimum : {std::size_t{0}, std::size_t{1}}) {
        Registry registry;
        FeatureType type = thingType();
        type.inputs = {{.name = "shape", .help = "A shape.", .kinds = {ShapeKind::Mesh}, .minimum = minimum}};
        type.parameters[0] = onlyWith(type.parameters[0], name);
        if (name == std::string("shape") && minimum == 0)
          registry.add(type);
        else
          VERIFY_ERROR(registry.add(type), ErrorCode::PluginBroken);
      }
    }
  }

  void parametersMayApplyForSomeValuesOfAChoice() {
    Registry registry;
    FeatureType type = thingType();
    for (const std::size_t parameter : {0, 1, 3, 4, 5})
      type.parameters[parameter] = onlyFor(type.parameters[parameter], "mode", {"exact"});
    registry.add(type);
    const auto& specs = registry.at("test.thing")->parameters;
    for (const ParameterSpec& spec : specs) {
      QCOMPARE(applies(spec, specs, {{"mode", "cubic"}}), spec.name == "mode");
      QVERIFY(applies(spec, specs, {{"mode", "exact"}}));
    }
    // The evaluation gets what is given all the same.
    const Value all = completed(specs, {{"mode", "cubic"}, {"copies", 7}});
    QCOMPARE(registry.at("thing")->evaluate(all, Inputs(), Progress::none()).stats["copies"], Value(7));
    type = thingType("test.named");
    type.parameters[0] = onlyFor(type.parameters[0], "mode", {"square"});
    QCOMPARE(refusalOf([&] { registry.add(type); }),
             std::string("The parameter \"t\" of test.named applies only for \"square\", which \"mode\" does not offer."));
  }

  void regionsMayComeAsCurvesOrFlatFaces() {
    const InputSpec region{.name = "profile", .help = "", .kinds = {ShapeKind::Region}};
    const Brep face(BRepBuilderAPI_MakeFace(gp_Pln(), 0, 3, 0, 2).Shape(), "sheet");
    const Brep solid(BRepPrimAPI_MakeBox(3, 2, 1).Shape(), "block");
    QVERIFY(accepts(region, closedCircle()));
    QVERIFY(accepts(region, face));
    QVERIFY(!accepts(region, solid));
    QVERIFY(!accepts(region, Mesh{}));
    QVERIFY(!accepts(region, Shape()));
    const Shape given[] = {face};
    const Inputs arranged = arrangedInputs(withInputs({region}), given);
    COMPARE_NEAR(area(arranged.get<Region>()), 6, 1e-12);
    const Shape wrong[] = {solid};
    QCOMPARE(refusalOf([&] { static_cast<void>(arrangedInputs(withInputs({region}), wrong)); }),
             std::string("The input \"profile\" of Morph takes a region; it got a solid or faces."));
    QVERIFY(accepts({.name = "any", .help = "", .kinds = {}}, solid));
  }

  void resultsAreOfTheKindsDeclared() {
    FeatureType type = thingType();
    checkResult(type, Mesh{});  // it declares none: any will do
    VERIFY_ERROR(checkResult(type, Shape()), ErrorCode::Internal);
    type.produces = {ShapeKind::Region, ShapeKind::Curves};
    checkResult(type, closedCircle());
    checkResult(type, Sequence{{closedCircle(), closedCircle()}, {0, 1}});
    VERIFY_ERROR(checkResult(type, Sequence{{closedCircle(), Mesh{}}, {0, 1}}), ErrorCode::Internal);
    QCOMPARE(refusalOf([&] { checkResult(type, Mesh{}); }),
             std::string("Thing made a mesh and declares that it gives a region or curves."));
  }

  void mergingIsAllOrNothing() {
    Registry registry, good, bad;
    registry.add(thingType());
    good.addAll(thingType("good.a"), thingType("good.b"));
    bad.addAll(thingType("bad.a2"), thingType("bad.thing"));
    registry.merge(good);
    QCOMPARE(registry.types().size(), std::size_t{3});
    VERIFY_ERROR(registry.merge(bad), ErrorCode::PluginBroken);
    QCOMPARE(registry.types().size(), std::size_t{3});
    QVERIFY(registry.find("bad.a2") == nullptr);
  }

  void aTypeOpensAKindOfShape() {
    const auto opener = [](std::string id, ShapeKind kind) {
      FeatureType type = thingType(std::move(id));
      type.inputs = {{.name = "given", .help = "What was read.", .kinds = {kind}}};
      type.opens = kind;
      return type;
    };
    Registry registry;
    registry.addAll(thingType(), opener("test.turn", ShapeKind::Motion), opener("test.again", ShapeKind::Motion));
    QCOMPARE(registry.opening(ShapeKind::Motion)->id, std::string("test.turn"));
    QVERIFY(!registry.opening(ShapeKind::Mesh));
    QVERIFY(!registry.opening(ShapeKind::None));
    // It must be content with what was read.
    const auto refused = [&](const std::function<void(FeatureType&)>& change) {
      FeatureType type = opener("test.changed", ShapeKind::Mesh);
      change(type);
      VERIFY_ERROR(registry.add(type), ErrorCode::PluginBroken);
    };
    refused([](FeatureType& t) { t.inputs.clear(); });
    refused([](FeatureType& t) { t.inputs[0].minimum = 2, t.inputs[0].maximum = 3; });
    refused([](FeatureType& t) { t.inputs[0].kinds = {ShapeKind::Motion}; });
    refused([](FeatureType& t) { t.inputs.push_back({"more", "", {ShapeKind::Mesh}}); });
    refused([](FeatureType& t) { t.parameters[0].fallback = nullptr; });
    registry.add(opener("test.changed", ShapeKind::Mesh));
    QCOMPARE(registry.opening(ShapeKind::Mesh)->id, std::string("test.changed"));
  }

  void aTypePlaysByACount() {
    const auto player = [](const std::string& parameter, int frames) {
      FeatureType type = thingType("test.player");
      type.playedBy = {.parameter = parameter, .frames = frames};
      return type;
    };
    Registry registry;
    VERIFY_ERROR(registry.add(player("nothing", 25)), ErrorCode::PluginBroken);
    VERIFY_ERROR(registry.add(player("t", 25)), ErrorCode::PluginBroken);
    VERIFY_ERROR(registry.add(player("copies", 1)), ErrorCode::PluginBroken);
    registry.add(player("copies", 25));
    // Keys are a list as the timeline reads it.
    FeatureType keyed = player("copies", 25);
    keyed.id = "test.keyed";
    keyed.command = "keyed";
    keyed.playedBy.keys = "widths";
    VERIFY_ERROR(registry.add(keyed), ErrorCode::PluginBroken);
    keyed.playedBy.keys = "keys";
    keyed.parameters.push_back(namedWithDefault(frameKeys(), "keys", Value::array()));
    registry.add(keyed);
    FeatureType excluded = player("copies", 25);
    excluded.id = "test.excluded";
    excluded.command = "excluded";
    excluded.playedBy.excludedBy = "t";
    VERIFY_ERROR(registry.add(excluded), ErrorCode::PluginBroken);
  }

  void aPreviewIsACountFrom0() {
    const auto previewed = [](const std::string& parameter) {
      FeatureType type = thingType("test.previewed");
      type.previewedBy = parameter;
      return type;
    };
    Registry registry;
    VERIFY_ERROR(registry.add(previewed("nothing")), ErrorCode::PluginBroken);
    VERIFY_ERROR(registry.add(previewed("t")), ErrorCode::PluginBroken);
    FeatureType quick = previewed("cells");
    quick.parameters.push_back(namedWithDefault(count(0, 200), "cells", 0));
    registry.add(quick);
  }

  void aTakenFrameIsACountFrom1OfAnInput() {
    const auto taking = [](const std::string& parameter, int from) {
      FeatureType type = thingType("test.taking");
      type.inputs = {{.name = "sequence", .help = "A sequence.", .kinds = {ShapeKind::Sequence}}};
      type.parameters.push_back(namedWithDefault(count(from, 200), "frame", 1));
      type.takesFrame = parameter;
      return type;
    };
    Registry registry;
    VERIFY_ERROR(registry.add(taking("nothing", 1)), ErrorCode::PluginBroken);
    VERIFY_ERROR(registry.add(taking("frame", 0)), ErrorCode::PluginBroken);
    FeatureType lonely = taking("frame", 1);
    lonely.inputs.clear();
    VERIFY_ERROR(registry.add(lonely), ErrorCode::PluginBroken);
    registry.add(taking("frame", 1));
  }

  void aDeclarationIsReplacedInItsPlace() {
    Registry registry;
    registry.addAll(thingType(), thingType("test.other"));
    FeatureType changed = thingType();
    changed.title = "Changed";
    registry.replace(changed);
    QCOMPARE(registry.types().size(), std::size_t{2});
    QCOMPARE(registry.types()[0]->title, std::string("Changed"));
    changed.command = "other";
    VERIFY_ERROR(registry.replace(changed), ErrorCode::PluginBroken);
    VERIFY_ERROR(registry.replace(thingType("test.none")), ErrorCode::PluginBroken);
  }

  void formatsAreChecked() {
    const auto format = [] {
      Format made;
      made.id = "dots";
      made.title = "Dots";
      made.extensions = {"dot", "dots"};
      made.readOptions = {namedWithDefault(count(1), "size", 3)};
      made.read = [](const auto&, const auto&, const auto&) { return Imported(); };
      return made;
    };
    Registry registry;
    registry.add(format());
    QCOMPARE(registry.formats().find("DOT")->id, std::string("dots"));
    const auto refused = [&](const std::function<void(Format&)>& change) {
      Format other = format();
      other.id = "other";
      other.extensions = {"other"};
      change(other);
      VERIFY_ERROR(registry.add(other), ErrorCode::PluginBroken);
    };
    refused([](Format& f) { f.id = "dots"; });
    refused([](Format& f) { f.id = "Two Words"; });
    refused([](Format& f) { f.id = "json"; });
    refused([](Format& f) { f.id = "file"; });  // a parameter of the import
    refused([](Format& f) { f.id = "3d"; });    // with options it is one, too
    refused([](Format& f) { f.title.clear(); });
    refused([](Format& f) { f.extensions.clear(); });
    refused([](Format& f) { f.extensions = {"dot"}; });
    refused([](Format& f) { f.extensions = {".other"}; });
    refused([](Format& f) { f.extensions = {"blossom"}; });
    refused([](Format& f) { f.read = {}; });
    refused([](Format& f) { f.writes = {ShapeKind::Mesh}; });
    refused([](Format& f) { f.readOptions[0].fallback = 0; });
    refused([](Format& f) { f.readOptions.push_back(f.readOptions[0]); });
    QCOMPARE(registry.formats().formats().size(), std::size_t{1});
    // All or nothing.
    Registry second;
    second.addAll(thingType(), format());
    VERIFY_ERROR(registry.merge(second), ErrorCode::PluginBroken);
    QVERIFY(registry.types().empty());
  }

  void literalsGoByTheirName() {
    Registry registry;
    registry.add(LiteralForm{"dot", "dot:NAME", "A mesh of nothing.", [](std::string_view text) {
                               Mesh mesh;
                               mesh.name = text;
                               return Shape(mesh);
                             }});
    QCOMPARE(registry.literal("dot:a:b").get<Mesh>()->name, std::string("a:b"));
    QCOMPARE(registry.literal("dot").get<Mesh>()->name, std::string());
    QVERIFY(registry.literal("dots:1").empty());
    VERIFY_ERROR(registry.add(LiteralForm{"dot", "", "", [](std::string_view) { return Shape(); }}),
                 ErrorCode::PluginBroken);
  }

  void closedCurvesBecomeARegion() {
    const auto type = withInputs({{"shape", "", {ShapeKind::Region}, 1, 1}});
    const std::vector<Shape> given{closedCircle()};
    QCOMPARE(arrangedInputs(type, given).get<Region>().loops.size(), std::size_t{1});
    const auto curves = withInputs({{"shape", "", {ShapeKind::Region, ShapeKind::Curves}, 1, 1}});
    QCOMPARE(arrangedInputs(curves, given).of(0)[0].kind(), ShapeKind::Curves);
    Curves open;
    open.paths.push_back({{Line2{Vec2(0, 0), Vec2(1, 0)}}, false, {}, {}});
    VERIFY_ERROR(arrangedInputs(type, std::vector<Shape>{open}), ErrorCode::InvalidInput);
  }

  void inputsOfTheWrongKindOrNumberAreNamed() {
    const auto type = withInputs({{"shape", "", {ShapeKind::Region}, 2, anyNumber}});
    QCOMPARE(refusalOf([&] {
               arrangedInputs(type, std::vector<Shape>{Region{}, Mesh{}});
             }),
             std::string("The input \"shape\" of Morph takes a region; it got a mesh."));
    QCOMPARE(refusalOf([&] {
               arrangedInputs(type, std::vector<Shape>{Region{}, Shape()});
             }),
             std::string("The input \"shape\" of Morph takes a region; it got nothing."));
    QCOMPARE(refusalOf([&] { arrangedInputs(type, std::vector<Shape>{Region{}}); }),
             std::string("Morph takes at least 2 \"shape\" as input; it got 1."));
    QCOMPARE(refusalOf([&] { arrangedInputs(withInputs({}), std::vector<Shape>{Region{}}); }),
             std::string("Morph takes no input; it got 1."));
  }

  void runsOfInputsLeaveEnoughForTheRest() {
    const auto type = withInputs({{"shape", "", {ShapeKind::Region}, 1, anyNumber},
                                  {"guide", "", {ShapeKind::Curve}, 0, 1},
                                  {"base", "", {ShapeKind::Mesh}, 1, 1}});
    const auto counts = [&](const std::vector<Shape>& given) {
      const Inputs inputs = arrangedInputs(type, given);
      return std::vector<std::size_t>{inputs.of(0).size(), inputs.of(1).size(), inputs.of(2).size()};
    };
    const Curve line{1, {0, 0, 1, 1}, {{0, 0, 0, 1}, {1, 0, 0, 1}}};
    QCOMPARE(counts({Region{}, Region{}, Mesh{}}), (std::vector<std::size_t>{2, 0, 1}));
    QCOMPARE(counts({Region{}, line, Mesh{}}), (std::vector<std::size_t>{1, 1, 1}));
    VERIFY_ERROR(counts({Region{}, line, line, Mesh{}}), ErrorCode::InvalidInput);
    VERIFY_ERROR(counts({Mesh{}, Mesh{}}), ErrorCode::InvalidInput);
  }
};

BLOSSOM_TEST(RegistryTest)
#include "registry_test.moc"
