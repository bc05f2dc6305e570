#include "document/evaluator.h"
