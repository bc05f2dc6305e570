#include "results/result_store.h"

#include <algorithm>
#include <chrono>
#include <fstream>
#include <map>
#include <vector>

#include "core/error.h"
#include "core/file.h"
#include "core/zip_archive.h"
#include "results/evaluated_transport.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

constexpr const char* head = "result.json";
constexpr const char* ending = ".result";

/// Keys are hashes; anything else is no name of a file.
bool isName(const std::string& key) {
  return !key.empty() && std::all_of(key.begin(), key.end(), [](unsigned char c) { return std::isalnum(c); });
}

/// Entries with a checksum each, uncompressed: reading is to be quick. Not above the limit. @returns the size; 0: too large
std::uintmax_t pack(const fs::path& folder, const Value& value, const fs::path& file, std::uintmax_t limit,
                    const Progress& progress) {
  std::map<std::string, std::string> contents{{head, value.dump()}};
  for (const auto& entry : fs::directory_iterator(folder))
    contents[entry.path().filename().string()] = readFile(entry.path());
  std::vector<ZipEntry> entries;
  entries.reserve(contents.size());
  for (const auto& [name, content] : contents) entries.push_back({name, content, true});
  const fs::path unfinished =
      file.string() + ".new-" + std::to_string(std::chrono::steady_clock::now().time_since_epoch().count());
  std::error_code ignored;
  try {
    writeZip(unfinished, entries, progress);
    const std::uintmax_t size = fs::file_size(unfinished);
    if (size <= limit) {
      fs::rename(unfinished, file);
      return size;
    }
  } catch (...) {
    fs::remove(unfinished, ignored);
    throw;
  }
  fs::remove(unfinished, ignored);
  return 0;
}

/// A file that holds something else than it should: it goes. Other trouble, such as a full disk, may pass.
struct Damaged {};

ZipContent contentOf(const fs::path& file) {
  const std::string bytes = readFile(file);
  try {
    ZipContent content = readZip(bytes, [](std::string_view) { return true; });
    if (!content.damaged.empty() || !content.entries.contains(head)) throw Damaged();
    return content;
  } catch (const Error&) {
    throw Damaged();
  }
}

void unpack(const ZipContent& content, const fs::path& folder) {
  for (const auto& [name, bytes] : content.entries)
    if (name != head && fs::path(name).filename() == name) {
      std::ofstream stream(folder / name, std::ios::binary);
      stream.write(bytes.data(), static_cast<std::streamsize>(bytes.size()));
      stream.close();
      if (!stream) throw Error(ErrorCode::FileUnwritable, "A result that was kept could not be unpacked.");
    }
}

/// @throws Damaged, or Error when there is no place to unpack it in.
KeptResult unpacked(const fs::path& file) {
  const ZipContent content = contentOf(file);
  const TemporaryFolder folder;
  unpack(content, folder.path());
  try {
    const Value value = Value::parse(content.entries.at(head));
    return {loadEvaluated(value.at("evaluated"), folder.path()), value.at("gouge_left_out").get<bool>()};
  } catch (const std::bad_alloc&) {
    throw;
  } catch (...) {  // OCCT's exceptions, too
    throw Damaged();
  }
}

}  // namespace

ResultStore::ResultStore(fs::path folder, std::string version, std::uintmax_t limit)
    : folder_(std::move(folder)), version_(std::move(version)), limit_(limit) {}

fs::path ResultStore::fileOf(const std::string& key) const { return folder_ / (version_ + "-" + key + ending); }

std::optional<KeptResult> ResultStore::find(const std::string& key) {
  std::error_code ignored;
  const fs::path file = fileOf(key);
  if (!isName(key) || !fs::exists(file, ignored)) return std::nullopt;
  try {
    KeptResult kept = unpacked(file);
    fs::last_write_time(file, fs::file_time_type::clock::now(), ignored);  // used just now
    return kept;
  } catch (const Damaged&) {
    fs::remove(file, ignored);
    return std::nullopt;
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

void ResultStore::keep(const std::string& key, const Evaluated& made, const Progress& progress) noexcept {
  if (!isName(key)) return;
  try {
    Evaluated plain = made;
    const Toolpath* path = made.shape.get<Toolpath>();
    const bool gouge = path && path->gougeOf;
    if (gouge) {
      Toolpath copy = *path;
      copy.gougeOf = nullptr;
      plain.shape = std::move(copy);
    }
    const TemporaryFolder folder;
    const Value value{{"evaluated", saveEvaluated(plain, folder.path(), "shape")}, {"gouge_left_out", gouge}};
    progress.check();
    if (fs::create_directories(folder_)) fs::permissions(folder_, fs::perms::owner_all);  // of documents that are private
    makeRoom(pack(folder.path(), value, fileOf(key), limit_, progress));
  } catch (...) {
    return;  // it is computed again next time
  }
}

// The folder is counted at first, when it has grown too large, and now and then for the sake of other processes.
void ResultStore::makeRoom(std::uintmax_t added) {
  constexpr int often = 100;
  const std::lock_guard lock(mutex_);
  if (total_) *total_ += added;
  if (total_ && *total_ <= limit_ && ++sinceCounted_ < often) return;
  sinceCounted_ = 0;
  struct File {
    fs::file_time_type used;
    std::uintmax_t size;
    fs::path path;
  };
  std::vector<File> files;
  std::uintmax_t all = 0;
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder_, ignored)) {
    if (!entry.is_regular_file(ignored)) continue;
    files.push_back({entry.last_write_time(ignored), entry.file_size(ignored), entry.path()});
    all += files.back().size;
  }
  std::sort(files.begin(), files.end(), [](const File& a, const File& b) { return a.used < b.used; });
  for (const File& file : files) {
    if (all <= limit_) break;
    if (fs::remove(file.path, ignored)) all -= file.size;
  }
  total_ = all;
}

}  // namespace blossom
