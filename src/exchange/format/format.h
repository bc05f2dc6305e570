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

/// Result of a reader. `entities` counts the entities of the file by type ("LINE": 4, "face": 6), `skipped` those left out.
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

  std::string id;                       ///< "step"
  std::string title;                    ///< "STEP (AP 203, 214, 242)"
  std::vector<std::string> extensions;  ///< lower case, without dot, preferred first
  std::vector<ParameterSpec> readOptions;
  std::vector<ParameterSpec> writeOptions;
  Read read;                      ///< empty: cannot be read
  Write write;                    ///< empty: cannot be written. writeShape makes it atomic
  std::vector<ShapeKind> writes;  ///< kinds that the writer accepts
  bool zipped = false;            ///< its files are zip archives
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

/// Every format of src/exchange.
FormatRegistry standardFormats();

/// Reads a file by its extension. Missing options have their defaults.
/// @throws Error FileNotFound, FileUnreadable, FormatUnknown, FormatDamaged, LimitExceeded, WorkerDied, Cancelled. Content
/// of another format than the extension says is FormatDamaged, with a hint that names the format.
Imported readShape(const FormatRegistry&, const std::filesystem::path&, const Value& options = Value::object(),
                   const Progress& = Progress::none());

/// Writes a shape by the extension of the path, atomically: an error leaves no partial file.
/// @throws Error FormatUnknown, OutputNotSupported, FileUnwritable, Cancelled.
void writeShape(const FormatRegistry&, const Shape&, const std::filesystem::path&, const Value& options = Value::object(),
                const Progress& = Progress::none());

/// Name of the format recognised by the first bytes of a file; empty when unknown.
std::string sniffFormat(std::string_view head);

// One per file of this room.
Format stepFormat();
Format igesFormat();
Format brepFormat();
Format stlFormat();
Format objFormat();
Format offFormat();
Format plyFormat();
Format threeMfFormat();
Format xyzFormat();
Format dxfFormat();
Format svgFormat();
Format pdfFormat();
Format psFormat();
Format motionFormat();
Format gcodeFormat();
Format controlPointsFormat();
Format outlinesFormat();

}  // namespace blossom
