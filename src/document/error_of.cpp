#include "document/error_of.h"

#include <fmt/format.h>
#include <Standard_Failure.hxx>

#include <new>

namespace blossom {

std::optional<Error> errorOf(const std::string& title, const std::function<void()>& work) {
  constexpr const char* defect = "This is a defect; please report it together with the document.";
  try {
    work();
  } catch (const Error& e) {
    if (e.code() == ErrorCode::Cancelled) throw;
    return e;
  } catch (const Standard_Failure& e) {
    const char* text = e.GetMessageString();
    return Error(ErrorCode::Internal,
                 fmt::format("{} failed in the modelling library: {} {}", title, e.DynamicType()->Name(), text ? text : ""),
                 defect);
  } catch (const std::bad_alloc&) {
    return Error(ErrorCode::LimitExceeded, fmt::format("{} needs more memory than there is.", title),
                 "Choose a coarser tolerance or smaller numbers.");
  } catch (const std::exception& e) {
    return Error(ErrorCode::Internal, fmt::format("{} failed unexpectedly: {}.", title, e.what()), defect);
  } catch (...) {
    return Error(ErrorCode::Internal, fmt::format("{} failed with an exception of an unknown type.", title), defect);
  }
  return std::nullopt;
}

}  // namespace blossom
