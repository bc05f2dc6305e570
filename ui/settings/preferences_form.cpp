#include "ui/settings/preferences_form.h"

#include <QLabel>
#include <QVBoxLayout>

#include "ui/fields/parameter_field.h"
#include "ui/look/text.h"

namespace blossom::ui {

PreferencesForm::PreferencesForm(const PreferenceGroup& group, QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("preferencesForm"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(24, 22, 24, 22);
  column->setSpacing(4);
  auto* title = new QLabel(group.title);
  title->setObjectName(QStringLiteral("featureName"));
  column->addWidget(title);
  column->addSpacing(8);
  for (const ParameterSpec& spec : group.specs) add(spec);
  column->addStretch(1);
  connect(&Preferences::instance(), &Preferences::changed, this, [this](const QString& name) {
    for (ParameterField* field : fields_) {
      const bool otherUnit = name == QLatin1String("length-unit") && field->spec().kind == ParameterKind::Length;
      if (otherUnit || qt(field->spec().name) == name) field->setValue(Preferences::instance().value(field->spec().name));
    }
  });
}

void PreferencesForm::add(const ParameterSpec& spec) {
  ParameterField* field = ParameterField::make(spec, this);
  field->setValue(Preferences::instance().value(spec.name));
  connect(field, &ParameterField::edited, this,
          [name = spec.name](const Value& value) { Preferences::instance().set(name, value); });
  connect(field, &ParameterField::hint, this, &PreferencesForm::hint);
  auto* help = new QLabel(qt(spec.help));
  help->setObjectName(QStringLiteral("note"));
  help->setWordWrap(true);
  auto* column = static_cast<QVBoxLayout*>(layout());
  column->addWidget(field);
  column->addWidget(help);
  column->addSpacing(12);
  fields_.push_back(field);
}

}  // namespace blossom::ui
