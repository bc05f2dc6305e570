#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "core/file.h"
#include "feature/plugin.h"

namespace blossom {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void broken(const fs::path& file, const std::string& why) {
  throw Error(ErrorCode::PluginBroken, fmt::format("{}: {}.", file.string(), why),
              "The plugin's makers have to correct its plugin.json.");
}

class ManifestReader {
 public:
  ManifestReader(const fs::path& file, const Value& json) : file_(file), json_(json) {}

  std::string text(const char* key, bool required = true) const {
    const auto found = json_.find(key);
    if (found == json_.end() && !required) return {};
    if (found == json_.end()) broken(file_, fmt::format("the key \"{}\" is missing", key));
    if (!found->is_string()) broken(file_, fmt::format("\"{}\" must be a text", key));
    if (required && found->get_ref<const std::string&>().empty()) broken(file_, fmt::format("\"{}\" is empty", key));
    return found->get<std::string>();
  }

  /// The plugin's name: it is the first half of its feature ids and the name of its folder.
  std::string id() const {
    std::string id = text("id");
    const auto allowed = [](char c) { return (c >= 'a' && c <= 'z') || (c >= '0' && c <= '9') || c == '-' || c == '_'; };
    if (!std::all_of(id.begin(), id.end(), allowed))
      broken(file_, fmt::format("the id \"{}\" may only have lower-case letters, digits, - and _", id));
    return id;
  }

  int api() const {
    const auto found = json_.find("api");
    if (found == json_.end()) broken(file_, "the key \"api\" is missing");
    if (!found->is_number_integer() || *found < 1 || *found > 1000000)
      broken(file_, "\"api\" must be a whole number from 1");
    return found->get<int>();
  }

  /// A file beside the manifest: a manifest must not reach for modules elsewhere.
  std::string module(const char* key, bool required) const {
    std::string name = text(key, required);
    if (!name.empty() && (fs::path(name).filename() != name || name == "." || name == ".."))
      broken(file_, fmt::format("\"{}\" must name a file in the plugin's own folder; it is \"{}\"", key, name));
    return name;
  }

  std::vector<std::string> features(const std::string& id) const {
    const auto found = json_.find("features");
    if (found == json_.end()) broken(file_, "the key \"features\" is missing");
    const auto owned = [&](const Value& v) {
      return v.is_string() && v.get_ref<const std::string&>().starts_with(id + ".");
    };
    if (!found->is_array() || !std::all_of(found->begin(), found->end(), owned))
      broken(file_, fmt::format("\"features\" must be a list of ids such as \"{}.name\"", id));
    return found->get<std::vector<std::string>>();
  }

  std::vector<std::string> formats() const {
    const auto found = json_.find("formats");
    if (found == json_.end()) return {};
    if (!found->is_array() || !std::all_of(found->begin(), found->end(), [](const Value& v) { return v.is_string(); }))
      broken(file_, "\"formats\" must be a list of the ids of file formats");
    return found->get<std::vector<std::string>>();
  }

 private:
  const fs::path& file_;
  const Value& json_;
};

Value parsed(const fs::path& file) {
  constexpr std::uintmax_t largest = 1 << 20;
  try {
    std::error_code ignored;
    if (const auto size = fs::file_size(file, ignored); size > largest && !ignored)
      broken(file, "it is larger than a manifest can be");
    return parseJson(readFile(file));
  } catch (const Error& e) {
    if (e.code() == ErrorCode::PluginBroken) throw;
    broken(file, e.message().substr(0, e.message().size() - 1));
  }
}

}  // namespace

PluginManifest readManifest(const fs::path& file) {
  const Value json = parsed(file);
  if (!json.is_object()) broken(file, "it holds no object");
  const ManifestReader reader(file, json);
  PluginManifest manifest;
  manifest.folder = file.parent_path();
  manifest.id = reader.id();
  manifest.api = reader.api();
  // another API may know other keys: only this one's are demanded
  const bool ours = manifest.api == pluginApiVersion;
  manifest.title = reader.text("title", ours);
  if (!ours) return manifest;
  manifest.version = reader.text("version");
  manifest.summary = reader.text("summary");
  manifest.icon = reader.text("icon", false);
  manifest.compute = reader.module("compute", true);
  manifest.manipulators = reader.module("manipulators", false);
  manifest.features = reader.features(manifest.id);
  manifest.formats = reader.formats();
  return manifest;
}

}  // namespace blossom
