#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"

namespace blossom {

/// Undo and redo as a list of documents. Documents share equal parts, so a long history is cheap.
class History {
 public:
  explicit History(Document = {});
  void commit(Document, std::string what);  ///< clears the redo steps
  void preview(Document);                   ///< current until the next commit or revert, not recorded
  void revert();
  void amend(Document);  ///< in place of the current one, which it means the same as: no step
  bool undo();           ///< also ends a preview; false when there is nothing to undo
  bool redo();
  [[nodiscard]] const Document& current() const;
  [[nodiscard]] const Document& committed() const { return steps_[place_].document; }  ///< without a preview
  [[nodiscard]] std::string undoText() const;                                          ///< empty when nothing can be undone
  [[nodiscard]] std::string redoText() const;
  /// Serial number of the committed document, as long as it can be reached.
  [[nodiscard]] std::uint64_t step() const { return steps_[place_].serial; }
  void markSaved() { markSaved(step()); }
  void markSaved(std::uint64_t step);   ///< the file contains the document of that step, whatever was undone since
  void markUnsaved();                   ///< no file contains any of the documents
  [[nodiscard]] bool modified() const;  ///< unsaved changes; previews are ignored

 private:
  struct Step {
    Document document;
    std::string what;
    std::uint64_t serial;
  };
  std::vector<Step> steps_;
  std::size_t place_ = 0;
  std::optional<std::size_t> savedPlace_ = 0;
  std::optional<Document> preview_;
};

}  // namespace blossom
