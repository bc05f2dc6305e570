#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "exchange/format/format.h"
#include "geometry/shape/brep.h"

namespace blossom {

/// Result of a reader of B-reps; readers run in the worker process.
struct BrepImport {
  Brep brep;
  Value skipped = Value::object();
  std::vector<std::string> warnings;
};

/// Reads the file at `path`, which contains only characters that OCCT can handle. Messages need not name the file.
using BrepReader = BrepImport (*)(const std::string& path, const Progress&);

/// Registers a reader in `blossom-worker` under a name such as "step.read".
void registerBrepReader(const std::string& call, BrepReader);

/// Reads a file by a registered reader in a worker process: a crash on a damaged file ends only that process, cancelling
/// ends it at once, and a reader that loops on damaged data is ended after 15 s of CPU time plus 20 s per MB.
/// @throws Error FormatDamaged when the file contains no geometry; errors of the reader and of runInWorker.
Imported importBrep(const std::string& call, const std::filesystem::path&, const Progress&);

/// The last `count` bytes of a file, or all of it when it is shorter.
std::string tailOf(const std::filesystem::path&, std::size_t count);

BrepImport readStep(const std::string& path, const Progress&);
BrepImport readIges(const std::string& path, const Progress&);
BrepImport readBrep(const std::string& path, const Progress&);

}  // namespace blossom
