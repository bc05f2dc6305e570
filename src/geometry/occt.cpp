#include "geometry/occt.h"
