#pragma once
#include <string>
#include <vector>

#include "geometry/shape/shape.h"

namespace blossom {

/// When each frame begins, as a share of one run: 0 for the first, below 1 for the last. The last frame stays for as long as
/// the others do on average. Frames without times are evenly spaced. O(frames).
std::vector<double> frameBeginnings(const Sequence&);

/// The frame that is shown at a share of one run, 0..1. @param beginnings of frameBeginnings, not empty. O(log frames).
std::size_t frameAt(const std::vector<double>& beginnings, double share);

/// The time of a frame as it is written beside it, "0.25"; its number, from 1, when the sequence has no times.
std::string frameLabel(const Sequence&, std::size_t frame);

/// Indices of at most `wanted` of `count` frames, evenly spread, the first and the last among them; of one, the first.
std::vector<std::size_t> spreadFrames(std::size_t count, std::size_t wanted);

}  // namespace blossom
