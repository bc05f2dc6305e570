#pragma once
#include <QObject>
#include <cstdint>
#include <functional>
#include <map>
#include <vector>

class QWidget;

namespace blossom::ui {

class DocumentFiles;
class DocumentPage;
class OpenDocuments;
struct UnsavedDocument;

/// Closing documents, one or all, without losing what is unsaved or cutting off what is being written.
class DocumentClosing : public QObject {
  Q_OBJECT
 public:
  DocumentClosing(OpenDocuments&, DocumentFiles&, QWidget* window);

  void close(std::size_t index);  ///< asks first when changes would be lost
  void closeOthers(std::size_t index);
  /// Whether the window may close now. When not, the user is asked, and it is closed later if the answer allows it.
  [[nodiscard]] bool mayCloseAll();

 signals:
  void announced(const QString&);

 private:
  /// Documents whose changes the user discards, as they were at that moment.
  using Discarded = std::map<const DocumentPage*, std::uint64_t>;
  using AfterQuestion = std::function<void(const Discarded&)>;
  /// Calls `go` at once, after saving, or never, as the user decides about the unsaved changes of a document.
  void guarded(DocumentPage&, const AfterQuestion& go);
  [[nodiscard]] std::vector<UnsavedDocument> unsaved(const std::vector<DocumentPage*>&) const;
  void guardedAll(const std::vector<DocumentPage*>&, const AfterQuestion& go);  ///< the same for several, asked once
  /// False when none of them writes a file; else `then` comes when the first has.
  bool waitsForWriting(const std::vector<DocumentPage*>&, const std::function<void()>& then);
  void saveInTurn(std::vector<DocumentPage*>, std::function<void()> then);
  [[nodiscard]] bool isOpen(const DocumentPage&) const;
  void show(const DocumentPage&);

  OpenDocuments& documents_;
  DocumentFiles& files_;
  QWidget* window_;
  Discarded discarded_;  // what was answered when the window was to be closed
};

}  // namespace blossom::ui
