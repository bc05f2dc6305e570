#pragma once
#include <qnamespace.h>

#include "parameter/parameter.h"

namespace blossom::ui {

/// ms without movement after which a turn of the wheel ends.
constexpr int wheelRestMs = 600;

/// Step of a key, a notch of the wheel or some pixels of dragging: 1 for counts and angles, about a tenth of small lengths
/// and numbers; a tenth of that with Shift, ten times with Ctrl.
double stepOf(const ParameterSpec&, double value, Qt::KeyboardModifiers);
/// `value` moved by `steps` steps of size `step`, on a multiple of the step and inside the range.
double stepped(const ParameterSpec&, double value, double steps, double step);

}  // namespace blossom::ui
