#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "naming/namer.h"
#include "parameter/value.h"

namespace blossom {

/// "<outline-1.edge 3>"; the brackets keep 3 from being found in 31.
std::string sourceLabel(const SourcePart&);

/// The labels that parts of sources had when a signature was made; others get labels of their own.
class FormerLabels {
 public:
  /// Whether the pieces of a segment that is gone have its label.
  enum class Pieces { No, Yes };

  /// @param sources by label: described parts (source_part.h). They are referred to.
  FormerLabels(const Value& sources, Pieces pieces) : sources_(sources), pieces_(pieces) {}

  /// @throws nlohmann::json::exception for sources of another form.
  std::string of(const SourcePart&, const Shape&);
  /// Whether a part that was asked for is gone.
  [[nodiscard]] bool someAreGone() const;

 private:
  const Value& sources_;
  Pieces pieces_;
  struct Now {
    std::optional<int> whole;
    std::vector<int> pieces;
  };
  const Now& now(const std::string& label, const Value& described, const Shape&, SubShapeKind);
  std::map<std::string, Now> found_;
};

}  // namespace blossom
