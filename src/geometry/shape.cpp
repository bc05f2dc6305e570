#include "geometry/shape.h"
