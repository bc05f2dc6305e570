#include "ui/panel/property_panel.h"

#include <QApplication>
#include <QClipboard>
#include <QColorDialog>
#include <QComboBox>
#include <QDropEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMimeData>
#include <QTemporaryDir>
#include <QToolButton>
#include <atomic>
#include <condition_variable>
#include <mutex>

#include "app/app.h"
#include "support/support.h"
#include "ui/fields/chip.h"
#include "ui/fields/curve_editor.h"
#include "ui/fields/field_label.h"
#include "ui/fields/list_field.h"
#include "ui/fields/list_row.h"
#include "ui/fields/swatch.h"
#include "ui/look/text.h"
#include "ui/look/theme.h"
#include "ui/panel/input_editor.h"
#include "ui/panel/parameter_field.h"
#include "ui/panel/ratio_slider.h"
#include "ui/panel/result_table.h"
#include "ui/tool.h"
#include "ui/window/application.h"
#include "ui/window/session.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

/// What the evaluation of the made-up feature meets: it can be held up, and counts.
struct Gate {
  std::mutex mutex;
  std::condition_variable changed;
  bool closed = false;
  int entered = 0, inside = 0, mostInside = 0;

  void pass(const Progress& progress) {
    std::unique_lock lock(mutex);
    ++entered;
    mostInside = std::max(mostInside, ++inside);
    changed.notify_all();
    changed.wait(lock, [&] { return !closed || progress.cancelled(); });
    --inside;
  }
  void close() {
    const std::lock_guard lock(mutex);
    closed = true;
    entered = 0;
  }
  void open() {
    const std::lock_guard lock(mutex);
    closed = false;
    changed.notify_all();
  }
  int count() {
    const std::lock_guard lock(mutex);
    return entered;
  }
};
Gate gate;

Mesh triangle() {
  Mesh mesh;
  mesh.points = {Vec3(0, 0, 0), Vec3(10, 0, 0), Vec3(0, 10, 0)};
  const std::vector<int> corners{0, 1, 2};
  mesh.addFace(corners);
  return mesh;
}

ParameterSpec declared(std::string name, ParameterSpec spec, Value fallback = {}) {
  spec.name = std::move(name);
  spec.help = "What it is for.";
  spec.fallback = std::move(fallback);
  return spec;
}

ParameterSpec tool() {
  return record({declared("diameter", positiveLength(), 6.0), declared("shape", choice({"flat", "ball"}), "flat"),
                 declared("at", point(), Value::array({0.0, 0.0, 0.0}))});
}

/// A parameter of every kind there is.
FeatureType everything() {
  FeatureType type;
  type.id = "test.everything";
  type.command = "everything";
  type.title = "Everything";
  type.summary = "A feature with a parameter of every kind.";
  type.inputs = {{.name = "base", .help = "What it stands on.", .kinds = {ShapeKind::Mesh}, .least = 1, .most = 1},
                 {.name = "others", .help = "More of it.", .kinds = {ShapeKind::Mesh}, .least = 0, .most = anyNumber}};
  const Value origin = Value::array({0.0, 0.0, 0.0});
  type.parameters = {declared("flag", flag(), false),
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
                     declared("file", optional(file("json"))),
                     declared("curve", controlCurve(), Value::parse("[[0.0,0.5],[1.0,0.5]]")),
                     declared("face", optional(subShape("face"))),
                     declared("edges", list(subShape("edge")), Value::array()),
                     declared("lengths", list(blossom::length()), Value::array({1.0, 2.0, 3.0})),
                     declared("points", list(point()), Value::array()),
                     declared("tools", list(tool()), Value::array()),
                     declared("pin", tool(), Value{{"diameter", 3.0}, {"shape", "ball"}, {"at", origin}}),
                     declared("limit", optional(blossom::length()))};
  type.parameters[15].least = 1;
  type.evaluate = [](const Value& values, const Inputs&, const Progress& progress) {
    gate.pass(progress);
    progress.check();
    if (values.at("length").get<double>() > 1000)
      throw Error(ErrorCode::InvalidParameter, "length must fit the base; it is far too long.", "Take at most 1000 mm.");
    if (values.at("angle").get<double>() == 13) throw Error(ErrorCode::Degenerate, "It folds over.", "Turn it back.");
    Evaluated out;
    out.shape = triangle();
    out.stats["chosen_mm"] = 12.25;
    if (values.at("flag").get<bool>()) out.warnings.push_back("The flag is up.");
    return out;
  };
  return type;
}

FeatureType source() {
  FeatureType type;
  type.id = "test.source";
  type.command = "source";
  type.title = "Source";
  type.summary = "A triangle.";
  type.parameters = {declared("size", positiveLength(), 10.0)};
  type.evaluate = [](const Value&, const Inputs&, const Progress&) {
    Evaluated out;
    out.shape = triangle();
    return out;
  };
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

Feature made(const std::string& id, const std::string& type, const std::string& name, std::vector<FeatureId> inputs = {}) {
  Feature feature;
  feature.id = id;
  feature.type = type;
  feature.name = name;
  feature.inputs = std::move(inputs);
  return feature;
}

QPoint middle(const QWidget* widget) { return widget->rect().center(); }

}  // namespace

class PropertyPanelTest : public QObject {
  Q_OBJECT
 private slots:
  void initTestCase();
  void init();
  void cleanup();
  void everyKindHasAFieldThatFits();
  void expressionsAreTyped();
  void aWrongValueIsKeptOut();
  void escapeTakesBackWhatIsTyped();
  void keysAndWheelStepAsOneEdit();
  void labelsAreScrubbed();
  void escapeEndsAScrub();
  void ratiosAreDragged();
  void flagsChoicesAndTexts();
  void coloursAreTypedAndChosen();
  void pointsAndVectors();
  void filesAreDroppedAndWritten();
  void curvesAreDrawn();
  void subShapesArePicked();
  void listsAreEdited();
  void listsOfRecords();
  void recordsAreGroups();
  void optionalValuesAreCleared();
  void valuesGoBackToTheirDefault();
  void draggingNeverQueuesUp();
  void inputsAreReplacedAddedAndRemoved();
  void circlesAndWrongKindsAreRefused();
  void errorsStandAtTheirField();
  void resultsAreShownAndCopied();
  void namesAreTypedOver();
  void whatIsTypedIsNotLostWithTheSelection();
  void tabGoesThroughTheFields();
  void longListsAreShownBitByBit();

 private:
  ParameterField* field(const char* name) const { return panel_->field(QLatin1String(name)); }
  template <class T>
  T* editor(const char* name) const {
    return field(name)->findChild<T*>();
  }
  QToolButton* pickButton(const char* name) const {
    return field(name)->findChild<QToolButton*>(QStringLiteral("fieldButton"));
  }
  [[nodiscard]] Value now(const char* name) const;
  void oneStep(const char* name, const Value& wanted, const std::function<void()>& edit);
  void type(QLineEdit*, const QString&);
  void settle() { QTRY_VERIFY(!session_->evaluating()); }
  FieldLabel* labelOf(const char* name) const { return field(name)->findChild<FieldLabel*>(); }
  Pick pickOf(SubShapeKind kind, int index, const FeatureId& feature = "a") const;

  std::unique_ptr<Session> session_;
  std::unique_ptr<PropertyPanel> panel_;
  QTemporaryDir folder_;
};

void PropertyPanelTest::initTestCase() {
  setUpApplication();
  ThemeManager::instance().apply(ThemeChoice::Dark);
}

void PropertyPanelTest::init() {
  auto registry = std::make_shared<Registry>();
  registry->addAll(everything(), source(), outline(), follower());
  App app;
  app.registry = registry;
  session_ = std::make_unique<Session>(app);
  session_->commit(
      Document::of({made("a", "test.source", "Plate"), made("b", "test.source", "Bolt"), made("m", "test.outline", "Path"),
                    made("e", "test.everything", "All", {"a"}), made("f", "test.follower", "After", {"e"})}),
      QStringLiteral("Begin"));
  panel_ = std::make_unique<PropertyPanel>(*session_);
  panel_->resize(262, 700);
  panel_->show(FeatureId("e"));
  static_cast<QWidget*>(panel_.get())->show();
  QVERIFY(QTest::qWaitForWindowExposed(panel_.get()));
  QApplication::setActiveWindow(panel_.get());
  settle();
}

void PropertyPanelTest::cleanup() {
  gate.open();
  panel_.reset();
  session_.reset();
}

Value PropertyPanelTest::now(const char* name) const {
  const Feature& feature = session_->document().at("e");
  const auto type = session_->app().registry->at(feature.type);
  return completed(type->parameters, feature.parameters).at(name);
}

// The edit arrives in the document, is one step of undo, and is shown again after undo and redo.
void PropertyPanelTest::oneStep(const char* name, const Value& wanted, const std::function<void()>& edit) {
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

void PropertyPanelTest::type(QLineEdit* line, const QString& text) {
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, text);
  QTest::keyClick(line, Qt::Key_Return);
}

Pick PropertyPanelTest::pickOf(SubShapeKind kind, int index, const FeatureId& feature) const {
  Pick pick;
  pick.feature = feature;
  pick.part.kind = kind;
  pick.part.index = index;
  pick.part.point = Vec3(1, 2.5, -3);
  pick.part.normal = Vec3(0, 1, 0);
  return pick;
}

void PropertyPanelTest::everyKindHasAFieldThatFits() {
  for (const ParameterSpec& spec : everything().parameters) {
    const ParameterField* made = panel_->field(qt(spec.name));
    QVERIFY2(made && made->isVisible(), spec.name.c_str());
    QVERIFY2(made->value() == spec.fallback, spec.name.c_str());
    QVERIFY2(made->minimumSizeHint().width() <= 210,
             qPrintable(qt(spec.name) + QString::number(made->minimumSizeHint().width())));
    QVERIFY2(made->geometry().right() <= panel_->viewport()->width(), spec.name.c_str());
  }
  // However much is in the lists, nothing is wider than the narrowest side.
  Feature feature = session_->document().at("e");
  feature.inputs = {"a", "b", "b"};
  feature.parameters["points"] = Value::parse("[[-1234.5678,2,3],[4,5,6]]");
  feature.parameters["tools"] = Value::array({now("pin"), now("pin")});
  feature.parameters["face"] = Value{{"input", "base"}, {"kind", "face"}, {"index", 123456}};
  session_->commit(session_->document().with(feature), QStringLiteral("Fill"));
  static_cast<ListField*>(field("tools"))->rows()[0]->open(true);
  panel_->resize(230, 700);
  settle();
  QTRY_COMPARE(panel_->widget()->width(), panel_->viewport()->width());
}

void PropertyPanelTest::expressionsAreTyped() {
  auto* length = editor<QLineEdit>("length");
  oneStep("length", 72.7, [&] { type(length, QStringLiteral("1/2 in + 3*(2 cm)")); });
  QCOMPARE(length->text(), QStringLiteral("72.7 mm"));
  oneStep("angle", parseText(declared("angle", angle()), "pi/4 rad + 1"),
          [&] { type(editor<QLineEdit>("angle"), QStringLiteral("pi/4 rad + 1")); });
  oneStep("number", std::sqrt(2.0), [&] { type(editor<QLineEdit>("number"), QStringLiteral("sqrt(2)")); });
  oneStep("count", 12, [&] { type(editor<QLineEdit>("count"), QStringLiteral("3*4")); });
  oneStep("ratio", 0.75, [&] {
    auto* slider = editor<RatioSlider>("ratio");
    slider->setFocus();
    QTest::keyClick(slider, Qt::Key_F2);
    type(slider, QStringLiteral("3/4"));
  });
}

void PropertyPanelTest::aWrongValueIsKeptOut() {
  const std::string before = toJson(session_->document());
  const std::vector<std::pair<const char*, QString>> wrong{
      {"length", QStringLiteral("-3")}, {"length", QStringLiteral("3 apples")}, {"length", QStringLiteral("1/0")},
      {"count", QStringLiteral("2.5")}, {"count", QStringLiteral("21")},        {"number", QStringLiteral("3 mm")},
      {"angle", QStringLiteral("")},    {"color", QStringLiteral("no colour")}, {"file", QStringLiteral("/nowhere/x.json")}};
  for (const auto& [name, text] : wrong) {
    auto* line = editor<QLineEdit>(name);
    const Value kept = field(name)->value();
    line->setFocus();
    line->selectAll();
    QTest::keyClick(line, Qt::Key_Delete);
    QTest::keyClicks(line, text);
    QTest::keyClick(line, Qt::Key_Return);
    QVERIFY2(field(name)->problem().contains(QStringLiteral("kept")), qPrintable(QLatin1String(name) + text));
    QVERIFY(field(name)->problem().front().isUpper() || field(name)->problem().front() == u'"');
    QCOMPARE(field(name)->value(), kept);
    QCOMPARE(toJson(session_->document()), before);
    QTest::keyClick(line, Qt::Key_Escape);
    QVERIFY(field(name)->problem().isEmpty());
    QCOMPARE(line->text(), displayText(field(name)->spec(), kept));
  }
}

void PropertyPanelTest::escapeTakesBackWhatIsTyped() {
  const std::string before = toJson(session_->document());
  for (const char* name : {"length", "text", "color", "count"}) {
    auto* line = editor<QLineEdit>(name);
    const QString shown = line->text();
    line->setFocus();
    line->selectAll();
    QTest::keyClicks(line, QStringLiteral("7"));
    QVERIFY(field(name)->editing());
    QTest::keyClick(line, Qt::Key_Escape);
    QCOMPARE(line->text(), shown);
    QVERIFY(!field(name)->editing());
    line->clearFocus();
    QCOMPARE(toJson(session_->document()), before);
  }
}

void PropertyPanelTest::keysAndWheelStepAsOneEdit() {
  auto* length = editor<QLineEdit>("length");
  length->setFocus();
  oneStep("length", 13.0, [&] {
    for (int i = 0; i < 3; ++i) QTest::keyPress(length, Qt::Key_Up);  // held down
    QVERIFY(session_->history().undoText() == "Begin");
    QTRY_COMPARE(now("length"), Value(13.0));  // shown while it is held
    QTest::keyRelease(length, Qt::Key_Up);
  });
  oneStep("length", 12.9, [&] { QTest::keyClick(length, Qt::Key_Down, Qt::ShiftModifier); });
  auto* count = editor<QLineEdit>("count");
  count->setFocus();
  oneStep("count", 20, [&] {
    for (int i = 0; i < 9; ++i) QTest::keyPress(count, Qt::Key_PageUp);
    QTest::keyRelease(count, Qt::Key_PageUp);
  });
  const auto turn = [](QWidget* widget, int notches) {
    QWheelEvent wheel(middle(widget), widget->mapToGlobal(middle(widget)), {}, QPoint(0, 120 * notches), Qt::NoButton, {},
                      Qt::NoScrollPhase, false);
    QApplication::sendEvent(widget, &wheel);
  };
  auto* angle = editor<QLineEdit>("angle");
  turn(angle, 2);  // without the focus it scrolls
  settle();
  QCOMPARE(now("angle"), Value(45.0));
  angle->setFocus();
  turn(angle, 1);
  turn(angle, 2);
  QTRY_COMPARE(qt(session_->history().undoText()), QStringLiteral("Change angle of All"));
  QCOMPARE(now("angle"), Value(48.0));
  session_->undo();
  QCOMPARE(now("angle"), Value(45.0));
}

void PropertyPanelTest::labelsAreScrubbed() {
  FieldLabel* label = labelOf("length");
  const QPoint from = middle(label);
  oneStep("length", 20.0, [&] {
    QTest::mousePress(label, Qt::LeftButton, {}, from);
    for (int i = 1; i <= 20; ++i) QTest::mouseMove(label, from + QPoint(2 * i, 0));
    QTRY_COMPARE(now("length"), Value(20.0));
    QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Begin"));
    QTest::mouseRelease(label, Qt::LeftButton, {}, from + QPoint(40, 0));
  });
}

void PropertyPanelTest::escapeEndsAScrub() {
  const std::string before = toJson(session_->document());
  FieldLabel* label = labelOf("angle");
  const QPoint from = middle(label);
  QTest::mousePress(label, Qt::LeftButton, {}, from);
  QTest::mouseMove(label, from + QPoint(40, 0));
  QTRY_COMPARE(now("angle"), Value(55.0));
  QTest::keyClick(editor<QLineEdit>("angle"), Qt::Key_Escape);
  QCOMPARE(now("angle"), Value(45.0));
  QTest::mouseMove(label, from + QPoint(80, 0));
  QTest::mouseRelease(label, Qt::LeftButton, {}, from + QPoint(80, 0));
  settle();
  QCOMPARE(toJson(session_->document()), before);
  QCOMPARE(editor<QLineEdit>("angle")->text(), QStringLiteral("45°"));
}

void PropertyPanelTest::ratiosAreDragged() {
  auto* slider = editor<RatioSlider>("ratio");
  const auto at = [&](double share) { return QPoint(int(share * slider->width()), slider->height() / 2); };
  QTest::mousePress(slider, Qt::LeftButton, {}, at(0.3));
  QTest::mouseMove(slider, at(0.8));
  QTRY_VERIFY(now("ratio").get<double>() > 0.7);
  QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Begin"));
  QTest::keyClick(slider, Qt::Key_Escape);
  QTest::mouseRelease(slider, Qt::LeftButton, {}, at(0.8));
  QCOMPARE(now("ratio"), Value(0.25));
  oneStep("ratio", 1.0, [&] {
    QTest::mousePress(slider, Qt::LeftButton, {}, at(0.3));
    QTest::mouseMove(slider, at(0.5));
    QTest::mouseMove(slider, at(1.5));
    QTest::mouseRelease(slider, Qt::LeftButton, {}, at(1.5));
  });
  oneStep("ratio", 0.98, [&] {
    QTest::keyPress(slider, Qt::Key_Left);
    QTest::keyPress(slider, Qt::Key_Left);
    QTest::keyRelease(slider, Qt::Key_Left);
  });
}

void PropertyPanelTest::flagsChoicesAndTexts() {
  auto* box = editor<QCheckBox>("flag");
  oneStep("flag", true, [&] { QTest::mouseClick(box, Qt::LeftButton, {}, QPoint(10, box->height() / 2)); });
  oneStep("flag", false, [&] { QTest::keyClick(box, Qt::Key_Space); });
  oneStep("choice", "fine", [&] { QTest::keyClick(editor<QComboBox>("choice"), Qt::Key_Down); });
  oneStep("text", " a ; \"b\" ", [&] { type(editor<QLineEdit>("text"), QStringLiteral(" a ; \"b\" ")); });
}

void PropertyPanelTest::coloursAreTypedAndChosen() {
  auto* line = editor<QLineEdit>("color");
  oneStep("color", "#112233", [&] { type(line, QStringLiteral("#123")); });
  oneStep("color", "#4682b4", [&] { type(line, QStringLiteral("Steel blue")); });
  oneStep("color", "#00ff00", [&] {
    QTest::mouseClick(editor<Swatch>("color"), Qt::LeftButton);
    auto* dialog = editor<QColorDialog>("color");
    QVERIFY(dialog);
    dialog->setCurrentColor(QColor(QStringLiteral("#0000ff")));
    QTRY_COMPARE(now("color"), Value("#0000ff"));  // previewed
    dialog->setCurrentColor(QColor(QStringLiteral("#00ff00")));
    dialog->accept();
  });
}

void PropertyPanelTest::pointsAndVectors() {
  auto* y = field("point")->findChild<QLineEdit*>(QStringLiteral("y"));
  oneStep("point", Value::array({0.0, 25.4, 0.0}), [&] { type(y, QStringLiteral("1 in")); });
  type(y, QStringLiteral("3 deg"));
  QVERIFY(!field("point")->problem().isEmpty());
  QCOMPARE(now("point"), Value::array({0.0, 25.4, 0.0}));
  QTest::keyClick(y, Qt::Key_Escape);

  QSignalSpy wanted(panel_.get(), &PropertyPanel::pickWanted), ended(panel_.get(), &PropertyPanel::pickEnded);
  oneStep("point", Value::array({1.0, 2.5, -3.0}), [&] {
    QTest::mouseClick(pickButton("point"), Qt::LeftButton);
    QCOMPARE(wanted.size(), 1);
    QVERIFY(panel_->wanted() && panel_->wanted()->want == PickRequest::Want::Point);
    QCOMPARE(panel_->wanted()->parameter, QStringLiteral("point"));
    panel_->offerPick(pickOf(SubShapeKind::Whole, -1));
  });
  QCOMPARE(ended.size(), 1);
  QVERIFY(!panel_->wanted());
  oneStep("vector", Value::array({0.0, 1.0, 0.0}), [&] {
    pickButton("vector")->click();
    panel_->offerPick(pickOf(SubShapeKind::Face, 0));
  });
  // A second click on the button gives up.
  auto* button = pickButton("vector");
  button->click();
  button->click();
  QVERIFY(!panel_->wanted() && !button->isChecked());
}

void PropertyPanelTest::filesAreDroppedAndWritten() {
  const auto written = [&](const char* name) {
    QFile out(folder_.filePath(QLatin1String(name)));
    if (out.open(QIODevice::WriteOnly)) out.write("{}");
    return out.fileName();
  };
  const QString good = written("motion.json"), bad = written("motion.xyz");
  const auto drop = [&](const QString& path) {
    QMimeData data;
    data.setUrls({QUrl::fromLocalFile(path)});
    QDragEnterEvent enter(middle(field("file")), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(field("file"), &enter);
    QVERIFY(enter.isAccepted());
    QDropEvent event(middle(field("file")), Qt::CopyAction, &data, Qt::LeftButton, {});
    QApplication::sendEvent(field("file"), &event);
  };
  drop(bad);
  QVERIFY(field("file")->problem().contains(QStringLiteral("json")));
  QVERIFY(now("file").is_null());
  drop(good);
  QTRY_VERIFY(!now("file").is_null());
  QCOMPARE(qt(now("file").at("path").get<std::string>()), good);
  QVERIFY(!now("file").at("asset").get<std::string>().empty());  // its content is in the document
  QVERIFY(field("file")->problem().isEmpty());
  QCOMPARE(editor<QLineEdit>("file")->text(), QStringLiteral("motion.json"));
  session_->undo();
  QVERIFY(now("file").is_null());
}

void PropertyPanelTest::curvesAreDrawn() {
  auto* curve = editor<CurveEditor>("curve");
  panel_->ensureWidgetVisible(curve);
  const std::string before = toJson(session_->document());
  const QPoint where = curve->toPixels({0.5, 0.75}).toPoint();
  QTest::mousePress(curve, Qt::LeftButton, {}, where);
  QTRY_COMPARE(now("curve").size(), std::size_t(3));  // previewed
  QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Begin"));
  QTest::mouseRelease(curve, Qt::LeftButton, {}, where);
  COMPARE_NEAR(now("curve").at(1).at(0).get<double>(), 0.5, 0.01);
  COMPARE_NEAR(now("curve").at(1).at(1).get<double>(), 0.75, 0.01);
  session_->undo();
  QCOMPARE(toJson(session_->document()), before);
  session_->redo();
  curve->choose(1);
  type(field("curve")->findChild<QLineEdit*>(QStringLiteral("curveValue")), QStringLiteral("1/2"));
  type(field("curve")->findChild<QLineEdit*>(QStringLiteral("curveT")), QStringLiteral("1/4"));
  QCOMPARE(now("curve"), Value::parse("[[0.0,0.5],[0.25,0.5],[1.0,0.5]]"));
  const QPoint at = curve->toPixels({0.25, 0.5}).toPoint();
  QTest::mousePress(curve, Qt::LeftButton, {}, at);
  QTest::mouseMove(curve, at + QPoint(1000, 0));  // stops at its neighbour
  QTRY_COMPARE(now("curve").at(1).at(0), Value(1.0));
  QTest::keyClick(curve, Qt::Key_Escape);
  QTest::mouseRelease(curve, Qt::LeftButton, {}, at);
  QCOMPARE(now("curve").at(1).at(0), Value(0.25));
  oneStep("curve", Value::parse("[[0.0,0.5],[1.0,0.5]]"), [&] {
    curve->choose(1);
    QTest::keyClick(curve, Qt::Key_Delete);
  });
  curve->choose(1);
  oneStep("curve", Value::parse("[[0.0,0.5],[1.0,0.25]]"),
          [&] { type(field("curve")->findChild<QLineEdit*>(QStringLiteral("curveValue")), QStringLiteral("1/4")); });
  type(field("curve")->findChild<QLineEdit*>(QStringLiteral("curveT")), QStringLiteral("-1"));
  QVERIFY(!field("curve")->problem().isEmpty());
}

void PropertyPanelTest::subShapesArePicked() {
  const Value face{{"input", "base"}, {"kind", "face"}, {"index", 4}};
  auto* pickFace = pickButton("face");
  QSignalSpy wanted(panel_.get(), &PropertyPanel::pickWanted);
  oneStep("face", face, [&] {
    QTest::mouseClick(pickFace, Qt::LeftButton);
    QCOMPARE(wanted.size(), 1);
    QVERIFY(panel_->wanted()->kind == SubShapeKind::Face && panel_->wanted()->features == std::vector<FeatureId>{"a"});
    panel_->offerPick(pickOf(SubShapeKind::Edge, 4));
    QVERIFY(field("face")->problem().contains(QStringLiteral("edge")));
    panel_->offerPick(pickOf(SubShapeKind::Face, 4, "b"));
    QVERIFY(!field("face")->problem().isEmpty() && panel_->wanted());
    panel_->offerPick(pickOf(SubShapeKind::Face, 4));
    QVERIFY(!panel_->wanted());
  });
  QCOMPARE(editor<Chip>("face")->text(), QStringLiteral("Face 4 of Plate"));
  oneStep("face", Value(), [&] {
    editor<Chip>("face")->setFocus();
    QTest::keyClick(editor<Chip>("face"), Qt::Key_Delete);
  });

  const auto edge = [](int index) { return Value{{"input", "base"}, {"kind", "edge"}, {"index", index}}; };
  pickButton("edges")->click();
  oneStep("edges", Value::array({edge(1)}), [&] { panel_->offerPick(pickOf(SubShapeKind::Edge, 1)); });
  oneStep("edges", Value::array({edge(1), edge(2)}), [&] { panel_->offerPick(pickOf(SubShapeKind::Edge, 2)); });
  oneStep("edges", Value::array({edge(2)}), [&] { panel_->offerPick(pickOf(SubShapeKind::Edge, 1)); });
  QVERIFY(panel_->wanted());
  panel_->endPick();
  QVERIFY(!pickButton("edges")->isChecked());
  oneStep("edges", Value::array(), [&] {
    Chip* chip = editor<Chip>("edges");
    QTest::mouseClick(chip, Qt::LeftButton, {}, QPoint(chip->width() - 14, chip->height() / 2));
  });
}

void PropertyPanelTest::listsAreEdited() {
  auto* lengths = static_cast<ListField*>(field("lengths"));
  const auto add = [](const ListField* list) {
    for (auto* button : list->findChildren<QToolButton*>())
      if (button->property("role") == QStringLiteral("add")) return button;
    return static_cast<QToolButton*>(nullptr);
  };
  QCOMPARE(lengths->rows().size(), std::size_t(3));
  oneStep("lengths", Value::array({1.0, 20.0, 3.0}),
          [&] { type(lengths->rows()[1]->findChild<QLineEdit*>(), QStringLiteral("2 cm")); });
  oneStep("lengths", Value::array({1.0, 20.0, 3.0, 0.0}), [&] { add(lengths)->click(); });
  oneStep("lengths", Value::array({20.0, 1.0, 3.0, 0.0}), [&] { emit lengths->rows()[1]->moveWanted(-1); });
  oneStep("lengths", Value::array({20.0, 3.0, 0.0, 1.0}), [&] {
    // The number in front is dragged below the last row.
    auto* number = lengths->rows()[1]->findChild<QLabel*>(QStringLiteral("rowNumber"));
    QTest::mousePress(number, Qt::LeftButton, {}, middle(number));
    const QPoint below = number->mapFromGlobal(lengths->rows()[3]->mapToGlobal(QPoint(5, lengths->rows()[3]->height())));
    QTest::mouseMove(number, (middle(number) + below) / 2);
    QTest::mouseMove(number, below);
    QTest::mouseRelease(number, Qt::LeftButton, {}, below);
  });
  oneStep("lengths", Value::array({20.0, 0.0, 1.0}), [&] { emit lengths->rows()[1]->removeWanted(); });
  oneStep("lengths", Value::array({20.0, 20.0, 0.0, 1.0}), [&] { emit lengths->rows()[0]->copyWanted(); });
  type(lengths->rows()[0]->findChild<QLineEdit*>(), QStringLiteral("3 deg"));
  QVERIFY(!lengths->rows()[0]->field()->problem().isEmpty());
  QCOMPARE(now("lengths").at(0), Value(20.0));
  // It must keep one.
  for (int i = 0; i < 4; ++i) emit lengths->rows()[0]->removeWanted();
  QCOMPARE(now("lengths"), Value::array({1.0}));
  QVERIFY(lengths->problem().contains(QStringLiteral("at least 1 item")));

  auto* points = static_cast<ListField*>(field("points"));
  oneStep("points", Value::parse("[[0.0,0.0,0.0]]"), [&] { add(points)->click(); });
  oneStep("points", Value::parse("[[1.0,2.5,-3.0]]"), [&] {
    points->rows()[0]->field()->findChild<QToolButton*>(QStringLiteral("fieldButton"))->click();
    QCOMPARE(panel_->wanted()->parameter, QStringLiteral("points/0"));
    panel_->offerPick(pickOf(SubShapeKind::Vertex, 0));
  });
}

void PropertyPanelTest::listsOfRecords() {
  auto* tools = static_cast<ListField*>(field("tools"));
  const Value fresh{{"diameter", 6.0}, {"shape", "flat"}, {"at", Value::array({0.0, 0.0, 0.0})}};
  Value ball = fresh;
  ball["shape"] = "ball";
  oneStep("tools", Value::array({fresh}), [&] {
    for (auto* button : tools->findChildren<QToolButton*>())
      if (button->property("role") == QStringLiteral("add")) button->click();
  });
  ListRow* row = tools->rows()[0];
  row->open(true);
  QTRY_VERIFY(row->field() && row->field()->isVisible());
  oneStep("tools", Value::array({ball}), [&] { QTest::keyClick(row->findChild<QComboBox*>(), Qt::Key_Down); });
  row->findChild<QToolButton*>(QStringLiteral("rowTitle"))->click();
  QVERIFY(row->field()->isHidden());
  QVERIFY(row->findChild<QToolButton*>(QStringLiteral("rowTitle"))->text().contains(QStringLiteral("6 mm · ball")));
  row->open(true);
  auto* pick = row->findChild<QToolButton*>(QStringLiteral("fieldButton"));
  pick->click();
  QCOMPARE(panel_->wanted()->parameter, QStringLiteral("tools/0/at"));
  Value moved = ball;
  moved["at"] = Value::array({1.0, 2.5, -3.0});
  oneStep("tools", Value::array({moved}), [&] { panel_->offerPick(pickOf(SubShapeKind::Whole, -1)); });
  // Dragging inside of a record inside of a list is previewed and one step too.
  auto* label = row->field()->findChild<ParameterField*>(QStringLiteral("parameter:diameter"))->findChild<FieldLabel*>();
  Value wider = moved;
  wider["diameter"] = 16.0;
  oneStep("tools", Value::array({wider}), [&] {
    QTest::mousePress(label, Qt::LeftButton, {}, QPoint(5, 5));
    QTest::mouseMove(label, QPoint(25, 5));
    QTest::mouseMove(label, QPoint(45, 5));
    QTRY_COMPARE(now("tools").at(0).at("diameter"), Value(16.0));
    QTest::mouseRelease(label, Qt::LeftButton, {}, QPoint(45, 5));
  });
}

void PropertyPanelTest::recordsAreGroups() {
  Value wider = now("pin");
  wider["diameter"] = 50.8;
  auto* diameter = field("pin")->findChild<ParameterField*>(QStringLiteral("parameter:diameter"));
  oneStep("pin", wider, [&] { type(diameter->findChild<QLineEdit*>(), QStringLiteral("2\"")); });
  type(diameter->findChild<QLineEdit*>(), QStringLiteral("-1"));
  QVERIFY(!diameter->problem().isEmpty());
  QCOMPARE(now("pin"), wider);
  QTest::keyClick(diameter->findChild<QLineEdit*>(), Qt::Key_Escape);
  QVERIFY(diameter->problem().isEmpty());
}

void PropertyPanelTest::optionalValuesAreCleared() {
  auto* line = editor<QLineEdit>("limit");
  QVERIFY(line->text().isEmpty() && !line->placeholderText().isEmpty());
  oneStep("limit", 30.0, [&] { type(line, QStringLiteral("3 cm")); });
  oneStep("limit", Value(), [&] {
    line->setFocus();
    line->selectAll();
    QTest::keyClick(line, Qt::Key_Delete);
    QTest::keyClick(line, Qt::Key_Return);
  });
}

void PropertyPanelTest::valuesGoBackToTheirDefault() {
  type(editor<QLineEdit>("length"), QStringLiteral("12"));
  auto* reset = field("length")->findChild<QToolButton*>(QStringLiteral("fieldReset"));
  QTest::mouseMove(field("length"), middle(field("length")));
  oneStep("length", 10.0, [&] { reset->click(); });
  const std::string text = session_->history().undoText();
  field("length")->resetToDefault();  // nothing to do
  QCOMPARE(session_->history().undoText(), text);
}

// However fast the mouse goes: one evaluation is under way and the newest value waits for it.
void PropertyPanelTest::draggingNeverQueuesUp() {
  FieldLabel* label = labelOf("length");
  const QPoint from = middle(label);
  gate.close();
  QTest::mousePress(label, Qt::LeftButton, {}, from);
  for (int i = 1; i <= 100; ++i) QTest::mouseMove(label, from + QPoint(4 * i, 0));
  QTRY_COMPARE(gate.count(), 1);
  QCoreApplication::processEvents();
  QCOMPARE(gate.count(), 1);                                                // ninety-nine values later
  QCOMPARE(editor<QLineEdit>("length")->text(), QStringLiteral("110 mm"));  // the hand is ahead of the document
  QVERIFY(now("length").get<double>() < 20);
  gate.open();
  QTRY_COMPARE(now("length"), Value(110.0));
  settle();
  QCOMPARE(gate.count(), 2);
  QCOMPARE(gate.mostInside, 1);
  QTest::mouseRelease(label, Qt::LeftButton, {}, from + QPoint(400, 0));
  QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Change length of All"));
  session_->undo();
  QCOMPARE(now("length"), Value(10.0));
}

void PropertyPanelTest::inputsAreReplacedAddedAndRemoved() {
  const auto inputs = [&] { return session_->document().at("e").inputs; };
  using Ids = std::vector<FeatureId>;
  InputEditor* base = panel_->input(QStringLiteral("base"));
  InputEditor* others = panel_->input(QStringLiteral("others"));
  QVERIFY(base && others);
  QCOMPARE(base->findChildren<Chip*>().size(), 1);
  QCOMPARE(base->findChild<Chip*>()->text(), QStringLiteral("Plate"));
  others->take(0, "b");
  QCOMPARE(inputs(), (Ids{"a", "b"}));
  QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Change others of All"));
  settle();
  base->take(0, "b");
  QCOMPARE(inputs(), (Ids{"b", "b"}));
  session_->undo();
  QCOMPARE(inputs(), (Ids{"a", "b"}));

  // Picked in the view.
  QSignalSpy wanted(panel_.get(), &PropertyPanel::pickWanted);
  for (auto* button : base->findChildren<QToolButton*>())
    if (button->isCheckable()) button->click();
  QCOMPARE(wanted.size(), 1);
  QVERIFY(panel_->wanted()->want == PickRequest::Want::Feature);
  QCOMPARE(panel_->wanted()->features, (Ids{"b"}));
  panel_->offerPick(pickOf(SubShapeKind::Face, 0, "b"));
  QCOMPARE(inputs(), (Ids{"b", "b"}));
  QVERIFY(!panel_->wanted());

  // The last one of a run that may be empty is let go of by its cross.
  QTRY_COMPARE(others->findChildren<Chip*>().size(), 1);
  Chip* chip = others->findChild<Chip*>();
  chip->setFocus();
  QTest::keyClick(chip, Qt::Key_Delete);
  QCOMPARE(inputs(), (Ids{"b"}));
  // The one that is needed stays.
  Chip* needed = base->findChild<Chip*>();
  needed->setFocus();
  QTest::keyClick(needed, Qt::Key_Delete);
  QCOMPARE(inputs(), (Ids{"b"}));
}

void PropertyPanelTest::circlesAndWrongKindsAreRefused() {
  const std::string before = toJson(session_->document());
  InputEditor* others = panel_->input(QStringLiteral("others"));
  others->take(0, "f");
  QVERIFY2(others->problem().contains(QStringLiteral("circle")), qPrintable(others->problem()));
  others->take(0, "e");
  QVERIFY(others->problem().contains(QStringLiteral("circle")));
  others->take(0, "m");
  QVERIFY2(others->problem().contains(QStringLiteral("curve")), qPrintable(others->problem()));
  QCOMPARE(toJson(session_->document()), before);
  const FeatureType everyKind = everything();
  const InputSlots offered(*session_, session_->document().at("e"), everyKind);
  QCOMPARE(offered.candidates(0), std::vector<FeatureId>{"b"});
}

void PropertyPanelTest::errorsStandAtTheirField() {
  type(editor<QLineEdit>("length"), QStringLiteral("2 m"));
  settle();
  QCOMPARE(now("length"), Value(2000.0));  // the panel knows no such bound; the evaluation does
  QTRY_COMPARE(field("length")->problem(), QStringLiteral("Length must fit the base; it is far too long."));
  QVERIFY(panel_->findChild<QLabel*>(QStringLiteral("problemBox")));
  session_->undo();
  settle();
  QTRY_VERIFY(field("length")->problem().isEmpty());
  type(editor<QLineEdit>("angle"), QStringLiteral("13"));
  settle();
  QTRY_VERIFY(panel_->findChild<QLabel*>(QStringLiteral("problemBox")));
  QCOMPARE(panel_->findChild<QLabel*>(QStringLiteral("problemBox"))->text(), QStringLiteral("It folds over."));
  QVERIFY(field("angle")->problem().isEmpty());
}

void PropertyPanelTest::resultsAreShownAndCopied() {
  auto* table = panel_->findChild<ResultTable*>();
  const auto shown = [&](const QString& text) -> QLabel* {
    for (auto* label : table->findChildren<QLabel*>())
      if (!label->isHidden() && label->text() == text) return label;
    return nullptr;
  };
  QTRY_VERIFY(shown(QStringLiteral("Area")));
  QLabel* area = shown(QStringLiteral("50"));
  QVERIFY(area && shown(QStringLiteral("mm²")));
  QVERIFY(shown(QStringLiteral("12.25")) && shown(QStringLiteral("mm")));
  QSignalSpy told(panel_.get(), &PropertyPanel::hint);
  panel_->ensureWidgetVisible(area);
  QTest::mouseClick(area, Qt::LeftButton);
  QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("50"));
  QVERIFY(!told.isEmpty());
  QVERIFY(!shown(QStringLiteral("The flag is up.")));
  QTest::keyClick(editor<QCheckBox>("flag"), Qt::Key_Space);
  QTRY_VERIFY(shown(QStringLiteral("The flag is up.")));
}

void PropertyPanelTest::namesAreTypedOver() {
  auto* name = panel_->findChild<QLineEdit*>(QStringLiteral("featureNameEdit"));
  QCOMPARE(name->text(), QStringLiteral("All"));
  type(name, QStringLiteral("All of it"));
  QCOMPARE(session_->document().at("e").name, std::string("All of it"));
  QCOMPARE(qt(session_->history().undoText()), QStringLiteral("Rename All of it"));
  session_->undo();
  QCOMPARE(name->text(), QStringLiteral("All"));
  name->setFocus();
  QTest::keyClicks(name, QStringLiteral("x"));
  QTest::keyClick(name, Qt::Key_Escape);
  QCOMPARE(name->text(), QStringLiteral("All"));
  QSignalSpy manual(panel_.get(), &PropertyPanel::manualWanted);
  panel_->findChild<QToolButton*>(QStringLiteral("fieldButton"))->click();
  QCOMPARE(manual.size(), 1);
  QVERIFY(manual.front().front().toString().contains(QStringLiteral("test.everything")));
}

void PropertyPanelTest::whatIsTypedIsNotLostWithTheSelection() {
  auto* line = editor<QLineEdit>("length");
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, QStringLiteral("17"));
  panel_->show(FeatureId("a"));
  QCOMPARE(now("length"), Value(17.0));
  QVERIFY(session_->document().at("a").parameters.empty());
  QVERIFY(field("size") && !field("length"));
  panel_->show(FeatureId());
  QVERIFY(!field("size"));
  // A drag that was not let go is taken back.
  panel_->show(FeatureId("e"));
  settle();
  const std::string before = toJson(session_->document());
  QTest::mousePress(labelOf("length"), Qt::LeftButton, {}, QPoint(5, 5));
  QTest::mouseMove(labelOf("length"), QPoint(60, 5));
  QVERIFY(toJson(session_->document()) != before);
  panel_->show(FeatureId("b"));
  QCOMPARE(toJson(session_->document()), before);
}

void PropertyPanelTest::tabGoesThroughTheFields() {
  editor<QCheckBox>("flag")->setFocus();
  for (const char* name : {"count", "number", "ratio", "length", "angle", "choice", "text"}) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QVERIFY2(field(name)->isAncestorOf(QApplication::focusWidget()), name);
  }
}

void PropertyPanelTest::longListsAreShownBitByBit() {
  Feature feature = session_->document().at("e");
  Value many = Value::array();
  for (int i = 0; i < 1000; ++i) many.push_back(double(i));
  feature.parameters["lengths"] = many;
  session_->commit(session_->document().with(feature), QStringLiteral("Many"));
  auto* lengths = static_cast<ListField*>(field("lengths"));
  QVERIFY(lengths->rows().size() < 50);
  auto* more = lengths->findChild<QPushButton*>(QStringLiteral("link"));
  QVERIFY(more->isVisible());
  const std::size_t before = lengths->rows().size();
  more->click();
  QVERIFY(lengths->rows().size() > before);
  Value changed = many;
  changed[before] = 5.5;
  oneStep("lengths", changed, [&] { type(lengths->rows()[before]->findChild<QLineEdit*>(), QStringLiteral("5.5")); });
}

int main(int argc, char** argv) {
  prepareApplication();
  QApplication application(argc, argv);
  PropertyPanelTest test;
  return QTest::qExec(&test, argc, argv);
}
#include "property_panel_test.moc"
