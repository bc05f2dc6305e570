#pragma once
#include <QFrame>
#include <QPointer>
#include <QStringList>
#include <functional>

#include "ui/files/sample_pictures.h"

class QBoxLayout;

namespace blossom::ui {

class TileGrid;

/// Content of an empty window: a new document, a file, a sample, or a recent document.
class StartPage : public QFrame {
  Q_OBJECT
 public:
  explicit StartPage(QWidget* parent = nullptr);
  /// Lies over this widget from here on, wherever that goes, below what `covered` says is told above.
  void showOver(QWidget*, std::function<int()> covered);
  void follow();
  void putAway();

 signals:
  void newWanted();
  void openWanted();
  void importWanted();
  void fileChosen(const QString& file);

 protected:
  void resizeEvent(QResizeEvent*) override;
  void showEvent(QShowEvent*) override;
  void hideEvent(QHideEvent*) override;
  bool eventFilter(QObject*, QEvent*) override;

 private:
  QBoxLayout* headings();
  void fillSamples();
  void fillRecent();
  void showMenu(const QString& file, bool pinned, const QPoint& at);

  SamplePictures pictures_;
  QPointer<QWidget> covered_;
  std::function<int()> toldAbove_;
  QBoxLayout *headings_ = nullptr, *all_ = nullptr;
  TileGrid *samples_, *recent_;
  QWidget* recentTitle_;
};

/// Sample documents of this installation, sorted by name.
QStringList sampleFiles();
/// "Twisted tube" for twisted-tube.json.
QString readableFileName(const QString& file);

}  // namespace blossom::ui
