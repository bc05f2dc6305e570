#pragma once
#include <QFrame>
#include <QHash>
#include <QStringList>

class QLabel;
class QVBoxLayout;

namespace blossom::ui {

class SamplePictures;

/// What an empty window offers: open a file, take a sample, go on with a recent document.
class StartPage : public QFrame {
  Q_OBJECT
 public:
  explicit StartPage(QWidget* parent = nullptr);
  void setRecent(const QStringList& files);

 signals:
  void openWanted();
  void importWanted();
  void fileChosen(const QString& file);

 protected:
  void showEvent(QShowEvent*) override;
  void hideEvent(QHideEvent*) override;

 private:
  QLayout* headings();
  QLayout* sampleTiles();

  SamplePictures* pictures_;
  QHash<QString, QLabel*> pictureOf_;
  QVBoxLayout* recent_;
  QWidget* recentColumn_;
};

/// Sample documents of this installation, sorted by name.
QStringList sampleFiles();

}  // namespace blossom::ui
