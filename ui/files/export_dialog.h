#pragma once
#include <QDialog>
#include <vector>

#include "document/document.h"
#include "exchange/format/format.h"

class QComboBox;
class QLabel;
class QPushButton;
class QVBoxLayout;

namespace blossom::ui {

class FittingScroll;
class ParameterField;

/// A selection that can be exported as one file, or a sequence as one file per frame.
struct ExportScope {
  QString title;
  std::vector<FeatureId> features;
  ShapeKind kind = ShapeKind::None;     ///< kind of all combined; None: they cannot be stored in one file
  std::vector<ShapeKind> frameKinds{};  ///< kinds of the frames of a sequence, which may be stored in separate files
};

/// Chooses what is exported, the format and its declared options. Format and options of the previous export are preselected.
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  /// @pre some scope can be written in some format
  ExportDialog(const FormatRegistry&, std::vector<ExportScope>, QWidget* parent = nullptr);
  [[nodiscard]] const ExportScope& scope() const;
  [[nodiscard]] const Format& format() const;
  [[nodiscard]] Value options() const;
  void choose(const QString& formatId);
  void remember() const;  ///< stores the choices for the next export
  void accept() override;

 private:
  void fillFormats();
  void fillOptions();
  void orderTabs();
  void fitToScreen();
  const FormatRegistry& formats_;
  std::vector<ExportScope> scopes_;
  QComboBox *what_, *format_;
  QVBoxLayout* rows_;
  FittingScroll* options_;
  QLabel* none_;
  QPushButton *cancel_, *go_;
  std::vector<ParameterField*> fields_;
};

/// The formats that can store the selection.
std::vector<const Format*> formatsFor(const FormatRegistry&, const ExportScope&);

}  // namespace blossom::ui
