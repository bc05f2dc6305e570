#pragma once
#include "document/recovery_area.h"
#include "ui/look/passing_bar.h"

class QLabel;
class QPushButton;
class QVBoxLayout;

namespace blossom::ui {

/// Offers, above the documents, the unsaved documents of an earlier run. When dismissed, it offers them again at the next
/// start.
class RecoveryBar : public PassingBar {
  Q_OBJECT
 public:
  explicit RecoveryBar(QWidget* parent = nullptr);

 signals:
  void recoverWanted(const blossom::LostDocument&);

 private:
  void refresh();
  QWidget* row(const LostDocument&);
  QLabel* message_;
  QVBoxLayout* rows_;
  QPushButton* all_;
};

}  // namespace blossom::ui
