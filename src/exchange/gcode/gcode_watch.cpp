#include "exchange/gcode/gcode_watch.h"

#include <fmt/format.h>

#include <algorithm>

namespace blossom {
namespace {

constexpr std::size_t maximumOfAKind = 3;

}  // namespace

void GcodeWatch::note(Noted& where, std::size_t line, std::string what) {
  if (where.size() < maximumOfAKind) where.emplace_back(line, std::move(what));
}

void GcodeWatch::toolChanged() {
  changes_ = true;
  if (chosen_) tool_ = Numbered{chosen_->number, line_};
}

void GcodeWatch::lengthFrom(std::optional<int> number) {
  hasLength_ = true;
  cancelled_.reset();
  if (number)
    length_ = Numbered{*number, line_};
  else
    length_.reset();  // that of the tool in the spindle
}

void GcodeWatch::lengthNumber(int number) {
  if (length_) length_ = Numbered{number, line_};
}

void GcodeWatch::noLength() {
  if (hasLength_) cancelled_ = line_;
  hasLength_ = false;
  length_.reset();
}

void GcodeWatch::workOffset(const std::string& name, bool moved) {
  if (offset_ && offset_->second != name && !moved)
    note(offsets_, line_,
         fmt::format("line {}: {} takes the place of {} from line {}, in which nothing has moved", line_, name,
                     offset_->second, offset_->first));
  offset_ = {line_, name};
}

void GcodeWatch::spindleTurns() {
  turning_ = everTurned_ = true;
  stillDoubted_ = false;
}

void GcodeWatch::spindleStops() {
  if (turning_) stopped_ = line_;
  turning_ = false;
}

void GcodeWatch::blendsWithoutLimit() {
  note(corners_, line_,
       fmt::format("line {}: G64 without a tolerance (P) lets the control cut corners without a limit", line_));
}

void GcodeWatch::blends(double mm) {
  constexpr double unusual = 0.1;  // mm: ten times what roughing asks for; 2 where 0.002 was meant
  if (mm > unusual)
    note(corners_, line_,
         fmt::format("line {}: G64 P lets the control leave its way by up to {:g} mm at corners, also where it lifts", line_,
                     mm));
}

void GcodeWatch::endsBefore(const std::string& by) {
  note(ends_, line_, fmt::format("line {}: {} ends the program; what stands after it is not run", line_, by));
}

void GcodeWatch::endsPerhaps() {
  note(ends_, line_,
       fmt::format("line {}: controls differ about a % between the lines of a program; it is read past it here", line_));
}

void GcodeWatch::belowZero(char letter, double value) {
  note(negative_, line_, fmt::format("line {}: {}{:g} is below 0, and controls stop there", line_, letter, value));
}

void GcodeWatch::feed(std::optional<double> value) {
  if (value && *value < 0) belowZero('F', *value);
  feeds_ = !value || *value > 0;
  feedDoubted_ = false;
}

void GcodeWatch::speed(std::optional<double> value) {
  if (value && *value < 0) belowZero('S', *value);
  hasSpeed_ = !value || *value > 0;
  speedDoubted_ = false;
}

void GcodeWatch::moves() {
  if (unitsSaid_ || unitsDoubted_) return;
  unitsDoubted_ = true;
  note(units_, line_,
       fmt::format("line {} moves before G21 or G20 tells whether lengths are millimetres or inches; they are read as "
                   "millimetres",
                   line_));
}

/// T alone is only made ready where M6 changes tools; where nothing does, it is the tool.
void GcodeWatch::checkLength() {
  if (cancelled_) {
    note(lengths_, *cancelled_,
         fmt::format("line {}: G49 takes the length of the tool back, and line {} cuts without it", *cancelled_, line_));
    cancelled_.reset();
  }
  const std::optional<Numbered>& tool = changes_ ? tool_ : chosen_;
  if (!length_ || !tool || length_->number == tool->number) return;
  if (!mismatches_.emplace(length_->number, tool->number).second) return;
  note(lengths_, length_->line,
       fmt::format("line {}: H{} takes the length of tool {}, and line {} cuts with tool {}, chosen in line {}",
                   length_->line, length_->number, length_->number, line_, tool->number, tool->line));
}

void GcodeWatch::checkFeed() {
  if (feeds_ || feedDoubted_) return;
  feedDoubted_ = true;
  note(feeding_, line_, fmt::format("line {} cuts without a feed above 0 (F)", line_));
}

void GcodeWatch::cuts() {
  checkLength();
  checkFeed();
  checkSpindle();
}

void GcodeWatch::checkSpindle() {
  if (turning_ && !hasSpeed_ && !speedDoubted_) {
    speedDoubted_ = true;
    note(still_, line_, fmt::format("line {} cuts without a speed of the spindle above 0 (S)", line_));
  }
  if (turning_ || stillDoubted_) return;
  stillDoubted_ = true;
  note(still_, line_,
       fmt::format("line {} cuts while the spindle stands still{}", line_,
                   stopped_ ? fmt::format("; line {} stopped it", *stopped_) : std::string()));
}

std::vector<std::string> GcodeWatch::doubts() const {
  Noted all = units_;
  for (const Noted* kind : {&ends_, &offsets_, &lengths_, &corners_, &feeding_, &negative_})
    all.insert(all.end(), kind->begin(), kind->end());
  if (everTurned_) all.insert(all.end(), still_.begin(), still_.end());
  std::stable_sort(all.begin(), all.end(), [](const auto& a, const auto& b) { return a.first < b.first; });
  std::vector<std::string> sentences;
  sentences.reserve(all.size());
  for (const auto& [line, what] : all) sentences.push_back(what);
  return sentences;
}

std::vector<std::string> GcodeWatch::drawingDoubts() const {
  std::vector<std::string> sentences;
  for (const Noted* kind : {&units_, &ends_})
    for (const auto& [line, what] : *kind) sentences.push_back(what);
  return sentences;
}

}  // namespace blossom
