#include "document/assets.h"

#include <fmt/format.h>

#include <functional>

namespace blossom {
namespace {

/// Calls `visit` with every text that could name an asset.
template <class Visit>
void visitTexts(const Value& value, const Visit& visit) {
  if (const auto* text = value.get_ptr<const std::string*>()) visit(*text);
  if (value.is_structured())
    for (const Value& item : value) visitTexts(item, visit);
}

/// Hashes under the key "asset", as file parameters have them.
void visitFiles(const Value& value, const std::function<void(const std::string& hash)>& visit) {
  if (value.is_object() && value.contains("asset") && value.at("asset").is_string())
    if (const auto& hash = value.at("asset").get_ref<const std::string&>(); !hash.empty()) visit(hash);
  if (value.is_structured())
    for (const Value& item : value) visitFiles(item, visit);
}

}  // namespace

std::set<std::string> namedAssets(const Document& document) {
  std::set<std::string> named;
  if (document.assets().empty()) return named;
  const auto keep = [&](const std::string& text) {
    if (document.assets().contains(text)) named.insert(text);
  };
  visitTexts(document.extra(), keep);
  for (const auto& feature : document.features()) visitTexts(feature->parameters, keep), visitTexts(feature->extra, keep);
  return named;
}

void checkAssets(const Document& document, Problems& problems) {
  for (const auto& feature : document.features())
    visitFiles(feature->parameters, [&](const std::string& hash) {
      if (!document.assets().contains(hash))
        problems.report(
            fmt::format("the imported file of \"{}\" is missing", feature->name.empty() ? feature->id : feature->name));
    });
}

}  // namespace blossom
