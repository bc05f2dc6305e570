#pragma once
#include <cstdint>
#include <filesystem>
#include <mutex>
#include <optional>
#include <string>

#include "core/progress.h"
#include "feature/feature_type.h"

namespace blossom {

/// A result that was kept.
struct KeptResult {
  Evaluated evaluated;
  bool gougeLeftOut = false;  ///< it is a toolpath whose function `gougeOf` was not kept
};

/// Results of features in a folder, so that a document opens quickly the next time. A file each, which holds a checksum:
/// what is damaged is ignored and removed. Beyond the limit, those go first that were not used for longest. Thread-safe,
/// also among processes.
class ResultStore {
 public:
  static constexpr std::uintmax_t oneGigabyte = 1u << 30;
  /// @param version of the programs: results of others are not found
  ResultStore(std::filesystem::path folder, std::string version, std::uintmax_t limit = oneGigabyte);

  /// Nothing when there is none, or none that can be read.
  std::optional<KeptResult> find(const std::string& key);
  /// Without it everything works, so a disk that is full or not there is no error.
  void keep(const std::string& key, const Evaluated&, const Progress& = Progress::none()) noexcept;

 private:
  [[nodiscard]] std::filesystem::path fileOf(const std::string& key) const;
  void makeRoom(std::uintmax_t added);

  std::filesystem::path folder_;
  std::string version_;
  std::uintmax_t limit_;
  std::mutex mutex_;
  std::optional<std::uintmax_t> total_;  ///< of the folder, as far as this process knows
  int sinceCounted_ = 0;
};

}  // namespace blossom
