#include "geometry/brep.h"
