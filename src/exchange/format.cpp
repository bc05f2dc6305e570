#include "exchange/format.h"
