#pragma once
#include <QDialog>
#include <vector>

#include "exchange/format.h"

namespace blossom::ui {

class ParameterField;

/// The options of a format as it declares them. Not shown for a format without any.
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  ExportDialog(const Format&, const QString& file, QWidget* parent = nullptr);
  [[nodiscard]] Value options() const;

 private:
  std::vector<ParameterField*> fields_;
};

}  // namespace blossom::ui
