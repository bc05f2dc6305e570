#pragma once
#include <QCoreApplication>
#include <QStringList>

#include "ui/fields/parameter_field.h"

class QLineEdit;

namespace blossom::ui {

/// A file: chosen, dropped or written as a path.
class FileField final : public ParameterField {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::FileField)
 public:
  FileField(const ParameterSpec&, const Context&, QWidget* parent);
  [[nodiscard]] bool editing() const override;
  void choose();

 protected:
  void dragEnterEvent(QDragEnterEvent*) override;
  void dropEvent(QDropEvent*) override;

 private:
  void display(const Value&) override;
  void take(const QString& path);
  [[nodiscard]] QStringList extensions() const;

  QLineEdit* line_;
};

}  // namespace blossom::ui
