#include <QMenu>
#include <QMenuBar>

#include "ui/fields/parameter_field.h"
#include "ui/help/manual_pages.h"
#include "ui/look/text.h"
#include "ui/panel/property_panel.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

/// The gear of the example plugin, built outside of the tree against the installed package, is everywhere in the window
/// although no line of the window knows it.
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

 private:
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

BLOSSOM_WINDOW_TEST_MAIN(ExamplePluginWindowTest)
#include "example_plugin_window_test.moc"
