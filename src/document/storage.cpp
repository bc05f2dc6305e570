#include "document/storage.h"
