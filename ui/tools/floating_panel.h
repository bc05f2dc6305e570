#pragma once
#include <QFrame>

namespace blossom::ui {

/// A small card over the view, with what belongs to the tool in use. Keeps its place when the view changes its size; the
/// mouse over it does not reach the view.
class FloatingPanel : public QFrame {
  Q_OBJECT
 public:
  enum class Place { UpperLeft, Bottom };
  FloatingPanel(QWidget* view, Place);

 protected:
  /// To be called when what it holds has changed.
  void settle();
  bool eventFilter(QObject*, QEvent*) override;
  bool event(QEvent*) override;

 private:
  Place place_;
};

}  // namespace blossom::ui
