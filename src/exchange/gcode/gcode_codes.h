#pragma once
#include <optional>
#include <string>

/// What the codes of G-code programs mean to whoever follows the tool. Only what is listed is followed: a code that is not
/// known may move it.
namespace blossom {

/// Why a toolpath cannot be made of a program with this G code (times ten: 921 is G92.1): "a drilling cycle"; nothing for
/// those that leave the tool's way as the words say it.
std::optional<std::string> obstacleOfMode(int tenths);
/// The same of an M code.
std::optional<std::string> obstacleOfMachine(int code);

/// "stops (M0)": what the machine does besides, and a program that is written anew does not; empty for others.
std::string notKept(char letter, int code);

/// "G92.1"
std::string modeName(int tenths);

}  // namespace blossom
