#pragma once
#include "kernel/exact.h"

namespace blossom::morphology {

/// The same solid with bodies that overlap made one, so that its surface crosses nowhere.
Solid united(const Solid&);

}  // namespace blossom::morphology
