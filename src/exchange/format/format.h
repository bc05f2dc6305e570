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

/// A file format: reader, writer and their options, declared once. File dialogs, `convert` and `--help` are derived from it.
struct Format {
  using Read = std::function<Imported(const std::filesystem::path&, const Value& options, const Progress&)>;
  using Write = std::function<void(const Shape&, const std::filesystem::path&, const Value& options, const Progress&)>;
  /// Makes the writer of those frames of a sequence that go into a file each, such that they share a page or a camera.
  using FrameWriter = std::function<Write(const Sequence&, const Value& options, const Progress&)>;

  std::string id;                       ///< "step"
  std::string title;                    ///< "STEP (AP 203, 214, 242)"
  std::vector<std::string> extensions;  ///< lower case, without dot, preferred first
  std::vector<ParameterSpec> readOptions;
  std::vector<ParameterSpec> writeOptions;
  Read read;                     ///< empty: cannot be read
  Write write;                   ///< empty: cannot be written. Writes to the path given; atomicity is writeShape's affair
  FrameWriter frameWriter = {};  ///< empty: `write` writes each frame as if it were alone
  /// Whether the options put all frames of a sequence into one file; empty: always. Only where `writes` has sequences.
  std::function<bool(const Value& options)> inOneFile = {};
  std::vector<ShapeKind> writes;      ///< kinds the writer takes; for the message when another comes
  ShapeKind reads = ShapeKind::None;  ///< the kind of every shape read, where that is known before; else None
  bool zipped = false;                ///< its files are zips
};

/// Whether files of the format can store a shape of the kind; a sequence may be stored as one file per frame.
bool canStore(const Format&, ShapeKind);
/// @throws Error OutputNotSupported naming the kinds that the format can store, when it can store none of `kinds`.
void refuseUnlessStorable(const Format&, std::span<const ShapeKind> kinds);

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

/// Writes a shape by the extension of the path, atomically: an error leaves no partial file.
/// @throws Error FormatUnknown, OutputNotSupported, FileUnwritable, Cancelled.
void writeShape(const FormatRegistry&, const Shape&, const std::filesystem::path&, const Value& options = Value::object(),
                const Progress& = Progress::none());

/// Name of the format recognised by the first bytes of a file; empty when unknown.
std::string sniffFormat(std::string_view head);

}  // namespace blossom
