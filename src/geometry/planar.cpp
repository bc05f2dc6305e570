#include "geometry/planar.h"
