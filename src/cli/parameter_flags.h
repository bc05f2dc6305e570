#pragma once
#include <string>
#include <vector>

#include "cli/command_line.h"

namespace blossom {

/// Flags made from parameter specs. A flag parameter becomes --name and --no-name, every other --name VALUE.
class ParameterFlags {
 public:
  /// @param prefix stands before every name: "stl." gives --stl.ascii. Names that every
  /// command needs itself are refused by the registry.
  ParameterFlags(CommandLine&, CLI::App&, std::vector<ParameterSpec> specs, const std::string& prefix,
                 const std::string& group);

  /// Canonical values of the flags given on the command line; the others are absent.
  /// @throws UsageError for a value that is not understood or out of range, and for a flag given twice that is no list.
  [[nodiscard]] Value given() const;
  /// The first flag given, as typed; empty when there is none.
  [[nodiscard]] std::string firstGiven() const;

 private:
  std::vector<ParameterSpec> specs_;
  std::vector<CLI::Option*> options_;
};

/// A message about a parameter as one about its flag: "tolerance must be above 0" becomes "--tolerance must be above 0".
std::string namingFlag(const std::string& flag, const std::string& parameter, const std::string& message);

/// "number from 0 to 1": one word in capitals for the column of flags.
std::string placeholder(const ParameterSpec&);

}  // namespace blossom
