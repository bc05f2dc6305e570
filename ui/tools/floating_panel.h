#pragma once
#include <QFrame>

class QToolButton;

namespace blossom::ui {

/// A small card over the view for the current tool. It keeps its place when the view is resized; mouse events over it do not
/// reach the view.
class FloatingPanel : public QFrame {
  Q_OBJECT
 public:
  enum class Place { UpperLeft, Bottom };
  FloatingPanel(QWidget* view, Place);

 protected:
  /// A button of the card, which Tab reaches; the help is its name for those who do not see it.
  static QToolButton* textButton(const QString& text, const QString& help);
  /// Call it when the content has changed.
  void settle();
  bool eventFilter(QObject*, QEvent*) override;
  bool event(QEvent*) override;

 private:
  Place place_;
};

}  // namespace blossom::ui
