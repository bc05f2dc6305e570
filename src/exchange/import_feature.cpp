#include "exchange/import_feature.h"
