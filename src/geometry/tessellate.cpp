#include "geometry/tessellate.h"
