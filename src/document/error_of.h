#pragma once
#include <functional>
#include <optional>
#include <string>

#include "core/error.h"

namespace blossom {

/// Calls `work` and converts any exception, also of OCCT and the standard library, to an Error that can be stored and shown.
/// @param title the work in messages: "Box", "Drawing the result". @throws Error Cancelled only.
std::optional<Error> errorOf(const std::string& title, const std::function<void()>& work);

}  // namespace blossom
