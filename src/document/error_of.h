#pragma once
#include <functional>
#include <optional>
#include <string>

#include "core/error.h"

namespace blossom {

/// Calls `work` and turns whatever it throws, the modelling library's and the standard library's exceptions too, into an
/// Error that can be kept and shown. @param title what was done: "Box", "Drawing the result". @throws Error Cancelled only.
std::optional<Error> errorOf(const std::string& title, const std::function<void()>& work);

}  // namespace blossom
