#include "feature/plugin.h"
