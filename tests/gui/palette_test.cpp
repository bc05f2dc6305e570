#include <QLineEdit>
#include <QListView>

#include "tree_fixture.h"
#include "ui/look/preferences.h"
#include "ui/look/text.h"
#include "ui/palette/command_palette.h"
#include "ui/palette/palette_match.h"
#include "ui/window/status_line.h"

using namespace blossom;
using namespace blossom::ui;

class PaletteTest : public TreeFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openTestWindow(); }
  void cleanup() { closeTestWindow(); }

  void lettersMatchInOrder();
  void everyCommandIsFound();
  void aCommandIsRunByKeys();
  void themesAreFound();
  void aFeatureIsAdded();
  void aSampleIsOpened();
  void featuresAndPagesAreFound();
  void whatWasUsedStandsFirst();
  void theWholeNameStandsBeforeWhatWasUsed();
  void theWordsOfTheTradeAreKnown();
  void aBooleanBeginsAsItWasAskedFor();
  void whatCannotBeDoneSaysWhy();
  void theStatusIsAsBeforeWhenItCloses();
  void whatIsNotFoundIsTold();
  void itClosesWithoutDoingAnything();

 private:
  [[nodiscard]] CommandPalette& palette() { return window_->palette(); }
  void openPalette(const QString& pattern) {
    QTest::keyClick(window_.get(), Qt::Key_K, Qt::ControlModifier);
    QVERIFY(palette().isVisible());
    QTRY_VERIFY(palette().field()->hasFocus());
    QTest::keyClicks(palette().field(), pattern);
  }
  [[nodiscard]] QStringList found() {
    QStringList ids;
    for (int row = 0; row < palette().model().rowCount(); ++row) ids << palette().model().at(row).id;
    return ids;
  }
};

void PaletteTest::lettersMatchInOrder() {
  const auto score = [](const char* pattern, const char* text) {
    const auto match = paletteMatch(QLatin1String(pattern), QLatin1String(text));
    return match ? match->score : -1;
  };
  QCOMPARE(score("zz", "Zoom in"), -1);
  QCOMPARE(score("niz", "Zoom in"), -1);
  QVERIFY(score("zi", "Zoom in") > 0);
  QVERIFY(score("", "Anything") == 0);
  QVERIFY2(score("exp", "Export") > score("exp", "Textile pattern"), "letters that follow each other count more");
  QVERIFY2(score("si", "Select invisible") > score("si", "Passing"), "beginnings of words count more");
  QVERIFY2(score("fit", "Fit") > score("fit", "Fitting"), "whole words count more");
  const auto match = paletteMatch(QStringLiteral("in zo"), QStringLiteral("Zoom in"));
  QVERIFY(match);
  QCOMPARE(match->letters, (QList<int>{0, 1, 5, 6}));
}

void PaletteTest::everyCommandIsFound() {
  QVERIFY(window_->commands().all().size() > 30);
  openPalette({});
  QCOMPARE(palette().model().rowCount() >= static_cast<int>(window_->commands().all().size()), true);
  for (const Command& command : window_->commands().all()) {
    palette().field()->setText(QString(command.action->text()).remove(u'&'));
    QVERIFY2(found().mid(0, 3).contains(command.id), qPrintable(command.id + ": " + found().mid(0, 3).join(u' ')));
  }
  for (const auto& type : window_->session().app().registry->types()) {
    const Command* command = window_->commands().find(QStringLiteral("feature.") + qt(type->id));
    if (command) QVERIFY(!command->help.isEmpty());
  }
}

void PaletteTest::aCommandIsRunByKeys() {
  const bool before = window_->view().parallel();
  openPalette(QStringLiteral("parall"));
  QCOMPARE(found().value(0), QStringLiteral("view.parallel"));
  QTest::keyClick(palette().field(), Qt::Key_Return);
  QVERIFY(palette().isHidden());
  QCOMPARE(window_->view().parallel(), !before);
}

void PaletteTest::themesAreFound() {
  openPalette(QStringLiteral("theme"));
  for (const char* id : {"view.theme-dark", "view.theme-light", "view.theme-system"})
    QVERIFY2(found().mid(0, 4).contains(QLatin1String(id)), id);
  for (const auto& [typed, wanted] : {std::pair{"light", "Light"}, std::pair{"dark", "Dark"}}) {
    palette().dismiss();
    openPalette(QLatin1String(typed));
    QCOMPARE(found().value(0), QStringLiteral("view.theme-") + QLatin1String(typed));
    QTest::keyClick(palette().field(), Qt::Key_Return);
    QCOMPARE(theme().name, QLatin1String(wanted));
    QVERIFY(window_->commands().action(QStringLiteral("view.theme-") + QLatin1String(typed))->isChecked());
  }
  Preferences::instance().set("theme", "light");
  QVERIFY(window_->commands().action(QStringLiteral("view.theme-light"))->isChecked());
  QVERIFY(!window_->commands().action(QStringLiteral("view.theme-dark"))->isChecked());
  Preferences::instance().set("theme", "dark");
}

void PaletteTest::aFeatureIsAdded() {
  openPropeller();
  window_->tree().select(document().at(sweep()).inputs.front());
  openPalette(QStringLiteral("sweep"));
  const qsizetype row = found().indexOf(QStringLiteral("feature.sweep.sweep"));
  QVERIFY(row >= 0 && row < 4);
  for (qsizetype i = 0; i < row; ++i) QTest::keyClick(palette().field(), Qt::Key_Down);
  QTest::keyClick(palette().field(), Qt::Key_Return);
  QCOMPARE(document().features().size(), std::size_t(3));
  QCOMPARE(undoText(), QStringLiteral("Add Sweep"));
  undo();
  QCOMPARE(document().features().size(), std::size_t(2));
}

void PaletteTest::aSampleIsOpened() {
  openPalette(QStringLiteral("propeller"));
  QVERIFY(found().value(0).startsWith(QStringLiteral("sample:")));
  auto* list = palette().findChild<QListView*>();
  QTest::mouseClick(list->viewport(), Qt::LeftButton, {}, list->visualRect(list->model()->index(0, 0)).center());
  QVERIFY(palette().isHidden());
  QTRY_VERIFY_WITH_TIMEOUT(!sweep().empty() && !window_->session().evaluating(), 60000);
}

void PaletteTest::featuresAndPagesAreFound() {
  showChain();
  window_->session().commit(document().with(feature("lid", "test.block", {}, "Lid of the box")), {});
  waitUntilComputed();
  openPalette(QStringLiteral("lidbox"));
  QCOMPARE(found().value(0), QStringLiteral("go-to:lid"));
  QTest::keyClick(palette().field(), Qt::Key_Return);
  QCOMPARE(window_->tree().selected(), std::vector<FeatureId>{"lid"});
  openPalette(QStringLiteral("manual"));
  const QStringList pages = found().filter(QStringLiteral("manual:"));
  QVERIFY(!pages.isEmpty());
}

void PaletteTest::whatWasUsedStandsFirst() {
  openPalette(QStringLiteral("grid"));
  QTest::keyClick(palette().field(), Qt::Key_Return);
  openPalette({});
  QCOMPARE(found().value(0), QStringLiteral("view.grid"));
}

void PaletteTest::theWholeNameStandsBeforeWhatWasUsed() {
  PaletteModel model;
  PaletteEntry pocket, simulate;
  pocket.id = QStringLiteral("pocket");
  pocket.text = pocket.group = QStringLiteral("Pocket");
  simulate.id = QStringLiteral("simulate");
  simulate.text = QStringLiteral("Simulate");
  simulate.group = QStringLiteral("Pocket");
  pocket.enabled = false;  // what cannot be done now comes later otherwise
  simulate.enabled = true;
  QStringList lately{simulate.id};
  for (int k = 0; k < 20; ++k) lately << QString::number(k);
  model.setEntries({simulate, pocket}, lately);
  model.setPattern(QStringLiteral("pocket"));
  QCOMPARE(model.rowCount(), 2);
  QCOMPARE(model.at(0).id, pocket.id);
}

void PaletteTest::theWordsOfTheTradeAreKnown() {
  for (const auto& [word, wanted] : {std::pair{"subtract", "boolean"},
                                     {"union", "boolean"},
                                     {"intersect", "boolean"},
                                     {"hole", "boolean"},
                                     {"3d", "extrude"},
                                     {"push pull", "extrude"},
                                     {"rotate", "transform"},
                                     {"move", "transform"},
                                     {"scale", "transform"},
                                     {"mirror", "mirror"},
                                     {"round", "fillet"},
                                     {"bevel", "chamfer"},
                                     {"array", "pattern"}}) {
    openPalette(QLatin1String(word));
    QVERIFY2(found().mid(0, 2).contains(QStringLiteral("feature.modeling.") + QLatin1String(wanted)),
             qPrintable(QLatin1String(word) + QStringLiteral(": ") + found().mid(0, 3).join(u' ')));
    palette().dismiss();
  }
  openPalette(QStringLiteral("measure"));
  QCOMPARE(found().value(0), QStringLiteral("view.measure"));
  palette().dismiss();
  openPalette(QStringLiteral("cut"));
  QCOMPARE(found().mid(0, 2), (QStringList{QStringLiteral("edit.cut"), QStringLiteral("feature.modeling.boolean")}));
}

void PaletteTest::aBooleanBeginsAsItWasAskedFor() {
  const auto type = window_->session().app().registry->find("modeling.boolean");
  QVERIFY(type);
  window_->session().commit(
      Document::of({feature("a", "modeling.box", {}, "Plate"), feature("b", "modeling.box", {}, "Pin")}), {});
  waitUntilComputed();
  openPalette(QStringLiteral("subtract"));
  QTest::keyClick(palette().field(), Qt::Key_Return);
  QCOMPARE(document().features().size(), std::size_t(3));
  QCOMPARE(document().features().back()->parameters.value("operation", std::string()), std::string("difference"));
}

void PaletteTest::whatCannotBeDoneSaysWhy() {
  openPalette(QStringLiteral("delete"));
  const int row = static_cast<int>(found().indexOf(QStringLiteral("edit.delete")));
  QVERIFY(row >= 0);
  const QModelIndex index = palette().model().index(row);
  QVERIFY(!index.data(PaletteModel::EnabledRole).toBool());
  QCOMPARE(index.data(PaletteModel::HelpRole).toString(), QStringLiteral("Select a feature first."));
}

void PaletteTest::theStatusIsAsBeforeWhenItCloses() {
  showChain();
  run("view.measure");
  const auto* status = window_->findChild<StatusLine*>();
  const QString wanted = window_->view().restingHint();
  QVERIFY(window_->page().measuring() && !wanted.isEmpty());
  openPalette(QStringLiteral("grid"));
  QTest::keyClick(palette().field(), Qt::Key_Escape);
  QTRY_COMPARE_WITH_TIMEOUT(status->hint(), wanted, 10000);
}

void PaletteTest::whatIsNotFoundIsTold() {
  openPalette(QStringLiteral("box"));
  palette().field()->setText(QStringLiteral("no such thing"));
  const auto* status = window_->findChild<StatusLine*>();
  QTRY_COMPARE(status->hint(), QStringLiteral("Nothing is called \"no such thing\"."));
  QTest::keyClick(palette().field(), Qt::Key_Escape);
}

void PaletteTest::itClosesWithoutDoingAnything() {
  const std::size_t features = document().features().size();
  openPalette(QStringLiteral("box"));
  QTest::keyClick(palette().field(), Qt::Key_Escape);
  QVERIFY(palette().isHidden());
  openPalette({});
  QTest::mouseClick(&window_->view(), Qt::LeftButton, {}, QPoint(10, window_->view().height() - 10));
  QVERIFY(palette().isHidden());
  QCOMPARE(document().features().size(), features);
}

BLOSSOM_WINDOW_TEST(PaletteTest)
#include "palette_test.moc"
