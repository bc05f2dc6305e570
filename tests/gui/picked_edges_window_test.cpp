#include <QToolButton>

#include "naming/likeness.h"
#include "ui/controls/chip.h"
#include "ui/fields/parameter_field.h"
#include "ui/look/text.h"
#include "ui/panel/property_panel.h"
#include "ui/tools/view_props.h"
#include "ui/tree/document_tree.h"
#include "ui/view/view_widget.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;

/// The edges of a fillet in the window: lit while they are picked, lost by an edit, and picked again.
class PickedEdgesWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() {
    openWindow();
    window_->commands().action(QStringLiteral("file.new"))->trigger();
  }
  void cleanup() { window_.reset(); }
  void chosenEdgesAreLitWhileMoreArePicked();
  void aLostEdgeIsPickedAgain();

 private:
  static Value outline(const std::vector<Vec2>& corners);
  static Value edgeNumber(int index) { return {{"input", "shape"}, {"kind", "edge"}, {"index", index}}; }
  [[nodiscard]] ParameterField& edges() const { return *window_->properties().field(QStringLiteral("edges")); }
  [[nodiscard]] QToolButton& pickButton() const { return *edges().findChild<QToolButton*>(QStringLiteral("fieldButton")); }
  /// The edge of a solid in a place, as a click on it finds it.
  [[nodiscard]] Pick edgeAt(const FeatureId& solid, const Vec3& place) const;
  [[nodiscard]] QList<Chip*> chips() const {
    QCoreApplication::sendPostedEvents(nullptr, QEvent::DeferredDelete);
    return edges().findChildren<Chip*>();
  }
};

Value PickedEdgesWindowTest::outline(const std::vector<Vec2>& corners) {
  Value segments = Value::array();
  for (std::size_t k = 1; k < corners.size(); ++k)
    segments.push_back({{"kind", "line"}, {"to", {corners[k].x(), corners[k].y(), 0}}});
  return {{"start", {corners[0].x(), corners[0].y(), 0}}, {"segments", segments}};
}

Pick PickedEdgesWindowTest::edgeAt(const FeatureId& solid, const Vec3& place) const {
  const std::vector<Likeness> all = likenesses(window_->session().view(solid)->shape, SubShapeKind::Edge);
  Pick pick;
  pick.feature = solid;
  pick.part.kind = SubShapeKind::Edge;
  pick.part.point = place;
  for (std::size_t k = 0; k < all.size(); ++k)
    if ((all[k].place - place).norm() < 1e-6) pick.part.index = static_cast<int>(k);
  return pick;
}

void PickedEdgesWindowTest::chosenEdgesAreLitWhileMoreArePicked() {
  const FeatureId box = add("modeling.box", {{"width", 40}, {"depth", 30}, {"height", 20}});
  Value all = Value::array();
  for (int k = 0; k < 12; ++k) all.push_back(edgeNumber(k));
  const FeatureId rounded = add("modeling.fillet", {{"radius", 3}, {"edges", all}}, {box});
  window_->tree().select(rounded);
  const MarkedParts& marked = window_->view().markedParts();
  QVERIFY(marked.chosen.empty());
  pickButton().click();
  QCOMPARE(marked.chosen.size(), std::size_t{12});
  window_->view().fit(false);
  QVERIFY(marked.chosen.front().feature == box);
  const QColor color = qtColor(Look::dark().control);
  const Vec3 middle = likenessOf(window_->session().view(box)->shape, SubShapeKind::Edge, 0).place;
  const double lit = colored(canvas(), color);
  window_->view().setMarkedParts({});
  QVERIFY(lit > colored(canvas(), color) + 1e-4);

  window_->properties().offerPick(edgeAt(box, middle));  // one is let go of
  QCOMPARE(edges().value().size(), std::size_t{11});
  QCOMPARE(marked.chosen.size(), std::size_t{11});
  QTest::keyClick(&window_->view(), Qt::Key_Escape);
  QTRY_VERIFY(marked.chosen.empty());
}

void PickedEdgesWindowTest::aLostEdgeIsPickedAgain() {
  const FeatureId drawing = add("modeling.outline", outline({{0, 0}, {60, 0}, {60, 40}, {0, 40}}));
  const FeatureId solid = add("modeling.extrude", {{"height", 20}}, {drawing});
  const Vec3 corner(60, 40, 10);
  const Pick first = edgeAt(solid, corner);
  QVERIFY(first.part.index >= 0);
  const FeatureId rounded =
      add("modeling.fillet", {{"radius", 1}, {"edges", Value::array({edgeNumber(first.part.index)})}}, {solid});
  window_->tree().select(rounded);
  QVERIFY(!window_->session().view(rounded)->result->error);
  QVERIFY(chips().front()->problem().isEmpty());

  // The corner is cut off: its edge is gone, and two others are near.
  Feature drawn = window_->page().document().at(drawing);
  drawn.parameters = outline({{0, 0}, {60, 0}, {60, 36}, {56, 40}, {0, 40}});
  window_->session().commit(window_->page().document().with(drawn), QStringLiteral("Cut the corner"));
  waitUntilComputed();
  QVERIFY(window_->session().view(rounded)->result->error);
  QCOMPARE(chips().size(), 1);
  QVERIFY(!chips().front()->problem().isEmpty());

  pickButton().click();
  QVERIFY(window_->view().markedParts().chosen.empty());  // what is lost is nowhere
  window_->properties().offerPick(edgeAt(solid, {60, 36, 10}));
  waitUntilComputed();
  QVERIFY(!window_->session().view(rounded)->result->error);
  QCOMPARE(chips().size(), 1);
  QVERIFY(chips().front()->problem().isEmpty());
  QCOMPARE(window_->view().markedParts().chosen.size(), std::size_t{1});
}

BLOSSOM_WINDOW_TEST(PickedEdgesWindowTest)
#include "picked_edges_window_test.moc"
