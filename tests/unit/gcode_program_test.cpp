#include <Eigen/Geometry>
#include <numbers>
#include <regex>
#include <sstream>

#include "geometry/measure/measure.h"
#include "support/exchange.h"
#include "support/rs274.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

/// Random lines, arcs and helices, small and large, with every kind of move.
Toolpath randomPath(std::mt19937_64& random, int count) {
  std::uniform_real_distribution<double> unit(0, 1);
  Toolpath path;
  path.cutter = {.diameter = 6, .cornerRadius = 0.5, .vAngle = 0, .number = 1, .spindle = 12000};
  path.stock.add(Vec3(-50, -40, -12.5));
  path.stock.add(Vec3(60, 70, 0));
  path.passes = 3;
  path.start = {1, 2, 5};
  for (int i = 0; i < count; ++i) {
    const Vec3 from = startOf(path, path.moves.size());
    ToolMove move;
    move.kind = unit(random) < 0.2 ? MoveKind::Rapid : MoveKind::Feed;
    move.feed = move.kind == MoveKind::Rapid ? 0 : 100 + std::floor(1000 * unit(random));
    const double size = std::pow(10, -3 + 5 * unit(random));
    move.to = from + size * Vec3(unit(random) - 0.5, unit(random) - 0.5, unit(random) < 0.7 ? 0 : -0.1 * unit(random));
    if (move.to.head<2>().norm() > 400) move.to.head<2>() *= 0.1;
    if (move.kind == MoveKind::Feed && unit(random) < 0.6) {
      move.turn = unit(random) < 0.5 ? 1 : -1;
      const Vec2 offset = size * Vec2(unit(random) - 0.5, unit(random) - 0.5);
      move.center = from.head<2>() + offset;
      const double sweep = move.turn * (unit(random) < 0.1 ? 1 : unit(random)) * 2 * std::numbers::pi;
      const Vec2 end = move.center + Eigen::Rotation2Dd(sweep) * Vec2(-offset);
      move.to.head<2>() = end;
      if (std::abs(std::abs(sweep) - 2 * std::numbers::pi) < 1e-12) move.to.head<2>() = from.head<2>();
    }
    if (move.to.z() < from.z() && move.kind == MoveKind::Feed) move.kind = MoveKind::Plunge;
    path.moves.push_back(move);
  }
  // Programs end above the work.
  const Vec3 last = path.moves.back().to;
  if (last.z() < path.start.z()) path.moves.push_back({.kind = MoveKind::Rapid, .to = {last.x(), last.y(), path.start.z()}});
  return path;
}

Toolpath readBack(const fs::path& file) {
  const Imported imported = readShape(formats(), file);
  const auto* path = imported.shape.get<Toolpath>();
  if (!path) throw Error(ErrorCode::Internal, imported.warnings.empty() ? "contours" : imported.warnings.front());
  return *path;
}

/// Farthest that a densely sampled path is from the other, both as sequences of points: one-sided, by brute force.
double deviation(const Toolpath& a, const Toolpath& b) {
  std::vector<std::pair<Vec3, Vec3>> lines;
  for (std::size_t i = 0; i < b.moves.size(); ++i) {
    const auto points = polylineOf(startOf(b, i), b.moves[i], 1e-4);
    for (std::size_t k = 0; k + 1 < points.size(); ++k) lines.emplace_back(points[k], points[k + 1]);
  }
  double worst = 0;
  for (std::size_t i = 0; i < a.moves.size(); ++i)
    for (const Vec3& p : polylineOf(startOf(a, i), a.moves[i], 1e-1)) {
      double nearest = 1e30;
      for (const auto& [from, to] : lines) {
        const Vec3 along = to - from;
        const double t = along.squaredNorm() > 0 ? std::clamp((p - from).dot(along) / along.squaredNorm(), 0.0, 1.0) : 0;
        nearest = std::min(nearest, (from + t * along - p).norm());
      }
      worst = std::max(worst, nearest);
    }
  return worst;
}

/// An arc so short that both its ends are printed alike is told by the interpreter as it tells a whole circle.
Toolpath withoutSmallCircles(const Toolpath& path, double radius) {
  Toolpath kept = path;
  for (std::size_t i = 0; i < path.moves.size(); ++i) {
    const Vec3 from = startOf(path, i);
    ToolMove& move = kept.moves[i];
    const bool closed = move.turn != 0 && (move.to - from).head<2>().norm() == 0;
    if (closed && (move.center - from.head<2>()).norm() < radius) move.turn = 0;
  }
  return kept;
}

std::string programOf(const Toolpath& path, const Value& options) {
  const TemporaryFolder folder;
  writeShape(formats(), path, folder.path() / "p.ngc", options);
  return readFile(folder.path() / "p.ngc");
}

/// What is wrong with a program for GRBL 1.1, by its own list of words, line length and rule for arcs; empty when nothing.
std::string grblComplaint(const std::string& text) {
  static const std::regex known(
      R"((?:P\d+|G(?:0|1|2|3|4|17|20|21|40|54|55|56|57|58|59|90|91\.1|94)|M(?:2|3|5|30)|[FSN]\d+(?:\.\d{1,3})?|[XYZIJ]-?\d+(?:\.\d+)?))");
  std::istringstream lines(text);
  std::string motion;
  for (std::string line; std::getline(lines, line);) {
    if (line.size() > 79 && line.front() != '(') return "longer than the buffer: " + line;
    if (line.front() == '(') {
      if (line.back() != ')' || line.find('(', 1) != std::string::npos) return "comment: " + line;
      continue;
    }
    std::istringstream words(line);
    std::string letters;
    bool axis = false, centre = false;
    for (std::string word; words >> word;) {
      if (!std::regex_match(word, known)) return "word " + word + " in: " + line;
      if (word[0] != 'G' && word[0] != 'M' && letters.find(word[0]) != std::string::npos) return "twice: " + line;
      letters += word[0];
      if (word == "G0" || word == "G1" || word == "G2" || word == "G3") motion = word;
      axis = axis || word[0] == 'X' || word[0] == 'Y';
      centre = centre || word[0] == 'I' || word[0] == 'J';
    }
    if (centre && motion != "G2" && motion != "G3") return "centre without an arc: " + line;
    if (centre && !axis) return "arc without an end: " + line;
    if (axis && (motion == "G2" || motion == "G3") && !centre) return "arc without a centre: " + line;
  }
  return {};
}

}  // namespace

class GcodeProgramTest final : public QObject {
  Q_OBJECT
 private slots:
  void programsReadBack() {
    auto random = seededRandom();
    const TemporaryFolder folder;
    for (const char* post : {"linuxcnc", "grbl", "mach3", "fanuc"})
      for (const char* unit : {"mm", "inch"})
        for (const int decimals : {3, 4, 6}) {
          const Toolpath path = randomPath(random, 60);
          const fs::path file = folder.path() / "program.ngc";
          writeShape(formats(), path, file,
                     {{"post", post}, {"unit", unit}, {"decimals", decimals}, {"line-numbers", true}});
          const Toolpath read = readBack(file);
          // Fanuc has three places in mm and four in inches, whatever is asked for.
          const int places = std::string(post) == "fanuc" ? std::min(decimals, 3) : decimals;
          const double resolution = std::pow(10, -places) * (std::string(unit) == "inch" ? 2.54 : 1);
          // Chords of demoted arcs lie within the larger of the resolution and a micrometre.
          const double bound = 8 * resolution + 1.2e-3;
          QVERIFY2(deviation(path, read) < bound,
                   qPrintable(QString("%1 %2 %3: %4").arg(post).arg(unit).arg(decimals).arg(deviation(path, read))));
          QVERIFY2(deviation(read, path) < bound,
                   qPrintable(QString("%1 %2 %3: back %4").arg(post).arg(unit).arg(decimals).arg(deviation(read, path))));
          QCOMPARE(read.cutter, path.cutter);
          QCOMPARE(read.stock.low, path.stock.low);
          QCOMPARE(read.stock.high, path.stock.high);
          QCOMPARE(read.passes, path.passes);
          QVERIFY(std::abs(*secondsOf(read) - *secondsOf(path)) < 0.02 * *secondsOf(path) + 0.5);
        }
  }

  void linuxcncRunsWhatIsWritten() {
    NEED_INTERPRETER();
    auto random = seededRandom();
    const TemporaryFolder folder;
    for (const char* post : {"linuxcnc", "grbl", "mach3"})
      for (const char* unit : {"mm", "inch"}) {
        const Toolpath path = randomPath(random, 80);
        const fs::path file = folder.path() / "program.ngc";
        writeShape(formats(), path, file, {{"post", post}, {"unit", unit}});
        const Interpreted run = interpret(file);
        QVERIFY2(run.good, run.log.c_str());
        // The interpreter prints four places, in inches 0.00254 mm; on the far side of a circle the errors of start and
        // centre add up to three times the half of that in each direction.
        const double printed = std::string(unit) == "inch" ? 2.54e-3 : 1e-4;
        const double bound = 1.8e-3 + 3 / std::numbers::sqrt2 * printed;
        QVERIFY2(deviation(path, readBack(file)) < 1.8e-3, qPrintable(QString::number(deviation(path, readBack(file)))));
        QVERIFY2(deviation(path, run.path) < bound, qPrintable(QString::number(deviation(path, run.path))));
        const double back = deviation(withoutSmallCircles(run.path, 8 * printed), path);
        QVERIFY2(back < bound, qPrintable(QString::number(back)));
        QCOMPARE(run.path.cutter.spindle, 12000.0);
      }
  }

  void grblTakesEveryWord() {
    auto random = seededRandom();
    for (const char* unit : {"mm", "inch"})
      for (int k = 0; k < 20; ++k) {
        const std::string text =
            programOf(randomPath(random, 100), {{"post", "grbl"}, {"unit", unit}, {"line-numbers", true}});
        QVERIFY2(grblComplaint(text).empty(), grblComplaint(text).c_str());
      }
  }

  void fullCirclesStayFullAndTinyArcsDoNotBecomeCircles() {
    Toolpath path;
    path.start = {10, 0, 5};
    path.moves = {{.kind = MoveKind::Plunge, .to = {10, 0, -1}, .feed = 100},
                  {.kind = MoveKind::Feed, .to = {10, 0, -1}, .turn = 1, .center = {0, 0}, .feed = 500},
                  // an arc shorter than the resolution: its rounded ends are one point
                  {.kind = MoveKind::Feed,
                   .to = {10 * std::cos(1e-6), 10 * std::sin(1e-6), -1},
                   .turn = 1,
                   .center = {0, 0},
                   .feed = 500},
                  // an arc of a radius of a kilometre
                  {.kind = MoveKind::Feed, .to = {11, 0, -1}, .turn = 1, .center = {10.5, 1e6}, .feed = 500}};
    const std::string text = programOf(path, Value::object());
    QCOMPARE(std::count(text.begin(), text.end(), 'I'), 1);
    QVERIFY(text.find("G3 X10 Y0 I-10 J0") != std::string::npos);
    QVERIFY(text.find("X11") != std::string::npos);
  }

  void rubbishIsRefused() {
    Toolpath path;
    VERIFY_ERROR(programOf(path, Value::object()), ErrorCode::InvalidInput);
    path.moves = {{.kind = MoveKind::Feed, .to = {1, 1, 1}, .feed = 0}};
    VERIFY_ERROR(programOf(path, Value::object()), ErrorCode::InvalidInput);
    path.moves = {{.kind = MoveKind::Feed, .to = {1, std::nan(""), 1}, .feed = 100}};
    VERIFY_ERROR(programOf(path, Value::object()), ErrorCode::InvalidInput);
    path.moves = {{.kind = MoveKind::Feed, .to = {1, 1e300, 1}, .feed = 100}};
    VERIFY_ERROR(programOf(path, Value::object()), ErrorCode::InvalidInput);
    path.moves = {{.kind = MoveKind::Feed, .to = {1, 1, 1}, .feed = 100}};
    VERIFY_ERROR(programOf(path, {{"post", "abacus"}}), ErrorCode::InvalidParameter);
    CancelToken cancelled;
    cancelled.cancel();
    const TemporaryFolder folder;
    VERIFY_ERROR(writeShape(formats(), path, folder.path() / "a.ngc", Value::object(), Progress(cancelled)),
                 ErrorCode::Cancelled);
  }

  /// What a toolpath would be wrong without is named by its line; contours do not need it.
  void whatCannotBeFollowedIsNamed_data() {
    QTest::addColumn<QString>("line");
    for (const char* line : {"G41 D1", "G81 X1 Y1 Z-1 R1", "O100 call", "G92 X0", "G55", "G1 Z#3", "M98 P1", "G38.2 Z-1",
                             "G2 X5 Y5 I9 J0", "G1 A5", "/G1 X5"})
      QTest::newRow(line) << line;
  }
  void whatCannotBeFollowedIsNamed() {
    QFETCH(QString, line);
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "p.ngc";
    writeAtomically(file, "G21 G90 G54\nM3 S100\nG0 X0 Y0 Z5\nG1 Z-1 F100\n" + line.toStdString() + "\nG1 X7\nM2\n");
    try {
      (void)readShape(formats(), file, {{"as", "toolpath"}});
      QFAIL("read without complaint");
    } catch (const Error& error) {
      QCOMPARE(error.code(), ErrorCode::FormatDamaged);
      QVERIFY2(error.message().find("ine 5") != std::string::npos, error.what());
    }
    const Imported imported = readShape(formats(), file);
    QCOMPARE(imported.shape.kind(), ShapeKind::Curves);
    QVERIFY(!imported.warnings.empty());
  }

  void drawingsStayContours() {
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "p.ngc";
    writeAtomically(file, "G21\nG0 Z5\nG0 X0 Y0\nG1 Z0 F100\nG1 X5\nG1 Y5\nM2\n");
    QCOMPARE(readShape(formats(), file).shape.kind(), ShapeKind::Curves);
    QCOMPARE(readShape(formats(), file, {{"as", "toolpath"}}).shape.kind(), ShapeKind::Toolpath);
    NEED_SHARED_DATA();
    for (const auto& each : std::filesystem::directory_iterator(sharedData() / "gcode"))
      QVERIFY2(readShape(formats(), each.path()).shape.kind() == ShapeKind::Curves, each.path().c_str());
  }

  void mutatedProgramsNeverCrash() {
    auto random = seededRandom();
    const TemporaryFolder folder;
    const fs::path file = folder.path() / "p.ngc";
    const std::string text = programOf(randomPath(random, 40), Value::object());
    const std::string letters = "GXYZIJKRFMSTNO0123456789.-+ ()#[];/%\n\t\xff";
    int read = 0, refused = 0;
    for (int k = 0; k < 1500; ++k) {
      std::string changed = text;
      for (int n = 0; n < 1 + k % 6; ++n) {
        const std::size_t at = random() % changed.size();
        const char c = letters[random() % letters.size()];
        if (n % 3 == 0) changed[at] = c;
        if (n % 3 == 1) changed.insert(at, 1 + random() % 9, c);
        if (n % 3 == 2) changed.erase(at, random() % 30);
      }
      writeAtomically(file, changed);
      try {
        const Imported imported = readShape(formats(), file, {{"as", k % 2 == 0 ? "toolpath" : "auto"}});
        if (const auto* path = imported.shape.get<Toolpath>()) QVERIFY(std::isfinite(lengthOf(*path)));
        ++read;
      } catch (const Error& error) {
        QVERIFY2(error.code() != ErrorCode::Internal, error.what());
        ++refused;
      }
    }
    QVERIFY(read > 0 && refused > 0);
  }

  void everyPostEndsWellFormed() {
    auto random = seededRandom();
    const Toolpath path = randomPath(random, 5);
    const std::string fanuc = programOf(path, {{"post", "fanuc"}});
    QVERIFY(fanuc.starts_with("%\nO0001\n") && fanuc.ends_with("M30\n%\n"));
    QVERIFY(!std::regex_search(fanuc, std::regex(R"([XYZIJ]-?\d+(\s|$))")));  // whole numbers carry a point
    QVERIFY(programOf(path, {{"post", "grbl"}}).find("M6") == std::string::npos);
    QVERIFY(programOf(path, {{"post", "linuxcnc"}}).find("G43 H1") != std::string::npos);
  }

  /// Nobody knows where the tool is when a program starts: across at the machine's top, and back up there before the end.
  void programsBeginAndEndOutOfTheWork() {
    auto random = seededRandom();
    Toolpath path = randomPath(random, 5);
    for (const auto& [post, top] :
         {std::pair("linuxcnc", "G53 G0 Z0"), {"mach3", "G53 G0 Z0"}, {"fanuc", "G91 G28 Z0.\nG90"}}) {
      const std::string text = programOf(path, {{"post", post}});
      const std::size_t up = text.find(top), across = text.find("G0 X"), down = text.find("\nZ5"), back = text.rfind(top);
      QVERIFY2(up < across && across < down && down < back && back < text.find("M5"), text.c_str());
      QVERIFY2(std::regex_search(text, std::regex("S12000 M3\nG4 P2(000)?\n")), text.c_str());
    }
    // GRBL need not know the machine's top: up first.
    const std::string grbl = programOf(path, {{"post", "grbl"}});
    QVERIFY(grbl.find("M3\nG4 P2\nG0 Z5\nX") != std::string::npos);
    path.moves.push_back({.kind = MoveKind::Plunge, .to = path.moves.back().to - Vec3(0, 0, 9), .feed = 100});
    QVERIFY(programOf(path, {{"post", "grbl"}}).find("G0 Z5\nM5\nM2") != std::string::npos);
    path.flood = true;
    QVERIFY(std::regex_search(programOf(path, Value::object()), std::regex("G4 P2\nM8\n[^]*\nG53 G0 Z0\nM9\nM5\nM2\n")));
  }

  void fanucHasThreePlacesInMillimetresAndFourInInches() {
    auto random = seededRandom();
    const Toolpath path = randomPath(random, 200);
    for (const auto& [unit, places] : {std::pair("mm", 3), {"inch", 4}})
      for (const int decimals : {3, 4, 6}) {
        const std::string text = programOf(path, {{"post", "fanuc"}, {"unit", unit}, {"decimals", decimals}});
        std::size_t most = 0;
        const std::regex number("[XYZIJ]-?\\d*\\.(\\d*)");
        for (auto it = std::sregex_iterator(text.begin(), text.end(), number); it != std::sregex_iterator(); ++it)
          if (text.rfind('(', static_cast<std::size_t>(it->position())) == std::string::npos ||
              text.rfind(')', static_cast<std::size_t>(it->position())) >
                  text.rfind('(', static_cast<std::size_t>(it->position())))
            most = std::max(most, static_cast<std::size_t>((*it)[1].length()));
        QCOMPARE(most, static_cast<std::size_t>(places));
      }
  }
};

BLOSSOM_TEST(GcodeProgramTest)
#include "gcode_program_test.moc"
