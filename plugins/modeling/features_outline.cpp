#include "feature_groups.h"

namespace blossom::modeling {

void registerOutlines(Registry&) {}

}  // namespace blossom::modeling
