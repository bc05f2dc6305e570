#pragma once
#include <QWidget>

class QLabel;
class QPushButton;

namespace blossom::ui {

/// A thin line around the widget of a step; transparent for the mouse.
class TourFrame : public QWidget {
 public:
  explicit TourFrame(QWidget* window);

 protected:
  void paintEvent(QPaintEvent*) override;
};

/// The bubble of the tour: title, text, step number, and buttons to continue, go back and end.
class TourBubble : public QWidget {
  Q_OBJECT
 public:
  explicit TourBubble(QWidget* window);

  void showStep(const QString& title, const QString& text, std::size_t step, std::size_t steps);
  /// Places the bubble beside the rectangle, in window coordinates, with its tip towards it; in the middle when it is empty.
  void pointAt(const QRect& target);
  void takeFocus();
  [[nodiscard]] QString title() const;

 signals:
  void nextWanted();
  void backWanted();
  void endWanted();

 protected:
  void paintEvent(QPaintEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  enum class Tip { None, Left, Right, Top, Bottom };
  [[nodiscard]] QPoint placeFor(Tip, const QRect& target) const;

  QLabel *title_, *text_, *where_;
  QPushButton *skip_, *back_, *next_;
  Tip tip_ = Tip::None;
  int tipAt_ = 0;  // along the side it sits on
};

}  // namespace blossom::ui
