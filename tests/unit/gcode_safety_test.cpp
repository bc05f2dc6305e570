// Programs that are read as a tool's moves: what cannot be followed exactly is refused, and nothing that the tool does is
// left out.
#include <Eigen/Geometry>
#include <numbers>
#include <regex>

#include "core/file.h"
#include "exchange/formats.h"
#include "exchange/gcode/gcode_program.h"
#include "exchange/gcode/gcode_write.h"
#include "support/splines.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

const std::string head = "G21 G90 G17\nT1 M6\nS12000 M3\n";

GcodeProgram parsed(const std::string& text) { return parseGcode(text, Progress::none()); }

Toolpath pathOf(const std::string& text) { return toolpathOf(parsed(text)); }

/// Why a toolpath cannot be made of it; empty when it can.
std::string obstacle(const std::string& text) {
  const GcodeProgram program = parsed(text);
  return program.obstacle ? program.obstacle->second : std::string();
}

std::string written(const Toolpath& path, const Value& options = Value::object()) {
  return gcodeText(path, options, Progress::none());
}

/// Arcs one after another, each turned by up to `kink` radians against the one before; the centre of arc `slipped` is off by
/// 0.05 mm in I or J, whichever moves the tool; or, of arcs that are written by their radius, along
/// their bisector. Those are longer: short ones hardly move with their radius.
std::string chainOfArcs(Random& random, int count, double kink, int slipped, bool byRadius = false) {
  std::string text = "G21 G90 G17\nS500 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\n";
  double heading = uniform(random, 0, 6);
  Vec2 at(0, 0);
  for (int k = 0; k < count; ++k) {
    const double turn = random() % 3 == 0 ? -1 : 1, radius = uniform(random, 3, 30),
                 sweep = byRadius ? uniform(random, 0.8, 2) : uniform(random, 0.25, 0.8);
    const Vec2 towards = radius * turn * Vec2(-std::sin(heading), std::cos(heading)), centre = at + towards;
    const Vec2 to = centre + Eigen::Rotation2Dd(turn * sweep) * Vec2(-towards);
    Vec2 written = towards;
    const double middle = heading + turn * sweep / 2;
    if (k == slipped) written[std::abs(std::sin(middle)) > 0.7 ? 1 : 0] += 0.05;
    text += fmt::format("{} X{:.3f} Y{:.3f} ", turn > 0 ? "G3" : "G2", to.x(), to.y());
    if (byRadius)
      text += fmt::format("R{:.3f}\n", radius + (k == slipped ? 0.05 * std::cos(sweep / 2) : 0));
    else
      text += fmt::format("I{:.3f} J{:.3f}\n", written.x(), written.y());
    heading += turn * sweep + uniform(random, -kink, kink);
    at = to;
  }
  return text;
}

}  // namespace

class GcodeSafetyTest : public QObject {
  Q_OBJECT
 private slots:
  void whatMayMoveTheToolIsRefused_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("why");
    const auto row = [](const char* line, const char* why) { QTest::newRow(line) << line << why; };
    row("G68 X0 Y0 R10", "rotation");
    row("G51 P2", "scaling");
    row("G50 X3", "G50");
    row("G16", "polar");
    row("G65 P9100 X10 Y10 Z-20", "macro");
    row("G13 I80", "G13");
    row("M97 P100", "subroutine");
    row("M98 P100", "subroutine");
    row("M150", "M150");
    row("M70", "M70");
    row("G43.1 Z-30", "G43.1");
    row("G4 X60.", "dwell");
    row("G70", "G70");
    row("G777", "G777");
    row("G93", "feed");
    row("G92 X0", "zero");
    row("G92.3", "zero");
    row("G7", "G7");
    row("G1 W-30", "axis");
    row("G1 U3", "axis");
    row("G1 A90", "rotary");
    row("#5221=30", "parameter");
    row("G55", "offset");
    row("G54.1 P2", "offset");
    row("G53 G1 Z-200", "G53");
    row("G3 X20 Y10 I0 J10 P2", "turns");
    row("G81 X1 Y1 Z-3 R1", "drilling");
    row("T2 M6", "second tool");
    row("T2", "second tool");
    row("(ramp (steep) G1 X97 Z-2)", "comment");
    row("/G1 X90", "left out");
  }

  void whatMayMoveTheToolIsRefused() {
    QFETCH(QString, line);
    QFETCH(QString, why);
    // M6 has a tool before it; T alone changes the tool where there is no M6
    const std::string before = line == QStringLiteral("T2") ? "G21 G90 G17\nT1\nS12000 M3\n" : head;
    const std::string program =
        before + "G54\nG0 X10 Y10\nG0 Z5\nG1 Z-1 F100\nG1 X20\n" + line.toStdString() + "\nG1 Y20\nG0 Z5\nM2\n";
    const std::string found = obstacle(program);
    QVERIFY2(QString::fromStdString(found).contains(why), qPrintable(line + QStringLiteral(": ") + found.c_str()));
    VERIFY_ERROR(toolpathOf(parsed(program)), ErrorCode::FormatDamaged);
  }

  void whatLeavesTheWayAloneIsNot() {
    const char* const lines[] = {"G4 P2", "M8",      "M9",      "M0",         "M1",  "G64 P0.01", "G61",          "G40",
                                 "G49",   "G80",     "G94",     "G43 H1",     "G17", "G98",       "G92.1",        "G69",
                                 "G15",   "N30",     "T1",      "T1 M6",      "G54", "M5",        "S9000",        "G97",
                                 "O100",  "(plain)", "; (a (b", "#<depth>=3", "G8",  "M48",       "G28 Z0\nG0 Z5"};
    for (const char* line : lines) {
      const std::string found =
          obstacle(head + "G54\nG0 X10 Y10\nG0 Z5\nG1 Z-1 F100\nG1 X20\n" + line + "\nG1 Y20\nG0 Z5\nM2\n");
      QVERIFY2(found.empty(), (std::string(line) + ": " + found).c_str());
    }
  }

  void aRapidIntoTheMaterialIsAMoveLikeOthers() {
    const Toolpath path = pathOf(head + "G0 X50 Y30\nG0 Z-5\nG1 X60 F300\nG0 Z5\nM30\n");
    QCOMPARE(path.start, Vec3(50, 30, 5));
    QCOMPARE(path.moves.front().kind, MoveKind::Rapid);
    QCOMPARE(path.moves.front().to, Vec3(50, 30, -5));
    // Height first: it comes down over the place, from as high as the program ever is.
    const Toolpath across = pathOf(head + "G0 Z-5\nG0 X-50 Y0\nG1 X60 F300\nG0 Z7\nM30\n");
    QCOMPARE(across.start, Vec3(-50, 0, 7));
    QCOMPARE(across.moves.front().to, Vec3(-50, 0, -5));
    // X alone is no place yet.
    const Toolpath late = pathOf(head + "G0 Z5\nG0 X1\nG0 Y2\nG1 Z-1 F100\nG1 X9\nM2\n");
    QCOMPARE(late.start, Vec3(1, 2, 5));
    QCOMPARE(late.moves.size(), std::size_t{2});
  }

  void fromAPlaceOfTheMachineNothingIsCut() {
    const std::string begin = head + "G0 X10 Y10 Z5\nG1 Z-1 F100\n";
    QVERIFY(obstacle(begin + "G53 G0 X0 Y0\nG1 Y40\n").find("does not tell") != std::string::npos);
    QVERIFY(obstacle(begin + "G28 Z0\nG1 Y40\n").find("does not tell") != std::string::npos);
    QVERIFY(obstacle(begin + "G91 G28 Z0\nG1 X3\nG90\n").find("does not tell") != std::string::npos);
    QVERIFY(obstacle(begin + "G0 Z5\nG91 G28 Z0\nG90 G0 X0 Y0\nG0 Z5\nG1 Y40\n").empty());
    // Over the place that is named, and no longer at the depth it was.
    const Toolpath path = pathOf(begin + "G28 X5 Y5\nG0 X1 Y1 Z9\nG1 Y40\n");
    QCOMPARE(path.moves[2].to, Vec3(5, 5, -1));
    const Toolpath lifted = pathOf(begin + "G91 G28 Z0\nG90\nG0 X60 Y60\nG0 Z9\nG1 Y40\n");
    for (const ToolMove& move : lifted.moves)
      if (move.to.x() == 60) QCOMPARE(move.to.z(), 9.0);  // as high as it ever is
  }

  void modesCountWhereverTheyStand() {
    const Toolpath path = pathOf(head + "G0 X0 Y0 Z1\nG1 X1 Y1 Z-1 F10 G20\nM2\n");
    QCOMPARE(path.moves.back().to, Vec3(25.4, 25.4, -25.4));
    QCOMPARE(path.moves.back().feed, 254.0);
  }

  void theFirstCutTellsToolAndSpindle() {
    const std::string cut = "G0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X5\n";
    const Toolpath ready = pathOf("G21 G90\nT3 M6\nM3 S8000\n" + cut + "T7\nG1 Y5\nM5 S0\nG0 Z5\nM2\n");
    QCOMPARE(ready.cutter.number, 3);  // 7 is only made ready
    QCOMPARE(ready.cutter.spindle, 8000.0);
    QCOMPARE(pathOf("G21 G90\nT3 M6\nS500\nM3\n" + cut + "M2\n").cutter.spindle, 500.0);
    QCOMPARE(parsed("G21 G90\nM3\n" + cut).doubts,
             std::vector<std::string>{"line 4 cuts without a speed of the spindle above 0 (S)"});
    QCOMPARE(parsed("G21 G90\nS100 M3\nM5\n" + cut).doubts,
             std::vector<std::string>{"line 5 cuts while the spindle stands still; line 3 stopped it"});
    QVERIFY(parsed(head + cut).doubts.empty());
    QCOMPARE(parsed("G21 G90\nT1 M6\nS500 M4\nM8\n" + cut + "G4 P1\nM0\nM9\n").notKept,
             (std::vector<std::string>{"a spindle that turns counter-clockwise (M4)", "dwells (G4)", "stops (M0)"}));
    // Coolant that runs from before the first cut to after the last is kept, and so is the wait for the spindle.
    const std::string cooled = "G21 G90\nT1 M6\nS500 M3\nG4 P2\nM8\n" + cut;
    QVERIFY(parsed(cooled + "M9\nM5\n").notKept.empty());
    QVERIFY(written(pathOf(cooled + "M9\nM5\n")).find("\nM8\n") != std::string::npos);
    QCOMPARE(parsed(cooled + "M9\nG1 X9\n").notKept, std::vector<std::string>{"changes of the coolant (M7, M8, M9)"});
  }

  /// The line of the only doubt; 0 when there is none.
  static std::size_t doubted(const std::string& text, const std::string& what) {
    for (const std::string& doubt : parsed(text).doubts) {
      std::smatch found;
      if (doubt.find(what) != std::string::npos && std::regex_search(doubt, found, std::regex("line (\\d+)")))
        return std::stoul(found[1]);
    }
    return 0;
  }

  void whatACarefulReaderWouldDoubtIsToldWithItsLine() {
    const std::string cut = "G0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X5\nG0 Z5\n";
    const std::string begin = "G21 G90 G17\nT3 M6\n";
    QCOMPARE(doubted(begin + "G43 H4\nS500 M3\n" + cut, "length"), std::size_t{3});
    QCOMPARE(doubted(begin + "G43 Z9 H4\nS500 M3\n" + cut, "length"), std::size_t{3});
    QCOMPARE(doubted("G21 G43 H4\nT3 M6\nS500 M3\n" + cut, "length"), std::size_t{1});
    for (const char* same : {"G43 H3", "G43", "g43h03", "T5 G43 H3", "G43 H5 G49\nG43 H3", "(G43 H4)"})
      QCOMPARE(doubted(begin + same + "\nS500 M3\n" + cut, "length"), std::size_t{0});
    QCOMPARE(doubted("G90\nS500 M3\n" + cut, "millimetres"), std::size_t{3});
    QCOMPARE(doubted("G90\nS500 M3\nG0 X1\nG21\n" + cut, "millimetres"), std::size_t{3});
    QCOMPARE(doubted("G90\nG91 G28 Z0\nG90 G20\nS500 M3\n" + cut, "millimetres"), std::size_t{0});
    QCOMPARE(doubted(begin + "S500 M3\n" + cut + "M5\n" + cut, "stands still"), std::size_t{10});
    QCOMPARE(doubted(begin + "S500 M3\n" + cut + "M5\nM3\n" + cut, "stands still"), std::size_t{0});
    QCOMPARE(doubted(begin + "S500\n" + cut + "M3\n" + cut, "stands still"), std::size_t{5});
    for (const char* bare : {"G64", "N5 g64", "G64 P0", "G61\nG64"})
      QVERIFY2(doubted(begin + bare + "\nS500 M3\n" + cut, "without a tolerance") >= 3, bare);
    for (const char* limited : {"G64 P0.01", "G64P.02", "G61", "G64 P0.01 Q0.01"})
      QCOMPARE(doubted(begin + limited + "\nS500 M3\n" + cut, "without a tolerance"), std::size_t{0});
    COMPARE_NEAR(pathOf("G20 G90\nG64 P0.001\nS9 M3\n" + cut).blending, 0.0254, 1e-12);
  }

  void arcsAreDoubtedWhenTheirCentreIsOff() {
    const std::string begin = "G21 G90 G17\nS500 M3\nG0 X10 Y0 Z5\nG1 Z-1 F100\n";
    QCOMPARE(doubted(begin + "G3 X0 Y10 I-10.000 J0.05\n", "centre"), std::size_t{5});
    QCOMPARE(doubted(begin + "G3 X0 Y10 I-10.000 J0.001\n", "centre"), std::size_t{0});  // rounding
    // A whole circle always meets its end; those around it tell that its centre has slipped.
    const std::string rings = "G3 X10 Y0 I-10 J0\nG1 X8.5\nG3 X8.5 Y0 I-8.5 J0\nG1 X6.5\n";
    QCOMPARE(doubted(begin + rings + "G3 X6.5 Y0 I-6.45 J0\n", "centre"), std::size_t{9});
    QCOMPARE(doubted(begin + rings + "G3 X6.5 Y0 I-6.5 J0\n", "centre"), std::size_t{0});
  }

  void arcsThatAreSmoothBesideTheirCentreAreDoubted() {
    // half around the end of a slot: the centre may slip along the middle line, and both ends still meet
    const std::string begin = "G21 G90 G17\nS500 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\nX40.000\n";
    QCOMPARE(doubted(begin + "G3 X40 Y8 I0 J4\nG1 X0\n", "smoothly"), std::size_t{0});
    QCOMPARE(doubted(begin + "G3 X40 Y8 I-0.05 J4\nG1 X0\n", "smoothly"), std::size_t{6});
    QCOMPARE(doubted(begin + "G3 X40 Y8 I0.05 J4\nG1 X0\n", "smoothly"), std::size_t{6});
    // A corner that is meant to be one is none of ours.
    QCOMPARE(doubted(begin + "G3 X40 Y8 I-1 J4\nG1 X0\n", "smoothly"), std::size_t{0});
    QCOMPARE(doubted(begin + "G3 X40 Y8.5 I0.05 J4.25\nG1 X41 Y30\n", "smoothly"), std::size_t{6});  // but half a circle
    QCOMPARE(doubted(begin + "G3 X44.05 Y4 I0.05 J4\nG1 X41 Y30\n", "smoothly"), std::size_t{0});
  }

  void radiiAreDoubtedWhereAllOtherArcsAreSmooth() {
    Random random = seededRandom();
    constexpr int rounds = 1000;  // of a hundred, one seed in twenty told fewer than 95
    int told = 0, blamed = 0;
    for (int k = 0; k < rounds; ++k) {
      const int slipped = uniformInt(random, 1, 38);
      told +=
          doubted(chainOfArcs(random, 40, 0, slipped, true), "a radius of") == static_cast<std::size_t>(5 + slipped) ? 1 : 0;
      blamed += doubted(chainOfArcs(random, 40, 0, -1, true), "centre") != 0 ? 1 : 0;
    }
    std::printf("figure radii_told %d\nfigure radii_blamed %d\n", told, blamed);
    QCOMPARE(blamed, 0);
    QVERIFY2(100 * told >= 95 * rounds, qPrintable(QString::number(told)));
  }

  void centresAreDoubtedWhereAllOtherArcsAreSmooth() {
    Random random = seededRandom();
    int told = 0, blamed = 0, kinked = 0;
    for (int k = 0; k < 100; ++k) {
      const int slipped = uniformInt(random, 1, 38);
      told += doubted(chainOfArcs(random, 40, 0, slipped), "centre") == static_cast<std::size_t>(5 + slipped) ? 1 : 0;
      blamed += doubted(chainOfArcs(random, 40, 0, -1), "centre") != 0 ? 1 : 0;
      kinked += doubted(chainOfArcs(random, 40, 0.01, -1), "centre") != 0 ? 1 : 0;
    }
    std::printf("figure centres_told %d\nfigure smooth_blamed %d\nfigure kinked_blamed %d\n", told, blamed, kinked);
    QCOMPARE(told, 100);
    QCOMPARE(blamed, 0);
    QVERIFY(kinked < 3);  // a way with small corners everywhere was made so
  }

  void manySlipsAreToldAtOnce() {
    // Thirty slots; the ends of six of them begin and end on their circles, 0.05 mm too far out.
    std::string text = "G21 G90 G17\nS500 M3\nG0 X0 Y0 Z5\nG1 Z-1 F100\n";
    for (int k = 0; k < 30; ++k)
      text += fmt::format("G1 X40 Y{0}\nG3 X40 Y{1} I{2} J2.5\nG1 X0 Y{1}\nG2 X0 Y{3} I0 J2.5\n", 10 * k, 10 * k + 5,
                          k % 5 == 2 ? "0.050" : "0", 10 * k + 10);
    QCOMPARE(doubted(text, "as it is with 6 of 60 arcs"), std::size_t{5 + 4 * 2 + 1});
  }

  void uprightArcsAreFollowed() {
    // A quarter down from (10, 0, 5) around (10, 0, 0) in G18, then one in G19; both lie on their circles.
    const Toolpath path = pathOf("G21 G90 G18\nS500 M3\nG0 X0 Y0 Z5\nG3 X5 Z0 I0 K-5 F100\nG19 G3 Y5 Z5 J0 K5\nM2\n");
    double low = 9;
    for (std::size_t i = 0; i < path.moves.size(); ++i) {
      const Vec3& p = path.moves[i].to;
      if (path.moves[i].line == 4) COMPARE_NEAR(std::hypot(p.x(), p.z()), 5, 1e-9);
      if (path.moves[i].line == 5) COMPARE_NEAR(std::hypot(p.y(), p.z() - 5), 5, 1e-9);
      low = std::min(low, p.z());
    }
    QVERIFY(path.moves.size() > 20);
    COMPARE_NEAR(low, 0, 1e-9);
    QVERIFY((path.moves.back().to - Vec3(5, 5, 5)).norm() < 1e-9);
    // in the middle of the first one it lies outwards of the chord
    const auto half = std::find_if(path.moves.begin(), path.moves.end(), [](const ToolMove& m) { return m.to.x() > 3.5; });
    QVERIFY(half->to.z() > 3);
  }

  void loopsThatAreNotRunAreTold() {
    const TemporaryFolder folder;
    const std::filesystem::path file = folder.path() / "holes.ngc";
    writeAtomically(file, "G21 G90\n#1=0\no101 while [#1 lt 4]\nG0 X0 Y0\nG1 X5 F100\n#1=[#1+1]\no101 endwhile\nM2\n");
    for (const char* as : {"auto", "contours"}) {
      const Imported read = readShape(standardFormats(), file, {{"as", as}});
      QCOMPARE(read.shape.kind(), ShapeKind::Curves);
      QCOMPARE(read.warnings.size(), std::size_t{1});
      QVERIFY2(read.warnings[0].starts_with("Line 3: ") && read.warnings[0].find("once") != std::string::npos,
               read.warnings[0].c_str());
    }
    writeAtomically(file, "G90\nG0 X0 Y0\nG1 X5 F100\nM2\n");
    const Imported unsaid = readShape(standardFormats(), file);
    QVERIFY(unsaid.warnings.size() == 1 && unsaid.warnings[0].starts_with("Line 2 moves before G21 or G20"));
  }

  void arcsThatMissTheirEndAreSpirals() {
    // 0.4 mm on a radius of 400: controls take it, and no circle goes through both ends.
    const Toolpath path = pathOf(head + "G0 X0 Y0 Z1\nG0 X900 Y500\nG1 Z-1 F100\nG3 X500 Y900.4 I-400 J0\nM2\n");
    std::size_t between = 0;
    for (const ToolMove& move : path.moves) {
      QCOMPARE(move.turn, 0);
      if (move.kind != MoveKind::Feed) continue;
      const Vec2 from = move.to.head<2>() - Vec2(500, 500);
      const double share = std::atan2(from.y(), from.x()) / (std::numbers::pi / 2);
      COMPARE_NEAR(from.norm(), 400 + 0.4 * share, 0.002);
      ++between;
    }
    QVERIFY(between > 50);
  }

  void whatControlsStopAtIsTold_data() {
    QTest::addColumn<QString>("line");
    QTest::addColumn<QString>("doubt");
    const auto row = [](const char* line, const char* doubt) { QTest::newRow(line) << line << doubt; };
    row("F-5", "line 7: F-5 is below 0");
    row("G4 P-1", "line 7: P-1 is below 0");
    row("S-1", "line 7: S-1 is below 0");
    row("F0", "line 8 cuts without a feed");
    row("S0", "line 8 cuts without a speed");
    row("G64 P2", "line 7: G64 P lets the control leave its way by up to 2 mm");
    row("%", "line 7: controls differ about a %");
    row("G64 P0.005", "");
    row("F50", "");
    row("G4 P0.5", "");
    row("% G1 X20 Y10", "");  // a comment
  }

  void whatControlsStopAtIsTold() {
    QFETCH(QString, line);
    QFETCH(QString, doubt);
    const auto doubts =
        parsed(head + "G0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X20\n" + line.toStdString() + "\nG1 Y20\nG1 X0\nG0 Z5\nM2\n").doubts;
    const auto tells = [&](const std::string& one) { return one.starts_with(doubt.toStdString()); };
    if (doubt.isEmpty())
      QVERIFY2(doubts.empty(), doubts.empty() ? "" : doubts[0].c_str());
    else
      QVERIFY2(std::any_of(doubts.begin(), doubts.end(), tells), doubts.empty() ? "no doubt" : doubts[0].c_str());
  }

  void aWorkOffsetInWhichNothingMovesIsTold() {
    const std::string rest = "G0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X20\nM2\n";
    QCOMPARE(parsed(head + "G54\nG55\n" + rest).doubts,
             std::vector<std::string>{"line 5: G55 takes the place of G54 from line 4, in which nothing has moved"});
    for (const char* one : {"G54\n", "G54\nG54\n", "G55\n"}) QVERIFY(parsed(head + one + rest).doubts.empty());
    QVERIFY(parsed(head + "G54\nG0 X1\nG55\n" + rest).doubts.empty());  // that is an obstacle
  }

  void whatHasNoFeedIsTold() {
    const auto doubts = parsed(head + "G0 X0 Y0 Z5\nG1 Z-1\nG1 X20\nF0\nG1 Y2\nF9\nG1 Y3\nM2\n").doubts;
    QCOMPARE(doubts.size(), std::size_t{2});
    QVERIFY(doubts[0].starts_with("line 5 cuts without a feed") && doubts[1].starts_with("line 8 cuts without a feed"));
  }

  void cutsWithoutTheLengthThatWasTakenBackAreTold() {
    const std::string begin = "G21 G90\nT1 M6\nG43 H1\nM3 S9000\nG0 X0 Y0 Z5\nG1 Z-1 F100\n";
    QVERIFY(parsed(begin + "G0 Z5\nG49\nG0 Z9\nM2\n").doubts.empty());
    QVERIFY(parsed(begin + "G0 Z5\nG49\nG43 H1\nG1 X3\nM2\n").doubts.empty());
    QVERIFY(parsed("G49\n" + begin + "M2\n").doubts.empty());
    QCOMPARE(parsed(begin + "G49\nG1 X5\nG1 X9\nM2\n").doubts,
             std::vector<std::string>{"line 7: G49 takes the length of the tool back, and line 8 cuts without it"});
  }

  void whatFollowsTheEndIsTold() {
    const std::string whole = head + "G0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X20\n";
    for (const char* end : {"M2", "M30", "M02"}) {
      for (const char* silent : {"", "%\n", "\n(a comment)\n; another\n"})
        QVERIFY(parsed(whole + end + "\n" + silent).doubts.empty());
      for (const char* more : {"G1 X50\n", "/G1 X50\n", "(on)\nN10 G1 X50\n"}) {
        const auto cut = parsed(whole + end + "\n" + more);
        QCOMPARE(cut.doubts.size(), std::size_t{1});
        QVERIFY2(cut.doubts[0].find("ends the program; what stands after it is not run") != std::string::npos,
                 cut.doubts[0].c_str());
        QCOMPARE(cut.drawingDoubts, cut.doubts);
      }
    }
    QCOMPARE(parsed("%\n" + whole + "%\n/G1 X50\n").doubts.size(), std::size_t{1});
  }
  void aByteOrderMarkIsNoWord() {
    for (const char* mark : {"", "\xEF\xBB\xBF"})
      QCOMPARE(parsed(mark + std::string("%\n") + head + "G0 X0 Y0 Z5\nG1 Z-1 F100\n%\nG1 X7\n").doubts.size(),
               std::size_t{1});
  }

  void thePercentSignEndsWhatItBegan() {
    const std::string whole = "%\n" + head + "G0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X20\n";
    for (const std::string end : {"%\n", " %\n\n", "%", "%\n(tool list: none)\n; made by hand\n%\n"}) {
      const GcodeProgram ended = parsed(whole + end);
      QVERIFY(ended.doubts.empty());
      QCOMPARE(ended.moves.size(), std::size_t{3});
    }
    QCOMPARE(parsed("%\n% drawn by hand\n" + head + "G0 X0 Y0 Z5\n% the cut\nG1 Z-1 F100\nG1 X20\n%\n").moves.size(),
             std::size_t{3});  // what follows on the line makes it a comment
    const GcodeProgram cut = parsed(whole + "%\nG1 Y20\nG0 Z5\nM5\nM2\n%\n");
    QCOMPARE(cut.moves.size(), std::size_t{3});
    QCOMPARE(cut.doubts, std::vector<std::string>{"line 8: % ends the program; what stands after it is not run"});
    QCOMPARE(cut.drawingDoubts, cut.doubts);
  }

  void blendingIsNeverWithoutALimit() {
    const Toolpath path = pathOf(head + "G0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X5\nG0 Z5\nM2\n");
    for (const char* unit : {"mm", "inch"})
      for (const int decimals : {2, 3, 4, 6}) {
        const std::string text = written(path, {{"unit", unit}, {"decimals", decimals}});
        std::smatch found;
        QVERIFY(std::regex_search(text, found, std::regex("G64 P([0-9.]+)")));
        const double mm = std::stod(found[1]) * (std::string(unit) == "inch" ? 25.4 : 1);
        COMPARE_NEAR(mm, 0.005, 2e-5);
      }
  }

  void aSlowSpindleStillTurns() {
    Toolpath path = pathOf(head + "G0 X0 Y0 Z5\nG1 Z-1 F100\nG1 X5\nG0 Z5\nM2\n");
    path.cutter.spindle = 0.4;
    QVERIFY(written(path).find("S1 M3") != std::string::npos);
  }
};

BLOSSOM_TEST(GcodeSafetyTest)
#include "gcode_safety_test.moc"
