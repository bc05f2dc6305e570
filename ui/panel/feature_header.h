#pragma once
#include <QWidget>

class QLabel;
class QLineEdit;
class QToolButton;

namespace blossom::ui {

/// Editable name of the feature, its type, and a button that opens its page of the manual.
class FeatureHeader final : public QWidget {
  Q_OBJECT
 public:
  explicit FeatureHeader(QWidget* parent = nullptr);
  void setName(const QString&);
  /// @param page of the manual; empty: there is none.
  void setType(const QString& title, const QString& summary, const QString& page);
  void setProblem(const QString&);  ///< shown instead of the type

 signals:
  void renamed(const QString&);
  void manualWanted(const QString& page);

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  QString given_, page_;
  QLineEdit* name_;
  QToolButton* manual_;
  QLabel* type_;
  QLabel* summary_;
};

}  // namespace blossom::ui
