#pragma once
#include <QIcon>
#include <QWidget>

namespace blossom::ui {

/// A taken thing by its name, with a cross to let go of it. With the focus, Delete lets go as well and Enter opens what a
/// click opens.
class Chip final : public QWidget {
  Q_OBJECT
 public:
  explicit Chip(const QString& text, QWidget* parent = nullptr);
  void setIconName(const QString&);
  void setRemovable(bool);
  void setChevron(bool);  ///< shows that a click opens something
  [[nodiscard]] const QString& text() const { return text_; }
  [[nodiscard]] QString shownText() const;  ///< its beginning where there is no room for all of it
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 signals:
  void clicked();
  void removed();

 protected:
  bool event(QEvent*) override;
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;

 private:
  [[nodiscard]] QRect crossArea() const;
  [[nodiscard]] int besideText() const;  ///< pixels that the text cannot take
  QString text_;
  QString icon_;
  bool removable_ = true;
  bool chevron_ = false;
};

}  // namespace blossom::ui
