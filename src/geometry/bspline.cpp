#include "geometry/bspline.h"
