#pragma once
#include "ui/plugin/manipulator.h"

namespace blossom::modeling {

/// Registers the drawing tool and the handles of all outlines.
void registerOutlineTools(ui::ManipulatorRegistry&);

}  // namespace blossom::modeling
