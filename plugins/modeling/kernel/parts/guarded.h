#pragma once
#include <Standard_Failure.hxx>
#include <string>
#include <utility>

namespace blossom::modeling {

/// Throws what an exception of OCCT means to a user: `message` with `hint`; want of memory is told as such.
[[noreturn]] void throwOcctFailure(const Standard_Failure&, const std::string& message, const std::string& hint);

/// Runs `work` and turns the exceptions of OCCT that come out of it into an Error InvalidInput; other exceptions pass.
template <class Work>
auto guarded(const std::string& message, const std::string& hint, Work&& work) -> decltype(work()) {
  try {
    return std::forward<Work>(work)();
  } catch (const Standard_Failure& failure) {
    throwOcctFailure(failure, message, hint);
  }
}

}  // namespace blossom::modeling
