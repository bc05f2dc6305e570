#pragma once
#include <QFrame>

namespace blossom::ui {

/// A bar that hides when one of its buttons was pressed. A widget that hides with the focus passes it to the next widget,
/// which may be a name with all its text selected, so that the next shortcut would overwrite it. This bar lets its owner
/// choose the next focus.
class PassingBar : public QFrame {
  Q_OBJECT
 public:
  using QFrame::QFrame;
  void setVisible(bool) override;

 signals:
  void focusFreed();  ///< the widget with the focus is about to disappear

 protected:
  /// To be called before something of the bar is hidden, disabled or deleted.
  void freeFocusOf(const QWidget* going);
};

}  // namespace blossom::ui
