#include "exchange/plain/motion_node.h"

#include <cmath>

#include "core/error.h"

namespace blossom {

namespace {

constexpr int largestDegree = 25;

}  // namespace

void MotionNode::fail(const std::string& expected) const {
  throw Error(ErrorCode::FormatDamaged, fmt::format("{} {}.", path.empty() ? "This motion file" : path, expected),
              "The manual page \"Sweep\" describes the motion file.");
}

MotionNode MotionNode::operator[](std::size_t index) const { return {value[index], fmt::format("{}[{}]", path, index)}; }

MotionNode MotionNode::at(const char* key) const {
  const std::string full = path.empty() ? key : path + "." + key;
  if (!has(key)) MotionNode{value, full}.fail("is missing");
  return {value.at(key), full};
}

void MotionNode::requireObject(std::initializer_list<const char*> keys) const {
  if (!value.is_object()) fail(path.empty() ? "must hold one JSON object" : "must be an object");
  for (const auto& [key, ignored] : value.items()) {
    bool known = false;
    for (const char* wanted : keys) known = known || key == wanted;
    if (!known) MotionNode{value, path.empty() ? key : path + "." + key}.fail("is not a key of a motion file");
  }
}

std::size_t MotionNode::arraySize(const char* what) const {
  if (!value.is_array() || value.empty()) fail(fmt::format("must be a list of {}", what));
  if (value.size() > motionFileEntries)
    fail(fmt::format("holds {} entries; at most {} can be read", value.size(), motionFileEntries));
  return value.size();
}

double MotionNode::number() const {
  if (!value.is_number()) fail("must be a number");
  const double number = value.get<double>();
  if (!(std::abs(number) <= motionFileNumber)) fail(fmt::format("must lie between -1e9 and 1e9; it is {}", number));
  return number;
}

double MotionNode::numberWithin(double least, double most) const {
  const double given = number();
  if (given < least || given > most) fail(fmt::format("must lie between {} and {}; it is {}", least, most, given));
  return given;
}

int MotionNode::wholeNumberWithin(int least, int most) const {
  if (!value.is_number_integer()) fail("must be a whole number");
  // As a double, so that an absurd size cannot overflow.
  const double given = value.get<double>();
  if (given < least || given > most) fail(fmt::format("must lie between {} and {}; it is {}", least, most, given));
  return static_cast<int>(given);
}

bool MotionNode::yesOrNo() const {
  if (!value.is_boolean()) fail("must be true or false");
  return value.get<bool>();
}

int MotionNode::degree() const { return wholeNumberWithin(1, largestDegree); }

std::vector<double> MotionNode::knots() const {
  const std::size_t count = arraySize("knots");
  std::vector<double> result;
  result.reserve(count);
  for (std::size_t i = 0; i < count; ++i) {
    result.push_back((*this)[i].number());
    if (i > 0 && result[i] < result[i - 1])
      (*this)[i].fail(fmt::format("must not be smaller than the knot before it, {}", result[i - 1]));
  }
  return result;
}

}  // namespace blossom
