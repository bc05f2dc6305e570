#include "cli/invocation.h"

#include <ostream>

namespace blossom {

double millisecondsSince(std::chrono::steady_clock::time_point start) {
  return std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
}

double Invocation::elapsedMs() const { return millisecondsSince(start); }

void printJson(std::ostream& out, const Value& value) {
  out << value.dump(-1, ' ', false, Value::error_handler_t::replace) << '\n';
}

Value toJson(const Error& error) {
  return {{"code", errorCodeName(error.code())}, {"message", error.message()}, {"hint", error.hint()}};
}

}  // namespace blossom
