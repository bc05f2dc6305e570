#include "app/app.h"
#include "geometry/planar/planar.h"
#include "geometry/shape/bounds.h"
#include "modeling/kernel/outline/text_outline.h"
#include "modeling/kernel/outline/text_union.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::modeling;

namespace {

std::size_t holes(const Region& region) {
  std::size_t count = 0;
  for (const auto& component : components(region)) count += component.holes.size();
  return count;
}

Path squareOutline(double x, double y, double side, bool counterClockwise = true) {
  Path path{{}, true, {}, {}};
  const Vec2 corners[] = {{x, y}, {x + side, y}, {x + side, y + side}, {x, y + side}};
  for (int k = 0; k < 4; ++k) path.segments.emplace_back(Line2{corners[k], corners[(k + 1) % 4]});
  return counterClockwise ? path : reversed(path);
}

}  // namespace

/// Outlines of letters. Needs the DejaVu fonts, as building Blossom does.
class ModelingTextTest : public QObject {
  Q_OBJECT
 private slots:
  void lettersHaveTheirHoles_data();
  void lettersHaveTheirHoles();
  void theHeightIsThatOfACapital();
  void sizesScaleTheArea();
  void linesAndAlignment();
  void spacingMovesLettersApart();
  void overlappingContoursAreOneArea();
  void touchingLettersAreUnited();
  void charactersThatAreMissingAreNamed();
  void brokenTextIsRefused();
  void aMissingFontNamesSimilarOnes();
  void aMissingStyleNamesThoseThatThereAre();

 private:
  [[nodiscard]] static FontFace sans() { return installedFace("DejaVu Sans", FontStyle::Regular).value(); }
};

void ModelingTextTest::lettersHaveTheirHoles_data() {
  QTest::addColumn<QString>("text");
  QTest::addColumn<int>("parts");
  QTest::addColumn<int>("holes");
  QTest::newRow("o8B") << "o8B" << 3 << 5;
  QTest::newRow("Blossom") << "Blossom" << 7 << 4;
  QTest::newRow("i and dots") << "iü" << 5 << 0;
  QTest::newRow("percent") << "%" << 3 << 2;
  QTest::newRow("Cyrillic") << "Ж" << 1 << 0;
  QTest::newRow("letter in an open ring") << "@" << 1 << 1;
}

void ModelingTextTest::lettersHaveTheirHoles() {
  QFETCH(const QString, text);
  const TextResult result = textOutline(text.toStdString(), sans(), {});
  QTEST(static_cast<int>(components(result.region).size()), "parts");
  QTEST(static_cast<int>(holes(result.region)), "holes");
  QVERIFY(area(result.region) > 0);
  QVERIFY(result.missing.empty());
  for (const Path& loop : result.region.loops)
    for (std::size_t k = 0; k < loop.segments.size(); ++k)
      COMPARE_NEAR((endPoint(loop.segments[k]) - startPoint(loop.segments[(k + 1) % loop.segments.size()])).norm(), 0, 1e-9);
}

void ModelingTextTest::theHeightIsThatOfACapital() {
  const Bounds box = bounds(Shape(textOutline("H", sans(), {.height = 25, .at = Vec2(3, 4)}).region));
  COMPARE_NEAR(box.low.y(), 4, 1e-9);
  COMPARE_NEAR(box.high.y(), 29, 1e-9);
}

void ModelingTextTest::sizesScaleTheArea() {
  const double one = area(textOutline("Rosé", sans(), {.height = 10}).region);
  COMPARE_NEAR(area(textOutline("Rosé", sans(), {.height = 30}).region), 9 * one, 1e-8);
}

void ModelingTextTest::linesAndAlignment() {
  const auto box = [&](const char* text, TextAlign align) {
    return bounds(Shape(textOutline(text, sans(), {.align = align}).region));
  };
  const Bounds left = box("HH", TextAlign::Left), centre = box("HH", TextAlign::Centre), right = box("HH", TextAlign::Right);
  COMPARE_NEAR(centre.center().x(), 0, 1e-9);  // H stands in the middle of its advance
  COMPARE_NEAR(left.low.x(), -right.high.x(), 1e-9);
  const Bounds two = box("HH\nHH", TextAlign::Left);
  COMPARE_NEAR(two.high.x(), left.high.x(), 1e-9);
  QVERIFY(two.low.y() < -10);
}

void ModelingTextTest::spacingMovesLettersApart() {
  const auto width = [&](double spacing) {
    const Bounds box = bounds(Shape(textOutline("HHH", sans(), {.spacing = spacing}).region));
    return box.high.x() - box.low.x();
  };
  COMPARE_NEAR(width(2) - width(1), width(3) - width(2), 1e-9);
}

void ModelingTextTest::overlappingContoursAreOneArea() {
  const Region both = nonZeroArea({squareOutline(0, 0, 10), squareOutline(5, 5, 10)});
  QCOMPARE(both.loops.size(), std::size_t{1});
  COMPARE_NEAR(area(both), 175, 1e-6);
  // A frame with a bar across its hole: the bar fills what it covers of it.
  const Region barred = nonZeroArea(
      {squareOutline(0, 0, 30), squareOutline(5, 5, 20, false), squareOutline(10, -2, 10), squareOutline(40, 0, 5)});
  COMPARE_NEAR(area(barred), 900 - 400 + 10 * 2 + 10 * 3 + 25, 1e-6);
  // Contours that keep apart stay as they are.
  const Region apart = nonZeroArea({squareOutline(0, 0, 10), squareOutline(2, 2, 3, false)});
  COMPARE_NEAR(area(apart), 91, 1e-12);
}

void ModelingTextTest::touchingLettersAreUnited() {
  const Region wide = textOutline("HH", sans(), {}).region, tight = textOutline("HH", sans(), {.spacing = 0.7}).region;
  QCOMPARE(components(wide).size(), std::size_t{2});
  QCOMPARE(components(tight).size(), std::size_t{1});
  QVERIFY(area(tight) < area(wide) - 1);
}

void ModelingTextTest::charactersThatAreMissingAreNamed() {
  const TextResult result = textOutline("A\U0001F9FFA\U0001F9FF", sans(), {});
  QCOMPARE(result.missing, std::vector<std::string>{"\U0001F9FF"});
  QCOMPARE(result.glyphs, std::size_t{4});
}

void ModelingTextTest::brokenTextIsRefused() {
  for (const char* text : {"", "  \n ", "\xff", "a\xc3", "\xc0\x80", "\xed\xa0\x80"})
    VERIFY_ERROR(textOutline(text, sans(), {}), ErrorCode::InvalidParameter);
}

void ModelingTextTest::aMissingFontNamesSimilarOnes() {
  const App app = loadApp();
  const auto type = app.registry->at("modeling.text");
  const auto evaluate = [&](const Value& given) {
    return type->evaluate(completed(type->parameters, given), Inputs(), Progress::none());
  };
  try {
    (void)evaluate({{"font", "DejaVu Serfi"}});
    QFAIL("there is no such font");
  } catch (const Error& e) {
    QCOMPARE(e.code(), ErrorCode::NotFound);
    QVERIFY2(e.hint().find("DejaVu Serif") != std::string::npos, e.hint().c_str());
  }
  QCOMPARE(evaluate({{"font", "dejavu sans"}, {"text", "B"}}).stats.at("glyphs").get<int>(), 1);
}

void ModelingTextTest::aMissingStyleNamesThoseThatThereAre() {
  QVERIFY(installedFace("DejaVu Sans", FontStyle::Bold).has_value());
  // Of the larger set of fonts, which may not be installed: a family of one face.
  if (const auto single = installedFaces("DejaVu Math TeX Gyre"); !single.empty()) {
    QCOMPARE(single.size(), std::size_t{1});
    QVERIFY(!installedFace("DejaVu Math TeX Gyre", FontStyle::Bold).has_value());
  }
  // Of several upright faces of one family, the plain one.
  QCOMPARE(sans().style, std::string("Book"));
}

BLOSSOM_TEST(ModelingTextTest)
#include "modeling_text_test.moc"
