#include <QComboBox>

#include "panel_fixture.h"

using namespace blossom;
using namespace blossom::ui;

/// Fields that are for some values of another field only.
class PanelConditionsTest : public PanelFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init();
  void cleanup() { closePanel(); }
  void rowsFollowTheChoice();
  void tabSkipsWhatIsHidden();
  void hiddenValuesStay();
  void whatIsTypedStaysUntilItIsEntered();
  void whatIsWrongIsShown();

 private:
  /// The fields that are seen, in order.
  [[nodiscard]] QStringList seen() const {
    QStringList names;
    for (const char* name : {"kind", "profile", "turns", "radius"})
      if (field(name)->isVisible()) names << QLatin1String(name);
    return names;
  }
  [[nodiscard]] const Value& stored() const { return session_->document().at("k").parameters; }
  void set(const char* name, const Value& value) {
    Feature feature = session_->document().at("k");
    feature.parameters[name] = value;
    session_->commit(session_->document().with(feature), QStringLiteral("Set"));
  }

  const QStringList ofBall_{"kind", "radius"}, ofRing_{"kind", "profile", "radius"},
      ofSpring_{"kind", "profile", "turns", "radius"};
};

void PanelConditionsTest::init() {
  openPanel();
  session_->commit(session_->document().with(made("k", "test.kinds", "One of them")), QStringLiteral("Add"));
  panel_->show(FeatureId("k"));
  settle();
}

void PanelConditionsTest::rowsFollowTheChoice() {
  QCOMPARE(seen(), ofBall_);
  auto* box = editor<QComboBox>("kind");
  box->setFocus();
  QTest::keyClick(box, Qt::Key_Down);
  QCOMPARE(seen(), ofRing_);  // at once, before anything is computed
  QTest::keyClick(box, Qt::Key_Down);
  QCOMPARE(seen(), ofSpring_);
  QVERIFY(box->hasFocus());
  QTest::keyClick(box, Qt::Key_Home);
  QCOMPARE(seen(), ofBall_);
  QVERIFY(box->hasFocus());
  session_->undo();
  QCOMPARE(seen(), ofSpring_);
  session_->redo();
  QCOMPARE(seen(), ofBall_);
  // Another feature and back; a kind that there is not is shown as the default.
  set("kind", "ring");
  panel_->show(FeatureId("a"));
  panel_->show(FeatureId("k"));
  QCOMPARE(seen(), ofRing_);
  set("kind", "cube");
  QCOMPARE(seen(), ofBall_);
}

void PanelConditionsTest::tabSkipsWhatIsHidden() {
  const auto tabFrom = [&](const char* name) {
    QTest::keyClick(QApplication::focusWidget(), Qt::Key_Tab);
    return field(name)->isAncestorOf(QApplication::focusWidget());
  };
  editor<QComboBox>("kind")->setFocus();
  QVERIFY(tabFrom("radius"));
  set("kind", "spring");
  editor<QComboBox>("kind")->setFocus();
  QVERIFY(tabFrom("profile") && tabFrom("turns") && tabFrom("radius"));
  // A row that goes hands the keyboard on to one that is seen.
  editor<QLineEdit>("turns")->setFocus();
  set("kind", "ball");
  QCOMPARE(seen(), ofBall_);
  QVERIFY(QApplication::focusWidget() && QApplication::focusWidget()->isVisible());
  QVERIFY(!field("turns")->isAncestorOf(QApplication::focusWidget()));
}

void PanelConditionsTest::hiddenValuesStay() {
  set("kind", "ring");
  type(editor<QLineEdit>("profile"), QStringLiteral("7"));
  QCOMPARE(stored().at("profile"), Value(7.0));
  set("kind", "ball");
  QCOMPARE(seen(), ofBall_);
  QCOMPARE(stored().at("profile"), Value(7.0));
  QCOMPARE(field("profile")->value(), Value(7.0));
  set("profile", 8.0);  // also while it is hidden
  set("kind", "spring");
  QCOMPARE(editor<QLineEdit>("profile")->text(), QStringLiteral("8 mm"));
}

void PanelConditionsTest::whatIsTypedStaysUntilItIsEntered() {
  set("kind", "ring");
  auto* line = editor<QLineEdit>("profile");
  line->setFocus();
  line->selectAll();
  QTest::keyClicks(line, QStringLiteral("5"));
  set("kind", "ball");
  QCOMPARE(seen(), ofRing_);
  QVERIFY(line->hasFocus());
  QCOMPARE(line->text(), QStringLiteral("5"));
  QVERIFY(!stored().contains("profile"));
  QTest::keyClick(line, Qt::Key_Return);
  QCOMPARE(stored().at("profile"), Value(5.0));
  QCOMPARE(seen(), ofBall_);
  settle();
  QCOMPARE(seen(), ofBall_);
}

void PanelConditionsTest::whatIsWrongIsShown() {
  set("turns", 99.0);  // out of its range, by another hand
  QCOMPARE(seen(), (QStringList{"kind", "turns", "radius"}));
  QVERIFY(!field("turns")->problem().isEmpty());
  set("turns", 4.0);
  settle();
  QTRY_COMPARE(seen(), ofBall_);
  set("turns", 0.0);  // the evaluation refuses it
  QTRY_COMPARE(field("turns")->problem(), QStringLiteral("Turns must not be 0."));
  QVERIFY(field("turns")->isVisible());
  type(editor<QLineEdit>("turns"), QStringLiteral("2"));
  settle();
  QTRY_COMPARE(seen(), ofBall_);
  QCOMPARE(stored().at("turns"), Value(2.0));
}

BLOSSOM_WIDGET_TEST(PanelConditionsTest)
#include "panel_conditions_test.moc"
