#pragma once
#include <Standard_Failure.hxx>
#include <string>
#include <utility>

namespace blossom::modeling {

/// Throws an Error with `message` and `hint` for an exception of OCCT; running out of memory has a message of its own.
[[noreturn]] void throwOcctFailure(const Standard_Failure&, const std::string& message, const std::string& hint);

/// Calls `work` and converts exceptions of OCCT to an Error InvalidInput; other exceptions pass.
template <class Work>
auto guarded(const std::string& message, const std::string& hint, Work&& work) -> decltype(work()) {
  try {
    return std::forward<Work>(work)();
  } catch (const Standard_Failure& failure) {
    throwOcctFailure(failure, message, hint);
  }
}

}  // namespace blossom::modeling
