#include "geometry/product.h"
