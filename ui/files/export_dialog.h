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

class ParameterField;

/// Something that can be exported as one file, or a sequence as one for each frame.
struct ExportScope {
  QString title;
  std::vector<FeatureId> features;
  ShapeKind kind = ShapeKind::None;       ///< of all together; None: they do not go into one file
  ShapeKind frameKind = ShapeKind::None;  ///< of every frame of a sequence, which may go into a file each
};

/// What is exported, in which format, and with which options, as the format declares them. The format that was used last and
/// its options come back.
class ExportDialog : public QDialog {
  Q_OBJECT
 public:
  /// @pre some scope can be written in some format
  ExportDialog(const FormatRegistry&, std::vector<ExportScope>, QWidget* parent = nullptr);
  [[nodiscard]] const ExportScope& scope() const;
  [[nodiscard]] const Format& format() const;
  [[nodiscard]] Value options() const;
  void choose(const QString& formatId);
  void remember() const;  ///< for the next time

 private:
  void fillFormats();
  void fillOptions();
  const FormatRegistry& formats_;
  std::vector<ExportScope> scopes_;
  QComboBox *what_, *format_;
  QVBoxLayout* rows_;
  QLabel* none_;
  QPushButton* go_;
  std::vector<ParameterField*> fields_;
};

/// The formats that can hold what is exported.
std::vector<const Format*> formatsFor(const FormatRegistry&, const ExportScope&);

}  // namespace blossom::ui
