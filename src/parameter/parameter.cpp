#include "parameter/parameter.h"
