#include <fmt/format.h>
#include <link.h>

#include <algorithm>
#include <vector>

#include "app/app.h"
#include "core/version.h"
#include "document/storage.h"
#include "results/result_store.h"

namespace blossom {

namespace {

namespace fs = std::filesystem;

/// Path, size and time of a library.
std::string stateOf(const fs::path& library) {
  std::error_code ignored;
  return fmt::format("{} {} {}\n", library.string(), fs::file_size(library, ignored),
                     fs::last_write_time(library, ignored).time_since_epoch().count());
}

/// Every library in a folder, in the order of their names.
std::string librariesIn(const fs::path& folder) {
  std::error_code ignored;
  std::vector<std::string> all;
  for (const auto& entry : fs::directory_iterator(folder, ignored))
    if (!entry.is_directory(ignored) && entry.path().filename().string().find(".so") != std::string::npos)
      all.push_back(stateOf(entry.path()));
  std::sort(all.begin(), all.end());
  std::string joined;
  for (const std::string& each : all) joined += each;
  return joined;
}

/// Our own libraries and those of the system that are loaded: kernels such as OpenCASCADE make results, too.
int addLoaded(dl_phdr_info* module, std::size_t, void* all) {
  const std::string name = module->dlpi_name ? module->dlpi_name : "";
  if (name.starts_with('/')) static_cast<std::vector<std::string>*>(all)->push_back(stateOf(name));
  return 0;
}

/// Differs between any two builds: a result of another build may be the one that its fault was mended for. Of several
/// folders with plugins the first ones win.
std::string buildStamp() {
  std::vector<std::string> loaded;
  dl_iterate_phdr(addLoaded, &loaded);
  std::sort(loaded.begin(), loaded.end());
  std::string all = versionText;
  for (const std::string& each : loaded) all += each;
  std::error_code ignored;
  for (const fs::path& folder : pluginSearchPath()) {
    std::vector<fs::path> plugins;
    for (const auto& plugin : fs::directory_iterator(folder, ignored))
      if (plugin.is_directory(ignored)) plugins.push_back(plugin.path());
    std::sort(plugins.begin(), plugins.end());
    for (const fs::path& plugin : plugins) all += librariesIn(plugin);
  }
  return contentHash(all).substr(0, 12);
}

}  // namespace

std::shared_ptr<ResultStore> resultStore(const fs::path& folder) {
  return std::make_shared<ResultStore>(folder, buildStamp());
}

}  // namespace blossom
