#include <QMenu>
#include <QMenuBar>

#include "ui/fields/parameter_field.h"
#include "ui/help/manual_pages.h"
#include "ui/look/text.h"
#include "ui/page/feature_menus.h"
#include "ui/panel/property_panel.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

/// The gear, its handle and the file format of the example plugin, built outside of the tree against the installed package,
/// are everywhere in the window although no line of the window knows them.
class ExamplePluginWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() {
    setUpOnce();
    plugin_ = test::buildFolder() / "tests/installed-plugin";
    QVERIFY2(std::filesystem::exists(plugin_ / "plugin.json"), "the test plugin/example builds the plugin");
  }
  void init() { openWindow({test::buildFolder() / "lib/blossom/plugins", plugin_}); }
  void cleanup() { window_.reset(); }
  void hasAMenuAndACommand();
  void isAddedEditedAndUndone();
  void hasAPageInTheManual();
  void itsHandleIsDraggedWhileTheAreaIsComputed();
  void itsFormatIsOpenedAndExported();

 private:
  FeatureId addGear() {
    gear()->trigger();
    waitUntilComputed();
    return last();
  }
  QAction* gear() { return window_->commands().find(QStringLiteral("feature.example.gear"))->action; }
  std::filesystem::path plugin_;
};

void ExamplePluginWindowTest::hasAMenuAndACommand() {
  const Command* command = window_->commands().find(QStringLiteral("feature.example.gear"));
  QVERIFY(command);
  QCOMPARE(command->group, QStringLiteral("Example"));
  bool inMenu = false;
  for (const QAction* menu : window_->menuBar()->actions())
    inMenu = inMenu || (menu->menu() && menu->menu()->actions().contains(command->action));
  QVERIFY(inMenu);
}

void ExamplePluginWindowTest::isAddedEditedAndUndone() {
  gear()->trigger();
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().evaluating() && !window_->page().document().features().empty(), 20000);
  const FeatureId id = window_->page().document().features().back()->id;
  QTRY_COMPARE(window_->tree().current(), id);
  for (const char* name : {"teeth", "module", "pressure-angle", "bore"})
    QVERIFY2(window_->properties().field(QLatin1String(name)), name);
  const auto teeth = [&] { return window_->page().document().at(id).parameters.value("teeth", 20); };
  window_->properties().field(QStringLiteral("teeth"))->edited(Value(31));
  QCOMPARE(teeth(), 31);
  QTRY_VERIFY_WITH_TIMEOUT(!window_->session().evaluating(), 20000);
  const auto view = window_->session().view(id);
  QVERIFY(view && !view->result->error);
  // A gear of 31 teeth and a bore has a line for each flank.
  const auto lines = std::find_if(view->measures.values.begin(), view->measures.values.end(),
                                  [](const Measure& measure) { return measure.name == "lines"; });
  QVERIFY(lines != view->measures.values.end());
  QCOMPARE(std::get<std::int64_t>(lines->value), std::int64_t(62));
  window_->session().undo();
  QCOMPARE(teeth(), 20);
  window_->session().undo();
  QVERIFY(window_->page().document().features().empty());
}

void ExamplePluginWindowTest::hasAPageInTheManual() {
  const ManualPages pages(window_->session().app(), window_->commands());
  const ManualPage* page = pages.find(QStringLiteral("reference/example.gear.md"));
  QVERIFY(page);
  QCOMPARE(page->title, QStringLiteral("Gear"));
  for (const char* word : {"pressure", "Number of teeth", "blossom gear --teeth 24"})
    QVERIFY2(page->text.contains(QLatin1String(word)), word);
}

// The module is the radius of the pitch circle, where the handle stands, times two over the 20 teeth.
void ExamplePluginWindowTest::itsHandleIsDraggedWhileTheAreaIsComputed() {
  run("file.new");
  const FeatureId id = addGear();
  window_->tree().select(id);
  QTRY_VERIFY(window_->page().tool());
  const auto area = [&] { return QStringLiteral("%1 mm²").arg(measureOf(id, "area"), 0, 'f', 1); };
  QTRY_VERIFY2(window_->page().tool()->hint().endsWith(area()), qPrintable(window_->page().tool()->hint()));
  QCOMPARE(window_->page().tool()->props().size(), std::size_t{1});

  window_->view().fitTo({{-50, -50, 0}, {50, 50, 0}}, false);
  const Vec3 handle(20, 0, 0), wanted(30, 0, 0);
  const QPoint from = screenOf(handle), to = screenOf(wanted);
  test::moveMouse(&window_->view(), from);
  QTest::mousePress(&window_->view(), Qt::LeftButton, {}, from);
  for (int i = 1; i <= 8; ++i) test::moveMouse(&window_->view(), from + (to - from) * i / 8);
  QTest::mouseRelease(&window_->view(), Qt::LeftButton, {}, to);
  waitUntilComputed();
  const double module = window_->page().document().at(id).parameters.value("module", 2.0);
  COMPARE_NEAR(module, 3, 2 * window_->view().camera().millimetresPerPixel());
  QTRY_VERIFY2(window_->page().tool()->hint().endsWith(area()), qPrintable(window_->page().tool()->hint()));
  window_->session().undo();
  waitUntilComputed();
  QCOMPARE(window_->page().document().at(id).parameters.value("module", 2.0), 2.0);
  QTRY_VERIFY2(window_->page().tool()->hint().endsWith(area()), qPrintable(window_->page().tool()->hint()));
}

void ExamplePluginWindowTest::itsFormatIsOpenedAndExported() {
  QVERIFY(readFilters(window_->session().app()).join(QLatin1Char(' ')).contains(QStringLiteral("*.plt")));
  run("file.new");
  const FeatureId id = addGear();
  window_->tree().select(id);
  const double perimeter = measureOf(id, "perimeter");
  QVERIFY(perimeter > 100);
  const QString file = folder_.filePath(QStringLiteral("gear.plt"));
  exportAs("hpgl", file, {{"unit", 0.0125}});
  QVERIFY(QFile::exists(file));
  openAndWait(file);
  // Read in units of 0.025 mm, everything is twice as large.
  COMPARE_NEAR(measureOf(last(), "length"), 2 * perimeter, 1);
  ParameterField* const options = window_->properties().field(QStringLiteral("hpgl"));
  QVERIFY(options && !options->isHidden());
  options->edited({{"unit", 0.0125}});
  waitUntilComputed();
  COMPARE_NEAR(measureOf(last(), "length"), perimeter, 0.5);
}

BLOSSOM_WINDOW_TEST(ExamplePluginWindowTest)
#include "example_plugin_window_test.moc"
