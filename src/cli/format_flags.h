#pragma once
#include <string>
#include <vector>

#include "cli/parameter_flags.h"

namespace blossom {

/// Whether files of the format can hold shapes of one of the kinds, or of any when there are none. With ShapeKind::Sequence
/// among them, the others may come as frames of a sequence: formats that hold nothing but sequences can hold that, too.
bool canHold(const Format&, const std::vector<ShapeKind>& kinds);

/// Options of the formats as flags: --stl.ascii, --step.schema ap242; also --chord and --post, which set the option of that
/// name for every output.
class FormatFlags {
 public:
  enum Side { Reading = 1, Writing = 2 };
  /// @param written only writers of formats that can store one of these kinds get flags (empty: all writers)
  FormatFlags(CommandLine&, CLI::App&, const FormatRegistry&, int sides, const std::vector<ShapeKind>& written = {});

  /// Values of the read or write options of a format. @throws UsageError.
  [[nodiscard]] Value reading(const Format&) const;
  [[nodiscard]] Value writing(const Format&) const;
  /// @throws UsageError when a flag of a format that is not in `used` was set.
  void refuseUnused(const std::vector<const Format*>& used) const;

 private:
  [[nodiscard]] Value values(const Format&, const std::vector<ParameterSpec>& declared) const;

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
