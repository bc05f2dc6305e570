#include "kernel/parts/guarded.h"

#include <Standard_OutOfMemory.hxx>

#include "core/error.h"

namespace blossom::modeling {

void throwOcctFailure(const Standard_Failure& failure, const std::string& message, const std::string& hint) {
  if (failure.IsKind(STANDARD_TYPE(Standard_OutOfMemory)))
    throw Error(ErrorCode::LimitExceeded, "There is not enough memory for this.", hint);
  throw Error(ErrorCode::InvalidInput, message, hint);
}

}  // namespace blossom::modeling
