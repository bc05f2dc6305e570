// The lines of a program, and the words in them.
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <cmath>

#include "core/error.h"
#include "exchange/gcode/gcode_comments.h"
#include "exchange/gcode/gcode_parser.h"

namespace blossom {

namespace {

constexpr std::size_t largestLine = 10000;

bool holdsCode(std::string_view text) {
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    const std::string code = withoutComments(text.substr(0, end)).code;
    if (!code.empty() &&
        (std::isalpha(static_cast<unsigned char>(code.front())) || code.front() == '/' || code.front() == '#'))
      return true;
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  return false;
}

}  // namespace

GcodeProgram GcodeParser::read(std::string_view text, const Progress& progress) {
  constexpr std::string_view byteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(byteOrderMark)) text.remove_prefix(byteOrderMark.size());
  std::size_t begin = 0;
  while (begin < text.size() && !ended_) {
    const std::size_t end = std::min(text.find('\n', begin), text.size());
    watch_.at(++lineNumber_);
    if (lineNumber_ % 4096 == 0)
      progress.report(static_cast<double>(begin) / static_cast<double>(text.size()), "Reading G-code");
    readLine(text.substr(begin, end - begin));
    begin = end + 1;
  }
  if (ended_ && begin < text.size() && holdsCode(text.substr(begin))) watch_.endsBefore(ending_);
  finishNurbs();
  settleSpindle();
  settleDoubts(progress);
  if (program_.counts.empty()) damaged("the file holds no motion (G0, G1, G2, G3 or G5.2)");
  return std::move(program_);
}

void GcodeParser::settleDoubts(const Progress& progress) {
  for (std::string& doubt : watch_.doubts()) program_.doubts.push_back(std::move(doubt));
  for (std::string& doubt : arcs_.doubts(progress)) program_.doubts.push_back(std::move(doubt));
  program_.drawingDoubts = watch_.drawingDoubts();
}

void GcodeParser::damaged(const std::string& what) const {
  throw Error(ErrorCode::FormatDamaged, fmt::format("Line {}: {}.", lineNumber_, what),
              "Check that the file is G-code and complete.");
}

void GcodeParser::count(Value& counts, const std::string& name) { counts[name] = counts.value(name, 0) + 1; }

void GcodeParser::cannotFollow(const std::string& what) {
  if (!program_.obstacle) program_.obstacle = {lineNumber_, what};
}

void GcodeParser::readLine(std::string_view raw) {
  if (raw.size() > largestLine) damaged("the line is longer than 10,000 characters");
  const GcodeLine read = withoutComments(raw);
  for (const std::string& comment : read.comments) readComment(comment, program_);
  if (read.nested) cannotFollow("a comment within a comment");
  if (read.tapeMark) return tapeMark();
  const std::string& line = read.code;
  if (line.empty()) return;
  begun_ = true;
  if (line.front() == '/') return cannotFollow("a line that may be left out (/)");
  if (line.front() == '#') {
    const auto isSystem = [&] { return line.size() > 4 && line[1] == '5' && line.find('=') >= 5; };
    if (isSystem()) cannotFollow("a parameter of the control that is set");  // #5221 and its like move the zero
    return count(program_.skipped, "parameter");
  }
  const auto isDigit = [](char c) { return c >= '0' && c <= '9'; };
  if (line.front() == 'O' && line.size() > 1 && std::all_of(line.begin() + 1, line.end(), isDigit)) return;  // its number
  if (line.front() == 'O') {
    cannotFollow("a subroutine or a loop (O)");
    if (!program_.unrolled) program_.unrolled = {lineNumber_, line.substr(0, 24)};
    return count(program_.skipped, "subroutine");
  }
  const GcodeWords said = gcodeWords(line);
  if (!said.damage.empty()) damaged(said.damage);
  if (said.polar) cannotFollow("polar coordinates");
  for (const GcodeWord& word : said.words)
    if (isLength(word.letter) && word.value) arcs_.number(word.digits, unit_);
  run(said.words);
}

void GcodeParser::tapeMark() {
  if (!begun_)
    opened_ = true;
  else if (opened_)
    end("%");
  else
    watch_.endsPerhaps();
}

void GcodeParser::end(std::string by) {
  ended_ = true;
  ending_ = std::move(by);
}

void GcodeParser::run(const std::vector<GcodeWord>& line) {
  Block block;
  for (const GcodeWord& word : line)
    if (word.letter == 'G') mode(number(word), block);
  for (const GcodeWord& word : line) place(word, block);
  for (const GcodeWord& word : line)
    if (word.letter == 'M') machine(word.value.value_or(-1));
  if (block.extended) setWorkOffset(fmt::format("G54.1 P{:g}", block.weight.value_or(1)));
  if (block.scaling && block.namesAny()) cannotFollow("scaling or a moved zero (G50)");
  if (block.dwell && block.namesAny()) return cannotFollow("a dwell that is given by an axis (G4)");
  if (block.dwell) dwell(block);
  watchModes(block);
  motionOf(block);
}

void GcodeParser::place(const GcodeWord& word, Block& block) {
  switch (word.letter) {
    case 'X':
      block.x = coordinate(word);
      break;
    case 'Y':
      block.y = coordinate(word);
      break;
    case 'Z':
      if (word.value)
        block.z = coordinate(word);
      else
        block.unknownZ = true;
      break;
    case 'I':
      block.i = coordinate(word);
      break;
    case 'J':
      block.j = coordinate(word);
      break;
    case 'R':
      block.radius = coordinate(word);
      break;
    case 'K':
      if (word.value) block.k = coordinate(word);
      break;
    case 'H':
      if (word.value && *word.value >= 0 && *word.value < 1e6) block.lengthNumber = static_cast<int>(*word.value);
      break;
    case 'P':
      block.weight = word.value;
      block.saysP = true;
      break;
    case 'L':
      block.order = word.value;
      break;
    default:
      setting(word);
  }
}

void GcodeParser::setting(const GcodeWord& word) {
  switch (word.letter) {
    case 'F':
      if (word.value) feed_ = std::max(0.0, *word.value) * unit_;
      watch_.feed(word.value);
      break;
    case 'S':
      if (word.value) setSpeed(std::max(0.0, *word.value));
      watch_.speed(word.value);
      break;
    case 'T':
      program_.namesTool = true;
      if (word.value && *word.value >= 0 && *word.value < 1e6) chooseTool(static_cast<int>(*word.value));
      break;
    case 'A':
    case 'B':
    case 'C':
      cannotFollow("a rotary axis");
      break;
    case 'U':
    case 'V':
    case 'W':
      cannotFollow("an axis beside X, Y and Z");
      count(program_.skipped, std::string(1, word.letter));
      break;
    case 'G':
    case 'M':
    case 'N':
    case 'D':
    case 'Q':
    case 'E':
      break;
    default:
      count(program_.skipped, std::string(1, word.letter));
  }
}

double GcodeParser::number(const GcodeWord& word) const {
  if (!word.value)
    damaged(fmt::format("the word {} is a parameter or an expression, which is not evaluated here", word.letter));
  return *word.value;
}

double GcodeParser::coordinate(const GcodeWord& word) const {
  const double mm = number(word) * unit_;
  if (std::abs(mm) > maximumGcodeCoordinate) damaged(fmt::format("the word {} is farther away than 10 km", word.letter));
  return mm;
}

GcodeProgram parseGcode(std::string_view text, const Progress& progress) { return GcodeParser().read(text, progress); }

bool isMachining(const GcodeProgram& program) {
  return program.movesInZ && (program.turnsSpindle || program.namesTool || program.cutter.diameter > 0) &&
         program.splines.empty();
}

}  // namespace blossom
