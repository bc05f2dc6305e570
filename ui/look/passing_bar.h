#pragma once
#include <QFrame>

namespace blossom::ui {

/// A bar that goes once its button was pressed. A widget that hides while it has the focus hands it to the next one, which
/// may be a name with all its text selected: the next shortcut would be typed over it. This bar lets its owner say who has
/// it.
class PassingBar : public QFrame {
  Q_OBJECT
 public:
  using QFrame::QFrame;
  void setVisible(bool) override;

 signals:
  void focusFreed();  ///< what had the focus is about to go

 protected:
  /// To be called before something of the bar is hidden, disabled or deleted.
  void freeFocusOf(const QWidget* going);
};

}  // namespace blossom::ui
