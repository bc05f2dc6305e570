#pragma once
#include <QObject>
#include <QStringList>
#include <functional>

#include "app/app.h"
#include "document/recovery_area.h"

class QMimeData;
class QWidget;

namespace blossom::ui {

class DocumentPage;
class OpenDocuments;

/// Opening, importing, saving and recovering files, with the dialogs for them.
class DocumentFiles : public QObject {
  Q_OBJECT
 public:
  DocumentFiles(App, OpenDocuments&, QWidget* window);

  /// Opens what the extension says, a document or geometry, in a tab of its own; shows the tab of a file that is open
  /// already.
  void open(const QString& file, bool salvage = false);
  /// Several at once, each in a tab; what cannot be opened is told together.
  void open(const QStringList& files);
  void chooseAndOpen();
  void chooseAndImport();
  void importFiles(const QStringList& files);  ///< into the document that is shown
  /// Documents open in tabs of their own; geometry is added to the document that is shown.
  void drop(const QMimeData&);
  static QStringList filesIn(const QMimeData&);
  void recover(const LostDocument&);

  /// Text in a field that was not entered yet counts, too.
  void takeTyping();
  void save(DocumentPage&, std::function<void()> then = {});
  void saveAs(DocumentPage&, std::function<void()> then = {});
  /// Among the files that were used lately.
  static void remember(const QString& file);

 private:
  void write(DocumentPage&, const QString& file, std::function<void()> then);

  App app_;
  OpenDocuments& documents_;
  QWidget* window_;
};

/// Adds the extension that a file dialog has not asked about; false when that file exists and shall stay.
bool completed(QString& file, const QString& extension, QWidget* window);

}  // namespace blossom::ui
