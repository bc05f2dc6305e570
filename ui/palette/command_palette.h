#pragma once
#include <QFrame>
#include <QPointer>
#include <vector>

#include "ui/palette/palette_model.h"

class QLabel;
class QLineEdit;
class QListView;

namespace blossom::ui {

/// Finds commands and other entries by a few letters: opens above the window, closes with Esc or a click elsewhere.
class CommandPalette : public QFrame {
  Q_OBJECT
 public:
  explicit CommandPalette(QWidget* window);
  void addSource(PaletteSource);  ///< called each time the palette opens
  void open();
  void dismiss();
  [[nodiscard]] QLineEdit* field() { return field_; }
  [[nodiscard]] const PaletteModel& model() const { return *model_; }

 signals:
  void hint(const QString&);

 protected:
  bool eventFilter(QObject*, QEvent*) override;
  void hideEvent(QHideEvent*) override;

 private:
  void place();
  void refresh(const QString& pattern);
  void step(int by);
  void run(const QModelIndex&);
  void tellHint(const QModelIndex&);

  QWidget* window_;
  QLineEdit* field_;
  QListView* list_;
  QLabel* nothing_;
  PaletteModel* model_;
  std::vector<PaletteSource> sources_;
  QPointer<QWidget> before_;  // had the focus
};

}  // namespace blossom::ui
