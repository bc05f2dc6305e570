#pragma once
#include <filesystem>
#include <string>

#include "geometry/shape/brep.h"
#include "parameter/value.h"

#include "core/progress.h"

namespace blossom {

/// Writer of a B-rep; it runs in the worker process. `path` contains only characters that OCCT can handle.
using BrepWriter = void (*)(const Brep&, const std::string& path, const Value& options, const Progress&);

/// Registers a writer in `blossom-worker` under a name such as "step.write".
void registerBrepWriter(const std::string& call, BrepWriter);

/// Writes a file by a registered writer in a worker process, because OCCT's writers crash on some shapes that its readers
/// produce.
/// @throws Error InvalidInput for an empty shape; errors of the writer and of runInWorker.
void exportBrep(const std::string& call, const Brep&, const std::filesystem::path&, const Value& options, const Progress&);

void writeStep(const Brep&, const std::string& path, const Value& options, const Progress&);
void writeIges(const Brep&, const std::string& path, const Value& options, const Progress&);
void writeBrep(const Brep&, const std::string& path, const Value& options, const Progress&);

}  // namespace blossom
