#include "geometry/color.h"
