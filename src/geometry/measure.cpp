#include "geometry/measure.h"
