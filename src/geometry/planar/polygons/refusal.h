#pragma once
#include <string>

#include "core/error.h"
#include "core/vector.h"
#include "geometry/planar/region.h"

/// How shapes are refused, always with the place.
namespace blossom::planar {

/// "(3, 4.5)"
std::string at(const Vec2&);

/// @param name of the shape, which begins the sentence @throws Error
[[noreturn]] void refuse(ErrorCode, const std::string& name, const std::string& what, const std::string& remedy);

/// The remedy for a tolerance that is too coarse: "Give a tolerance of at most 0.019 mm, or none." for 0.02.
std::string smallerTolerance(double most);

/// @param path "loop 2" @throws Error InvalidInput
void refuseWhatIsNoNumber(const Path&, const std::string& path, const std::string& name);

/// @throws Error LimitExceeded beyond 1e9 mm
void refuseFarAway(const Vec2&, const std::string& name);

}  // namespace blossom::planar
