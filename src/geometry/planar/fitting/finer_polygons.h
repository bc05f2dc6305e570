#pragma once
#include <optional>
#include <utility>

#include "core/error.h"
#include "core/progress.h"
#include "geometry/planar/region.h"

namespace blossom::planar {

/// The result of an operation decided by polygons, which become finer until curves fit: `attempt(share, progress)`, with the
/// share of the tolerances, returns what has `curves(progress)`, which may fail, and `lines()`, the last resort; before that
/// the finest one is asked for `curvesInPieces(progress)`, if it has them.
template <class Attempt>
Region byFinerPolygons(Attempt attempt, const Progress& progress) {
  constexpr int attempts = 3;
  constexpr double finer = 1.0 / 8;
  double share = 1, done = 0;
  std::optional<Region> lines;
  for (int i = 0; i < attempts; ++i, share *= finer, done = (1 + done) / 2) {
    progress.check();
    try {
      const auto result = attempt(share, progress.part(done, (1 + done) / 2));
      if (auto curves = result.curves(progress)) return *std::move(curves);
      if (!lines) lines = result.lines();
      if constexpr (requires { result.curvesInPieces(progress); })
        if (i + 1 == attempts)
          if (auto pieces = result.curvesInPieces(progress)) return *std::move(pieces);
    } catch (const Error& error) {
      if (!lines || error.code() != ErrorCode::LimitExceeded) throw;  // finer polygons are too many
      break;
    }
  }
  return *std::move(lines);
}

}  // namespace blossom::planar
