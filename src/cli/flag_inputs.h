#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "cli/parameter_flags.h"
#include "document/document.h"

namespace blossom {

/// The inputs of one command that flags alone can make, as feature types declare it (InputByFlags):
/// `pocket --text Blossom --font "DejaVu Serif"`.
class FlagInputs {
 public:
  FlagInputs(CommandLine&, CLI::App&, const Registry&, const FeatureType& command);

  /// The features asked for, each with its place among the inputs; their ids are what fresh ids are to be made from.
  /// @throws UsageError for a value that is not understood, and for a flag without the one that asks for the input.
  [[nodiscard]] std::vector<std::pair<std::size_t, Feature>> given() const;

 private:
  struct Source {
    std::size_t place;
    std::shared_ptr<const FeatureType> type;
    ParameterFlags asks, plain, prefixed;
  };
  std::vector<Source> sources_;
};

}  // namespace blossom
