#pragma once
#include <QFrame>

namespace blossom::ui {

/// A small card over the view for the current tool. It keeps its place when the view is resized; mouse events over it do not
/// reach the view.
class FloatingPanel : public QFrame {
  Q_OBJECT
 public:
  enum class Place { UpperLeft, Bottom };
  FloatingPanel(QWidget* view, Place);

 protected:
  /// Call it when the content has changed.
  void settle();
  bool eventFilter(QObject*, QEvent*) override;
  bool event(QEvent*) override;

 private:
  Place place_;
};

}  // namespace blossom::ui
