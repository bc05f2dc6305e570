#pragma once
#include <QWidget>
#include <optional>
#include <vector>

namespace blossom::ui {

/// One line of results: a name, and either a number with its unit or a text.
struct ResultRow {
  QString name, number, unit;
  QString text;  ///< instead of number and unit
  QString copy;  ///< text copied by a click on the value: all digits
  [[nodiscard]] QString value() const { return text.isEmpty() ? number : text; }
};

/// Results as aligned names and values, painted by one widget: a label per cell would take twenty times as long to fill, and
/// results arrive many times a second during a drag. A click on a value copies it.
class ResultRows final : public QWidget {
  Q_OBJECT
 public:
  explicit ResultRows(QWidget* parent);

  void setRows(std::vector<ResultRow>);
  void setOutdated(bool);  ///< values in grey
  [[nodiscard]] bool outdated() const { return outdated_; }
  [[nodiscard]] const std::vector<ResultRow>& rows() const { return rows_; }
  /// Rectangle of the value of a row, with its unit, in this widget.
  [[nodiscard]] QRect valueRect(std::size_t row) const;

  [[nodiscard]] QSize sizeHint() const override;
  [[nodiscard]] QSize minimumSizeHint() const override;
  [[nodiscard]] bool hasHeightForWidth() const override { return true; }
  [[nodiscard]] int heightForWidth(int width) const override;

 signals:
  void copied(const QString& what);

 protected:
  bool event(QEvent*) override;
  void paintEvent(QPaintEvent*) override;
  void mouseMoveEvent(QMouseEvent*) override;
  void mouseReleaseEvent(QMouseEvent*) override;
  void leaveEvent(QEvent*) override;
  void contextMenuEvent(QContextMenuEvent*) override;
  void changeEvent(QEvent*) override;

 private:
  void measureColumns();
  [[nodiscard]] int heightOf(const ResultRow&, int width) const;
  [[nodiscard]] int valueWidth() const;
  [[nodiscard]] int valueLeft(int width) const;
  [[nodiscard]] QString shownName(std::size_t row) const;
  [[nodiscard]] QString fullNameAt(QPoint) const;
  [[nodiscard]] std::optional<std::size_t> rowAt(QPoint) const;
  void hover(std::optional<std::size_t>);
  void copy(const QString& text, const QString& told);

  std::vector<ResultRow> rows_;
  int names_ = 0, numbers_ = 0, units_ = 0;  ///< widths of the columns
  std::optional<std::size_t> hovered_;
  bool outdated_ = false;
};

}  // namespace blossom::ui
