#include "feature/registry.h"
