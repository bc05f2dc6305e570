#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

namespace blossom {

/// The files of a journal's folder: generation n is base-n and the steps since in steps-n.
std::filesystem::path journalBase(const std::filesystem::path& folder, std::size_t generation);
std::filesystem::path journalSteps(const std::filesystem::path& folder, std::size_t generation);
std::filesystem::path journalAssets(const std::filesystem::path& folder);
/// Generations that have a base, newest first.
std::vector<std::size_t> journalGenerations(const std::filesystem::path& folder);

/// Whoever looks after a kill finds the folder whole or not at all. Does nothing when it is not there.
void removeAtOnce(const std::filesystem::path& folder);
/// Is it what a kill left of removing a folder?
bool isRemoved(const std::filesystem::path& folder);

/// A file that only grows.
class AppendedFile {
 public:
  AppendedFile() = default;
  ~AppendedFile() { close(); }
  AppendedFile(const AppendedFile&) = delete;
  AppendedFile& operator=(const AppendedFile&) = delete;
  void open(const std::filesystem::path&);  ///< @throws Error FileUnwritable
  void append(std::string_view);            ///< hands it to the system @throws Error FileUnwritable
  void sync();                              ///< waits for the disk @throws Error FileUnwritable
  void close();
  [[nodiscard]] bool isOpen() const { return fd_ >= 0; }

 private:
  [[noreturn]] void fail() const;
  std::filesystem::path path_;
  int fd_ = -1;
};

}  // namespace blossom
