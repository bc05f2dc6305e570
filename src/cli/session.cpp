#include "cli/session.h"

#include <ostream>

namespace blossom {

void printJson(std::ostream& out, const Value& value) {
  out << value.dump(-1, ' ', false, Value::error_handler_t::replace) << '\n';
}

Value toJson(const Error& error) {
  return {{"code", errorCodeName(error.code())}, {"message", error.message()}, {"hint", error.hint()}};
}

}  // namespace blossom
