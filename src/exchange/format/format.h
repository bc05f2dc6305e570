#pragma once
#include <filesystem>
#include <functional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "core/progress.h"
#include "geometry/shape/shape.h"
#include "parameter/parameter.h"

namespace blossom {

/// The shape read from a file. `entities` counts what the file holds by type of entity ("LINE": 4, "face": 6), `skipped`
/// what was left out.
struct Imported {
  Shape shape;
  Value entities = Value::object();
  Value skipped = Value::object();
  std::vector<std::string> warnings;  ///< full sentences
};

/// One file format: reader, writer and their options, declared once (file dialogs, `convert`, `--help` are made from it).
struct Format {
  using Read = std::function<Imported(const std::filesystem::path&, const Value& options, const Progress&)>;
  using Write = std::function<void(const Shape&, const std::filesystem::path&, const Value& options, const Progress&)>;

  std::string id;                       ///< "step"
  std::string title;                    ///< "STEP (AP 203, 214, 242)"
  std::vector<std::string> extensions;  ///< lower case, without dot, preferred first
  std::vector<ParameterSpec> readOptions;
  std::vector<ParameterSpec> writeOptions;
  Read read;                      ///< empty: cannot be read
  Write write;                    ///< empty: cannot be written. Writes to the path given; atomicity is writeShape's affair
  std::vector<ShapeKind> writes;  ///< kinds the writer takes; for the message when another comes
  ShapeKind reads = ShapeKind::None;  ///< the kind of every shape read, where that is known before; else None
  bool zipped = false;                ///< its files are zips
};

/// Whether its files can hold a shape of the kind; a sequence has files of its frames where they cannot.
bool holds(const Format&, ShapeKind);
/// @throws Error OutputNotSupported saying what its files can hold when that is none of `kinds`.
void refuseUnlessHeld(const Format&, std::span<const ShapeKind> kinds);

class FormatRegistry {
 public:
  void add(Format);
  [[nodiscard]] const std::vector<Format>& formats() const { return formats_; }
  /// By extension (any case, with or without dot) or id; nullptr when there is none.
  [[nodiscard]] const Format* find(std::string_view extensionOrId) const;

 private:
  std::vector<Format> formats_;
};

/// Reads a file by its extension. Options are completed from their defaults.
/// @throws Error FileNotFound, FileUnreadable, FormatUnknown, FormatDamaged, LimitExceeded, WorkerDied, Cancelled. A file
/// whose content is of another format than its extension says is FormatDamaged with a hint that names the format it looks
/// like.
Imported readShape(const FormatRegistry&, const std::filesystem::path&, const Value& options = Value::object(),
                   const Progress& = Progress::none());

/// Writes a shape by the extension of the path, atomically: nothing half-written remains after an error.
/// @throws Error FormatUnknown, OutputNotSupported, FileUnwritable, Cancelled.
void writeShape(const FormatRegistry&, const Shape&, const std::filesystem::path&, const Value& options = Value::object(),
                const Progress& = Progress::none());

/// Name of the format that the first bytes of a file look like; empty when unknown.
std::string sniffFormat(std::string_view head);

}  // namespace blossom
