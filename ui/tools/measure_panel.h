#pragma once
#include "ui/tools/floating_panel.h"

class QGridLayout;
class QLabel;
class QListWidget;
class QToolButton;

namespace blossom::ui {

class Measurements;

/// The measurements as a list with the figures of the one selected; they can be copied and deleted.
class MeasurePanel : public FloatingPanel {
  Q_OBJECT
 public:
  MeasurePanel(Measurements& measurements, QWidget* view);

  void copy() const;  ///< copies the selected one to the clipboard
  void removeSelected();

 protected:
  bool eventFilter(QObject*, QEvent*) override;

 private:
  void build();
  void refresh();
  void showFigures();

  Measurements& measurements_;
  QListWidget* list_;
  QLabel *parts_, *empty_, *names_, *values_;
  QToolButton *copy_, *delete_, *clear_;
};

}  // namespace blossom::ui
