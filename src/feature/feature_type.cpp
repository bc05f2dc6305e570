#include "feature/feature_type.h"
