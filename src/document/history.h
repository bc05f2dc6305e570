#pragma once
#include <cstdint>
#include <optional>
#include <string>
#include <vector>

#include "document/document.h"

namespace blossom {

/// Undo is an older value. Documents share what is equal, so a long history costs little.
class History {
 public:
  explicit History(Document = {});
  void commit(Document, std::string what);  ///< forgets what could be redone
  void preview(Document);                   ///< shown, not remembered; the next commit or revert ends it
  void revert();
  bool undo();  ///< also ends a preview; false when there is nothing to undo
  bool redo();
  [[nodiscard]] const Document& current() const;
  [[nodiscard]] const Document& committed() const { return steps_[place_].document; }  ///< without a preview
  [[nodiscard]] std::string undoText() const;                                          ///< empty when nothing can be undone
  [[nodiscard]] std::string redoText() const;
  /// Names the committed document for as long as it can be reached.
  [[nodiscard]] std::uint64_t step() const { return steps_[place_].serial; }
  void markSaved() { markSaved(step()); }
  void markSaved(std::uint64_t step);   ///< the file holds what was committed then, wherever undo has gone since
  void markUnsaved();                   ///< no file holds any of its documents
  [[nodiscard]] bool modified() const;  ///< a preview does not count

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
