#pragma once
#include <string>
#include <vector>

#include "cli/parameter_flags.h"

namespace blossom {

/// Options of the formats as flags: --stl.ascii, --step.schema ap242; and --chord and --post, which stand for the option of
/// that name of every output.
class FormatFlags {
 public:
  enum Side { Reading = 1, Writing = 2 };
  /// Of writers, those of the formats that can hold one of `written` (empty: any).
  FormatFlags(CommandLine&, CLI::App&, const FormatRegistry&, int sides, const std::vector<ShapeKind>& written = {});

  /// Values for one side of a format. @throws UsageError.
  [[nodiscard]] Value reading(const Format&) const;
  [[nodiscard]] Value writing(const Format&) const;
  /// @throws UsageError when a flag was given for a format that is not among `used`.
  void refuseUnused(const std::vector<const Format*>& used) const;

 private:
  [[nodiscard]] Value given(const Format&, const std::vector<ParameterSpec>& declared) const;

  struct Entry {
    std::string id, title;
    ParameterFlags flags;
  };
  std::vector<Entry> entries_;
  struct Common {
    std::string name;
    CLI::Option* option;
  };
  std::vector<Common> common_;
};

}  // namespace blossom
