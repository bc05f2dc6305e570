#include "features.h"

namespace blossom::modeling {

void registerOutlines(Registry&) {}

}  // namespace blossom::modeling
