#pragma once
#include <string>
#include <vector>

#include "cli/command_line.h"

namespace blossom {

/// Flags made from parameter specs. A flag parameter becomes --name and --no-name, a record that cannot be absent
/// --name.field VALUE for each of its fields, any other parameter --name VALUE. Where the command has the flag already,
/// because reader and writer of a format share an option, the one flag sets both.
class ParameterFlags {
 public:
  /// @param prefix of every name: "stl." makes --stl.ascii. Names that every
  /// command needs itself are refused by the registry.
  ParameterFlags(CommandLine&, CLI::App&, const std::vector<ParameterSpec>& specs, const std::string& prefix,
                 const std::string& group);

  /// Canonical values of the flags on the command line; parameters without a flag are absent.
  /// @throws UsageError for a value that cannot be parsed or is out of range, and for a repeated flag that is no list.
  [[nodiscard]] Value values() const;
  /// The first flag on the command line, as typed, leaving out those that other specs declared before; empty when there is
  /// none.
  [[nodiscard]] std::string firstUsed() const;

 private:
  struct Entry {
    std::string record;  ///< the record it is a field of; empty: none
    ParameterSpec spec;
    CLI::Option* option;
    bool shared;  ///< declared by others before
  };
  void declare(CommandLine&, CLI::App&, const ParameterSpec&, const std::string& record, const std::string& prefix,
               const std::string& group);

  std::vector<Entry> entries_;
};

/// Rewrites a message about a parameter as one about its flag: "tolerance must be above 0" becomes "--tolerance must be
/// above 0".
std::string namingFlag(const std::string& flag, const std::string& parameter, const std::string& message);

/// The value's name in the column of flags: one word in capitals, such as NUMBER.
std::string placeholder(const ParameterSpec&);

}  // namespace blossom
