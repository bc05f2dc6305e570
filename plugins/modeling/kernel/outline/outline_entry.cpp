#include "kernel/outline/outline_entry.h"

#include <cctype>
#include <string_view>

#include "core/error.h"
#include "core/units.h"

namespace blossom::modeling {

bool TypedEntry::begins(char c) { return std::string_view("0123456789.-@<").find(c) != std::string_view::npos; }

bool TypedEntry::type(char c) {
  if (!open() && !begins(c)) return false;
  if (c == '@') {
    if (open()) return false;
    relative_ = place_ = true;
    return true;
  }
  if (c == '<' || c == ',') {
    if (active_ == 1 || (place_ && c == '<')) return false;
    place_ = place_ || c == ',';
    active_ = 1;
    return true;
  }
  const bool known =
      std::isalnum(static_cast<unsigned char>(c)) || std::string_view(".+-*/()'\" ").find(c) != std::string_view::npos;
  if (!known) return false;
  field().push_back(c);
  return true;
}

bool TypedEntry::back() {
  if (!open() && active_ == 0) return false;
  if (!field().empty()) {
    field().pop_back();
  } else if (active_ == 1) {
    active_ = 0;
    place_ = relative_;
  } else {
    clear();
  }
  if (!open()) clear();
  return true;
}

void TypedEntry::switchField() { active_ = 1 - active_; }

std::string TypedEntry::text() const {
  std::string text = relative_ ? "@" : "";
  text += fields_[0];
  if (active_ == 1 || !fields_[1].empty()) text += (place_ ? ", " : " < ") + fields_[1];
  return text;
}

TypedEntry::Values TypedEntry::values() const {
  Values values;
  if (place_) {
    values.place = Vec2(parseLength(fields_[0], unit_), parseLength(fields_[1], unit_));
    values.relative = relative_;
    return values;
  }
  if (!fields_[0].empty()) values.length = parseLength(fields_[0], unit_);
  if (!fields_[1].empty()) values.angle = parseAngle(fields_[1]);
  if (values.length && !(*values.length > 0))
    throw Error(ErrorCode::InvalidParameter, "The length must be above 0.", "Give the direction by an angle.");
  return values;
}

std::string TypedEntry::problem() const {
  try {
    (void)values();
    return {};
  } catch (const Error& e) {
    return e.message();
  }
}

}  // namespace blossom::modeling
