#pragma once
#include <string>

#include "document/storage.h"

namespace blossom {

/// Limit that keeps a hostile file from taking quadratic time; real documents are far below.
inline constexpr std::size_t maximumFeatures = 10000;

/// Collects the defects of a document that is read. Without salvaging the first defect is an error, with salvaging defects
/// become warnings.
class Problems {
 public:
  Problems(std::string subject, bool salvage) : subject_(std::move(subject)), salvage_(salvage) {}
  /// @param what "feature 3 has no id", appended to "The document is damaged:" @throws Error FormatDamaged unless
  /// salvaging
  void report(const std::string& what);
  [[noreturn]] void fail(const std::string& what) const;
  [[nodiscard]] bool salvage() const { return salvage_; }
  [[nodiscard]] const std::string& subject() const { return subject_; }
  std::vector<std::string> warnings;

 private:
  std::string subject_;  ///< "The document propeller.blossom"
  bool salvage_;
};

/// One feature in the form of document.json.
Value featureJson(const Feature&);
/// The document in the form of document.json.
Value documentJson(const Document&);

/// @throws Error FormatTooNew, FormatDamaged, LimitExceeded.
Document readDocumentJson(const std::string& json, Problems&);

}  // namespace blossom
