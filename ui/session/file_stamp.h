#pragma once
#include <cstdint>
#include <filesystem>

namespace blossom::ui {

/// By what a file is known to be the one that was read: size and time of its last change.
struct FileStamp {
  bool exists = false;
  std::uintmax_t size = 0;
  std::filesystem::file_time_type time{};

  static FileStamp of(const std::filesystem::path& file) {
    std::error_code ec;
    FileStamp stamp;
    stamp.size = std::filesystem::file_size(file, ec);
    if (ec) return {};
    stamp.time = std::filesystem::last_write_time(file, ec);
    stamp.exists = !ec;
    return stamp;
  }
  friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

}  // namespace blossom::ui
