#include <cstdlib>
#include <stdexcept>
#include <string>

#include "core/error.h"
#include "feature/plugin.h"

namespace {

struct None {};

blossom::FeatureType thing(std::string id) {
  return blossom::feature<None>(std::move(id), "Thing", "A thing to test with.")
      .evaluate([](const None&, const blossom::Inputs&, const blossom::Progress&) -> blossom::Evaluated {
        return {blossom::Mesh{}, {}, {}};
      });
}

}  // namespace

/// Behaves as BLOSSOM_PROBE says.
BLOSSOM_PLUGIN(registry) {
  const char* given = std::getenv("BLOSSOM_PROBE");
  const std::string behaviour = given ? given : "";
  registry.add(thing("probe.thing"));
  blossom::Format format;
  format.id = "probed";
  format.title = "Probe";
  format.extensions = {behaviour == "taken extension" ? "step" : "probe"};
  format.read = [](const auto&, const auto&, const auto&) { return blossom::Imported(); };
  if (behaviour.find("format") != std::string::npos || behaviour == "taken extension") registry.add(format);
  if (behaviour == "undeclared") registry.add(thing("probe.more"));
  if (behaviour == "double") registry.add(thing("probe.thing"));
  if (behaviour == "error") throw blossom::Error(blossom::ErrorCode::Internal, "The probe has no licence.");
  if (behaviour == "exception") throw std::runtime_error("out of luck");
  if (behaviour == "number") throw 7;
}
