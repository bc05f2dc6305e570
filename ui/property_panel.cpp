#include "ui/property_panel.h"

#include <QGridLayout>
#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/parameter_field.h"
#include "ui/session.h"
#include "ui/text.h"

namespace blossom::ui {

namespace {

QLabel* styled(const QString& text, const char* name) {
  auto* label = new QLabel(text);
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  return label;
}

// {"LINE": 29, "ARC": 3} reads "29 LINE, 3 ARC".
QString statText(const Value& value) {
  if (value.is_structured()) {
    QStringList parts;
    for (const auto& [name, part] : value.items())
      parts << (value.is_object() ? counted(statText(part), qt(name).replace(u'_', u' ')) : statText(part));
    return parts.join(QStringLiteral(", "));
  }
  if (value.is_boolean()) return value.get<bool>() ? PropertyPanel::tr("yes") : PropertyPanel::tr("no");
  if (value.is_number_integer()) return readable(value.get<std::int64_t>());
  if (value.is_number()) return readable(value.get<double>());
  return value.is_string() ? qt(value.get<std::string>()) : qt(value.dump());
}

}  // namespace

PropertyPanel::PropertyPanel(Session& session, QWidget* parent) : QScrollArea(parent), session_(session) {
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFrameShape(NoFrame);
  connect(&session, &Session::documentChanged, this, [this] { show(shown_); });
  connect(&session, &Session::viewChanged, this, [this](const QString& feature) {
    if (feature.toStdString() == shown_) refreshResult();
  });
  rebuild();
}

void PropertyPanel::show(const FeatureId& id) {
  const FeatureId wanted = session_.document().contains(id) ? id : FeatureId();
  const std::string type = wanted.empty() ? std::string() : session_.document().at(wanted).type;
  const bool same = wanted == shown_ && type == shownType_;
  shown_ = wanted;
  shownType_ = type;
  if (same && !wanted.empty()) {
    refreshFields();
    refreshResult();
  } else {
    rebuild();
  }
}

ParameterField* PropertyPanel::field(const QString& parameter) const {
  for (ParameterField* field : fields_)
    if (qt(field->spec().name) == parameter) return field;
  return nullptr;
}

void PropertyPanel::rebuild() {
  fields_.clear();
  result_ = nullptr;
  auto* content = new QWidget;
  content->setObjectName(QStringLiteral("propertyContent"));
  column_ = new QVBoxLayout(content);
  column_->setContentsMargins(16, 14, 16, 16);
  column_->setSpacing(9);
  if (shown_.empty()) {
    column_->addWidget(styled(tr("PROPERTIES"), "sectionTitle"));
    column_->addWidget(styled(session_.document().features().empty()
                                  ? tr("Nothing is open yet.")
                                  : tr("Select a feature to see what it is made from and what it came to."),
                              "note"));
  } else {
    addParameters(session_.document().at(shown_));
    column_->addSpacing(8);
    column_->addWidget(styled(tr("RESULT"), "sectionTitle"));
    result_ = new QWidget;
    resultColumn_ = new QVBoxLayout(result_);
    resultColumn_->setContentsMargins(0, 0, 0, 0);
    resultColumn_->setSpacing(6);
    column_->addWidget(result_);
  }
  column_->addStretch();
  setWidget(content);
  refreshResult();
}

void PropertyPanel::addParameters(const Feature& feature) {
  const auto type = session_.app().registry->find(feature.type);
  name_ = styled(qt(feature.name), "featureName");
  column_->addWidget(name_);
  column_->addWidget(
      styled(type ? qt(type->summary) : tr("The plugin that makes \"%1\" is not installed.").arg(qt(feature.type)),
             type ? "featureSummary" : "problem"));
  if (!type || type->parameters.empty()) return;
  column_->addSpacing(6);
  column_->addWidget(styled(tr("PROPERTIES"), "sectionTitle"));
  for (const ParameterSpec& spec : type->parameters) {
    ParameterField* field = ParameterField::make(spec, nullptr);
    connect(field, &ParameterField::edited, this,
            [this, name = spec.name](const Value& value) { change(name, value, false); });
    connect(field, &ParameterField::previewed, this,
            [this, name = spec.name](const Value& value) { change(name, value, true); });
    connect(field, &ParameterField::hint, this, &PropertyPanel::hint);
    column_->addWidget(field);
    fields_.push_back(field);
  }
  refreshFields();
}

void PropertyPanel::refreshFields() {
  const Feature& feature = session_.document().at(shown_);
  name_->setText(qt(feature.name));
  for (ParameterField* field : fields_) {
    const auto given = feature.parameters.find(field->spec().name);
    const Value value = given == feature.parameters.end() || given->is_null() ? field->spec().fallback : *given;
    // A field that says what is wrong keeps saying it until its value really changes.
    if (field->problem().isEmpty() || field->value() != value) field->setValue(value);
  }
}

void PropertyPanel::change(const std::string& parameter, const Value& value, bool preview) {
  Feature feature = session_.document().at(shown_);
  feature.parameters[parameter] = value;
  if (preview) {
    session_.preview(session_.document().with(feature));
    return;
  }
  ParameterSpec named;
  named.name = parameter;
  session_.commit(session_.document().with(feature), tr("Change %1 of %2").arg(qt(label(named)), qt(feature.name)));
}

void PropertyPanel::addResult(const QString& name, const QString& value) {
  const int row = resultGrid_->rowCount();
  auto* title = new QLabel(name);
  title->setObjectName(QStringLiteral("resultName"));
  resultGrid_->addWidget(title, row, 0, Qt::AlignTop);
  auto* number = new QLabel(value);
  number->setAlignment(Qt::AlignRight);
  number->setWordWrap(true);
  number->setTextInteractionFlags(Qt::TextSelectableByMouse);
  resultGrid_->addWidget(number, row, 1);
}

void PropertyPanel::addWords(const QString& text, const char* style) { resultColumn_->addWidget(styled(text, style)); }

void PropertyPanel::refreshResult() {
  if (!result_) return;
  while (QLayoutItem* item = resultColumn_->takeAt(0)) {
    if (QWidget* widget = item->widget()) {
      widget->hide();
      widget->deleteLater();
    }
    delete item;
  }
  const auto view = session_.view(shown_);
  if (!view) return addWords(tr("Computing…"), "note");
  const FeatureResult& result = *view->result;
  if (result.error) {
    addWords(qt(result.error->message()), "problem");
    if (!result.error->hint().empty()) addWords(qt(result.error->hint()), "note");
    return;
  }
  auto* table = new QWidget;
  resultGrid_ = new QGridLayout(table);
  resultGrid_->setContentsMargins(0, 0, 0, 0);
  resultGrid_->setVerticalSpacing(5);
  resultGrid_->setHorizontalSpacing(12);
  resultGrid_->setColumnStretch(1, 1);
  addResult(tr("Kind"), qt(view->measures.kind));
  for (const Measure& measure : view->measures.values) addResult(measureLabel(measure.name), readable(measure));
  const auto measured = [&](const std::string& name) {
    return std::any_of(view->measures.values.begin(), view->measures.values.end(),
                       [&](const Measure& m) { return m.name == name; });
  };
  const auto given = [&](const std::string& name) { return field(qt(name)) != nullptr; };  // stands above already
  for (const auto& [name, value] : result.evaluated.stats.items())
    if (!measured(name) && !given(name) && worthReading(name, value))
      addResult(measureLabel(name), statText(value) + statUnit(name));
  addResult(tr("Time"),
            result.fromCache || result.kernelMs == 0 ? tr("from the cache") : tr("%1 ms").arg(readable(result.kernelMs, 3)));
  resultColumn_->addWidget(table);
  for (const std::string& warning : result.evaluated.warnings) addWords(qt(warning), "warning");
}

}  // namespace blossom::ui
