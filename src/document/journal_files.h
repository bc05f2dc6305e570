#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

namespace blossom {

/// The files of a journal's folder: generation n is base-n and the steps since in steps-n.
std::filesystem::path journalBase(const std::filesystem::path& folder, std::size_t generation);
std::filesystem::path journalSteps(const std::filesystem::path& folder, std::size_t generation);
std::filesystem::path journalAssets(const std::filesystem::path& folder);
/// Generations with a base, newest first.
std::vector<std::size_t> journalGenerations(const std::filesystem::path& folder);

/// Removes a folder atomically, so that after a kill it exists completely or not at all. Does nothing when it does not
/// exist.
void removeAtOnce(const std::filesystem::path& folder);
/// Whether a folder is the rest of a removal that was interrupted by a kill.
bool isRemoved(const std::filesystem::path& folder);

/// An append-only file.
class AppendedFile {
 public:
  AppendedFile() = default;
  ~AppendedFile() { close(); }
  AppendedFile(const AppendedFile&) = delete;
  AppendedFile& operator=(const AppendedFile&) = delete;
  void open(const std::filesystem::path&);  ///< @throws Error FileUnwritable
  void append(std::string_view);            ///< writes without syncing @throws Error FileUnwritable
  void sync();                              ///< waits for the disk @throws Error FileUnwritable
  void close();
  [[nodiscard]] bool isOpen() const { return fd_ >= 0; }

 private:
  [[noreturn]] void fail() const;
  std::filesystem::path path_;
  int fd_ = -1;
};

}  // namespace blossom
