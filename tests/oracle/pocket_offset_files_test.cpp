#include <filesystem>

#include "core/stopwatch.h"
#include "exchange/formats.h"
#include "geometry/planar/planar.h"
#include "pocket/kernel/medial/boundary.h"
#include "pocket/kernel/offset/clearance_diagram.h"
#include "support/medial_checks.h"
#include "support/support.h"
#include "support/true_distance.h"

using namespace blossom;
using namespace blossom::pocket;
using namespace blossom::test;

namespace {

constexpr double tolerance = 1e-3;

Vec2 pointOn(const Segment& segment, double t) {
  if (const auto* line = std::get_if<Line2>(&segment)) return line->from + t * (line->to - line->from);
  const Arc2& arc = std::get<Arc2>(segment);
  const double angle = arc.start + t * arc.sweep;
  return arc.center + arc.radius * Vec2(std::cos(angle), std::sin(angle));
}

/// Where the loops of an offset cross one another; empty when they do not.
std::string crossingOf(const Region& made) {
  if (made.loops.empty()) return {};
  try {
    (void)Boundary(made, tolerance / 4, Progress::none());
  } catch (const Error& error) {
    return error.message();
  }
  return {};
}

/// Closed outlines of a drawing; lines that do not close are left out.
Curves closedOutlines(const Shape& shape) {
  Curves curves = shape.get<Region>() ? toCurves(*shape.get<Region>()) : joined(*shape.get<Curves>());
  std::erase_if(curves.paths, [](const Path& path) { return !path.closed; });
  return curves;
}

}  // namespace

/// Offsets and axes of drawings that nobody here made, against an independent search on their true curves.
class PocketOffsetFilesTest final : public QObject {
  Q_OBJECT
 private slots:
  void everyFileIsOffsetOrSaysWhyNot_data();
  void everyFileIsOffsetOrSaysWhyNot();
  void cleanupTestCase();

 private:
  void verifyOffset(const Region& part, const ClearanceDiagram&, const TrueDistance&, double distance, Side);
  void verifyAxis(const Region& part, const ClearanceDiagram&);

  std::mt19937_64 random_ = seededRandom();
  std::size_t files_ = 0, offset_ = 0, refused_ = 0, offsets_ = 0, points_ = 0, axisPoints_ = 0, members_ = 0;
  double worst_ = 0, worstAxis_ = 0, worstFoot_ = 0, slowestDiagram_ = 0, slowestOffset_ = 0, maximumSites_ = 0;
};

void PocketOffsetFilesTest::everyFileIsOffsetOrSaysWhyNot_data() {
  NEED_SHARED_DATA();
  QTest::addColumn<QString>("path");
  for (const char* folder : {"svg", "dxf"}) {
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(sharedData() / folder)) files.push_back(entry.path());
    std::sort(files.begin(), files.end());
    for (const fs::path& file : files) QTest::newRow(file.filename().c_str()) << QString::fromStdString(file.string());
  }
}

void PocketOffsetFilesTest::everyFileIsOffsetOrSaysWhyNot() {
  NEED_SHARED_DATA();
  QFETCH(const QString, path);
  ++files_;
  const Curves outlines = closedOutlines(readShape(standardFormats(), path.toStdString()).shape);
  try {
    const Region part = toRegion(outlines);
    const Stopwatch watch;
    const ClearanceDiagram diagram(part, {.tolerance = tolerance});
    const double took = watch.elapsedMs();
    const auto sites = static_cast<double>(diagram.stats().sites);
    slowestDiagram_ = std::max(slowestDiagram_, took);
    maximumSites_ = std::max(maximumSites_, sites);
    ++offset_;
    const TrueDistance truth(part.loops, 1e-7);
    COMPARE_NEAR(truth(diagram.largestCenter()), diagram.largestClearance(), 1e-6);
    for (const double share : {0.01, 0.2, 0.5, 0.8, 0.99, 1.3})
      for (const Side side : {Side::Inside, Side::Outside})
        verifyOffset(part, diagram, truth, share * diagram.largestClearance(), side);
    QVERIFY(diagram.offset(1.001 * diagram.largestClearance(), Side::Inside).loops.empty());
    verifyAxis(part, diagram);
  } catch (const Error& error) {
    // Without a closed outline, or with outlines that cross: said in a sentence with a place and a remedy.
    ++refused_;
    const std::string said = error.message() + " " + error.hint();
    qInfo("refused: %s", said.c_str());
    QCOMPARE(error.code(), ErrorCode::InvalidInput);
    QVERIFY2(outlines.paths.empty() || said.find('(') != std::string::npos, said.c_str());
    QVERIFY2(!error.hint().empty(), said.c_str());
    QVERIFY2(outlines.paths.empty() || said.find("itself") != std::string::npos, said.c_str());
  }
}

void PocketOffsetFilesTest::verifyOffset(const Region& part, const ClearanceDiagram& diagram, const TrueDistance& truth,
                                         double distance, Side side) {
  const Stopwatch watch;
  const Region made = diagram.offset(distance, side);
  slowestOffset_ = std::max(slowestOffset_, watch.elapsedMs());
  ++offsets_;
  // Exactly at the clearance of a flat edge, both sides of the offset lie on it: next to it they do not.
  const bool fine = crossingOf(made).empty() || crossingOf(diagram.offset(distance * (1 - 1e-6), side)).empty();
  QVERIFY2(fine,
           qPrintable(QStringLiteral("its loops at %1 mm: ").arg(distance) + QString::fromStdString(crossingOf(made))));
  for (const Path& loop : made.loops) {
    for (std::size_t i = 0; i < loop.segments.size(); ++i) {
      const Segment& segment = loop.segments[i];
      const Segment& next = loop.segments[(i + 1) % loop.segments.size()];
      COMPARE_NEAR((endPoint(segment) - startPoint(next)).norm(), 0, 1e-9 * (1 + startPoint(next).norm()));
      for (const double t : {0.0, 0.37, 0.81}) {
        const Vec2 p = pointOn(segment, t);
        const double off = std::abs(truth(p) - distance);
        ++points_;
        worst_ = std::max(worst_, off);
        QVERIFY2(off <= tolerance, qPrintable(QStringLiteral("at %1 mm %2: (%3, %4) is off by %5")
                                                  .arg(distance)
                                                  .arg(side == Side::Inside ? "inside" : "outside")
                                                  .arg(p.x())
                                                  .arg(p.y())
                                                  .arg(off)));
      }
    }
  }
  // Random points are in it exactly when they should be: nothing is missing, nothing is turned.
  std::uniform_real_distribution<double> share(0, 1), away(-2, 2);
  for (int i = 0; i < 60; ++i) {
    const Path& near = part.loops[static_cast<std::size_t>(share(random_) * double(part.loops.size()))];
    const auto k = static_cast<std::size_t>(share(random_) * double(near.segments.size()));
    const Vec2 p = startPoint(near.segments[k]) + distance * Vec2(away(random_), away(random_));
    const double far = truth(p);
    if (std::abs(far - distance) < 2 * tolerance || far < tolerance) continue;
    const bool within = windingAround(part.loops, p) == 1;
    const bool wanted = side == Side::Inside ? within && far > distance : within || far < distance;
    ++members_;
    QVERIFY2(windingAround(made.loops, p) == (wanted ? 1 : 0),
             qPrintable(QStringLiteral("(%1, %2) at %3 mm").arg(p.x()).arg(p.y()).arg(distance)));
  }
}

void PocketOffsetFilesTest::verifyAxis(const Region& part, const ClearanceDiagram& diagram) {
  const MedialAxis axis = diagram.medialAxis();
  for (const MedialVertex& vertex : axis.vertices) QVERIFY(vertex.certified);
  const AxisCheck check(part, axis);
  const AxisCheck::Report report = check.all();
  axisPoints_ += report.points;
  worstAxis_ = std::max(worstAxis_, report.worstClearance);
  worstFoot_ = std::max(worstFoot_, report.worstSecondFoot);
  QVERIFY2(report.worstClearance <= tolerance && report.worstSecondFoot <= tolerance && report.outside == 0,
           report.text().c_str());
}

void PocketOffsetFilesTest::cleanupTestCase() {
  if (files_ == 0) return;
  const std::pair<const char*, double> figures[] = {{"files", double(files_)},
                                                    {"files_offset", double(offset_)},
                                                    {"files_refused", double(refused_)},
                                                    {"offsets", double(offsets_)},
                                                    {"points", double(points_)},
                                                    {"members", double(members_)},
                                                    {"worst_offset_mm", worst_},
                                                    {"axis_points", double(axisPoints_)},
                                                    {"worst_axis_mm", worstAxis_},
                                                    {"worst_second_foot_mm", worstFoot_},
                                                    {"most_sites", maximumSites_},
                                                    {"slowest_diagram_ms", slowestDiagram_},
                                                    {"slowest_offset_ms", slowestOffset_}};
  for (const auto& [name, value] : figures) qInfo("figure %s %g", name, value);
}

BLOSSOM_TEST(PocketOffsetFilesTest)
#include "pocket_offset_files_test.moc"
