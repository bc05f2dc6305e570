#pragma once
#include <Standard_Failure.hxx>
#include <Standard_Type.hxx>
#include <string>

namespace blossom {

/// What an exception of OCCT says, without a full stop; many say nothing but what they are.
inline std::string reasonOf(const Standard_Failure& failure) {
  std::string text = failure.GetMessageString() ? failure.GetMessageString() : "";
  while (!text.empty() && (text.back() == '.' || text.back() == ' ' || text.back() == '\n')) text.pop_back();
  if (!text.empty()) return text;
  return std::string("the geometry kernel ends with ") + failure.DynamicType()->Name();
}

}  // namespace blossom
