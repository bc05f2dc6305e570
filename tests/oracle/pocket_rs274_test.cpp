#include <fmt/format.h>

#include <set>

#include "core/file.h"
#include "exchange/formats.h"
#include "geometry/planar/planar.h"
#include "pocket/kernel/offset/clearance_diagram.h"
#include "pocket/kernel/path/pocket_path.h"
#include "support/planar_parts.h"
#include "support/reach_raster.h"
#include "support/rs274.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::pocket;
using namespace blossom::test;

namespace {

/// mm: programs are written with four places after the point in mm and five in inches, but rs274 prints four of either.
double resolutionOf(const char* unit) { return unit == std::string("inch") ? 2.54e-3 : 1e-4; }
constexpr double curvesWithin = 5e-5;  // mm, of the oracle

/// The figures that all programs together came to.
struct Figures {
  int parts = 0, programs = 0, refused = 0, arcs = 0;
  double gouge = 0;   ///< mm, of all programs
  double beyond = 0;  ///< share of what arc tolerance and output resolution allow
  double residue = 0, reachable = 0, millimetres = 0;
};

struct Job {
  double share = 0.5;      ///< of the largest tool that fits
  double stepover = 0.45;  ///< of its diameter
  double depths = 2;
  Entry entry = Entry::Ramp;
  bool climb = true, finish = false;
  const char* post = "linuxcnc";
  const char* unit = "mm";
};

/// Every part is cut by each of these; between them they show every entry, both posts and units, a narrow and a full step.
const std::vector<Job>& jobs() {
  static const std::vector<Job> all{
      {0.18, 0.45, 2, Entry::Ramp, true, false, "linuxcnc", "mm"},
      {0.45, 0.95, 3, Entry::Helix, false, true, "grbl", "mm"},
      {0.97, 0.6, 1, Entry::Plunge, true, false, "grbl", "inch"},
  };
  return all;
}

PocketOptions optionsOf(const Job& job, double diameter) {
  PocketOptions o;
  o.cutter.diameter = diameter;
  o.cutter.spindle = 9000;
  o.depth = job.depths * diameter / 2;
  o.stepover = job.stepover * diameter;
  o.climb = job.climb;
  o.entry = job.entry;
  o.finish = job.finish ? 0.04 * diameter : 0;
  o.feed = 700;
  o.plungeFeed = 150;
  return o;
}

/// The ways of the tool's centre, seen from above.
std::vector<ShortLine> linesOfMove(const Vec3& from, const ToolMove& move) {
  std::vector<ShortLine> lines;
  if (move.turn == 0) return {{from.head<2>(), move.to.head<2>()}};
  const std::vector<Vec3> points = polylineOf(from, move, curvesWithin);
  for (std::size_t i = 0; i + 1 < points.size(); ++i) lines.push_back({points[i].head<2>(), points[i + 1].head<2>()});
  return lines;
}

bool isTracked(const std::vector<std::pair<double, ShortLine>>& cut, const Vec3& p) {
  return std::any_of(cut.begin(), cut.end(),
                     [&](const auto& each) { return each.first <= p.z() && each.second.distance(p.head<2>()) < 0.01; });
}

std::string place(const Vec2& p) { return fmt::format("({:.3f}, {:.3f})", p.x(), p.y()); }

/// What LinuxCNC's interpreter makes of one program, held against the part. An empty text when all is well.
std::string complaint(const Toolpath& path, const PocketOptions& o, double resolution, const ReachOracle& oracle,
                      Figures& figures) {
  std::vector<ShortLine> floor;
  std::vector<std::pair<double, ShortLine>> cut;
  std::set<std::tuple<double, double, double, double, double, double, int>> seen;
  double worst = 0;
  Vec2 worstAt = Vec2::Zero();
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Vec3 from = startOf(path, i);
    const ToolMove& m = path.moves[i];
    const double low = std::min(from.z(), m.to.z()), high = std::max(from.z(), m.to.z());
    if (low < -o.depth - resolution) return fmt::format("the floor is cut {:.4f} mm too deep", -o.depth - low);
    if (m.turn != 0) ++figures.arcs;
    if (m.kind == MoveKind::Rapid) {
      const bool across = (m.to - from).head<2>().norm() > 2 * resolution;
      if (across && low < 0) return "a rapid runs across within the stock to " + place(m.to.head<2>());
      if (!across && m.to.z() < from.z() && m.to.z() < 0 && !isTracked(cut, m.to))
        return "a rapid falls into the stock at " + place(m.to.head<2>());
      continue;
    }
    if (low >= 0) continue;
    const auto lines = linesOfMove(from, m);
    for (const ShortLine& line : lines) {
      cut.emplace_back(high, line);
      if (high <= -o.depth + resolution) floor.push_back(line);
    }
    if (m.to.z() <= -o.depth + resolution && high > -o.depth + resolution) floor.push_back({m.to.head<2>(), m.to.head<2>()});
    if (!seen.insert({from.x(), from.y(), m.to.x(), m.to.y(), m.center.x(), m.center.y(), m.turn}).second) continue;
    // Between two samples the distance to a corner r away changes by apart^2 / 8 r.
    const double apart = std::sqrt(8 * o.cutter.diameter / 2 * 2e-4);
    for (const ShortLine& line : lines) {
      const int steps = std::max(1, static_cast<int>(std::ceil((line.to - line.from).norm() / apart)));
      for (int k = 0; k <= steps; ++k) {
        const Vec2 p = line.from + (line.to - line.from) * (static_cast<double>(k) / steps);
        if (const double gouge = oracle.gouge(p); gouge > worst) worst = gouge, worstAt = p;
      }
    }
    figures.millimetres += lengthOf(from, m);
  }
  const ReachOracle::Left left = oracle.left(floor, o.cutter.diameter / 2 + o.tolerance + resolution);
  figures.gouge = std::max(figures.gouge, worst);
  figures.beyond = std::max(figures.beyond, worst / (o.tolerance + resolution));
  figures.residue = std::max(figures.residue, left.area);
  figures.reachable += oracle.reachable();
  ++figures.programs;
  if (worst > o.tolerance + resolution) return fmt::format("a gouge of {:.5f} mm at {}", worst, place(worstAt));
  if (left.area > 0) return fmt::format("{:.5f} mm2 are left at {}", left.area, place(left.at));
  return {};
}

/// One part, one job: made, written, interpreted, swept.
std::string complaint(const Region& part, const Job& job, double largest, Figures& figures) {
  const double diameter = std::floor(2 * largest * job.share * 1000) / 1000;
  if (diameter < 0.05) return {};
  PocketOptions o = optionsOf(job, diameter);
  if (largest <= diameter / 2 + o.finish) o.finish = 0;
  const PocketResult made = pocketPath(part, o);
  const TemporaryFolder folder;
  const fs::path file = folder.path() / "pocket.ngc";
  static const FormatRegistry formats = standardFormats();
  writeShape(formats, made.path, file, {{"post", job.post}, {"unit", job.unit}});
  const Interpreted run = interpret(file);
  if (!run.good) return "rs274: " + run.log;
  const ReachOracle oracle(part, diameter / 2, curvesWithin, 5e5);
  return complaint(run.path, o, resolutionOf(job.unit), oracle, figures);
}

/// Ten times as large: icons are drawn in an inch.
Region enlarged(Region part, double factor) {
  Eigen::Matrix<double, 2, 3> by = Eigen::Matrix<double, 2, 3>::Zero();
  by(0, 0) = by(1, 1) = factor;
  for (Path& loop : part.loops) loop = transformed(loop, by);
  return part;
}

std::optional<Region> partIn(const fs::path& file) {
  static const FormatRegistry formats = standardFormats();
  const Imported imported = readShape(formats, file);
  if (const auto* region = imported.shape.get<Region>()) return *region;
  const auto* curves = imported.shape.get<Curves>();
  if (!curves) return std::nullopt;
  Curves closed{{}, curves->fillRule};
  for (const Path& path : joined(*curves).paths)
    if (path.closed) closed.paths.push_back(path);
  if (closed.paths.empty()) return std::nullopt;
  return toRegion(closed);
}

}  // namespace

/// Every program runs through LinuxCNC's own interpreter; what it would do on the machine is swept here by means that
/// share nothing with the path's making: gouge by distances to the true curves, residue against the part opened by the tool.
class PocketRs274Test final : public QObject {
  Q_OBJECT
 private slots:
  void closedFormsAreReachedAsTheyShould() {
    // the oracle itself: a square of 40 opened by a tool of 5 loses (4 - pi) r^2
    const ReachOracle oracle({{boxPath(0, 0, 40, 40)}}, 5, 1e-5, 1e6);
    COMPARE_NEAR(oracle.reachable(), 1600 - (4 - std::numbers::pi) * 25, 12);
    COMPARE_NEAR(oracle.gouge({20, 4.75}), 0.25, 1e-12);
    COMPARE_NEAR(oracle.gouge({20, 20}), 0, 1e-12);
    COMPARE_NEAR(oracle.gouge({20, -1}), 6, 1e-12);
    // one way around at 5 leaves the inner square of 40 - 4 x 5 with its round corners
    const std::vector<ShortLine> around{{{5, 5}, {35, 5}}, {{35, 5}, {35, 35}}, {{35, 35}, {5, 35}}, {{5, 35}, {5, 5}}};
    COMPARE_NEAR(oracle.left(around, 5).area, 400, 4);
  }

  void ownParts() {
    NEED_INTERPRETER();
    Figures figures;
    const std::vector<Region> parts{
        {{boxPath(0, 0, 60, 40), circlePath({30, 20}, 8, true)}},
        {{wavyPath({0, 0}, 25, 6, 5), wavyPath({2, 1}, 8, 1.5, 3, true)}},
        {{polygonPath({{0, 0}, {50, 0}, {20, 12}, {12, 50}, {-6, 20}})}},
        {{boxPath(0, 0, 20, 20), boxPath(30, 0, 50, 20), circlePath({80, 10}, 9)}},
    };
    for (const Region& part : parts) {
      ++figures.parts;
      const double largest = ClearanceDiagram(part, {.tolerance = 0.005}).largestClearance();
      for (const Job& job : jobs()) {
        const std::string wrong = complaint(part, job, largest, figures);
        QVERIFY2(wrong.empty(), qPrintable(QString("part %1, tool %2: ").arg(figures.parts).arg(job.share) + wrong.c_str()));
      }
    }
    print("own", figures);
  }

  void drawings_data() {
    QTest::addColumn<QString>("file");
    QTest::addColumn<double>("factor");
    if (!fs::exists(sharedData())) return;
    for (const auto& [folder, factor] : {std::pair("svg", 10.0), std::pair("dxf", 1.0)}) {
      std::set<fs::path> files;
      for (const auto& entry : fs::directory_iterator(sharedData() / folder)) files.insert(entry.path());
      for (const fs::path& file : files) QTest::newRow(file.filename().c_str()) << QString(file.c_str()) << factor;
    }
  }
  void drawings() {
    NEED_SHARED_DATA();
    NEED_INTERPRETER();
    QFETCH(QString, file);
    QFETCH(double, factor);
    Figures& figures = drawings_;
    double largest = 0;
    Region part;
    try {
      const std::optional<Region> found = partIn(file.toStdString());
      if (!found) return;  // nothing closed in it
      part = enlarged(*found, factor);
      largest = ClearanceDiagram(part, {.tolerance = 0.005}).largestClearance();
    } catch (const Error& error) {
      ++figures.refused;
      qInfo("no part: %s", error.message().c_str());
      return;
    }
    ++figures.parts;
    for (const Job& job : jobs()) {
      const std::string wrong = complaint(part, job, largest, figures);
      QVERIFY2(wrong.empty(), qPrintable(QString("tool %1: ").arg(job.share) + wrong.c_str()));
    }
  }
  void cleanupTestCase() {
    if (drawings_.parts > 0) print("drawings", drawings_);
  }

  /// A tool that is too large is refused, and the size told is the truth to a hundredth.
  void theLargestToolThatFitsDoesFit() {
    NEED_INTERPRETER();
    const Region part{{wavyPath({0, 0}, 25, 6, 5), wavyPath({2, 1}, 8, 1.5, 3, true)}};
    PocketOptions o = optionsOf(jobs()[0], 30);
    double told = 0;
    try {
      (void)pocketPath(part, o);
      QFAIL("a tool of 30 mm");
    } catch (const Error& error) {
      const QRegularExpressionMatch found = QRegularExpression("diameter of ([0-9.]+) mm").match(error.hint().c_str());
      QVERIFY2(found.hasMatch(), error.hint().c_str());
      told = found.captured(1).toDouble();
    }
    o.cutter.diameter = told;
    o.stepover = 0;
    QVERIFY(!pocketPath(part, o).path.moves.empty());
    o.cutter.diameter = told + 0.011;
    VERIFY_ERROR(pocketPath(part, o), ErrorCode::InvalidInput);
  }

 private:
  static void print(const std::string& name, const Figures& f) {
    std::printf("figure %s_parts %d\nfigure %s_refused %d\nfigure %s_programs %d\nfigure %s_arcs %d\n", name.c_str(),
                f.parts, name.c_str(), f.refused, name.c_str(), f.programs, name.c_str(), f.arcs);
    std::printf("figure %s_gouge %.6f\nfigure %s_gouge_share %.4f\nfigure %s_residue %.6f\n", name.c_str(), f.gouge,
                name.c_str(), f.beyond, name.c_str(), f.residue);
    std::printf("figure %s_reachable %.1f\nfigure %s_path %.0f\n", name.c_str(), f.reachable, name.c_str(), f.millimetres);
    std::fflush(stdout);
  }
  Figures drawings_;
};

BLOSSOM_TEST(PocketRs274Test)
#include "pocket_rs274_test.moc"
