// The window in German: what the registry says is translated, too, and the command line's words stay as they are.
#include <QComboBox>
#include <QLabel>
#include <QTranslator>

#include "ui/fields/parameter_field.h"
#include "ui/look/text.h"
#include "ui/palette/command_palette.h"
#include "ui/tree/document_model.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

class GermanWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() {
    setUpOnce();
    for (const char* part : {"blossom", "features"}) {
      auto* translator = new QTranslator(this);
      const auto file = test::buildFolder() / "share/blossom/translations" / (std::string(part) + "_de.qm");
      QVERIFY2(translator->load(qt(file.string())), file.c_str());
      QVERIFY(QCoreApplication::installTranslator(translator));
    }
  }
  void init() { openNewDocument(); }
  void cleanup() { window_.reset(); }
  void featuresAreNamedInGerman();
  void fieldsAreLabelledInGerman();
  void resultsAreToldInGerman();
  void bothLanguagesFindACommand();

 private:
  [[nodiscard]] const Feature& lastFeature() const { return window_->page().document().at(last()); }
  /// Every text that a widget shows in labels.
  static QStringList labelsOf(const QWidget& widget) {
    QStringList texts;
    for (const QLabel* label : widget.findChildren<QLabel*>()) texts << label->text();
    return texts;
  }
};

void GermanWindowTest::featuresAreNamedInGerman() {
  run("feature.modeling.rectangle");
  waitUntilComputed();
  QCOMPARE(lastFeature().name, std::string("Rechteck"));
  QCOMPARE(lastFeature().type, std::string("modeling.rectangle"));
  run("feature.modeling.rectangle");
  waitUntilComputed();
  QCOMPARE(lastFeature().name, std::string("Rechteck 2"));
  const QAbstractItemModel& rows = *window_->tree().model();
  QCOMPARE(rows.index(0, 0).data(DocumentModel::TypeRole).toString(), QStringLiteral("Rechteck"));
}

void GermanWindowTest::resultsAreToldInGerman() {
  run("feature.sweep.primitive");
  waitUntilComputed();
  const auto view = window_->session().view(last());
  QVERIFY(view && view->result && !view->result->error);
  QCOMPARE(stateLine(view->measures).section(u',', 0, 0), QStringLiteral("Bewegung"));
  for (const char* kind :
       {"nothing", "region", "curve", "curves", "surface", "solid", "faces", "mesh", "motion", "toolpath", "sequence"})
    QVERIFY2(shownShapeKind(kind) != QLatin1String(kind), kind);
  QCOMPARE(readable(Measure{"crosses_itself", false}), QStringLiteral("nein"));
  QCOMPARE(shownWarning("Nothing is edited yet: there is no place."),
           QStringLiteral("Noch wird nichts bearbeitet: Es gibt keine Stelle."));
  QCOMPARE(shownWarning("With 3 spans it does not fit."), QStringLiteral("With 3 spans it does not fit."));
}

void GermanWindowTest::fieldsAreLabelledInGerman() {
  run("feature.modeling.polygon");
  waitUntilComputed();
  const ParameterField* size = window_->properties().field(QStringLiteral("size"));
  QVERIFY(size);
  QVERIFY2(labelsOf(*size).contains(QStringLiteral("Größe")), qPrintable(labelsOf(*size).join(u'|')));
  const auto* box = size->findChild<QComboBox*>();
  QCOMPARE(box->itemText(0), QStringLiteral("einbeschrieben"));
  QCOMPARE(box->itemData(0).toString(), QStringLiteral("inscribed"));
  QVERIFY(box->toolTip().startsWith(QStringLiteral("Ob die Ecken auf dem Kreis liegen")));
  QVERIFY(labelsOf(window_->properties()).contains(QStringLiteral("Ein regelmäßiges Vieleck.")));
  // What is stored is not translated.
  QVERIFY(!lastFeature().parameters.contains("Größe"));
  edit("radius", "20");
  waitUntilComputed();
  QCOMPARE(lastFeature().parameters.at("radius"), Value(20.0));
}

void GermanWindowTest::bothLanguagesFindACommand() {
  for (const char* typed : {"rechteck", "rectangle"}) {
    QTest::keyClick(window_.get(), Qt::Key_K, Qt::ControlModifier);
    CommandPalette& palette = window_->palette();
    QVERIFY(palette.isVisible());
    QTRY_VERIFY(palette.field()->hasFocus());
    QTest::keyClicks(palette.field(), QLatin1String(typed));
    QCOMPARE(palette.model().at(0).id, QStringLiteral("feature.modeling.rectangle"));
    palette.dismiss();
  }
}

BLOSSOM_WINDOW_TEST(GermanWindowTest)
#include "german_window_test.moc"
