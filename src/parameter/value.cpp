#include "parameter/value.h"

#include <fmt/format.h>

#include <string>
#include <vector>

#include "core/error.h"

namespace blossom {
namespace {

constexpr std::size_t deepest = 100;
constexpr std::size_t widest = 4096;

/// nlohmann's "[json.exception.parse_error.101] parse error at line 1, column 5: ..." without the part for programmers.
std::string withoutPrefix(const std::string& what) {
  const auto end = what.find("] ");
  return end == std::string::npos ? what : what.substr(end + 2);
}

/// Reads without keeping anything: nlohmann's own parser with a callback looks at all elements of an array after each.
class LimitCheck final : public nlohmann::json_sax<Value> {
 public:
  bool null() override { return true; }
  bool boolean(bool) override { return true; }
  bool number_integer(number_integer_t) override { return true; }
  bool number_unsigned(number_unsigned_t) override { return true; }
  bool number_float(number_float_t, const string_t&) override { return true; }
  bool string(string_t&) override { return true; }
  bool binary(binary_t&) override { return true; }
  bool start_object(std::size_t) override { return open(); }
  bool end_object() override { return close(); }
  bool start_array(std::size_t) override { return open(); }
  bool end_array() override { return close(); }
  bool key(string_t&) override {
    if (++keysOfOpen_.back() > widest)
      throw Error(ErrorCode::LimitExceeded, fmt::format("An object in the JSON has more than {} keys.", widest));
    return true;
  }
  bool parse_error(std::size_t, const std::string&, const nlohmann::detail::exception&) override { return false; }

 private:
  bool open() {
    if (keysOfOpen_.size() > deepest)
      throw Error(ErrorCode::LimitExceeded, fmt::format("The JSON is nested more than {} levels deep.", deepest));
    keysOfOpen_.push_back(0);
    return true;
  }
  bool close() {
    keysOfOpen_.pop_back();
    return true;
  }

  std::vector<std::size_t> keysOfOpen_;
};

}  // namespace

Value parseJson(std::string_view text) {
  LimitCheck limits;
  (void)Value::sax_parse(text, &limits);
  try {
    return Value::parse(text);
  } catch (const Value::exception& e) {
    throw Error(ErrorCode::FormatDamaged, fmt::format("The JSON cannot be read: {}.", withoutPrefix(e.what())));
  }
}

}  // namespace blossom
