#pragma once
#include <QObject>
#include <functional>
#include <vector>

class QMenu;

namespace blossom::ui {

class Commands;
class DocumentPage;
class DocumentTree;
class FeatureMenus;

/// The commands on features: declared here once, for the Edit menu, the context menus of tree and view, and the palette.
class DocumentCommands : public QObject {
  Q_OBJECT
 public:
  DocumentCommands(Commands&, FeatureMenus&, QWidget* window);
  void addTo(QMenu* edit);
  void setPage(DocumentPage* page) { page_ = page; }  ///< what the commands are about
  void refresh();                                     ///< what can be done with what is selected, and why the rest cannot
  /// About what is selected: in the tree, or under the mouse in the view.
  void popup(const QPoint& global);

 private:
  void declareHistory();
  void declareFeatureEdits();
  void declareClipboard();
  /// The tree, for a command that adds or takes away features: what is drawn meanwhile is given up.
  DocumentTree& treeWithoutDrawing();
  void declareSelection();
  void fillContextMenu(QMenu&);
  void fitToSelection();
  void refreshHistory();
  void refreshWords();
  Commands& commands_;
  FeatureMenus& featureMenus_;
  QWidget* window_;
  DocumentPage* page_ = nullptr;
};

}  // namespace blossom::ui
