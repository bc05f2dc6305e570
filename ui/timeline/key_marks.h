#pragma once
#include <QWidget>
#include <optional>
#include <vector>

namespace blossom::ui {

class GrooveSlider;

/// The keys of a sequence as marks over the slider of the timeline. They are dragged to other frames, Esc gives that up; a
/// click shows the frame, Delete or a right click removes the key, a double click beside them sets one. Arrow keys move the
/// one that was clicked.
class KeyMarks final : public QWidget {
  Q_OBJECT
 public:
  explicit KeyMarks(const GrooveSlider&, QWidget* parent = nullptr);

  /// @param frames of each key, counted from 1, in any order
  /// @param count frames of the sequence; marks after the last are not shown
  void setKeys(std::vector<int> frames, int count);
  [[nodiscard]] const std::vector<int>& frames() const { return frames_; }
  /// The middle of the mark at a frame.
  [[nodiscard]] QPoint placeOf(int frame) const;
  [[nodiscard]] QSize sizeHint() const override { return {100, 12}; }

 signals:
  void dragged(int key, int frame);  ///< numbers of keys are those of setKeys
  void moved(int key, int frame);
  void reverted();
  void clicked(int frame);
  void removed(int key);
  void added(int frame);

 protected:
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void mouseDoubleClickEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;
  void hideEvent(QHideEvent*) override;
  bool event(QEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  void giveUp();
  [[nodiscard]] double pixelOf(int frame) const;
  [[nodiscard]] int frameAt(double pixel) const;
  [[nodiscard]] std::optional<std::size_t> keyAt(double pixel) const;
  /// As near to a frame as the marks beside it allow.
  [[nodiscard]] int roomFor(std::size_t key, int frame) const;

  const GrooveSlider& slider_;
  std::vector<int> frames_;
  int count_ = 0;
  std::optional<std::size_t> chosen_, under_, held_;
  int heldFrom_ = 0;
};

}  // namespace blossom::ui
