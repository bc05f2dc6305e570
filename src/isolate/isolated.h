#pragma once
#include <filesystem>
#include <functional>
#include <string>

#include "feature/feature_type.h"

namespace blossom {

struct IsolationOptions {
  std::string activity{};          ///< completes "The helper process .. crashed": "for the Boolean operation"
  std::filesystem::path module{};  ///< the plugin's own module, from `moduleOf(&anchor)`
  /// Limits it to evaluations that are worth a process: its first call costs 50 to 100 ms, the next ones a few; empty: all.
  std::function<bool(const Value& parameters, const Inputs&)> when{};
};

/// The same feature type, evaluated in a child process: what cannot poll `Progress` can so be cancelled at once, and may
/// crash without harm. Takes and returns regions, curves, surfaces, B-reps, meshes, motions and sequences of them, with
/// their names, colours and layers; a B-rep that is made without these gets name and colour of the first B-rep given
/// (control shapes aside).
///
/// The statistics get "worker_ms": what the evaluation took beside the kernel, which is the way to the child and back, and
/// its start when none was kept (see runInWorker).
///
/// The child declares the feature types of the module once more, which BLOSSOM_PLUGIN provides for.
FeatureType isolated(FeatureType, IsolationOptions);

}  // namespace blossom
