#include <fmt/format.h>

#include <QTemporaryDir>
#include <map>

#include "support/minkowski_answers.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// What `info` tells of the features of a document.
class SampleResults {
 public:
  explicit SampleResults(const Value& info) {
    for (const Value& feature : info.at("features")) byId_[feature.at("id").get<std::string>()] = feature;
  }
  [[nodiscard]] Value of(const std::string& id) const { return byId_.at(id); }
  [[nodiscard]] double area(const std::string& id) const { return of(id)["result"]["area"].get<double>(); }

 private:
  std::map<std::string, Value> byId_;
};

}  // namespace

/// The samples of sums and morphs, and drawings that nobody here made.
class MinkowskiSamplesTest : public QObject {
  Q_OBJECT

 private slots:
  void theSamplesHoldTheirMorphs() {
    const Answer star = blossom({"info", samplePath("triangle-to-star.blossom")});
    QCOMPARE(star.json["result"]["kind"], Value("sequence"));
    QCOMPARE(star.json["result"]["frames"], Value(49));
    QCOMPARE(blossom({"info", samplePath("phi-to-flower.blossom")}).json["result"]["kind"], Value("sequence"));
    const Answer cut = blossom({"info", samplePath("cutter-room.blossom")});
    QCOMPARE(cut.json["result"]["kind"], Value("region"));
    QCOMPARE(cut.result("holes"), 1.0);
  }

  /// The figures of the paper by its number, and what each is to show.
  void theSamplesShowTheFiguresOfThePaper() {
    // 1: A + A is 2 A for the triangle; B + B is more for the star.
    const SampleResults doubled(inSample("figure-1-doubled-star.blossom"));
    COMPARE_NEAR(doubled.area("region-repeat-1"), doubled.area("transform-1"), 1e-9);
    QVERIFY(doubled.area("region-repeat-2") > 1.3 * doubled.area("transform-5"));
    // 2: fuller with every copy, and inside the hull.
    const SampleResults fuller(inSample("figure-2-towards-the-hull.blossom"));
    double before = 0;
    for (int n = 1; n <= 10; ++n) {
      const double now = fuller.area(fmt::format("region-repeat-{}", n));
      QVERIFY(now > before && now < fuller.area("region-hull-1"));
      before = now;
    }
    // 3: flower, outer sweep, hole sweep and the sum have one hole each, and the sum is the largest.
    const SampleResults flower(inSample("figure-3-flower-and-butterfly.blossom"));
    for (const char* part : {"boolean-2", "outline-sweep-1", "outline-sweep-2", "minkowski-sum-1"}) {
      QCOMPARE(flower.of(part)["result"]["holes"], Value(1));
      QVERIFY(flower.area(part) <= flower.area("minkowski-sum-1"));
    }
    // 4 to 6: sequences.
    const std::pair<const char*, int> sequences[] = {{"figure-4-triangle-to-square.blossom", 1},
                                                     {"figure-6-rounded-by-a-circle.blossom", 4}};
    // 5: five stills of each pair, then its sequence, whose ends they begin and end with.
    const SampleResults pairs(inSample("figure-5-five-pairs.blossom"));
    for (int pair = 0; pair < 5; ++pair) {
      QCOMPARE(pairs.of(fmt::format("morph-{}", 6 * pair + 6))["result"]["frames"], Value(25));
      const auto areaOf = [&](int still) { return pairs.area(fmt::format("morph-{}", 6 * pair + 1 + still).c_str()); };
      for (int still = 1; still < 4; ++still) QVERIFY(areaOf(still) > std::min(areaOf(0), areaOf(4)) - 1e-9);
    }
    for (const auto& [name, morphs] : sequences) {
      const SampleResults results(inSample(name));
      for (int k = 1; k <= morphs; ++k) QCOMPARE(results.of(fmt::format("morph-{}", k))["result"]["frames"], Value(25));
      if (morphs == 4) QCOMPARE(results.of("morph-4")["stats"]["degree"], Value(2));
    }
  }

  /// Two icons that nobody here drew: every in-between has an area between nothing and the sum of both boxes, and the ends
  /// are the icons.
  void realIconsMorph() {
    NEED_SHARED_DATA();
    const fs::path folder = sharedData() / "svg";
    const QString cat = QString::fromStdString((folder / "cat.svg").string()),
                  dog = QString::fromStdString((folder / "dog-side.svg").string());
    const double catArea = areaInFile(folder / "cat.svg"), dogArea = areaInFile(folder / "dog-side.svg");
    COMPARE_NEAR(blossom({"morph", cat, dog, "--t", "0"}).result("area"), catArea, 1e-9 * catArea);
    COMPARE_NEAR(blossom({"morph", cat, dog, "--t", "1"}).result("area"), dogArea, 1e-9 * dogArea);
    // Brunn and Minkowski: the root of the area is concave along the morph.
    for (const double t : {0.25, 0.5, 0.75}) {
      const Answer between = blossom({"morph", cat, dog, "--t", QString::number(t)});
      QVERIFY(std::sqrt(between.result("area")) >= ((1 - t) * std::sqrt(catArea) + t * std::sqrt(dogArea)) * (1 - 1e-4));
    }
  }

 private:
  Value inSample(const char* name) const { return blossom({"info", samplePath(name)}).json; }
  static QString samplePath(const char* name) { return QString::fromStdString(sample(name).string()); }

  Answer blossom(const QStringList& arguments) const { return answerOf(folder_.path(), arguments); }

  QTemporaryDir folder_;
};

BLOSSOM_TEST(MinkowskiSamplesTest)
#include "minkowski_samples_test.moc"
