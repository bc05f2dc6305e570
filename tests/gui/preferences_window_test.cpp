#include <QSignalSpy>

#include "ui/settings/preferences_form.h"
#include "ui/tree/document_model.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

/// Preferences change what an open document looks like, and never the document.
class PreferencesWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() {
    openWindow();
    openPropeller();
    window_->tree().select(sweep());
    before_ = stateNow();
  }
  void cleanup() {
    window_.reset();
    Preferences::instance().reset();
  }
  void aUnitIsFollowedByAllThatShowsLengths();
  void aFinerToleranceDrawsAnew();
  void theFormShowsItsLengthsInTheUnit();

 private:
  /// What an edit would change.
  struct State {
    std::string document, undo, redo;
    bool modified = false;
    friend bool operator==(const State&, const State&) = default;
  };
  [[nodiscard]] State stateNow() const {
    const Session& session = window_->session();
    return {toJson(session.document()), session.history().undoText(), session.history().redoText(),
            session.modified() || window_->isWindowModified()};
  }
  [[nodiscard]] QString stateLineOfSweep() const {
    const QAbstractItemModel& model = *window_->tree().model();
    for (int row = 0; row < model.rowCount(); ++row)
      if (const QModelIndex index = model.index(row, 0);
          index.data(DocumentModel::IdRole).toString().toStdString() == sweep())
        return index.data(DocumentModel::StateRole).toString();
    return {};
  }
  [[nodiscard]] vtkPolyData* drawn() const { return window_->session().view(sweep())->scene.faces; }
  State before_;
};

void PreferencesWindowTest::aUnitIsFollowedByAllThatShowsLengths() {
  const auto text = [&](const char* parameter) {
    return window_->properties().field(QLatin1String(parameter))->findChild<QLineEdit*>()->text();
  };
  const QString line = stateLineOfSweep(), length = text("tolerance");
  QVERIFY2(line.contains(QStringLiteral(" mm")), qPrintable(line));
  QVERIFY2(length.endsWith(QStringLiteral(" mm")), qPrintable(length));
  const auto* const picture = drawn();
  QSignalSpy computed(&window_->session(), &Session::evaluationStarted);
  QSignalSpy told(&window_->view(), &ViewWidget::whereabouts);
  const int frames = window_->view().framesDrawn();

  Preferences::instance().set("length-unit", "in");
  QVERIFY2(stateLineOfSweep().contains(QStringLiteral(" in")), qPrintable(stateLineOfSweep()));
  QVERIFY2(text("tolerance").endsWith(QStringLiteral(" in")), qPrintable(text("tolerance")));
  QTRY_VERIFY(window_->view().framesDrawn() > frames);
  test::moveMouse(&window_->view(), window_->view().rect().center());
  QTRY_VERIFY(!told.isEmpty() && told.back().front().toString().endsWith(QStringLiteral(" in")));
  QCOMPARE(computed.size(), 0);
  QCOMPARE(drawn(), picture);  // the shape looks the same
  QVERIFY(stateNow() == before_);

  // A page that comes later follows too, and so does the first one still.
  window_->addPage();
  Preferences::instance().set("length-unit", "mm");
  window_->showPage(0);
  QCOMPARE(stateLineOfSweep(), line);
  QCOMPARE(text("tolerance"), length);
  QVERIFY(stateNow() == before_);
}

void PreferencesWindowTest::aFinerToleranceDrawsAnew() {
  const vtkSmartPointer<vtkPolyData> coarse = drawn();
  const int frames = window_->view().framesDrawn();
  Preferences::instance().set("drawing-tolerance", 0.002);
  waitUntilComputed();
  QVERIFY2(drawn()->GetNumberOfCells() > 2 * coarse->GetNumberOfCells(),
           qPrintable(QStringLiteral("%1 after %2").arg(drawn()->GetNumberOfCells()).arg(coarse->GetNumberOfCells())));
  QTRY_VERIFY(window_->view().framesDrawn() > frames);
  QVERIFY(stateNow() == before_);
  const double area = measureOf(sweep(), "area");

  Preferences::instance().set("drawing-tolerance", 0.0);
  waitUntilComputed();
  QCOMPARE(drawn(), coarse.Get());  // it was remembered
  QCOMPARE(measureOf(sweep(), "area"), area);
  QVERIFY(stateNow() == before_);
}

void PreferencesWindowTest::theFormShowsItsLengthsInTheUnit() {
  std::vector<std::unique_ptr<PreferencesForm>> forms;
  ParameterField* tolerance = nullptr;
  for (const PreferenceGroup& group : preferenceGroups()) {
    forms.push_back(std::make_unique<PreferencesForm>(group));
    for (ParameterField* field : forms.back()->fields())
      if (field->spec().name == "drawing-tolerance") tolerance = field;
  }
  QVERIFY(tolerance);
  auto* const line = tolerance->findChild<QLineEdit*>();
  Preferences::instance().set("drawing-tolerance", 2.54);
  QCOMPARE(line->text(), QStringLiteral("2.54 mm"));
  Preferences::instance().set("length-unit", "in");
  QCOMPARE(line->text(), QStringLiteral("0.1 in"));
  line->selectAll();
  QTest::keyClicks(line, QStringLiteral("0.2"));
  QTest::keyClick(line, Qt::Key_Return);
  COMPARE_NEAR(Preferences::instance().get<double>("drawing-tolerance"), 5.08, 1e-12);
  Preferences::instance().reset();
  QCOMPARE(line->text(), QStringLiteral("0 mm"));
}

BLOSSOM_WINDOW_TEST(PreferencesWindowTest)
#include "preferences_window_test.moc"
