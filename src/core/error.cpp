#include "core/error.h"

#include <array>
#include <utility>

namespace blossom {
namespace {

constexpr std::array<std::pair<ErrorCode, std::string_view>, 18> names{{
    {ErrorCode::Cancelled, "Cancelled"},
    {ErrorCode::InvalidParameter, "InvalidParameter"},
    {ErrorCode::InvalidInput, "InvalidInput"},
    {ErrorCode::FileNotFound, "FileNotFound"},
    {ErrorCode::FileUnreadable, "FileUnreadable"},
    {ErrorCode::FileUnwritable, "FileUnwritable"},
    {ErrorCode::FormatUnknown, "FormatUnknown"},
    {ErrorCode::FormatDamaged, "FormatDamaged"},
    {ErrorCode::FormatTooNew, "FormatTooNew"},
    {ErrorCode::LimitExceeded, "LimitExceeded"},
    {ErrorCode::Degenerate, "Degenerate"},
    {ErrorCode::NotFound, "NotFound"},
    {ErrorCode::InUse, "InUse"},
    {ErrorCode::CycleFound, "CycleFound"},
    {ErrorCode::PluginBroken, "PluginBroken"},
    {ErrorCode::WorkerDied, "WorkerDied"},
    {ErrorCode::OutputNotSupported, "OutputNotSupported"},
    {ErrorCode::Internal, "Internal"},
}};

}  // namespace

std::string_view errorCodeName(ErrorCode code) noexcept {
  for (const auto& [c, name] : names)
    if (c == code) return name;
  return "Internal";
}

ErrorCode errorCodeFromName(std::string_view wanted) noexcept {
  for (const auto& [code, name] : names)
    if (name == wanted) return code;
  return ErrorCode::Internal;
}

Error::Error(ErrorCode code, std::string message, std::string hint)
    : code_(code), message_(std::move(message)), hint_(std::move(hint)) {}

}  // namespace blossom
