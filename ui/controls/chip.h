#pragma once
#include <QIcon>
#include <QWidget>

namespace blossom::ui {

/// A chip with the name of a chosen object and a cross that removes it. With the focus, Delete removes it and Enter acts
/// like a click.
class Chip final : public QWidget {
  Q_OBJECT
 public:
  explicit Chip(const QString& text, QWidget* parent = nullptr);
  void setIconName(const QString&);
  void setRemovable(bool);
  void setChevron(bool);  ///< shows the sign for a menu
  /// Marks what cannot be used, with the reason as a tooltip; empty: no mark.
  void setProblem(const QString&);
  [[nodiscard]] const QString& problem() const { return problem_; }
  [[nodiscard]] const QString& text() const { return text_; }
  [[nodiscard]] QString shownText() const;  ///< the text, elided when there is no room for it
  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;

 signals:
  void clicked();
  void removed();
  void pointedAt(bool);  ///< the mouse has come, or has left

 protected:
  bool event(QEvent*) override;
  void paintEvent(QPaintEvent*) override;
  void mousePressEvent(QMouseEvent*) override;
  void keyPressEvent(QKeyEvent*) override;
  void enterEvent(QEnterEvent*) override;
  void leaveEvent(QEvent*) override;

 private:
  [[nodiscard]] QRect crossArea() const;
  [[nodiscard]] int besideText() const;  ///< pixels not available to the text
  QString text_;
  QString icon_;
  QString problem_;
  bool removable_ = true;
  bool chevron_ = false;
};

}  // namespace blossom::ui
