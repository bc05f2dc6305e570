#pragma once
#include <filesystem>
#include <string>

#include "geometry/shape/brep.h"
#include "parameter/value.h"

#include "core/progress.h"

namespace blossom {

/// Writes a shape to a path that OCCT understands as it is; it runs in the child process.
using BrepWriter = void (*)(const Brep&, const std::string& path, const Value& options, const Progress&);

/// Makes a writer callable in `blossom-worker` under a name such as "step.write".
void registerBrepWriter(const std::string& call, BrepWriter);

/// Writes a file by such a writer, in a child process: OCCT's writers fall over some shapes that its readers give.
/// @throws Error InvalidInput for an empty shape; as the writer; what runInWorker throws.
void exportBrep(const std::string& call, const Brep&, const std::filesystem::path&, const Value& options, const Progress&);

void writeStep(const Brep&, const std::string& path, const Value& options, const Progress&);
void writeIges(const Brep&, const std::string& path, const Value& options, const Progress&);
void writeBrep(const Brep&, const std::string& path, const Value& options, const Progress&);

}  // namespace blossom
