#include "geometry/motion.h"
