#pragma once
#include <QFrame>
#include <QTimer>

class QLabel;
class QProgressBar;
class QToolButton;

namespace blossom::ui {

/// The bottom line: what the mouse would do, what is being computed (with a way to stop it), and where the cursor is.
class StatusLine : public QFrame {
  Q_OBJECT
 public:
  explicit StatusLine(QWidget* parent = nullptr);

  void setHint(const QString&);
  void setWhereabouts(const QString&);
  /// Shown for a few seconds in place of the hint.
  void announce(const QString&);
  /// Two sorts of work may run at once; each has its own key.
  void setWork(const QString& key, const QString& what, double fraction);
  void endWork(const QString& key);
  [[nodiscard]] bool working() const { return !work_.isEmpty(); }

 signals:
  void cancelled();

 private:
  void refresh();
  struct Work {
    QString what;
    double fraction = 0;
  };
  QMap<QString, Work> work_;
  QLabel* hint_;
  QLabel* whereabouts_;
  QLabel* workText_;
  QProgressBar* bar_;
  QToolButton* cancel_;
  QString idle_;
  QTimer announcing_, patience_;
};

}  // namespace blossom::ui
