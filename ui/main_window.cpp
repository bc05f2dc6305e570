#include "ui/manipulator.h"
