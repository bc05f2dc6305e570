#pragma once
#include <QObject>
#include <functional>

class QMenu;
class QWidget;

namespace blossom::ui {

struct CommandSpec;
class Commands;
class DocumentClosing;
class DocumentExport;
class DocumentFiles;
class OpenDocuments;

/// The commands of the menu of files.
class FileCommands : public QObject {
  Q_OBJECT
 public:
  struct Doers {
    OpenDocuments& documents;
    DocumentFiles& files;
    DocumentClosing& closing;
    DocumentExport& exporting;
  };
  FileCommands(Commands&, Doers, QWidget* window);
  void addTo(QMenu&);
  /// Which of them can be used on the document that is shown.
  void refresh();

 private:
  void add(QMenu&, const CommandSpec&, std::function<void()>);
  void addOpening(QMenu&);
  void addSaving(QMenu&);
  void addTabs(QMenu&);
  void fillRecent();

  Commands& commands_;
  Doers do_;
  QWidget* window_;
  QMenu* recent_ = nullptr;
};

}  // namespace blossom::ui
