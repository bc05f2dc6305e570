#include "ui/fields/record_field.h"

#include <QVBoxLayout>
#include <algorithm>
#include <cmath>

#include "parameter/start_value.h"
#include "ui/controls/field_label.h"
#include "ui/controls/switch_box.h"
#include "ui/look/registry_text.h"
#include "ui/look/text.h"
#include "ui/look/units.h"

namespace blossom::ui {

namespace {

constexpr int indent = 10;

}  // namespace

RecordField::RecordField(const ParameterSpec& given, const Context& outside, QWidget* parent)
    : ParameterField(given, outside, parent), body_(new QWidget) {
  body_->setObjectName(QStringLiteral("fieldGroup"));
  auto* column = new QVBoxLayout(body_);
  column->setContentsMargins(indent, 2, 0, 2);
  column->setSpacing(7);
  for (const ParameterSpec& field : given.fields) addField(field);
  if (given.mayBeAbsent && given.fallback.is_null()) {
    switch_ = new SwitchBox;
    connect(switch_, &QCheckBox::clicked, this, [this](bool on) { offer(on ? startValue(spec()) : Value()); });
  }
  setWideEditor(body_, switch_);
}

void RecordField::addField(const ParameterSpec& given) {
  ParameterField* field = make(given, nullptr, context());
  field->indentLabel(indent);
  body_->layout()->addWidget(field);
  fields_.push_back(field);
  const std::string name = given.name;
  connect(field, &ParameterField::edited, this, [this, name](const Value& part) {
    draft_ = with(name, part);
    offer(draft_);
  });
  connect(field, &ParameterField::previewed, this, [this, name](const Value& part) { offer(with(name, part), true); });
  connect(field, &ParameterField::reverted, this, &RecordField::revert);
  connect(field, &ParameterField::hint, this, &RecordField::hint);
  connect(field, &ParameterField::pickUnwanted, this, &RecordField::pickUnwanted);
  connect(field, &ParameterField::pickWanted, this, [this, name](ParameterField* from, PickRequest request) {
    request.parameter = request.parameter.isEmpty() ? qt(name) : qt(name) + u'/' + request.parameter;
    emit pickWanted(from, request);
  });
}

Value RecordField::with(const std::string& name, const Value& part) const {
  Value whole = draft_.is_object() ? draft_ : startValue(spec());
  whole[name] = part;
  return whole;
}

bool RecordField::editing() const {
  return ParameterField::editing() ||
         std::any_of(fields_.begin(), fields_.end(), [](const ParameterField* field) { return field->editing(); });
}

Value RecordField::written() const {
  Value whole = value();
  if (!whole.is_object()) return whole;
  for (const ParameterField* field : fields_)
    if (whole.contains(field->spec().name)) whole[field->spec().name] = field->written();
  return whole;
}

void RecordField::setWritten(const Value& given) {
  for (ParameterField* field : fields_) {
    const bool there = given.is_object() && given.contains(field->spec().name);
    field->setWritten(there ? given.at(field->spec().name) : Value());
  }
}

void RecordField::showAsItem() {
  hideLabel();
  body_->setProperty("item", true);
}

void RecordField::display(const Value& shown) {
  draft_ = shown;
  if (switch_) switch_->setChecked(!shown.is_null());
  body_->setVisible(!switch_ || !shown.is_null());
  for (ParameterField* field : fields_) {
    const auto found = shown.is_object() ? shown.find(field->spec().name) : shown.end();
    const bool given = shown.is_object() && found != shown.end() && !found->is_null();
    field->setValue(given ? *found : field->spec().fallback);
  }
}

namespace {

// Enough to tell items apart; the fields have all digits.
constexpr int summaryDigits = 3;

QString coordinatesText(const ParameterSpec& field, const Value& value) {
  const double unit = field.kind == ParameterKind::Vector ? 1 : lengthUnit().millimetres;
  double largest = 0;
  for (const Value& each : value) largest = std::max(largest, std::abs(each.get<double>()));
  QStringList parts;
  for (const Value& each : value) parts << readable(withoutNoise(each.get<double>(), largest) / unit, summaryDigits);
  return parts.join(QStringLiteral(", "));
}

// What has no unit needs its name.
QString summaryText(const ParameterSpec& field, const Value& value) {
  using enum ParameterKind;
  switch (field.kind) {
    case Number:
    case Ratio:
      if (!value.is_number()) return {};
      return registryText(label(field)) + u' ' + readable(value.get<double>(), summaryDigits);
    case Point:
    case Vector:
    case Displacement:
      if (!value.is_array()) return {};
      return registryText(label(field)) + u' ' + coordinatesText(field, value);
    case Flag:
    case Count:
      return registryText(label(field)) + u' ' + displayText(field, value);
    case List:
    case Record:
    case Curve:
    case SubShape:
      return {};
    default:
      return displayText(field, value);
  }
}

}  // namespace

QString summaryOf(const ParameterSpec& record, const Value& value) {
  QStringList parts;
  for (const ParameterSpec& field : record.fields) {
    if (!value.is_object() || !value.contains(field.name) || parts.size() == 3) continue;
    const QString text = summaryText(field, value.at(field.name));
    if (!text.isEmpty()) parts << text;
  }
  return parts.join(QStringLiteral(" · "));
}

}  // namespace blossom::ui
