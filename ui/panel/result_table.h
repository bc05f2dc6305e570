#pragma once
#include <QWidget>
#include <vector>

#include "ui/panel/result_rows.h"
#include "ui/session/display_cache.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace blossom::ui {

/// The result of a feature: its measures with aligned units, the statistics of its computation, the time and warnings; or
/// the error with its remedy. A click on a value copies it with all its digits.
class ResultTable final : public QWidget {
  Q_OBJECT
 public:
  explicit ResultTable(QWidget* parent = nullptr);
  /// @param besides names of figures shown elsewhere; a null FeatureView means that there is no result yet.
  /// @param outdated it is the result of an older document, and a new one is awaited.
  void show(const FeatureView*, const std::vector<std::string>& besides, bool outdated = false);
  /// Shows that the computation was cancelled, with a button that starts it.
  void showCancelled();
  [[nodiscard]] bool showsCancelled() const;

 signals:
  void copied(const QString& what);
  void computeWanted();

 private:
  void clear();
  void addRow(const QString& name, const QString& number, const QString& unit, const QString& copy);
  void addText(const QString& name, const QString& text);
  void addWords(const QString&, const char* style);
  void addResult(const FeatureView&, const std::vector<std::string>& besides);
  void addError(const Error&);

  QLabel* late_;  ///< says that the figures are outdated
  ResultRows* shown_;
  QVBoxLayout* words_;
  std::vector<ResultRow> rows_;  ///< being gathered
  std::vector<QLabel*> sentences_;
  QPushButton* compute_;
};

}  // namespace blossom::ui
