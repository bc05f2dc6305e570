// Spindle, tool and coolant.
#include <fmt/format.h>

#include <algorithm>

#include "exchange/gcode/gcode_codes.h"
#include "exchange/gcode/gcode_parser.h"

namespace blossom {

void GcodeParser::machine(double given) {
  const int code = given >= 0 && given < 1000 ? static_cast<int>(given) : -1;
  if (const auto obstacle = obstacleOfMachine(code)) cannotFollow(*obstacle);
  noteLost(notKept('M', code));
  if (code == 3 || code == 4) {
    program_.turnsSpindle = turning_ = justStarted_ = true;
    watch_.spindleTurns();
  }
  if (code == 5 || code == 19) {
    turning_ = false;
    watch_.spindleStops();
  }
  if (code == 6) changeTool();
  if (code >= 7 && code <= 9) cool(code);
  if (code == 2 || code == 30) end(fmt::format("M{}", code));
}

void GcodeParser::cool(int code) {
  if (code == 7) mist_ = true;
  if (code == 8) flood_ = true;
  if (code == 9) mist_ = flood_ = false;
}

void GcodeParser::noteCoolant() {
  if (program_.cut && (mist_ != program_.mist || flood_ != program_.flood)) noteLost("changes of the coolant (M7, M8, M9)");
}

void GcodeParser::dwell(const Block& block) {
  if (block.weight.value_or(0) < 0) watch_.belowZero('P', *block.weight);
  if (!justStarted_) noteLost(notKept('G', 4));
}

void GcodeParser::chooseTool(int number) {
  if (program_.cut && !changes_ && number != program_.cutter.number) cannotFollow("a second tool");
  chosen_ = number;
  watch_.toolMade(number);
  if (!program_.cut && !changes_) program_.cutter.number = number;
}

void GcodeParser::changeTool() {
  program_.namesTool = true;
  const int number = chosen_.value_or(program_.cutter.number);
  if (program_.cut && number != program_.cutter.number) cannotFollow("a second tool");
  if (!program_.cut) program_.cutter.number = number;
  changes_ = true;
  watch_.toolChanged();
}

void GcodeParser::setSpeed(double speed) {
  if (program_.cut && turning_ && speed > 0 && speed != program_.cutter.spindle)
    noteLost("a change of the spindle's speed (S)");
  speed_ = speed;
}

void GcodeParser::settleSpindle() {
  if (!program_.cut) program_.cutter.spindle = speed_;
}

void GcodeParser::beginCutting() {
  if (program_.cut) return;
  program_.cut = true;
  program_.mist = mist_;
  program_.flood = flood_;
  if (unknown_.any())
    program_.doubts.push_back(
        fmt::format("line {} cuts before X, Y and Z were all named; what was not is taken as 0", lineNumber_));
  program_.cutter.spindle = turning_ || !program_.turnsSpindle ? speed_ : 0;
}

void GcodeParser::noteLost(const std::string& what) {
  if (!what.empty() && std::find(program_.notKept.begin(), program_.notKept.end(), what) == program_.notKept.end())
    program_.notKept.push_back(what);
}

}  // namespace blossom
