#include "kernel/exact_types.h"
#include "kernel/united.h"

namespace blossom::morphology {

Solid united(const Solid& solid) { return solidFrom(nefOf(*solid)); }

}  // namespace blossom::morphology
