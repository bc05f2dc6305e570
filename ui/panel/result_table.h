#pragma once
#include <QWidget>
#include <vector>

#include "ui/view/display_cache.h"

class QGridLayout;
class QLabel;
class QVBoxLayout;

namespace blossom::ui {

/// What a feature came to: its measures with their units in line, the figures of its computation, the time, warnings; or why
/// it failed and what to do. A click on a value copies it with all its digits.
class ResultTable final : public QWidget {
  Q_OBJECT
 public:
  explicit ResultTable(QWidget* parent = nullptr);
  /// @param besides names of figures that stand elsewhere already; nullptr: nothing is known yet.
  void show(const FeatureView*, const std::vector<std::string>& besides);

 signals:
  void copied(const QString& what);

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  struct Row {
    QLabel* name;
    QLabel* number;
    QLabel* unit;
    QLabel* text;  ///< instead of number and unit
    QString copy;
  };
  void addRow(const QString& name, const QString& number, const QString& unit, const QString& copy);
  void addText(const QString& name, const QString& text);
  Row& next(const QString& name);
  void addWords(const QString&, const char* style);
  void makeRows();
  void showResult(const FeatureView&, const std::vector<std::string>& besides);
  void showError(const Error&);
  void copyMenu(const Row&, const QPoint& at);
  [[nodiscard]] const Row* rowOf(const QObject*) const;

  QGridLayout* grid_;
  QVBoxLayout* words_;
  std::vector<Row> rows_;  // kept and filled anew, for results come many times a second while something is dragged
  std::size_t used_ = 0;
  std::vector<QLabel*> sentences_;
};

}  // namespace blossom::ui
