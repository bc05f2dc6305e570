#pragma once
#include <filesystem>
#include <vector>

#include "exchange/format/format.h"

namespace blossom {

/// A file in which a shape, or a frame of it, is stored.
struct FileOfShape {
  std::filesystem::path path;
  Shape shape;
};

/// The files in which a shape is stored. A sequence is stored in one file when the format accepts sequences (and the options
/// say so, where that is a choice), else in one file per frame: out-0001.svg, out-0002.svg and so on for out.svg. Any other
/// shape is stored in one file.
std::vector<FileOfShape> filesOf(const Format&, const Shape&, const std::filesystem::path&, const Value& options);

/// The kinds of shapes stored in the files of a shape: its own kind, or those of its frames, each once; None when it is
/// empty.
std::vector<ShapeKind> kindsInFiles(const Format&, const Shape&, const Value& options);

/// What a shape becomes on the disk.
struct PlannedFiles {
  const Format* format = nullptr;
  Value options = Value::object();  ///< completed
  std::vector<FileOfShape> files;
  Format::Write write;  ///< of every one of them; frames of a sequence share what the format has them share
};

/// Plans the files of a shape by the extension of the path. Makes the writer of frames, which may take a look at all of
/// them. @throws Error FormatUnknown, OutputNotSupported, InvalidParameter, Cancelled; whatever the format's frameWriter
/// throws.
PlannedFiles plannedFiles(const FormatRegistry&, const Shape&, const std::filesystem::path&, const Value& options,
                          const Progress&);

/// Writes one of the files, atomically. @param options in place of those planned. @throws Error FileUnwritable, Cancelled.
void writeFile(const PlannedFiles&, const FileOfShape&, const Value& options, const Progress&);

/// Write option `sheet` of formats that can show a sequence as a contact sheet: the number of its cells, 0 for none.
ParameterSpec sheetOption();
/// Its value; 0 when it is absent.
int sheetCells(const Value& options);

}  // namespace blossom
