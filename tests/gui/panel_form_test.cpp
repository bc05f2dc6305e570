#include <QCheckBox>
#include <QClipboard>
#include <QLabel>
#include <QPushButton>

#include "panel_fixture.h"
#include "ui/controls/chip.h"
#include "ui/fields/list_field.h"
#include "ui/fields/list_row.h"
#include "ui/panel/input_editor.h"
#include "ui/panel/result_rows.h"
#include "ui/tree/document_model.h"

using namespace blossom;
using namespace blossom::ui;

/// The form as a whole: what stands in it, the name, the results.
class PanelFormTest : public PanelFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() { openPanel(); }
  void cleanup() { closePanel(); }
  void everyKindHasAFieldThatFits();
  void tabGoesThroughTheFields();
  void namesAreTypedOver();
  void whatIsTypedIsNotLostWithTheSelection();
  void errorsStandAtTheirField();
  void resultsAreShownAndCopied();
  void valuesGoBackToTheirDefault();
  void aCancelledFeatureSaysSoAndIsComputed();
  void figuresFromBeforeAreGrey();
  void namesOfInputsAreReadFromTheirBeginning();
};

void PanelFormTest::everyKindHasAFieldThatFits() {
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

void PanelFormTest::tabGoesThroughTheFields() {
  editor<QCheckBox>("flag")->setFocus();
  for (const char* name : {"count", "number", "ratio", "length", "angle", "choice", "text"}) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    QVERIFY2(field(name)->isAncestorOf(QApplication::focusWidget()), name);
  }
}

void PanelFormTest::namesAreTypedOver() {
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

void PanelFormTest::whatIsTypedIsNotLostWithTheSelection() {
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
  test::moveMouse(labelOf("length"), QPoint(60, 5));
  QVERIFY(toJson(session_->document()) != before);
  panel_->show(FeatureId("b"));
  QCOMPARE(toJson(session_->document()), before);
}

void PanelFormTest::errorsStandAtTheirField() {
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

void PanelFormTest::resultsAreShownAndCopied() {
  auto* rows = panel_->findChild<ResultRows*>();
  const auto row = [&](const char* name) {
    const auto& all = rows->rows();
    return std::find_if(all.begin(), all.end(), [&](const ResultRow& each) { return each.name == QLatin1String(name); });
  };
  QTRY_VERIFY(rows->isVisible() && row("Area") != rows->rows().end());
  QCOMPARE(row("Area")->number, QStringLiteral("50"));
  QCOMPARE(row("Area")->unit, QStringLiteral("mm²"));
  QVERIFY(std::any_of(rows->rows().begin(), rows->rows().end(), [](const ResultRow& each) {
    return each.number == QStringLiteral("12.25") && each.unit == QStringLiteral("mm");
  }));
  QSignalSpy told(panel_.get(), &PropertyPanel::hint);
  const QRect area = rows->valueRect(static_cast<std::size_t>(row("Area") - rows->rows().begin()));
  const QPoint inPanel = rows->mapTo(panel_->widget(), area.center());
  panel_->ensureVisible(inPanel.x(), inPanel.y());
  QTest::mouseClick(rows, Qt::LeftButton, {}, area.center());
  QCOMPARE(QApplication::clipboard()->text(), QStringLiteral("50"));
  QVERIFY(!told.isEmpty());
  // Warnings stand with the results, and where they are seen without scrolling.
  const auto warned = [&](const char* where) {
    for (const auto* label : panel_->findChildren<QLabel*>(QLatin1String(where)))
      if (!label->isHidden() && label->text() == QStringLiteral("The flag is up.")) return true;
    return false;
  };
  QVERIFY(!warned("warning") && !warned("noticeBox"));
  QTest::keyClick(editor<QCheckBox>("flag"), Qt::Key_Space);
  QTRY_VERIFY(warned("warning") && warned("noticeBox"));
  QTest::keyClick(editor<QCheckBox>("flag"), Qt::Key_Space);
  QTRY_VERIFY(!warned("warning") && !warned("noticeBox"));
}

void PanelFormTest::figuresFromBeforeAreGrey() {
  auto* const rows = panel_->findChild<ResultRows*>();
  QTRY_VERIFY(rows->isVisible());
  const auto saysSo = [&] {
    for (const auto* label : panel_->findChildren<QLabel*>(QStringLiteral("warning")))
      if (!label->isHidden() && label->text() == QStringLiteral("Out of date: computing…")) return true;
    return false;
  };
  const auto brightest = [&] {
    const QImage image = rows->grab().toImage();
    int value = 0;
    for (int y = 0; y < image.height(); ++y)
      for (int x = 0; x < image.width(); ++x) value = std::max(value, qGray(image.pixel(x, y)));
    return value;
  };
  QTRY_VERIFY(brightest() > 0);  // laid out
  const int fresh = brightest();
  QVERIFY(!rows->outdated() && !saysSo());
  gate_.close();
  type(editor<QLineEdit>("length"), QStringLiteral("12"));
  QTRY_VERIFY(gate_.count() > 0);
  QTRY_VERIFY(rows->outdated() && saysSo());
  // No letter is lighter than the grey of the theme.
  const int grey = qGray(theme().color("faint").rgb());
  QVERIFY2(brightest() <= grey + 2 && grey + 2 < fresh, qPrintable(QStringLiteral("%1 %2").arg(grey).arg(fresh)));
  gate_.open();
  settle();
  QTRY_VERIFY(!rows->outdated() && !saysSo());
  QCOMPARE(brightest(), fresh);
}

void PanelFormTest::namesOfInputsAreReadFromTheirBeginning() {
  const QString name = QStringLiteral("Outline of the propeller blade, second one");
  Chip chip(name);
  chip.setIconName(QStringLiteral("mesh"));
  chip.setChevron(true);
  chip.resize(chip.sizeHint());
  QCOMPARE(chip.shownText(), name);
  chip.resize(160, chip.height());
  const QString shown = chip.shownText();
  QVERIFY2(shown.endsWith(u'…') && shown.size() > 6 && name.startsWith(shown.chopped(1)), qPrintable(shown));

  // Beside its caption there is no room in a narrow panel; below there is.
  Feature base = session_->document().at("a");
  base.name = "Plate of the hull";
  session_->commit(session_->document().with(base), QStringLiteral("Rename"));
  settle();
  panel_->resize(262, 700);
  const auto readable = [&] {
    const auto* taken = panel_->input(QStringLiteral("base"))->findChild<Chip*>();
    for (const auto* each : panel_->input(QStringLiteral("base"))->findChildren<Chip*>())
      if (!each->isHidden()) taken = each;
    return taken->shownText() == QStringLiteral("Plate of the hull");
  };
  const auto seen = [&] { return panel_->input(QStringLiteral("base"))->findChildren<Chip*>().last()->shownText(); };
  QTRY_VERIFY2(readable(), qPrintable(seen() + QString::number(panel_->input(QStringLiteral("base"))->width())));
}

void PanelFormTest::aCancelledFeatureSaysSoAndIsComputed() {
  const DocumentModel model(*session_);
  const auto state = [&] { return model.data(model.indexOf("e"), DocumentModel::StateRole).toString(); };
  const auto says = [&](const QString& text) {
    for (const auto* label : panel_->findChildren<QLabel*>(QStringLiteral("note")))
      if (!label->isHidden() && label->text() == text) return true;
    return false;
  };
  auto* const compute = panel_->findChild<QPushButton*>(QStringLiteral("compute"));
  QVERIFY(compute && compute->isHidden());
  gate_.close();
  std::set<FeatureId> arrived;
  connect(session_.get(), &Session::viewsChanged, panel_.get(),
          [&](const auto& features) { arrived.merge(std::set(features)); });
  type(editor<QLineEdit>("length"), QStringLiteral("12"));
  QTRY_VERIFY(gate_.count() > 0);
  QTRY_COMPARE(arrived, (std::set<FeatureId>{"a", "b", "m"}));  // what stands before it
  session_->cancelEvaluation();
  QVERIFY(!session_->evaluating());
  QTRY_VERIFY(says(QStringLiteral("Cancelled.")));
  QVERIFY(!says(QStringLiteral("Computing…")));
  QVERIFY(!compute->isHidden());
  QCOMPARE(state(), QStringLiteral("cancelled"));
  QVERIFY(session_->cancelled("f") && !session_->cancelled("a"));  // what follows it, and what was there before
  panel_->show(FeatureId("f"));                                    // never shows the figures from before as its own
  QTRY_VERIFY(says(QStringLiteral("Cancelled.")));
  panel_->show(FeatureId("e"));
  gate_.open();
  compute->click();
  settle();
  QTRY_VERIFY(compute->isHidden());
  QVERIFY(!says(QStringLiteral("Cancelled.")));
  QVERIFY(!session_->cancelled("e") && state() != QStringLiteral("cancelled"));
  QVERIFY(!session_->view("e")->result->error);
}

void PanelFormTest::valuesGoBackToTheirDefault() {
  type(editor<QLineEdit>("length"), QStringLiteral("12"));
  auto* reset = field("length")->findChild<QToolButton*>(QStringLiteral("fieldReset"));
  test::moveMouse(field("length"), middle(field("length")));
  oneStep("length", 10.0, [&] { reset->click(); });
  const std::string text = session_->history().undoText();
  field("length")->resetToDefault();  // nothing to do
  QCOMPARE(session_->history().undoText(), text);
}

BLOSSOM_WIDGET_TEST(PanelFormTest)
#include "panel_form_test.moc"
