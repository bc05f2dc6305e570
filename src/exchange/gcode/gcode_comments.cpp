#include "exchange/gcode/gcode_comments.h"

#include <cctype>
#include <cmath>

#include "core/angle.h"
#include "exchange/format/text.h"

namespace blossom {
namespace {

/// What Blossom writes into the comments of its programs (see gcode_write.cpp): words and numbers apart by blanks.
class HeaderComment {
 public:
  explicit HeaderComment(std::string_view comment) : rest_(comment) {}
  bool word(std::string_view wanted) { return parse::takeWord(rest_) == wanted; }
  double number() {
    const auto value = parse::toNumber(parse::takeWord(rest_));
    good_ = good_ && value && std::abs(*value) < maximumGcodeCoordinate;
    return good_ ? *value : 0;
  }
  [[nodiscard]] bool good() const { return good_; }

 private:
  std::string_view rest_;
  bool good_ = true;
};

void readTool(HeaderComment words, Cutter& cutter) {
  Cutter read = cutter;
  if (!words.word("tool") || !words.word("T")) return;
  read.number = static_cast<int>(words.number());
  if (!words.word("diameter")) return;
  read.diameter = words.number();
  if (!words.word("corner")) return;
  read.cornerRadius = words.number();
  if (!words.word("angle")) return;
  read.vAngle = toRadians(words.number());
  const bool sane = words.good() && read.diameter > 0 && read.cornerRadius >= 0 && read.cornerRadius <= read.diameter / 2 &&
                    read.vAngle >= 0 && read.vAngle < fullTurn / 2;
  if (sane) cutter = read;
}

void readStock(HeaderComment words, Bounds& stock) {
  if (!words.word("stock")) return;
  Vec3 low, high;
  for (int k = 0; k < 3; ++k) {
    if (!words.word(std::string_view("XYZ").substr(static_cast<std::size_t>(k), 1))) return;
    low[k] = words.number();
    high[k] = words.number();
  }
  if (!words.good()) return;
  stock.add(low);
  stock.add(high);
}

void readTask(HeaderComment words, GcodeProgram& program) {
  if (!words.word("part")) return;
  PocketTask task;
  for (int k = 0; k < 3; ++k) {
    if (!words.word(std::string_view("XYZ").substr(static_cast<std::size_t>(k), 1))) return;
    task.zero[k] = words.number();
  }
  if (!words.word("depth")) return;
  task.depth = words.number();
  if (!words.word("wall")) return;
  task.leaveWall = words.number();
  if (!words.word("floor")) return;
  task.leaveFloor = words.number();
  const bool sane =
      words.good() && task.depth > 0 && task.leaveWall >= 0 && task.leaveFloor >= 0 && task.leaveFloor < task.depth;
  if (sane) program.task = task;
}

}  // namespace

GcodeLine withoutComments(std::string_view line) {
  GcodeLine read;
  constexpr std::string_view blanks = " \t\r";
  const std::size_t first = line.find_first_not_of(blanks);
  read.tapeMark = first != std::string_view::npos && line[first] == '%' && line.find_last_not_of(blanks) == first;
  int depth = 0;
  for (const char c : line) {
    if (depth == 0 && (c == ';' || c == '%')) break;
    if (c == '(' && depth++ == 0) read.comments.emplace_back();
    read.nested = read.nested || depth > 1;
    if (depth > 0 && c != '(' && c != ')') read.comments.back() += c;
    if (depth == 0 && c != ' ' && c != '\t' && c != '\r')
      read.code += static_cast<char>(std::toupper(static_cast<unsigned char>(c)));
    if (c == ')' && depth > 0) --depth;
  }
  return read;
}

void readComment(const std::string& comment, GcodeProgram& program) {
  const HeaderComment words(comment);
  readTool(words, program.cutter);
  readStock(words, program.stock);
  readTask(words, program);
  if (comment == "Blossom") program.isBlossoms = true;
  HeaderComment passes(comment);
  if (!passes.word("passes")) return;
  if (const double count = passes.number(); count > 0) program.passes = static_cast<std::size_t>(count);
}

}  // namespace blossom
