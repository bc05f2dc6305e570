#include "geometry/shape/bounds.h"
#include "ui/tree/document_tree.h"
#include "window_fixture.h"

using namespace blossom;
using namespace blossom::ui;
using namespace blossom::test;

/// The arrows of a transformed shape, seen from the front: x to the right, z up.
class ModelingMoveWindowTest : public WindowFixture {
  Q_OBJECT
 private slots:
  void initTestCase() { setUpOnce(); }
  void init() {
    openNewDocument();
    const FeatureId box = add("modeling.box", {{"width", 20}, {"depth", 20}, {"height", 20}});
    moved_ = add("modeling.transform", Value::object(), {box});
    run("view.front");
    QTRY_VERIFY(std::abs(window_->view().camera().turn().pitch) < 1e-9);
    QTest::qWait(0);
    window_->tree().select(moved_);
    middle_ = middleOf(moved_);
  }
  void cleanup() { window_.reset(); }

  void anArrowMovesAlongItsAxis() {
    const double pixel = window_->view().camera().millimetresPerPixel();
    drag(middle_ + Vec3(0, 0, 40 * pixel), middle_ + Vec3(30 * pixel, 0, 90 * pixel), Qt::ControlModifier);
    COMPARE_NEAR(move()[2], 50 * pixel, 3 * pixel);
    QVERIFY(move()[0] == 0 && move()[1] == 0);
    COMPARE_NEAR(middleOf(moved_).z(), middle_.z() + move()[2], 1e-6);
    window_->session().undo();
    QCOMPARE(move(), Vec3(0, 0, 0));
  }

  void stepsAreShortNumbers() {
    const double pixel = window_->view().camera().millimetresPerPixel();
    drag(middle_ + Vec3(40 * pixel, 0, 0), middle_ + Vec3(77 * pixel, 0, 5 * pixel), {});
    QVERIFY(move()[0] > 0);
    const double hundred = 100 * move()[0];
    COMPARE_NEAR(hundred, std::round(hundred), 1e-9);
    QVERIFY(move()[1] == 0 && move()[2] == 0);
  }

  void whatIsMadeOfItFollows() {
    const FeatureId ball = add("ball", {{"radius", 3}, {"subdivisions", 1}});
    const FeatureId sum = add("morphology.solid-sum", Value::object(), {moved_, ball});
    window_->tree().select(moved_);
    const Vec3 before = middleOf(sum);
    const double pixel = window_->view().camera().millimetresPerPixel();
    drag(middle_ + Vec3(0, 0, 40 * pixel), middle_ + Vec3(0, 0, 80 * pixel), Qt::ControlModifier);
    COMPARE_NEAR(middleOf(sum).z(), before.z() + move()[2], 1e-6);
    QVERIFY(move()[2] > 0);
  }

  void escapeTakesItBack() {
    const double pixel = window_->view().camera().millimetresPerPixel();
    const QPoint from = screenOf(middle_ + Vec3(0, 0, 40 * pixel));
    moveMouse(&window_->view(), from);
    mouse(QEvent::MouseButtonPress, from);
    mouse(QEvent::MouseMove, from - QPoint(0, 50));
    QTest::keyClick(&window_->view(), Qt::Key_Escape);
    mouse(QEvent::MouseButtonRelease, from - QPoint(0, 50));
    waitUntilComputed();
    QCOMPARE(move(), Vec3(0, 0, 0));
  }

 private:
  void drag(const Vec3& start, const Vec3& end, Qt::KeyboardModifiers modifiers) {
    const QPoint from = screenOf(start), to = screenOf(end);
    moveMouse(&window_->view(), from);
    mouse(QEvent::MouseButtonPress, from, modifiers);
    mouse(QEvent::MouseMove, (from + to) / 2, modifiers);
    mouse(QEvent::MouseMove, to, modifiers);
    mouse(QEvent::MouseButtonRelease, to, modifiers);
    waitUntilComputed();
  }
  [[nodiscard]] Vec3 move() const {
    const Value& given = window_->page().document().at(moved_).parameters;
    const auto found = given.find("move");
    if (found == given.end()) return Vec3::Zero();
    return {found->at(0).get<double>(), found->at(1).get<double>(), found->at(2).get<double>()};
  }
  [[nodiscard]] Vec3 middleOf(const FeatureId& id) const {
    return bounds(window_->session().view(id)->result->evaluated.shape).center();
  }

  FeatureId moved_;
  Vec3 middle_ = Vec3::Zero();
};

BLOSSOM_WINDOW_TEST(ModelingMoveWindowTest)
#include "modeling_move_window_test.moc"
