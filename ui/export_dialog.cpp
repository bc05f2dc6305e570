#include "ui/export_dialog.h"

#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "ui/parameter_field.h"
#include "ui/text.h"

namespace blossom::ui {

ExportDialog::ExportDialog(const Format& format, const QString& file, QWidget* parent) : QDialog(parent) {
  setWindowTitle(tr("Export %1").arg(QFileInfo(file).fileName()));
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(22, 20, 22, 18);
  all->setSpacing(10);
  auto* title = new QLabel(qt(format.title));
  title->setObjectName(QStringLiteral("featureName"));
  all->addWidget(title);
  for (const ParameterSpec& spec : format.writeOptions) {
    ParameterField* field = ParameterField::make(spec, this);
    field->setValue(spec.fallback);
    fields_.push_back(field);
    all->addWidget(field);
  }
  all->addSpacing(8);
  auto* buttons = new QHBoxLayout;
  auto* cancel = new QPushButton(tr("Cancel"));
  auto* go = new QPushButton(tr("Export"));
  go->setProperty("primary", true);
  go->setDefault(true);
  connect(cancel, &QPushButton::clicked, this, &QDialog::reject);
  connect(go, &QPushButton::clicked, this, &QDialog::accept);
  buttons->addStretch();
  buttons->addWidget(cancel);
  buttons->addWidget(go);
  all->addLayout(buttons);
  setMinimumWidth(380);
}

Value ExportDialog::options() const {
  Value values = Value::object();
  for (const ParameterField* field : fields_)
    if (!field->value().is_null()) values[field->spec().name] = field->value();
  return values;
}

}  // namespace blossom::ui
