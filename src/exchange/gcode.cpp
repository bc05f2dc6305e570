#include <fmt/format.h>

#include <charconv>
#include <cmath>
#include <numbers>
#include <optional>

#include "core/error.h"
#include "core/file.h"
#include "core/units.h"
#include "exchange/format.h"

/// Reads the contours of a G-code program (RS-274, LinuxCNC's dialect): G0 G1 G2 G3 in the plane G17 and G5.2 NURBS.
namespace blossom {
namespace {

struct Word {
  char letter;
  std::optional<double> value;  ///< empty for parameters and expressions, which are not evaluated
};

constexpr std::size_t largestLine = 10000;
constexpr double pi = std::numbers::pi;

/// A line without its comments: "(..)" and everything after ";".
std::string withoutComments(std::string_view line) {
  std::string kept;
  int depth = 0;
  for (const char c : line) {
    if (depth == 0 && (c == ';' || c == '%')) break;
    if (c == '(') ++depth;
    if (depth == 0 && c != ' ' && c != '\t' && c != '\r')
      kept += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (c == ')' && depth > 0) --depth;
  }
  return kept;
}

/// Length of a parameter or an expression: "#1", "#<name>", "[#1+2]".
std::size_t expressionLength(std::string_view text) {
  std::size_t at = 0;
  int brackets = 0, angles = 0;
  while (at < text.size()) {
    const char c = text[at];
    if (c == '[') ++brackets;
    if (c == '<') ++angles;
    if (brackets == 0 && angles == 0 && at > 0 && std::isalpha(static_cast<unsigned char>(c))) break;
    if (c == ']') --brackets;
    if (c == '>') --angles;
    ++at;
  }
  return at;
}

class Reader {
 public:
  Imported read(const std::string& text, const Progress& progress) {
    std::size_t begin = 0;
    while (begin < text.size()) {
      const std::size_t end = std::min(text.find('\n', begin), text.size());
      ++lineNumber_;
      if (lineNumber_ % 4096 == 0)
        progress.report(static_cast<double>(begin) / static_cast<double>(text.size()), "Reading G-code");
      readLine(std::string_view(text).substr(begin, end - begin));
      begin = end + 1;
    }
    finishNurbs();
    finishPath();
    if (moves_.empty()) damaged("the file holds no motion (G0, G1, G2, G3 or G5.2)");
    Imported imported;
    for (const auto& [name, count] : moves_.items()) imported.entities[name] = count;
    imported.skipped = skipped_;
    imported.shape = Shape(std::move(drawing_));
    return imported;
  }

 private:
  [[noreturn]] void damaged(const std::string& what) const {
    throw Error(ErrorCode::FormatDamaged, fmt::format("Line {}: {}.", lineNumber_, what),
                "Check that the file is G-code and complete.");
  }

  static void count(Value& counts, const std::string& name) { counts[name] = counts.value(name, 0) + 1; }

  void readLine(std::string_view raw) {
    if (raw.size() > largestLine) damaged("the line is longer than 10,000 characters");
    const std::string line = withoutComments(raw);
    if (line.empty() || line.front() == '/') return;
    if (line.front() == '#' || line.front() == 'O') return count(skipped_, line.front() == '#' ? "parameter" : "subroutine");
    run(words(line));
  }

  std::vector<Word> words(std::string_view text) {
    std::vector<Word> found;
    while (!text.empty()) {
      const char letter = text.front();
      text.remove_prefix(1);
      if (letter == '$' || letter == '^' || letter == '@') {  // spindle numbers and polar words of LinuxCNC
        double ignored = 0;
        const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), ignored);
        text.remove_prefix(error == std::errc{} ? static_cast<std::size_t>(end - text.data()) : 0);
        continue;
      }
      if (!std::isupper(static_cast<unsigned char>(letter)))
        damaged(fmt::format("a word starts with '{}'", letter >= ' ' && letter < 127 ? letter : '?'));
      if (!text.empty() && (text.front() == '#' || text.front() == '[')) {
        text.remove_prefix(expressionLength(text));
        found.push_back({letter, std::nullopt});
        continue;
      }
      if (!text.empty() && text.front() == '+') text.remove_prefix(1);
      double value = 0;
      const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value, std::chars_format::fixed);
      if (error != std::errc{} || !std::isfinite(value)) damaged(fmt::format("the word {} has no number", letter));
      text.remove_prefix(static_cast<std::size_t>(end - text.data()));
      found.push_back({letter, value});
    }
    return found;
  }

  void run(const std::vector<Word>& line) {
    std::optional<double> x, y, i, j, radius, weight, order;
    bool moves = false;
    for (const Word& word : line) {
      switch (word.letter) {
        case 'G':
          mode(number(word));
          break;
        case 'X':
          x = number(word) * unit_;
          break;
        case 'Y':
          y = number(word) * unit_;
          break;
        case 'Z':
          moves = true;
          break;
        case 'I':
          i = number(word) * unit_;
          break;
        case 'J':
          j = number(word) * unit_;
          break;
        case 'R':
          radius = number(word) * unit_;
          break;
        case 'P':
          weight = word.value;
          break;
        case 'L':
          order = word.value;
          break;
        case 'M':
        case 'F':
        case 'S':
        case 'T':
        case 'N':
        case 'H':
        case 'D':
        case 'Q':
        case 'E':
        case 'K':
        case 'A':
        case 'B':
        case 'C':
          break;
        default:
          count(skipped_, std::string(1, word.letter));
      }
    }
    if (motion_ == Motion::Nurbs) return addNurbs(x, y, weight, order);
    if (!x && !y && !i && !j) {
      if (moves) countMove();
      return;
    }
    countMove();
    move(target(x, y), i, j, radius);
  }

  double number(const Word& word) const {
    if (!word.value)
      damaged(fmt::format("the word {} is a parameter or an expression, which is not evaluated here", word.letter));
    return *word.value;
  }

  void mode(double code) {
    const int tenths = static_cast<int>(std::lround(code * 10));
    if (motion_ == Motion::Nurbs && tenths != 52) finishNurbs();
    switch (tenths) {
      case 0:
        motion_ = Motion::Rapid;
        break;
      case 10:
        motion_ = Motion::Line;
        break;
      case 20:
        motion_ = Motion::Clockwise;
        break;
      case 30:
        motion_ = Motion::Counterclockwise;
        break;
      case 52:
        motion_ = Motion::Nurbs;
        break;
      case 53:
      case 800:
        motion_ = Motion::None;
        break;
      case 180:
      case 190:
        damaged("arcs in the planes G18 and G19 are not read");
      case 200:
        unit_ = millimetresPerInch;
        break;
      case 210:
        unit_ = 1;
        break;
      case 900:
        absolute_ = true;
        break;
      case 910:
        absolute_ = false;
        break;
      case 901:
        absoluteCenters_ = true;
        break;
      case 911:
        absoluteCenters_ = false;
        break;
      default:
        break;  // offsets, path modes and other settings do not change the contour
    }
  }

  [[nodiscard]] Vec2 target(const std::optional<double>& x, const std::optional<double>& y) const {
    if (absolute_) return {x.value_or(at_.x()), y.value_or(at_.y())};
    return at_ + Vec2(x.value_or(0), y.value_or(0));
  }

  void countMove() {
    static constexpr const char* names[] = {"", "G0", "G1", "G2", "G3", "G5.2"};
    if (motion_ != Motion::None) count(moves_, names[static_cast<int>(motion_)]);
  }

  void move(const Vec2& to, const std::optional<double>& i, const std::optional<double>& j,
            const std::optional<double>& radius) {
    switch (motion_) {
      case Motion::Rapid:
        finishPath();
        break;
      case Motion::Line:
        if (to != at_) path_.segments.push_back(Line2{at_, to});
        break;
      case Motion::Clockwise:
      case Motion::Counterclockwise:
        path_.segments.push_back(arc(to, i, j, radius));
        break;
      default:
        damaged("coordinates without a motion (G0, G1, ..)");
    }
    at_ = to;
  }

  Arc2 arc(const Vec2& to, const std::optional<double>& i, const std::optional<double>& j,
           const std::optional<double>& radius) const {
    const bool clockwise = motion_ == Motion::Clockwise;
    Vec2 center;
    if (radius) {
      const Vec2 chord = to - at_;
      const double half = chord.norm() / 2;
      if (half == 0 || half > std::abs(*radius) * (1 + 1e-4)) damaged("the arc's radius R does not reach its end");
      const double height = std::sqrt(std::max(0.0, *radius * *radius - half * half));
      const Vec2 left = Vec2(-chord.y(), chord.x()) / (2 * half);
      center = at_ + chord / 2 + left * height * ((clockwise != (*radius < 0)) ? -1 : 1);
    } else if (i || j) {
      center =
          absoluteCenters_ ? Vec2(i.value_or(at_.x()), j.value_or(at_.y())) : Vec2(at_ + Vec2(i.value_or(0), j.value_or(0)));
    } else {
      damaged("an arc needs I, J or R");
    }
    const Vec2 first = at_ - center, last = to - center;
    if (first.norm() == 0) damaged("the arc has no radius");
    const double start = std::atan2(first.y(), first.x());
    double sweep = std::atan2(last.y(), last.x()) - start;
    if (clockwise && sweep >= -1e-12) sweep -= 2 * pi;
    if (!clockwise && sweep <= 1e-12) sweep += 2 * pi;
    return {center, first.norm(), start, sweep};
  }

  void addNurbs(const std::optional<double>& x, const std::optional<double>& y, const std::optional<double>& weight,
                const std::optional<double>& order) {
    if (nurbs_.empty()) {
      count(moves_, "G5.2");
      nurbs_.emplace_back(at_.x(), at_.y(), 1);  // the curve starts where the tool is
      order_ = 3;
    }
    if (order) order_ = static_cast<int>(std::clamp(*order, 2.0, 26.0));
    if (!x && !y) return;
    const Vec2 pole = target(x, y);
    const double w = weight.value_or(1);
    if (!(w > 0)) damaged("the weight P must be above 0");
    nurbs_.emplace_back(pole.x() * w, pole.y() * w, w);
    at_ = pole;
  }

  void finishNurbs() {
    if (motion_ == Motion::Nurbs) motion_ = Motion::None;
    if (nurbs_.empty()) return;
    if (nurbs_.size() < 2) damaged("a G5.2 curve needs at least two control points");
    Spline2 spline;
    spline.degree = std::min(order_, static_cast<int>(nurbs_.size())) - 1;
    const auto poles = static_cast<int>(nurbs_.size());
    for (int k = 0; k <= poles + spline.degree; ++k)
      spline.knots.push_back(std::clamp(k - spline.degree, 0, poles - spline.degree));
    spline.poles = std::move(nurbs_);
    nurbs_.clear();
    path_.segments.emplace_back(std::move(spline));
  }

  void finishPath() {
    if (path_.segments.empty()) return;
    path_.closed = (pathStart() - at_).norm() < 1e-6;
    drawing_.paths.push_back(std::move(path_));
    path_ = {};
  }

  [[nodiscard]] Vec2 pathStart() const {
    const Segment& first = path_.segments.front();
    if (const auto* line = std::get_if<Line2>(&first)) return line->from;
    if (const auto* round = std::get_if<Arc2>(&first))
      return round->center + round->radius * Vec2(std::cos(round->start), std::sin(round->start));
    const Vec3& pole = std::get<Spline2>(first).poles.front();
    return pole.head<2>() / pole.z();
  }

  enum class Motion { None, Rapid, Line, Clockwise, Counterclockwise, Nurbs };
  Motion motion_ = Motion::None;
  double unit_ = 1;
  bool absolute_ = true;
  bool absoluteCenters_ = false;
  Vec2 at_{0, 0};
  int order_ = 3;
  std::vector<Vec3> nurbs_;
  Path path_;
  Curves drawing_;
  Value moves_ = Value::object();
  Value skipped_ = Value::object();
  std::size_t lineNumber_ = 0;
};

}  // namespace

Format gcodeFormat() {
  Format format;
  format.id = "gcode";
  format.title = "G-code contours (LinuxCNC)";
  format.extensions = {"ngc", "nc", "gcode", "tap"};
  format.read = [](const std::filesystem::path& path, const Value&, const Progress& progress) {
    return Reader().read(readFile(path), progress);
  };
  return format;
}

}  // namespace blossom
