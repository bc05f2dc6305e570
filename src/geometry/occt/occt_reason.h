#pragma once
#include <Standard_Failure.hxx>
#include <Standard_Type.hxx>
#include <string>

namespace blossom {

/// Message of an exception of OCCT without a full stop; the name of its type when the message is empty.
inline std::string reasonOf(const Standard_Failure& failure) {
  std::string text = failure.GetMessageString() ? failure.GetMessageString() : "";
  while (!text.empty() && (text.back() == '.' || text.back() == ' ' || text.back() == '\n')) text.pop_back();
  if (!text.empty()) return text;
  return std::string("the geometry kernel ends with ") + failure.DynamicType()->Name();
}

}  // namespace blossom
