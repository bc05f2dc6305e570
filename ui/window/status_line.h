#pragma once
#include <QFrame>
#include <QTimer>

class QAction;
class QLabel;
class QMenu;
class QProgressBar;
class QToolButton;

namespace blossom::ui {

/// The bottom line: what the mouse would do, what is being computed (with a way to stop it), and where the cursor is.
class StatusLine : public QFrame {
  Q_OBJECT
 public:
  explicit StatusLine(QWidget* parent = nullptr);

  /// What the mouse would do where it is; empty: the standing hint is shown. Where there is no room for all of its parts,
  /// which " · " separates, they are shown one after the other.
  void setHint(const QString&);
  void setStandingHint(const QString&);
  void setWhereabouts(const QString&);
  /// Shown for a few seconds in place of the hint.
  void announce(const QString&);
  /// Several sorts of work may run at once; each has its own key.
  void setWork(const QString& key, const QString& what, double fraction);
  void endWork(const QString& key);
  /// Offers what a click in the view may select; the mode in force stands at the left.
  void setPickModes(QMenu*);
  void showPickMode(const QAction& chosen);
  void setJobs(int running);  ///< of all documents
  [[nodiscard]] QString hint() const;
  [[nodiscard]] bool working() const { return !work_.isEmpty(); }

 signals:
  void cancelled();
  void jobsWanted();  ///< the words about the work under way were clicked

 protected:
  bool eventFilter(QObject*, QEvent*) override;
  void resizeEvent(QResizeEvent*) override;

 private:
  void refresh();
  void shareRoom();
  void say(const QString&);
  void fitHint();
  [[nodiscard]] QStringList pages() const;  ///< the hint in parts that there is room for
  struct Work {
    QString what;
    double fraction = 0;
  };
  QMap<QString, Work> work_;
  QToolButton* pickMode_;
  QLabel* hint_;
  QLabel* whereabouts_;
  QToolButton* workText_;
  QProgressBar* bar_;
  QToolButton* cancel_;
  QString said_;  ///< in full; shown as far as there is room
  QString idle_, standing_;
  QString where_;  ///< likewise in full
  int jobs_ = 0;
  int page_ = 0;  ///< of the hint
  QTimer announcing_, patience_, turning_;
};

}  // namespace blossom::ui
