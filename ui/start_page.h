#pragma once
#include <QFrame>
#include <QStringList>

class QVBoxLayout;

namespace blossom::ui {

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

 private:
  QWidget* column(const QString& title, const QStringList& files);
  QVBoxLayout* recent_;
  QWidget* recentColumn_;
};

/// Sample documents of this installation, sorted by name.
QStringList sampleFiles();

}  // namespace blossom::ui
