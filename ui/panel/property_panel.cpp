#include "ui/panel/property_panel.h"

#include <QLabel>
#include <QVBoxLayout>
#include <algorithm>

#include "app/reference_page.h"
#include "ui/look/text.h"
#include "ui/panel/feature_header.h"
#include "ui/panel/input_editor.h"
#include "ui/panel/input_slots.h"
#include "ui/panel/parameter_field.h"
#include "ui/panel/result_table.h"
#include "ui/tool.h"
#include "ui/window/session.h"

namespace blossom::ui {

namespace {

QLabel* styled(const QString& text, const char* name) {
  auto* label = new QLabel(text);
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  return label;
}

/// "height must be ..", "x of height must be ..", "item 2 of heights must ..".
bool isAbout(const QString& message, const QString& parameter) {
  for (qsizetype at = message.indexOf(parameter, 0, Qt::CaseInsensitive); at >= 0;
       at = message.indexOf(parameter, at + 1, Qt::CaseInsensitive)) {
    const QString before = message.left(at), after = message.mid(at + parameter.size());
    const bool starts = before.isEmpty() || before == QLatin1String("The ") || before.endsWith(QLatin1String(" of ")) ||
                        before.endsWith(u'"');
    const bool ends = after.isEmpty() || !after.front().isLetterOrNumber();
    if (starts && ends && !before.contains(QLatin1String(" must "))) return true;
  }
  return false;
}

}  // namespace

PropertyPanel::PropertyPanel(Session& session, QWidget* parent)
    : QScrollArea(parent), session_(session), context_(std::make_shared<FieldContext>()), result_(new ResultTable(this)) {
  context_->picking = true;
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFrameShape(NoFrame);
  setFocusPolicy(Qt::NoFocus);
  connect(&session, &Session::documentChanged, this, [this] { show(shown_); });
  connect(&session, &Session::viewChanged, this, [this](const QString& feature) {
    if (feature.toStdString() == shown_) return refreshResult();
    // The kind of another feature's result may tell which inputs it fits.
    for (InputEditor* input : inputs_) input->refresh();
  });
  connect(&session, &Session::evaluationFinished, this, &PropertyPanel::sendPreview);
  connect(result_, &ResultTable::copied, this, &PropertyPanel::hint);
  rebuild();
}

void PropertyPanel::show(const FeatureId& id) {
  const FeatureId wanted = session_.document().contains(id) ? id : FeatureId();
  const std::string type = wanted.empty() ? std::string() : session_.document().at(wanted).type;
  const bool same = wanted == shown_ && type == shownType_;
  if (!same) leave();
  shown_ = wanted;
  shownType_ = type;
  if (same && !wanted.empty()) {
    refreshFields();
    refreshResult();
  } else {
    rebuild();
  }
}

// What is still typed belongs to the feature shown before; what is dragged was not let go.
void PropertyPanel::leave() {
  if (previewed_) revert();
  QWidget* focused = widget() ? widget()->focusWidget() : nullptr;
  if (focused && session_.document().contains(shown_)) focused->clearFocus();
}

ParameterField* PropertyPanel::field(const QString& parameter) const {
  for (ParameterField* field : fields_)
    if (qt(field->spec().name) == parameter) return field;
  return nullptr;
}

InputEditor* PropertyPanel::input(const QString& name) const {
  for (InputEditor* input : inputs_)
    if (input->objectName() == QStringLiteral("input:") + name) return input;
  return nullptr;
}

// A field that goes away loses the focus, and what is typed in it would be told then.
void PropertyPanel::muteEditors() {
  for (ParameterField* field : fields_) field->disconnect(this);
  for (InputEditor* input : inputs_) input->disconnect(this);
  if (header_) header_->disconnect(this);
}

PropertyPanel::~PropertyPanel() { muteEditors(); }

void PropertyPanel::rebuild() {
  endPick();
  muteEditors();
  fields_.clear();
  inputs_.clear();
  header_ = nullptr;
  result_->hide();
  result_->setParent(this);  // it stays, for its rows take longer to make than to fill
  previewed_ = faulty_ = nullptr;
  waiting_.reset();
  auto* content = new QWidget;
  content->setObjectName(QStringLiteral("propertyContent"));
  column_ = new QVBoxLayout(content);
  column_->setContentsMargins(16, 12, 16, 16);
  column_->setSpacing(7);
  if (shown_.empty()) {
    addTitle(tr("PROPERTIES"));
    column_->addWidget(styled(session_.document().features().empty()
                                  ? tr("Nothing is open yet.")
                                  : tr("Select a feature to see what it is made from and what it came to."),
                              "note"));
  } else {
    addFeature(session_.document().at(shown_));
    refreshFields();
    refreshResult();
  }
  column_->addStretch();
  if (QWidget* before = takeWidget()) {
    before->hide();
    before->deleteLater();  // one of its buttons may have been clicked
  }
  setWidget(content);  // at last, for what is hidden yet is laid out only once
}

void PropertyPanel::addTitle(const QString& text) {
  auto* title = styled(text, "sectionTitle");
  title->setMinimumHeight(20);
  column_->addWidget(title);
}

void PropertyPanel::addFeature(const Feature& feature) {
  type_ = session_.app().registry->find(feature.type);
  header_ = new FeatureHeader;
  if (type_)
    header_->setType(qt(type_->title), qt(type_->summary), qt(referencePageName(type_->id)));
  else
    header_->setProblem(tr("The plugin that makes \"%1\" is not installed.").arg(qt(feature.type)));
  connect(header_, &FeatureHeader::renamed, this, &PropertyPanel::rename);
  connect(header_, &FeatureHeader::manualWanted, this, &PropertyPanel::manualWanted);
  column_->addWidget(header_);
  if (type_ && !type_->inputs.empty()) addInputs();
  if (type_ && !type_->parameters.empty()) addParameters();
  addResult();
}

void PropertyPanel::addInputs() {
  column_->addSpacing(4);
  addTitle(tr("INPUTS"));
  for (std::size_t spec = 0; spec < type_->inputs.size(); ++spec) {
    auto* input = new InputEditor(session_, shown_, type_, spec);
    connect(input, &InputEditor::hint, this, &PropertyPanel::hint);
    connect(input, &InputEditor::pickWanted, this,
            [this](InputEditor* from, const PickRequest& request) { wantPick(nullptr, from, request); });
    connect(input, &InputEditor::pickUnwanted, this, [this](InputEditor* from) {
      if (from == pickingInput_) endPick();
    });
    column_->addWidget(input);
    inputs_.push_back(input);
  }
}

void PropertyPanel::addParameters() {
  column_->addSpacing(4);
  addTitle(tr("PROPERTIES"));
  for (const ParameterSpec& spec : type_->parameters) {
    ParameterField* field = ParameterField::make(spec, nullptr, context_);
    connectField(field);
    column_->addWidget(field);
    fields_.push_back(field);
  }
}

void PropertyPanel::connectField(ParameterField* field) {
  connect(field, &ParameterField::edited, this, [this, field](const Value& value) { commit(field, value); });
  connect(field, &ParameterField::previewed, this, [this, field](const Value& value) { preview(field, value); });
  connect(field, &ParameterField::reverted, this, &PropertyPanel::revert);
  connect(field, &ParameterField::hint, this, &PropertyPanel::hint);
  connect(field, &ParameterField::pickWanted, this, [this, field](ParameterField* from, PickRequest request) {
    const QString name = qt(field->spec().name);
    request.parameter = request.parameter.isEmpty() ? name : name + u'/' + request.parameter;
    wantPick(from, nullptr, request);
  });
  connect(field, &ParameterField::pickUnwanted, this, [this](ParameterField* from) {
    if (from == pickingField_) endPick();
  });
}

void PropertyPanel::addResult() {
  column_->addSpacing(6);
  addTitle(tr("RESULT"));
  column_->addWidget(result_);
  result_->setVisible(true);
}

/// Sub-shapes are named after the features that stand in the inputs now.
void PropertyPanel::refreshContext() {
  const InputSlots taken(session_, session_.document().at(shown_), *type_);
  std::vector<FieldContext::Source> sources;
  for (std::size_t k = 0; k < type_->inputs.size(); ++k)
    for (const FeatureId& id : taken.of(k)) {
      const bool first = sources.empty() || sources.back().input != type_->inputs[k].name;
      if (first) sources.push_back({type_->inputs[k].name, id, qt(shownName(session_.document().at(id)))});
    }
  context_->sources = std::move(sources);
}

void PropertyPanel::refreshFields() {
  const Feature& feature = session_.document().at(shown_);
  header_->setName(qt(shownName(feature)));
  if (!type_) return;
  refreshContext();
  for (InputEditor* input : inputs_) input->refresh();
  for (ParameterField* field : fields_) {
    if (field == previewed_) continue;  // what is dragged is ahead of the document
    const auto given = feature.parameters.find(field->spec().name);
    const Value value = given == feature.parameters.end() || given->is_null() ? field->spec().fallback : *given;
    // What is being typed, and what is wrong with it, stays until the value really changes.
    const bool busy = field->editing() || !field->problem().isEmpty();
    if (!busy || field->value() != value) field->setValue(value);
  }
}

void PropertyPanel::refreshResult() {
  if (shown_.empty()) return;
  std::vector<std::string> besides;  // what is set above need not be told below
  for (const ParameterField* field : fields_) besides.push_back(field->spec().name);
  const auto view = session_.view(shown_);
  result_->show(view.get(), besides);
  showFault();
}

// An error that names a parameter is shown where that parameter is.
void PropertyPanel::showFault() {
  if (faulty_ && faulty_->problem() == fault_) faulty_->setFault({});
  faulty_ = nullptr;
  const auto view = session_.view(shown_);
  if (!view || !view->result->error || view->result->error->code() != ErrorCode::InvalidParameter) return;
  const QString message = qt(view->result->error->message());
  const auto named = std::find_if(fields_.begin(), fields_.end(), [&](const ParameterField* field) {
    return isAbout(message, qt(label(field->spec()))) || isAbout(message, qt(field->spec().name));
  });
  if (named == fields_.end() || !(*named)->problem().isEmpty()) return;
  faulty_ = *named;
  fault_ = sentenceCase(message);
  faulty_->setFault(fault_);
}

}  // namespace blossom::ui
