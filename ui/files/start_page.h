#pragma once
#include <QFrame>
#include <QPointer>
#include <QStringList>

#include "ui/files/sample_pictures.h"

namespace blossom::ui {

class TileGrid;

/// Content of an empty window: a new document, a file, a sample, or a recent document.
class StartPage : public QFrame {
  Q_OBJECT
 public:
  explicit StartPage(QWidget* parent = nullptr);
  /// Lies over this widget from here on, wherever that goes.
  void showOver(QWidget*);
  void putAway();

 signals:
  void newWanted();
  void openWanted();
  void importWanted();
  void fileChosen(const QString& file);

 protected:
  void showEvent(QShowEvent*) override;
  void hideEvent(QHideEvent*) override;
  bool eventFilter(QObject*, QEvent*) override;

 private:
  QLayout* headings();
  void fillSamples();
  void fillRecent();
  void showMenu(const QString& file, bool pinned, const QPoint& at);
  void follow();

  SamplePictures pictures_;
  QPointer<QWidget> covered_;
  TileGrid *samples_, *recent_;
  QWidget* recentTitle_;
};

/// Sample documents of this installation, sorted by name.
QStringList sampleFiles();
/// "Twisted tube" for twisted-tube.json.
QString readableFileName(const QString& file);

}  // namespace blossom::ui
