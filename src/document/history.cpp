#include "document/history.h"
