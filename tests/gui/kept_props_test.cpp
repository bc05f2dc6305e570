// What tools draw: actors stay from frame to frame, and what is seen is always what was given last, in its order.
#include <vtkActor.h>
#include <vtkActor2D.h>
#include <vtkPolyData.h>
#include <vtkPolyDataMapper.h>
#include <vtkPolyDataMapper2D.h>
#include <vtkPropCollection.h>
#include <vtkProperty.h>
#include <vtkRenderer.h>

#include <QtTest>

#include "support/test_main.h"
#include "ui/tools/view_props.h"
#include "ui/view/kept_props.h"
#include "ui/view/prop_share.h"

using namespace blossom;
using namespace blossom::ui;

namespace {

using Props = std::vector<PropPtr>;

constexpr Color red{1, 0, 0}, blue{0, 0, 1};

vtkActor& actorOf(const PropPtr& prop) { return *vtkActor::SafeDownCast(prop); }

vtkPolyData& dataOf(const PropPtr& prop) { return *vtkPolyDataMapper::SafeDownCast(actorOf(prop).GetMapper())->GetInput(); }

Props inOrder(vtkRenderer& renderer) {
  Props props;
  for (int k = 0; k < renderer.GetViewProps()->GetNumberOfItems(); ++k)
    props.emplace_back(vtkProp::SafeDownCast(renderer.GetViewProps()->GetItemAsObject(k)));
  return props;
}

PropPtr label(const QString& text) { return labelProp(text, Vec3::Zero(), {Qt::white, Qt::black, Qt::white}); }

}  // namespace

class KeptPropsTest : public QObject {
  Q_OBJECT
 private slots:
  void init() {
    renderer_ = vtkSmartPointer<vtkRenderer>::New();
    shown_.clear();
  }
  void whatIsMadeAlikeStaysAndShowsTheNew();
  void whatIsOfAnotherSortIsReplacedInItsOrder();
  void theDataGivenStayAsTheyWere();
  void labelsAreAlwaysTheNewOnes();
  void halfThePixelsMakeHalfTheSize();

 private:
  void show(const Props& props) { replaceProps(*renderer_, shown_, props); }

  vtkSmartPointer<vtkRenderer> renderer_;
  Props shown_;
};

void KeptPropsTest::whatIsMadeAlikeStaysAndShowsTheNew() {
  show({linesProp({{{0, 0, 0}, {1, 0, 0}}}, red, 1), pointsProp({{5, 0, 0}}, red, 4)});
  const Props first = shown_;
  const auto shaderAsked = actorOf(first[0]).GetMapper()->GetMTime();
  show({linesProp({{{0, 0, 0}, {2, 0, 0}, {2, 3, 0}}, {{0, 0, 1}, {0, 0, 2}}}, blue, 3),
        pointsProp({{6, 0, 0}, {7, 0, 0}}, blue, 9)});
  QCOMPARE(shown_, first);
  QCOMPARE(inOrder(*renderer_), first);
  QCOMPARE(actorOf(first[0]).GetMapper()->GetMTime(), shaderAsked);  // VTK keeps its shader as long as this stays

  vtkPolyData& lines = dataOf(first[0]);
  QCOMPARE(lines.GetNumberOfLines(), vtkIdType{2});
  QCOMPARE(lines.GetNumberOfPoints(), vtkIdType{5});
  QCOMPARE(Vec3(lines.GetPoint(2)), Vec3(2, 3, 0));
  QCOMPARE(actorOf(first[0]).GetProperty()->GetColor()[2], 1.0);
  QCOMPARE(actorOf(first[0]).GetProperty()->GetLineWidth(), 3.0F);
  QCOMPARE(dataOf(first[1]).GetNumberOfVerts(), vtkIdType{2});
  QCOMPARE(actorOf(first[1]).GetProperty()->GetPointSize(), 9.0F);
}

/// They may be those of a result that is shown again later.
void KeptPropsTest::theDataGivenStayAsTheyWere() {
  const PropPtr first = linesProp({{{0, 0, 0}, {1, 0, 0}}}, red, 1), second = linesProp({{{0, 0, 0}, {9, 0, 0}}}, red, 1);
  const vtkSmartPointer<vtkPolyData> ofFirst = &dataOf(first), ofSecond = &dataOf(second);
  show({first});
  show({second});
  show({linesProp({{{0, 0, 0}, {5, 0, 0}}}, red, 1)});
  QCOMPARE(Vec3(ofFirst->GetPoint(1)), Vec3(1, 0, 0));
  QCOMPARE(Vec3(ofSecond->GetPoint(1)), Vec3(9, 0, 0));
  QCOMPARE(Vec3(dataOf(shown_[0]).GetPoint(1)), Vec3(5, 0, 0));
}

void KeptPropsTest::whatIsOfAnotherSortIsReplacedInItsOrder() {
  const PropPtr lines = linesProp({{{0, 0, 0}, {1, 0, 0}}}, red, 1), points = pointsProp({{5, 0, 0}}, red, 4);
  show({lines, points});
  const Props swapped{pointsProp({{5, 0, 0}}, red, 4), linesProp({{{0, 0, 0}, {1, 0, 0}}}, red, 1)};
  show(swapped);
  QCOMPARE(inOrder(*renderer_), swapped);
  const Props see{trianglesProp({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}, red, 0.5)},
      solid{trianglesProp({{Vec3(0, 0, 0), Vec3(1, 0, 0), Vec3(0, 1, 0)}}, red, 1)};
  show(see);
  show(solid);  // drawn in another pass, and lit
  QCOMPARE(inOrder(*renderer_), solid);

  // Two overlays may draw the same at different depths.
  const Props before{linesProp({{{0, 0, 0}, {1, 0, 0}}}, red, 1)}, among{linesProp({{{0, 0, 0}, {1, 0, 0}}}, red, 1)},
      blended{linesProp({{{0, 0, 0}, {1, 0, 0}}}, red, 1)};
  actorOf(among[0]).GetMapper()->SetRelativeCoincidentTopologyLineOffsetParameters(0, 0);
  actorOf(blended[0]).ForceOpaqueOn();
  for (const Props& each : {before, among, before, blended}) {
    show(each);
    QCOMPARE(inOrder(*renderer_), each);
  }
  show({});
  QVERIFY(inOrder(*renderer_).empty());
  QVERIFY(shown_.empty());
}

void KeptPropsTest::labelsAreAlwaysTheNewOnes() {
  show({linesProp({{{0, 0, 0}, {1, 0, 0}}}, red, 1), label(QStringLiteral("12°"))});
  const Props first = shown_;
  const PropPtr next = label(QStringLiteral("13°"));
  show({linesProp({{{0, 0, 0}, {2, 0, 0}}}, red, 1), next});
  QCOMPARE(shown_, (Props{first[0], next}));
  QCOMPARE(inOrder(*renderer_), shown_);
}

/// In every frame that is drawn at half the size, of actors that stay and of new ones; and back again.
void KeptPropsTest::halfThePixelsMakeHalfTheSize() {
  const auto heightOf = [](const PropPtr& flat) {
    auto* const mapper = vtkPolyDataMapper2D::SafeDownCast(vtkActor2D::SafeDownCast(flat)->GetMapper());
    double bounds[6];
    mapper->GetInput()->GetBounds(bounds);
    return bounds[3] - bounds[2];
  };
  const Props props{linesProp({{{0, 0, 0}, {1, 0, 0}}}, red, 3), pointsProp({{5, 0, 0}}, red, 10), label("a")};
  const double height = heightOf(props[2]);
  for (const double share : {0.5, 0.5, 1.0, 0.5, 1.0}) {
    for (const PropPtr& prop : props) drawAtShare(*prop, share);
    QCOMPARE(static_cast<double>(actorOf(props[0]).GetProperty()->GetLineWidth()), 3 * share);
    QCOMPARE(static_cast<double>(actorOf(props[1]).GetProperty()->GetPointSize()), 10 * share);
    QCOMPARE(heightOf(props[2]), height * share);
  }
}

BLOSSOM_TEST_RUN(KeptPropsTest, (&blossom::test::runTest<KeptPropsTest, QApplication>))
#include "kept_props_test.moc"
