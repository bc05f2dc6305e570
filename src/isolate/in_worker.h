#pragma once
#include "isolate/isolated.h"

extern "C" {
/// Provided by the compiler in every program and shared module; its address identifies the one that the code belongs to.
extern void* __dso_handle __attribute__((visibility("hidden")));  // NOLINT(bugprone-reserved-identifier)
}

namespace blossom {

/// The same feature type, evaluated in a worker that loads the plugin which calls this:
///   registry.add(inWorker(gear(), {.activity = "for the gear"}));
/// What it may take and return is told at `isolated`. The plugin links Blossom::isolate and declares its types in
/// BLOSSOM_PLUGIN; `options.module` is filled in.
/// @param insideModule left out: the default is evaluated in the calling module, which is how that is found
FeatureType inWorker(FeatureType, IsolationOptions options, const void* insideModule = &__dso_handle);

}  // namespace blossom
