// The length of a side that is typed as an expression stays one, in the coordinates that move with the side.
#include "modeling/manipulators/side_writing.h"

#include "core/units.h"
#include "feature/registry.h"
#include "modeling/features_outline_value.h"
#include "support/modeling.h"

using namespace blossom;
using namespace blossom::modeling;
using blossom::test::theApp;

namespace {

const std::vector<ParameterSpec>& specs() { return theApp().registry->at("modeling.outline")->parameters; }

DrawnOutline outlineOf(const Value& written) { return drawnOutlineOf(completed(specs(), written)); }

std::vector<double> lengthsOf(const Value& written) {
  std::vector<double> lengths;
  for (const StraightSide& side : straightSides(outlineOf(written))) lengths.push_back((side.to - side.from).norm());
  return lengths;
}

/// A rectangle of 60 x 40 with this as its start, and maybe back to it.
Value rectangle(const Vec2& at, bool returns = false) {
  DrawnOutline outline{at, {}, true};
  for (const Vec2& corner : {Vec2(60, 0), Vec2(60, 40), Vec2(0, 40)})
    outline.segments.push_back({DrawnKind::Line, at + corner, {}, false});
  if (returns) outline.segments.push_back({DrawnKind::Line, at, {}, false});
  return parametersOf(outline);
}

NamedNumbers numbers(double width, double height = 30) { return {{"width", {width, 1, 0}}, {"height", {height, 1, 0}}}; }

/// The parameters after an expression was typed at a side.
Value typed(const Value& written, std::size_t index, const std::string& expression, const NamedNumbers& names) {
  const DrawnOutline before = outlineOf(written);
  const StraightSide side = straightSides(before).at(index);
  const double now = (side.to - side.from).norm(), to = parseLength(expression, {}, names);
  const auto after = withSideLength(before, side.segment, to);
  const auto longer = withSideLength(before, side.segment, 1.5 * now);
  Value next = completed(specs(), written);
  next.update(parametersOf(*after));
  next = keepWritten(specs(), written, completed(specs(), next));
  return withExpressions(next, written, {before, *after, *after == before ? *longer : *after, side, expression}, names);
}

Value withNumbersOf(const Value& written, const NamedNumbers& names) {
  Value all = written;
  for (const ParameterSpec& spec : specs()) all[spec.name] = withNames(spec, written.at(spec.name), names, true);
  return all;
}

const Value& parameterOfEnd(const Value& written) { return written.at("segments").at(0).at("to").at(0); }

std::string lengthAt(const Value& written, std::size_t index) {
  const DrawnOutline outline = outlineOf(written);
  return writtenLength(written, outline, straightSides(outline).at(index));
}

}  // namespace

class SideWritingTest : public QObject {
  Q_OBJECT
 private slots:
  void everySideOfARectangleFollowsItsName();
  void bothSizesOfARectangle();
  void anExpressionForTheSameLength();
  void whatFollowsOfAnOpenOutline();
  void plainNumbersLeaveOtherExpressions();
  void slantedSidesHaveNoAxis();
  void pointsPutInLeaveExpressions();
};

void SideWritingTest::everySideOfARectangleFollowsItsName() {
  for (const bool returns : {false, true})
    for (const Vec2& at : {Vec2(0, 0), Vec2(-12.5, 7)})
      for (std::size_t side = 0; side < 4; ++side) {
        const Value start = rectangle(at, returns);
        const double other = lengthsOf(start)[(side + 1) % 4];
        const Value kept = typed(start, side, "width+20", numbers(60));
        QCOMPARE(lengthAt(kept, side), std::string("width+20"));
        const std::vector<double> now = lengthsOf(kept), later = lengthsOf(withNumbersOf(kept, numbers(90)));
        QCOMPARE(later.size(), std::size_t(4));
        for (std::size_t k = 0; k < 4; ++k) {
          const bool changes = k % 2 == side % 2;
          COMPARE_NEAR(now[k], changes ? 80 : other, 1e-12);
          COMPARE_NEAR(later[k], changes ? 110 : other, 1e-12);
        }
      }
}

void SideWritingTest::bothSizesOfARectangle() {
  Value kept = typed(rectangle({5, 5}), 0, "width", numbers(60));
  kept = typed(kept, 1, "2*height", numbers(60));
  kept = typed(kept, 2, "width-height/3", numbers(60));
  const std::vector<double> lengths = lengthsOf(withNumbersOf(kept, numbers(100, 45)));
  for (std::size_t k = 0; k < 4; ++k) COMPARE_NEAR(lengths[k], k % 2 == 0 ? 85 : 90, 1e-9);
  QCOMPARE(lengthAt(kept, 1), std::string("2*height"));
  QCOMPARE(lengthAt(kept, 2), std::string("width-height/3"));
}

void SideWritingTest::anExpressionForTheSameLength() {
  const Value kept = typed(rectangle({0, 0}), 0, "width", numbers(60));
  QCOMPARE(parameterOfEnd(kept), (Value{{"expression", "width"}, {"value", 60.0}}));
  QCOMPARE(lengthsOf(kept)[0], 60.0);
  QCOMPARE(lengthAt(kept, 0), std::string("width"));
  COMPARE_NEAR(lengthsOf(withNumbersOf(kept, numbers(75)))[2], 75, 1e-12);
}

// A stair: all that comes after the step goes with it, and keeps its own expressions.
void SideWritingTest::whatFollowsOfAnOpenOutline() {
  DrawnOutline stair{{0, 0}, {}, false};
  for (const Vec2& corner : {Vec2(10, 0), Vec2(10, 5), Vec2(20, 5), Vec2(20, 10)})
    stair.segments.push_back({DrawnKind::Line, corner, {}, false});
  stair.segments.push_back({DrawnKind::Arc, {30, 10}, {{25, 15}}, false});
  Value kept = typed(parametersOf(stair), 2, "width/2", numbers(60, 60));
  kept = typed(kept, 0, "height", numbers(60, 60));
  const Value later = withNumbersOf(kept, numbers(80, 50));
  const std::vector<double> lengths = lengthsOf(later), wanted{50, 5, 40, 5};
  for (std::size_t k = 0; k < wanted.size(); ++k) COMPARE_NEAR(lengths[k], wanted[k], 1e-9);
  const DrawnOutline outline = outlineOf(later);
  COMPARE_NEAR((outline.segments.back().to - Vec2(100, 10)).norm(), 0, 1e-9);
  COMPARE_NEAR((outline.segments.back().through[0] - Vec2(95, 15)).norm(), 0, 1e-9);
}

void SideWritingTest::plainNumbersLeaveOtherExpressions() {
  const Value wide = typed(rectangle({0, 0}), 0, "width", numbers(60));
  const DrawnOutline before = outlineOf(wide);
  const StraightSide side = straightSides(before).at(1);
  const auto after = withSideLength(before, 1, 70);
  Value next = completed(specs(), wide);
  next.update(parametersOf(*after));
  const Value kept = withExpressions(keepWritten(specs(), wide, completed(specs(), next)), wide,
                                     {before, *after, *after, side, {}}, numbers(60));
  const std::vector<double> lengths = lengthsOf(withNumbersOf(kept, numbers(33)));
  for (std::size_t k = 0; k < 4; ++k) COMPARE_NEAR(lengths[k], k % 2 == 0 ? 33 : 70, 1e-12);
}

void SideWritingTest::slantedSidesHaveNoAxis() {
  StraightSide side;
  side.to = {3, 4};
  QVERIFY(!axisOf(side));
  side.to = {3, 3e-12};
  QCOMPARE(axisOf(side), std::optional(0));
  side.to = {0, -1};
  QCOMPARE(axisOf(side), std::optional(1));
}

// A list with an item more or less leaves the others as they were written.
void SideWritingTest::pointsPutInLeaveExpressions() {
  const Value wide = typed(rectangle({0, 0}), 0, "width", numbers(60));
  for (const bool more : {true, false}) {
    Value next = completed(specs(), wide);
    Value& segments = next["segments"];
    const auto last = segments.begin() + static_cast<std::ptrdiff_t>(segments.size()) - 1;
    if (more)
      segments.insert(last, valueOf(DrawnSegment{DrawnKind::Line, {30, 40}, {}, false}));
    else
      segments.erase(last);
    const Value kept = keepWritten(specs(), wide, completed(specs(), next));
    QCOMPARE(kept.at("segments").at(0), wide.at("segments").at(0));
    QCOMPARE(kept.at("segments").at(1), wide.at("segments").at(1));
    QCOMPARE(completed(specs(), kept), completed(specs(), next));
    if (more) QCOMPARE(kept.at("segments").at(3), wide.at("segments").at(2));
  }
}

BLOSSOM_TEST(SideWritingTest)
#include "modeling_side_writing_test.moc"
