#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "exchange/format/format.h"
#include "geometry/shape/brep.h"

namespace blossom {

/// What a reader of B-reps gives; it runs in the child process.
struct BrepImport {
  Brep brep;
  Value skipped = Value::object();
  std::vector<std::string> warnings;
};

/// Reads the file whose path OCCT understands as it is. Messages need not name the file.
using BrepReader = BrepImport (*)(const std::string& path, const Progress&);

/// Makes a reader callable in `blossom-worker` under a name such as "step.read".
void registerBrepReader(const std::string& call, BrepReader);

/// Reads a file by such a reader, in a child process: a crash on a damaged file ends the child, cancel ends it at once, and
/// a reader that spins on rubbish is ended after 15 s of computing and 20 s more for each MB.
/// @throws Error as the reader; FormatDamaged when the file holds no geometry; what runInWorker throws.
Imported importBrep(const std::string& call, const std::filesystem::path&, const Progress&);

/// Last bytes of a file, at most `count`.
std::string tailOf(const std::filesystem::path&, std::size_t count);

BrepImport readStep(const std::string& path, const Progress&);
BrepImport readIges(const std::string& path, const Progress&);
BrepImport readBrep(const std::string& path, const Progress&);

}  // namespace blossom
