#pragma once
#include <array>
#include <exception>
#include <functional>

#include "core/parallel.h"

namespace blossom::morphology {

/// Calls two pieces of work that share nothing, beside each other where there are threads. @throws what the first of them
/// throws, else what the second does.
inline void sideBySide(const Progress& progress, const std::function<void()>& first, const std::function<void()>& second) {
  std::array<std::exception_ptr, 2> failures;
  parallelFor(2, 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) try {
        (k == 0 ? first : second)();
      } catch (...) {
        failures[k] = std::current_exception();
      }
  });
  for (const std::exception_ptr& failure : failures)
    if (failure) std::rethrow_exception(failure);
}

}  // namespace blossom::morphology
