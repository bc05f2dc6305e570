#pragma once
#include <QObject>
#include <functional>

class QAction;
class QMenu;

namespace blossom::ui {

class Commands;
class DocumentPage;

/// The commands about what is seen of a document: what a click selects, how shapes are drawn, measuring and the section.
class ViewCommands : public QObject {
  Q_OBJECT
 public:
  /// @param page the one that is shown
  ViewCommands(Commands&, std::function<DocumentPage&()> page, QObject* parent);
  void addTo(QMenu& view, QMenu& select);
  void refresh();  ///< another page is shown, or its view has changed

 signals:
  void pickModeShown(const QAction& chosen);  ///< what a click selects, as the command that chose it

 private:
  void addPickModes();
  void addDisplayModes();
  void addTools();
  void addTimeline();
  Commands& commands_;
  std::function<DocumentPage&()> page_;
};

}  // namespace blossom::ui
