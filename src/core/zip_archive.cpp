#include "core/zip_archive.h"

#include <fmt/format.h>
#include <zip.h>

#include <array>
#include <memory>

#include "core/error.h"
#include "core/file.h"

namespace blossom {
namespace {

/// 2 January 1980, noon: the first day that a zip can represent in every time zone.
constexpr time_t fixedTime = 315662400;

std::string textOf(int code) {
  zip_error_t error;
  zip_error_init_with_code(&error, code);
  std::string text = zip_error_strerror(&error);
  zip_error_fini(&error);
  return text;
}

using Archive = std::unique_ptr<zip_t, decltype(&zip_discard)>;
using EntryFile = std::unique_ptr<zip_file_t, decltype(&zip_fclose)>;

Archive openBytes(const std::string& bytes) {
  zip_error_t error;
  zip_error_init(&error);
  zip_source_t* source = zip_source_buffer_create(bytes.data(), bytes.size(), 0, &error);
  zip_t* archive = source ? zip_open_from_source(source, ZIP_RDONLY, &error) : nullptr;
  const std::string why = zip_error_strerror(&error);
  zip_error_fini(&error);
  if (!archive) {
    if (source) zip_source_free(source);
    throw Error(ErrorCode::FormatDamaged, fmt::format("The zip cannot be opened: {}.", why));
  }
  return Archive(archive, &zip_discard);
}

void checkLimits(const std::string& name, std::uint64_t size, std::uint64_t total, const ZipLimits& limits) {
  if (size > limits.entry || total > limits.total)
    throw Error(
        ErrorCode::LimitExceeded,
        fmt::format("{} unpacks to more than {} MB.", name, (size > limits.entry ? limits.entry : limits.total) >> 20),
        "A file of this size cannot be opened.");
}

/// The size an entry declares may be a lie, so that the text grows with what is really there.
/// @returns whether the entry is whole
bool readEntry(zip_t* archive, zip_uint64_t index, const std::string& name, std::string& content, std::uint64_t before,
               const ZipLimits& limits) {
  const EntryFile file(zip_fopen_index(archive, index, 0), &zip_fclose);
  if (!file) return false;
  std::array<char, 1 << 16> chunk;
  while (true) {
    const zip_int64_t got = zip_fread(file.get(), chunk.data(), chunk.size());
    if (got < 0) return false;
    if (got == 0) return true;
    content.append(chunk.data(), static_cast<std::size_t>(got));
    checkLimits(name, content.size(), before + content.size(), limits);
  }
}

}  // namespace

void writeZip(const std::filesystem::path& path, const std::vector<ZipEntry>& entries, const Progress& progress) {
  int code = 0;
  Archive archive(zip_open(path.c_str(), ZIP_CREATE | ZIP_TRUNCATE, &code), &zip_discard);
  if (!archive) cannotWrite(path, textOf(code));
  for (const auto& entry : entries) {
    zip_source_t* source = zip_source_buffer(archive.get(), entry.content.data(), entry.content.size(), 0);
    const zip_int64_t index = source ? zip_file_add(archive.get(), entry.name.c_str(), source, ZIP_FL_ENC_UTF_8) : -1;
    if (index < 0) {
      if (source) zip_source_free(source);
      cannotWrite(path, zip_strerror(archive.get()));
    }
    const auto place = static_cast<zip_uint64_t>(index);
    zip_set_file_compression(archive.get(), place, entry.stored ? ZIP_CM_STORE : ZIP_CM_DEFLATE, 0);
    zip_file_set_mtime(archive.get(), place, fixedTime, 0);
  }
  Progress watched = progress;
  zip_register_cancel_callback_with_state(
      archive.get(), [](zip_t*, void* p) { return static_cast<const Progress*>(p)->cancelled() ? 1 : 0; }, nullptr,
      &watched);
  if (zip_close(archive.get()) != 0) {
    progress.check();
    cannotWrite(path, zip_strerror(archive.get()));
  }
  (void)archive.release();  // zip_close has freed it
}

ZipContent readZip(const std::string& bytes, const std::function<bool(std::string_view)>& wanted, const ZipLimits& limits) {
  const Archive archive = openBytes(bytes);
  ZipContent result;
  std::uint64_t total = 0;
  const zip_int64_t count = zip_get_num_entries(archive.get(), 0);
  for (zip_int64_t i = 0; i < count; ++i) {
    const auto index = static_cast<zip_uint64_t>(i);
    const char* name = zip_get_name(archive.get(), index, ZIP_FL_ENC_GUESS);
    if (!name || !wanted(name)) continue;
    std::string content;
    if (readEntry(archive.get(), index, name, content, total, limits)) {
      total += content.size();
      result.entries.emplace(name, std::move(content));
    } else {
      result.damaged.push_back(fmt::format("{} is damaged.", name));
    }
  }
  return result;
}

}  // namespace blossom
