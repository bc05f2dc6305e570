#pragma once
#include <functional>

#include "core/error.h"

namespace blossom::test {

/// The error that a call ends with; an internal one that says so where it ends without.
inline Error errorOf(const std::function<void()>& call) {
  try {
    call();
  } catch (const Error& error) {
    return error;
  }
  return Error(ErrorCode::Internal, "nothing was thrown");
}

}  // namespace blossom::test
