#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "app/app.h"
#include "core/version.h"
#include "document/storage.h"
#include "results/result_store.h"
#include "worker/worker.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

/// Name, size and time of every library in a folder whose name begins like this.
void addLibraries(const fs::path& folder, const std::string& beginning, std::vector<std::string>& all) {
  std::error_code ignored;
  for (const auto& entry : fs::directory_iterator(folder, ignored)) {
    const std::string name = entry.path().filename().string();
    if (entry.is_directory(ignored) || !name.starts_with(beginning) || name.find(".so") == std::string::npos) continue;
    all.push_back(
        fmt::format("{} {} {}", name, entry.file_size(ignored), entry.last_write_time(ignored).time_since_epoch().count()));
  }
}

/// Differs between any two builds: a result of another build may be the one that its fault was mended for.
std::string buildStamp() {
  std::vector<std::string> libraries{versionText};
  static const char here = 0;
  addLibraries(fs::path(moduleOf(&here)).parent_path(), "libblossom", libraries);
  std::error_code ignored;
  for (const fs::path& folder : pluginSearchPath()) {
    addLibraries(folder, "", libraries);
    for (const auto& plugin : fs::directory_iterator(folder, ignored))
      if (plugin.is_directory(ignored)) addLibraries(plugin.path(), "", libraries);
  }
  std::sort(libraries.begin(), libraries.end());
  std::string all;
  for (const std::string& library : libraries) all += library + '\n';
  return contentHash(all).substr(0, 12);
}

}  // namespace

std::shared_ptr<ResultStore> resultStore(const fs::path& folder) {
  return std::make_shared<ResultStore>(folder, buildStamp());
}

}  // namespace blossom
