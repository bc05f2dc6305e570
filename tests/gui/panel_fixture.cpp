#include "panel_fixture.h"

namespace blossom::ui {

ParameterSpec declared(std::string name, ParameterSpec spec, Value fallback) {
  spec.name = std::move(name);
  spec.help = "What it is for.";
  spec.fallback = std::move(fallback);
  return spec;
}

Feature made(const std::string& id, const std::string& type, const std::string& name, std::vector<FeatureId> inputs) {
  Feature feature;
  feature.id = id;
  feature.type = type;
  feature.name = name;
  feature.inputs = std::move(inputs);
  return feature;
}

namespace {

ParameterSpec atLeastOne(ParameterSpec list) {
  list.minimum = 1;
  return list;
}

FeatureType titled(const char* id, const char* command, const char* title, const char* summary) {
  FeatureType type;
  type.id = id;
  type.command = command;
  type.title = title;
  type.summary = summary;
  return type;
}

Evaluated triangle() {
  Mesh mesh;
  mesh.points = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 10, 0)};
  const std::vector<int> corners{0, 1, 2};
  mesh.addFace(corners);
  Evaluated out;
  out.shape = mesh;
  return out;
}

ParameterSpec tool() {
  return record({declared("diameter", positiveLength(), 6.0), declared("shape", choice({"flat", "ball"}), "flat"),
                 declared("at", point(), Value::array({0.0, 0.0, 0.0}))});
}

FeatureType source() {
  FeatureType type = titled("test.source", "source", "Source", "A triangle.");
  type.parameters = {declared("size", positiveLength(), 10.0)};
  type.evaluate = [](const Value&, const Inputs&, const Progress&) { return triangle(); };
  return type;
}

/// What a mesh does not fit.
FeatureType outline() {
  FeatureType type = source();
  type.id = "test.outline";
  type.command = "outline";
  type.evaluate = [](const Value&, const Inputs&, const Progress&) {
    Evaluated out;
    Curve line;
    line.degree = 1;
    line.knots = {0, 0, 1, 1};
    line.poles = {Vec4(0, 0, 0, 1), Vec4(10, 0, 0, 1)};
    out.shape = line;
    return out;
  };
  return type;
}

FeatureType follower() {
  FeatureType type = source();
  type.id = "test.follower";
  type.command = "follower";
  type.inputs = {{.name = "of", .help = "What it follows.", .kinds = {ShapeKind::Mesh}}};
  return type;
}

/// Something closed, so that it has a volume.
FeatureType cube() {
  FeatureType type = titled("test.cube", "cube", "Cube", "A cube.");
  type.parameters = {declared("size", positiveLength(), 10.0)};
  type.evaluate = [](const Value& values, const Inputs&, const Progress&) {
    const double s = values.at("size").get<double>();
    Mesh mesh;
    mesh.points = {{0, 0, 0}, {s, 0, 0}, {s, s, 0}, {0, s, 0}, {0, 0, s}, {s, 0, s}, {s, s, s}, {0, s, s}};
    mesh.faceVertices = {0, 3, 2, 1, 4, 5, 6, 7, 0, 1, 5, 4, 1, 2, 6, 5, 2, 3, 7, 6, 3, 0, 4, 7};
    mesh.faceStarts = {0, 4, 8, 12, 16, 20, 24};
    Evaluated out;
    out.shape = mesh;
    return out;
  };
  return type;
}

/// It takes a number for each shape after the first.
FeatureType blend() {
  FeatureType type = titled("test.blend", "blend", "Blend", "Something of several shapes.");
  type.inputs = {
      {.name = "shape", .help = "What is blended.", .kinds = {ShapeKind::Mesh}, .minimum = 2, .maximum = anyNumber}};
  type.parameters = {declared("t", ratio(), 0.25),
                     declared("levels", onePer(list(ratio()), "shape", -1, "t"), Value::array()),
                     declared("path", list(onePer(list(ratio()), "shape", -1, "t")), Value::array())};
  type.evaluate = [](const Value&, const Inputs&, const Progress&) { return triangle(); };
  return type;
}

/// Some of its fields are for some of its kinds.
FeatureType kinds() {
  FeatureType type = titled("test.kinds", "kinds", "Kinds", "One of several shapes.");
  type.parameters = {declared("kind", choice({"ball", "ring", "spring"}), "ball"),
                     declared("profile", onlyFor(positiveLength(), "kind", {"ring", "spring"}), 2.0),
                     declared("turns", onlyFor(number(-10, 10), "kind", {"spring"}), 3.0),
                     declared("radius", positiveLength(), 10.0)};
  type.evaluate = [](const Value& values, const Inputs&, const Progress&) {
    if (values.at("turns") == Value(0.0)) throw Error(ErrorCode::InvalidParameter, "turns must not be 0.", "Give more.");
    return triangle();
  };
  return type;
}

}  // namespace

void PanelFixture::setUpOnce() {
  QSettings::setDefaultFormat(QSettings::IniFormat);
  QSettings::setPath(QSettings::IniFormat, QSettings::UserScope, folder_.path());
  setUpApplication();
  ThemeManager::instance().apply(ThemeChoice::Dark);
}

void PanelFixture::openPanel() {
  auto registry = std::make_shared<Registry>();
  registry->addAll(everything(), source(), outline(), follower(), cube(), kinds(), blend());
  App app;
  app.registry = registry;
  app.formats = std::make_shared<FormatRegistry>();
  session_ = std::make_unique<Session>(app);
  session_->commit(
      Document::of({made("a", "test.source", "Plate"), made("b", "test.source", "Bolt"), made("m", "test.outline", "Path"),
                    made("e", "test.everything", "All", {"a"}), made("f", "test.follower", "After", {"e"})}),
      QStringLiteral("Begin"));
  panel_ = std::make_unique<PropertyPanel>(*session_);
  panel_->resize(262, 700);
  panel_->show(FeatureId("e"));
  static_cast<QWidget*>(panel_.get())->show();
  panel_->activateWindow();
  QVERIFY(QTest::qWaitForWindowActive(panel_.get()));
  settle();
}

void PanelFixture::closePanel() {
  gate_.open();
  panel_.reset();
  session_.reset();
  Preferences::instance().reset();
}

FeatureType PanelFixture::everything() {
  FeatureType all = titled("test.everything", "everything", "Everything", "A feature with a parameter of every kind.");
  all.inputs = {{.name = "base", .help = "What it stands on.", .kinds = {ShapeKind::Mesh}, .minimum = 1, .maximum = 1},
                {.name = "others", .help = "More of it.", .kinds = {ShapeKind::Mesh}, .minimum = 0, .maximum = anyNumber}};
  const Value origin = Value::array({0.0, 0.0, 0.0});
  all.parameters = {declared("flag", flag(), false),
                    declared("count", count(1, 20), 3),
                    declared("number", number(-5, 5), 1.0),
                    declared("ratio", ratio(), 0.25),
                    declared("length", positiveLength(), 10.0),
                    declared("angle", angle(), 45.0),
                    declared("choice", choice({"coarse", "medium", "fine"}), "medium"),
                    declared("text", text(), "Blossom"),
                    declared("color", color(), "#ff8800"),
                    declared("point", point(), origin),
                    declared("vector", blossom::vector(), Value::array({0.0, 0.0, 1.0})),
                    declared("shift", displacement(), Value::array({0.0, 25.4, 0.0})),
                    declared("file", optional(file("json"))),
                    declared("curve", controlCurve(), Value::parse("[[0.0,0.5],[1.0,0.5]]")),
                    declared("face", optional(subShape("face"))),
                    declared("edges", list(subShape("edge")), Value::array()),
                    declared("lengths", atLeastOne(list(blossom::length())), Value::array({1.0, 2.0, 3.0})),
                    declared("points", list(point()), Value::array()),
                    declared("tools", list(tool()), Value::array()),
                    declared("pin", tool(), Value{{"diameter", 3.0}, {"shape", "ball"}, {"at", origin}}),
                    declared("limit", optional(blossom::length()))};
  all.evaluate = [](const Value& values, const Inputs&, const Progress& progress) {
    gate_.pass(progress);
    progress.check();
    if (values.at("length").get<double>() > 1000)
      throw Error(ErrorCode::InvalidParameter, "length must fit the base; it is far too long.", "Take at most 1000 mm.");
    if (values.at("angle").get<double>() == 13) throw Error(ErrorCode::Degenerate, "It folds over.", "Turn it back.");
    Evaluated out = triangle();
    out.stats["chosen_mm"] = 12.25;
    if (values.at("flag").get<bool>()) out.warnings.push_back("The flag is up.");
    return out;
  };
  return all;
}

Value PanelFixture::now(const char* name) const {
  const Feature& feature = session_->document().at("e");
  const auto type = session_->app().registry->at(feature.type);
  return completed(type->parameters, feature.parameters).at(name);
}

void PanelFixture::oneStep(const char* name, const Value& wanted, const std::function<void()>& edit) {
  const Value before = now(name);
  const std::string document = toJson(session_->document());
  QVERIFY2(before != wanted, name);
  edit();
  QVERIFY2(now(name) == wanted, (std::string(name) + ": " + now(name).dump() + " instead of " + wanted.dump()).c_str());
  QVERIFY2(field(name)->value() == wanted, field(name)->value().dump().c_str());
  QVERIFY2(field(name)->problem().isEmpty(), qPrintable(field(name)->problem()));
  QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Change %1 of All").arg(QLatin1String(name)));
  session_->undo();
  QCOMPARE(toJson(session_->document()), document);
  QVERIFY2(field(name)->value() == before, name);
  session_->redo();
  QVERIFY2(field(name)->value() == wanted, name);
}

void PanelFixture::type(QLineEdit* line, const QString& text) {
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, text);
  QTest::keyClick(line, Qt::Key_Return);
}

void PanelFixture::settle() { QTRY_VERIFY(!session_->evaluating()); }

Pick PanelFixture::pickOf(SubShapeKind kind, int index, const FeatureId& feature) {
  Pick pick;
  pick.feature = feature;
  pick.part.kind = kind;
  pick.part.index = index;
  pick.part.point = Vec3(1, 2.5, -3);
  pick.part.normal = Vec3(0, 1, 0);
  return pick;
}

}  // namespace blossom::ui
