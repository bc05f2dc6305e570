#pragma once
#include <fmt/format.h>

#include <filesystem>
#include <functional>
#include <vector>

#include "app/app.h"
#include "core/error.h"
#include "document/storage.h"

/// What the programs share that write the sample documents of the plugins; they are run by hand when samples are to change.
namespace blossom::samples {

/// Adds a feature, named by its command. What it takes is hidden from then on.
inline FeatureId add(const App& app, Document& document, const char* command, const char* name, Value parameters,
                     const std::vector<FeatureId>& inputs = {}) {
  const auto type = app.registry->at(command);
  for (const FeatureId& input : inputs) {
    Feature hidden = document.at(input);
    hidden.visible = false;
    document = document.with(std::move(hidden));
  }
  Feature feature{document.freshId(command), type->id, name, std::move(parameters), inputs, true, false, Value::object()};
  document = document.with(feature);
  return feature.id;
}

/// The main function: `write` gets the folder that the only argument names.
inline int run(int argc, char** argv, const std::function<void(const App&, const std::filesystem::path&)>& write) {
  if (argc != 2) {
    fmt::print(stderr, "{} FOLDER\n", std::filesystem::path(argv[0]).filename().string());
    return 2;
  }
  try {
    write(loadApp(), argv[1]);
  } catch (const Error& error) {
    fmt::print(stderr, "{} {}\n", error.message(), error.hint());
    return 1;
  }
  return 0;
}

}  // namespace blossom::samples
