// Pages of PDF and PostScript, read back by a small interpreter of their path operators.
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <numbers>
#include <sstream>

#include "geometry/planar/planar.h"
#include "geometry/planar/single_point.h"
#include "support/exchange.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using std::numbers::pi;
constexpr double mmPerPoint = 25.4 / 72;
constexpr double tolerance = 1e-3, keptPlaces = 2e-3;  // mm

struct Painted {
  std::vector<std::vector<std::array<Vec2, 4>>> loops;  // cubics; mm from the corner of the page, y upwards
  bool filled = false;
};

/// What m, l, c, h, re and cm build up and f, f* and S paint.
class Interpreter {
 public:
  std::vector<Painted> run(const std::string& content) {
    std::istringstream words(content);
    for (std::string word; words >> word;) {
      char* end = nullptr;
      const double number = std::strtod(word.c_str(), &end);
      if (end != word.c_str() && *end == 0)
        stack_.push_back(number);
      else
        apply(word);
    }
    return painted_;
  }

 private:
  Vec2 point(std::size_t fromEnd) {
    const std::size_t at = stack_.size() - fromEnd;
    return mmPerPoint * (turn_ * Vec2(stack_.at(at), stack_.at(at + 1)) + shift_);
  }
  void lineTo(const Vec2& to) {
    const Vec2 step = (to - at_) / 3;
    loops_.back().push_back({at_, at_ + step, to - step, to});
    at_ = to;
  }
  void moveTo(const Vec2& to) {
    loops_.emplace_back();
    start_ = at_ = to;
  }
  void apply(const std::string& word) {
    if (word == "cm" && stack_.size() >= 6) {
      const double* m = &stack_[stack_.size() - 6];
      shift_ += turn_ * Vec2(m[4], m[5]);
      turn_ *= (Eigen::Matrix2d() << m[0], m[2], m[1], m[3]).finished();
    } else if (word == "q") {
      kept_.emplace_back(turn_, shift_);
    } else if (word == "Q" && !kept_.empty()) {
      std::tie(turn_, shift_) = kept_.back();
      kept_.pop_back();
    } else if (word == "m") {
      moveTo(point(2));
    } else if (word == "l") {
      lineTo(point(2));
    } else if (word == "c") {
      loops_.back().push_back({at_, point(6), point(4), point(2)});
      at_ = point(2);
    } else if (word == "h") {
      lineTo(start_);
    } else if (word == "f" || word == "f*" || word == "S") {
      std::erase_if(loops_, [](const auto& loop) { return loop.empty(); });
      painted_.push_back({std::exchange(loops_, {}), word != "S"});
    } else if (word == "n" || word == "W" || word == "W*" || word == "rectclip") {
      loops_.clear();
    }
    stack_.clear();
  }

  std::vector<double> stack_;
  std::vector<std::vector<std::array<Vec2, 4>>> loops_;
  std::vector<Painted> painted_;
  std::vector<std::pair<Eigen::Matrix2d, Vec2>> kept_;
  Eigen::Matrix2d turn_ = Eigen::Matrix2d::Identity();
  Vec2 shift_ = Vec2::Zero(), at_ = Vec2::Zero(), start_ = Vec2::Zero();
};

std::string pageFile(const Shape& shape, const std::string& extension) {
  const TemporaryFolder folder;
  const fs::path path = folder.path() / ("page." + extension);
  writeShape(formats(), shape, path, {{"tolerance", tolerance}});
  return readFile(path);
}

/// The streams of a PDF, uncompressed; what is not deflated is empty.
std::vector<std::string> streamsOf(const std::string& file) {
  const std::string begin = "stream\n", end = "endstream";
  std::vector<std::string> streams;
  for (std::size_t from = file.find(begin); from != std::string::npos; from = file.find(begin, from)) {
    from += begin.size();
    const std::size_t to = std::min(file.find(end, from), file.size());
    const QByteArray packed(file.data() + from, static_cast<qsizetype>(to - from));
    streams.push_back(qUncompress(QByteArray(4, '\0').append(packed)).toStdString());
    from = std::min(to + end.size(), file.size());
  }
  return streams;
}

/// The page's own operators, uncompressed.
std::string contentOf(const std::string& file, const std::string& extension) {
  if (extension == "ps") {
    const std::size_t from = file.find("%%EndPageSetup");
    return file.substr(from, file.find("%%Trailer", from) - from);
  }
  return streamsOf(file).front();
}

std::vector<Painted> paintedOf(const Shape& shape, const std::string& extension) {
  return Interpreter().run(contentOf(pageFile(shape, extension), extension));
}

/// Twice the integral of x dy - y dx over a cubic is exact with three points of Gauss.
double areaOfLoop(const std::vector<std::array<Vec2, 4>>& loop) {
  double twice = 0;
  for (const auto& [a, b, c, d] : loop)
    for (const auto& [t, weight] :
         {std::pair{0.5 - std::sqrt(0.15), 5.0 / 18}, std::pair{0.5, 4.0 / 9}, std::pair{0.5 + std::sqrt(0.15), 5.0 / 18}}) {
      const double s = 1 - t;
      const Vec2 p = s * s * s * a + 3 * s * s * t * b + 3 * s * t * t * c + t * t * t * d;
      const Vec2 v = 3 * (s * s * (b - a) + 2 * s * t * (c - b) + t * t * (d - c));
      twice += weight * (p.x() * v.y() - p.y() * v.x());
    }
  return twice / 2;
}

Path circlePath(double radius, bool counterClockwise) {
  Path path;
  path.closed = true;
  path.segments = {Arc2{{0, 0}, radius, 0, counterClockwise ? 2 * pi : -2 * pi}};
  return path;
}

}  // namespace

class PageTest : public QObject {
  Q_OBJECT
 private slots:
  void aRing_data() { bothFormats(); }
  void aRing();
  void curvesKeepTheirPoles_data() { bothFormats(); }
  void curvesKeepTheirPoles();
  void openLinesAreDrawn_data() { bothFormats(); }
  void openLinesAreDrawn();
  void aPointIsADot_data() { bothFormats(); }
  void aPointIsADot();
  void thePageIsAsLargeAsTheDrawing();
  void theSameDrawingGivesTheSameFile();
  void aSolidIsRefused();

 private:
  static void bothFormats() {
    QTest::addColumn<QString>("extension");
    QTest::newRow("pdf") << "pdf";
    QTest::newRow("ps") << "ps";
  }
};

void PageTest::aRing() {
  QFETCH(QString, extension);
  Curves ring;
  ring.paths = {circlePath(20, true), circlePath(8, false)};
  const auto painted = paintedOf(Shape(ring), extension.toStdString());
  QCOMPARE(painted.size(), std::size_t{1});
  QVERIFY(painted[0].filled);
  QCOMPARE(painted[0].loops.size(), std::size_t{2});
  double area = 0;
  for (const auto& loop : painted[0].loops) area += areaOfLoop(loop);
  const double length = 2 * pi * (20 + 8);
  QVERIFY2(std::abs(std::abs(area) - pi * (400 - 64)) < length * (tolerance + keptPlaces), fmt::format("{}", area).c_str());
  // The middle of the page, a margin of 1 mm beside the ring.
  const Vec2 middle(21, 21);
  for (const auto& loop : painted[0].loops)
    for (const auto& cubic : loop) {
      const Vec2 p = (cubic[0] + 3 * cubic[1] + 3 * cubic[2] + cubic[3]) / 8;
      const double radius = (p - middle).norm(), wanted = radius > 14 ? 20 : 8;
      QVERIFY2(std::abs(radius - wanted) < tolerance + 2 * keptPlaces, fmt::format("{}", radius).c_str());
    }
}

void PageTest::curvesKeepTheirPoles() {
  QFETCH(QString, extension);
  const std::array<Vec2, 4> poles{Vec2(0, 0), Vec2(10, 30), Vec2(20, 30), Vec2(30, 0)};
  Spline2 spline;
  spline.degree = 3;
  spline.knots = {0, 0, 0, 0, 1, 1, 1, 1};
  for (const Vec2& p : poles) spline.poles.emplace_back(p.x(), p.y(), 1);
  Path path;
  path.segments = {spline};
  Curves curves;
  curves.paths = {path};
  const auto painted = paintedOf(Shape(curves), extension.toStdString());
  QCOMPARE(painted.size(), std::size_t{1});
  QCOMPARE(painted[0].loops.size(), std::size_t{1});
  QCOMPARE(painted[0].loops[0].size(), std::size_t{1});
  for (std::size_t k = 0; k < 4; ++k) {
    const Vec2 moved = painted[0].loops[0][0][k] - Vec2(1, 1);
    QVERIFY2((moved - poles[k]).norm() < 2 * keptPlaces, fmt::format("{} {}", moved.x(), moved.y()).c_str());
  }
}

void PageTest::aPointIsADot() {
  QFETCH(QString, extension);
  const std::string page =
      contentOf(pageFile(Shape(pointDrawing({5, 6})), extension.toStdString()), extension.toStdString());
  QVERIFY2(page.find("1 J") != std::string::npos, "round ends are what is seen of a point");
  const auto painted = Interpreter().run(page);
  QCOMPARE(painted.size(), std::size_t{1});
  QVERIFY(!painted[0].filled);
  for (const Vec2& p : painted[0].loops.at(0).at(0)) QVERIFY((p - Vec2(1, 1)).norm() < 2 * keptPlaces);
}

void PageTest::openLinesAreDrawn() {
  QFETCH(QString, extension);
  Path open;
  open.segments = {Line2{{0, 0}, {5, 0}}, Line2{{5, 0}, {5, 7}}};
  Curves curves;
  curves.paths = {open, circlePath(2, true)};
  const auto painted = paintedOf(Shape(curves), extension.toStdString());
  QCOMPARE(painted.size(), std::size_t{2});
  QVERIFY(!painted[0].filled);
  QVERIFY(painted[1].filled);
}

void PageTest::thePageIsAsLargeAsTheDrawing() {
  Curves curves;
  curves.paths = {circlePath(20, true)};
  std::string file = pageFile(Shape(curves), "pdf");
  for (const std::string& stream : streamsOf(file)) file += stream;  // Cairo 1.18 writes the page as an object in a stream
  const std::size_t at = file.find("/MediaBox [");
  QVERIFY(at != std::string::npos);
  std::istringstream numbers(file.substr(at + 11, 60));
  double x = 1, y = 1, width = 0, height = 0;
  numbers >> x >> y >> width >> height;
  QCOMPARE(x, 0.0);
  QCOMPARE(y, 0.0);
  for (const double size : {width, height}) QVERIFY(size * mmPerPoint >= 42 && (size - 1) * mmPerPoint < 42);
}

void PageTest::theSameDrawingGivesTheSameFile() {
  Curves curves;
  curves.paths = {circlePath(20, true)};
  QVERIFY(pageFile(Shape(curves), "pdf") == pageFile(Shape(curves), "pdf"));
}

void PageTest::aSolidIsRefused() {
  Mesh mesh;
  mesh.points = {{0, 0, 0}, {1, 0, 0}, {0, 1, 0}};
  mesh.addFace(std::array{0, 1, 2});
  for (const char* extension : {"pdf", "ps"}) {
    try {
      (void)pageFile(Shape(mesh), extension);
      QFAIL("A mesh was written to a page.");
    } catch (const Error& error) {
      QVERIFY(error.code() == ErrorCode::OutputNotSupported);
    }
  }
}

BLOSSOM_TEST(PageTest)
#include "page_test.moc"
