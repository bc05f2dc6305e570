#pragma once
#include <QObject>
#include <QString>

namespace blossom::ui {

class MainWindow;

/// Waits until everything asked for has been computed and drawn, then writes a picture of the whole window.
class Screenshot : public QObject {
  Q_OBJECT
 public:
  Screenshot(MainWindow&, QString file);

 signals:
  void taken(bool written);

 private:
  void whenComputed();
  MainWindow& window_;
  QString file_;
};

}  // namespace blossom::ui
