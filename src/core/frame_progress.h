#pragma once
#include <cstddef>

#include "core/progress.h"

namespace blossom {

/// Progress of one of several frames, whose stages say which one it is: "frame 2 of 4, cutting faces". @param frame from 0
Progress progressOfFrame(const Progress& whole, std::size_t frame, std::size_t count);

}  // namespace blossom
