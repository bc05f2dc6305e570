#include "exchange/format/format.h"

#include <fmt/format.h>

#include <algorithm>
#include <fstream>
#include <new>

#include "core/error.h"
#include "core/file.h"
#include "core/lower_case.h"
#include "exchange/format/frames.h"
#include "exchange/format/sniff.h"
#include "exchange/format/text.h"
#include "geometry/shape/kind_names.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

/// "dxf, svg, stl": the preferred extension of every format that can be read (or written).
std::string extensionList(const FormatRegistry& registry, bool forReading) {
  std::string list;
  for (const Format& format : registry.formats()) {
    if (forReading ? !format.read : !format.write) continue;
    list += (list.empty() ? "" : ", ") + format.extensions.front();
  }
  return list;
}

const Format& formatFor(const FormatRegistry& registry, const fs::path& path, bool forReading) {
  const std::string extension = path.extension().string();
  const char* verb = forReading ? "read" : "written";
  const std::string hint = fmt::format("Files that can be {} end in: {}.", verb, extensionList(registry, forReading));
  if (extension.size() < 2)
    throw Error(ErrorCode::FormatUnknown,
                fmt::format("\"{}\" has no extension that tells its format.", path.filename().string()), hint);
  const Format* format = registry.find(extension);
  if (!format)
    throw Error(ErrorCode::FormatUnknown, fmt::format("There is no format with the extension \"{}\".", extension.substr(1)),
                hint);
  if (forReading ? !format->read : !format->write)
    throw Error(ErrorCode::FormatUnknown, fmt::format("{} files cannot be {}.", format->title, verb), hint);
  return *format;
}

/// The first bytes of the file; also proves that it is there, a file, and readable.
std::string headOf(const fs::path& path) {
  std::error_code status;
  if (!fs::exists(path, status))
    throw Error(ErrorCode::FileNotFound, fmt::format("There is no file \"{}\".", path.string()));
  if (!fs::is_regular_file(path, status))
    throw Error(ErrorCode::FileUnreadable, fmt::format("\"{}\" is not a file.", path.string()));
  std::ifstream stream(path, std::ios::binary);
  if (!stream)
    throw Error(ErrorCode::FileUnreadable, fmt::format("The file \"{}\" cannot be opened.", path.string()),
                "Check its permissions.");
  std::string head(4096, '\0');
  stream.read(head.data(), static_cast<std::streamsize>(head.size()));
  head.resize(static_cast<std::size_t>(stream.gcount()));
  return head;
}

bool covers(const Format& format, const std::string& name) {
  return lowerCase(name) == format.id ||
         std::find(format.extensions.begin(), format.extensions.end(), lowerCase(name)) != format.extensions.end();
}

void refuseWrongContent(const FormatRegistry& registry, const Format& format, const fs::path& path,
                        const std::string& head) {
  const std::string file = path.filename().string();
  if (head.empty())
    throw Error(ErrorCode::FormatDamaged, fmt::format("The file \"{}\" is empty.", file), "Fetch or export the file again.");
  std::string looks = sniffFormat(head);
  std::error_code status;
  if (looks.empty() && looksLikeBinaryStl(head, fs::file_size(path, status))) looks = "STL";
  if (looks.empty() || covers(format, looks) || (looks == "ZIP" && format.zipped)) return;
  const Format* right = registry.find(looks);
  throw Error(ErrorCode::FormatDamaged,
              fmt::format("The file \"{}\" looks like {}, not like {}.", file, looks, format.title),
              right ? fmt::format("Rename it or give its right extension, \"{}\".", right->extensions.front())
                    : "Convert it to a format that Blossom reads.");
}

/// Runs a reader; whatever it throws comes out as an Error that names the file.
Imported guardedRead(const Format& format, const fs::path& path, const Value& options, const Progress& progress) {
  const std::string file = path.filename().string();
  try {
    Imported imported = format.read(path, options, progress);
    for (std::string& warning : imported.warnings) warning = parse::utf8(warning);
    return imported;
  } catch (const Error& error) {
    const bool aboutContent = error.code() == ErrorCode::FormatDamaged || error.code() == ErrorCode::LimitExceeded ||
                              error.code() == ErrorCode::Degenerate || error.code() == ErrorCode::InvalidInput;
    if (!aboutContent) throw;
    // Messages quote the file, whose bytes need not be text.
    const std::string message = parse::utf8(error.message()), hint = parse::utf8(error.hint());
    if (message.find(file) != std::string::npos) throw Error(error.code(), message, hint);
    const ErrorCode code = error.code() == ErrorCode::LimitExceeded ? error.code() : ErrorCode::FormatDamaged;
    throw Error(code, fmt::format("The file \"{}\" cannot be read: {}", file, message), hint);
  } catch (const std::bad_alloc&) {
    throw Error(ErrorCode::LimitExceeded, fmt::format("The file \"{}\" needs more memory than there is.", file));
  } catch (const std::exception& error) {
    throw Error(ErrorCode::FormatDamaged,
                fmt::format("The file \"{}\" cannot be read as {} ({}).", file, format.title, error.what()));
  }
}

}  // namespace

bool canStore(const Format& format, ShapeKind kind) {
  return std::find(format.writes.begin(), format.writes.end(), kind) != format.writes.end();
}

void refuseUnlessStorable(const Format& format, std::span<const ShapeKind> kinds) {
  if (std::any_of(kinds.begin(), kinds.end(), [&](ShapeKind kind) { return canStore(format, kind); })) return;
  if (kinds.size() == 1 && kinds.front() == ShapeKind::None)
    throw Error(ErrorCode::OutputNotSupported, "There is nothing to write.", "Give a shape that is not empty.");
  const bool sequencesOnly = format.writes == std::vector{ShapeKind::Sequence};
  throw Error(ErrorCode::OutputNotSupported, fmt::format("{} files cannot hold {}.", format.title, kindNames(kinds, true)),
              sequencesOnly ? "They hold sequences: set frames, as of a morph, or write one shape as a picture (PNG)."
                            : fmt::format("They can hold {}.", kindNames(format.writes, true)));
}

void FormatRegistry::add(Format format) { formats_.push_back(std::move(format)); }

const Format* FormatRegistry::find(std::string_view extensionOrId) const {
  std::string wanted = lowerCase(extensionOrId);
  if (!wanted.empty() && wanted.front() == '.') wanted.erase(0, 1);
  for (const Format& format : formats_)
    if (covers(format, wanted)) return &format;
  return nullptr;
}

Imported readShape(const FormatRegistry& registry, const fs::path& path, const Value& options, const Progress& progress) {
  const std::string head = headOf(path);
  const Format& format = formatFor(registry, path, true);
  refuseWrongContent(registry, format, path, head);
  std::error_code status;
  if (fs::file_size(path, status) > maximumFileSize)
    throw Error(ErrorCode::LimitExceeded, fmt::format("The file \"{}\" is larger than 2 GB.", path.filename().string()));
  progress.check();
  return guardedRead(format, path, completed(format.readOptions, options), progress);
}

PlannedFiles plannedFiles(const FormatRegistry& registry, const Shape& shape, const fs::path& path, const Value& options,
                          const Progress& progress) {
  PlannedFiles planned;
  planned.format = &formatFor(registry, path, false);
  const Format& format = *planned.format;
  planned.options = completed(format.writeOptions, options);
  planned.files = filesOf(format, shape, path, planned.options);
  for (const ShapeKind kind : kindsInFiles(format, shape, planned.options)) refuseUnlessStorable(format, {&kind, 1});
  const bool framesApart = planned.files.size() != 1 || planned.files.front().path != path;
  planned.write = framesApart && format.frameWriter ? format.frameWriter(*shape.get<Sequence>(), planned.options, progress)
                                                    : format.write;
  return planned;
}

namespace {

/// Of a file among several: which frame it is, and what there is by now.
[[noreturn]] void throwWithFrame(const Error& error, const PlannedFiles& planned, const FileOfShape& file) {
  const auto isThis = [&](const FileOfShape& each) { return each.path == file.path; };
  const auto before = std::find_if(planned.files.begin(), planned.files.end(), isThis) - planned.files.begin();
  const std::string stay = before == 0 ? "" : " The files of the frames before it are written.";
  throw Error(error.code(), fmt::format("Frame {} of {}: {}{}", before + 1, planned.files.size(), error.message(), stay),
              error.hint());
}

}  // namespace

// Streams of the libraries behind some formats end a full disk with exceptions of their own, such as std::bad_cast.
void writeFile(const PlannedFiles& planned, const FileOfShape& file, const Value& options, const Progress& progress) {
  try {
    writeAtomically(file.path, [&](const fs::path& temporary) { planned.write(file.shape, temporary, options, progress); });
  } catch (const Error& error) {
    if (planned.files.size() == 1 || error.code() == ErrorCode::Cancelled) throw;
    throwWithFrame(error, planned, file);
  } catch (const std::bad_alloc&) {
    throw;
  } catch (const std::exception&) {
    throw Error(ErrorCode::FileUnwritable,
                fmt::format("The file {} cannot be written as {}.", file.path.string(), planned.format->title),
                "Check that the disk is not full.");
  }
}

void writeShape(const FormatRegistry& registry, const Shape& shape, const fs::path& path, const Value& options,
                const Progress& progress) {
  const bool frames = shape.kind() == ShapeKind::Sequence;
  const double begin = frames ? 0.2 : 0;
  const PlannedFiles planned = plannedFiles(registry, shape, path, options, progress.part(0, begin));
  const Progress writing = progress.part(begin, 1);
  const double count = static_cast<double>(planned.files.size());
  for (std::size_t i = 0; i < planned.files.size(); ++i)
    writeFile(planned, planned.files[i], planned.options,
              writing.part(static_cast<double>(i) / count, static_cast<double>(i + 1) / count));
}

}  // namespace blossom
