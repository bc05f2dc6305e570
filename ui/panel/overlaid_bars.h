#pragma once
#include <QPointer>
#include <QWidget>
#include <vector>

namespace blossom::ui {

/// Bars that come and go, one below the other over the upper edge of a view, so that nothing moves under the mouse. The
/// corner at the right stays free for the cube that turns the view.
class OverlaidBars : public QWidget {
  Q_OBJECT
 public:
  /// @param view the bars lie beside it in its parent
  OverlaidBars(QWidget& view, const std::vector<QWidget*>& bars);
  /// What the bars cover from above; 0 when there are none.
  [[nodiscard]] int covered() const { return isHidden() ? 0 : height(); }

  void leaveCorner(bool);  ///< false: the whole width is theirs

 signals:
  void coverageChanged();

 protected:
  bool eventFilter(QObject*, QEvent*) override;
  bool event(QEvent*) override;

 private:
  void settle();
  QPointer<QWidget> view_;
  std::vector<QWidget*> bars_;
  bool settling_ = false, leavesCorner_ = true;
};

}  // namespace blossom::ui
