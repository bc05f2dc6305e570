#pragma once
#include <QObject>
#include <QPointer>
#include <QString>
#include <functional>
#include <vector>

class QWidget;

namespace blossom::ui {

class TourBubble;
class TourFrame;

/// One step of the tour: the widget, its name and its purpose.
struct TourStep {
  QString title, text;
  std::function<QWidget*()> target;     ///< called at the start of the step; nullptr: the middle of the window
  std::function<bool()> isPassed = {};  ///< what it tells of is behind the user already; none: never
};

/// A tour of the window: a bubble beside one widget after the other. Enter or Right continues, Left goes back, Esc ends. The
/// keyboard goes back to what had it before or, when that is gone, to `home`.
class Tour : public QObject {
  Q_OBJECT
 public:
  Tour(QWidget* window, std::vector<TourStep>, std::function<QWidget*()> home = {});
  ~Tour() override;

  void start();
  void next();
  void back();
  void end();
  /// Something has changed in the window: a step that is passed by that gives way to the next, which leaves the keyboard
  /// where it is.
  void follow();
  [[nodiscard]] bool running() const;
  [[nodiscard]] std::size_t step() const { return step_; }
  [[nodiscard]] std::size_t steps() const { return all_.size(); }
  [[nodiscard]] TourBubble* bubble() const;

  /// Whether this user has seen the tour.
  static bool shownBefore();

 signals:
  void ended();

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  void show();
  void place();
  void skipPassed();
  void giveKeysBack();
  [[nodiscard]] QRect targetRect() const;
  QWidget* window_;
  std::vector<TourStep> all_;
  std::function<QWidget*()> home_;
  std::size_t step_ = 0;
  QPointer<TourBubble> bubble_;
  QPointer<TourFrame> frame_;
  QPointer<QWidget> before_;  // had the focus
};

}  // namespace blossom::ui
