#pragma once
#include <optional>
#include <string>

/// Meaning of G and M codes for the path of the tool. Only listed codes are followed, because an unknown code may move the
/// tool.
namespace blossom {

/// Why a toolpath cannot be made of a program with this G code (times ten: 921 is G92.1), such as "a drilling cycle"; empty
/// for codes that leave the path as written.
std::optional<std::string> obstacleOfMode(int tenths);
/// The same for an M code.
std::optional<std::string> obstacleOfMachine(int code);

/// "stops (M0)": what the machine does at this code and a program written from the toolpath does not; empty for others.
std::string notKept(char letter, int code);

/// "G92.1"
std::string modeName(int tenths);

}  // namespace blossom
