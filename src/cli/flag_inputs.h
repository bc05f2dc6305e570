#pragma once
#include <memory>
#include <utility>
#include <vector>

#include "cli/parameter_flags.h"
#include "document/document.h"

namespace blossom {

/// The inputs of a command that can be created by flags alone, as declared by the InputByFlags of feature types: `pocket
/// --text Blossom --font "DejaVu Serif"`.
class FlagInputs {
 public:
  FlagInputs(CommandLine&, CLI::App&, const Registry&, const FeatureType& command);

  /// The features created by the flags, each with its position among the inputs. Their ids are proposals; the caller makes
  /// them unique.
  /// @throws UsageError for a value that cannot be parsed, and for a flag without the flag that creates the input.
  [[nodiscard]] std::vector<std::pair<std::size_t, Feature>> features() const;

 private:
  struct Source {
    std::size_t place;
    std::shared_ptr<const FeatureType> type;
    ParameterFlags asks, plain, prefixed;
  };
  std::vector<Source> sources_;
};

}  // namespace blossom
