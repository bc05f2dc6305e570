#pragma once
#include <QFrame>
#include <optional>

class QToolButton;

namespace blossom::ui {

/// A small card over the view for the current tool. It keeps its place when the view is resized; mouse events over it do not
/// reach the view. Where it has no controls it can be dragged out of the way, within the view; a double click takes it back.
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
  [[nodiscard]] QPoint placeOf(const QSize&) const;
  bool dragged(QEvent*);

  Place place_;
  std::optional<QPoint> draggedTo_;  ///< upper left corner
  std::optional<QPoint> held_;       ///< where it is held, from that corner
};

}  // namespace blossom::ui
