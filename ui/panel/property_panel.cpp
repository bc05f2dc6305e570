#include "ui/panel/property_panel.h"

#include <QLabel>
#include <QScrollBar>
#include <QVBoxLayout>
#include <algorithm>
#include <utility>

#include "app/reference_page.h"
#include "core/error.h"
#include "document/named_numbers.h"
#include "ui/controls/resting_line.h"
#include "ui/fields/parameter_field.h"
#include "ui/look/registry_text.h"
#include "ui/look/text.h"
#include "ui/panel/feature_header.h"
#include "ui/panel/field_of_error.h"
#include "ui/panel/input_editor.h"
#include "ui/panel/input_slots.h"
#include "ui/panel/result_table.h"
#include "ui/panel/shown_parameters.h"
#include "ui/plugin/tool.h"
#include "ui/session/session.h"
#include "ui/thread/refreshes.h"

namespace blossom::ui {

namespace {

QLabel* styled(const QString& text, const char* name, QWidget* parent) {
  auto* label = new QLabel(text, parent);
  label->setObjectName(QLatin1String(name));
  label->setWordWrap(true);
  return label;
}

QLabel* title(const QString& text, QWidget* parent) {
  QLabel* label = styled(text, "sectionTitle", parent);
  label->setMinimumHeight(20);
  return label;
}

}  // namespace

PropertyPanel::PropertyPanel(Session& session, QWidget* parent)
    : QScrollArea(parent), session_(session), context_(std::make_shared<FieldContext>()), result_(new ResultTable(this)) {
  provideParts();
  setWidgetResizable(true);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  setFrameShape(NoFrame);
  setFocusPolicy(Qt::NoFocus);
  restAfterEnter(this);
  buildColumn();
  connect(&session, &Session::documentChanged, this, [this] { show(shown_); });
  connect(&session, &Session::viewsChanged, this, &PropertyPanel::followViews);
  // In a turn of its own: the results that have come are shown first.
  connect(&session, &Session::evaluationFinished, this, &PropertyPanel::sendPreview, Qt::QueuedConnection);
  constexpr int restMs = 150;
  rest_.setSingleShot(true);
  rest_.setInterval(restMs);
  connect(&rest_, &QTimer::timeout, this, [this] {
    if (previewed_ && !waiting_) sendWhole(session_.document());
  });
  connect(&session, &Session::evaluationStarted, this, [this] {
    if (result_->showsCancelled()) refreshResult();
  });
  connect(&session, &Session::evaluationFinished, this, [this] {
    if (heldBack_ && !session_.coarse()) refreshResult();
  });
  connect(&session, &Session::evaluationOverdue, this, &PropertyPanel::refreshResult);
  connect(&session, &Session::evaluationCancelled, this, &PropertyPanel::refreshResult);
  connect(&picking_, &PanelPicking::begun, this, [this](const PickRequest& request) {
    emit hint(request.hint);
    emit pickWanted(request);
  });
  connect(&picking_, &PanelPicking::ended, this, &PropertyPanel::pickEnded);
  connect(result_, &ResultTable::copied, this, &PropertyPanel::hint);
  connect(result_, &ResultTable::computeWanted, &session, &Session::compute);
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

PropertyPanel::~PropertyPanel() {
  muteEditors();
  forgetParts();
}

// The results stay when another feature is shown: Qt looks up the style of a widget, and of all within, whenever its parent
// changes, and that takes longer than all else. For the same reason widgets are made with the parent that they keep.
void PropertyPanel::buildColumn() {
  auto* content = new QWidget;
  content->setObjectName(QStringLiteral("propertyContent"));
  auto* column = new QVBoxLayout(content);
  column->setContentsMargins(16, 12, 16, 16);
  column->setSpacing(7);
  notice_ = styled({}, "noticeBox", content);
  notice_->setTextInteractionFlags(Qt::TextSelectableByMouse);
  notice_->hide();
  column->addWidget(notice_);
  form_ = new QWidget(content);
  column->addWidget(form_);
  column->addSpacing(6);
  resultTitle_ = title(tr("RESULT"), content);
  column->addWidget(resultTitle_);
  column->addWidget(result_);
  column->addStretch();
  setWidget(content);
}

void PropertyPanel::rebuild() {
  endPick();
  mark({});
  muteEditors();
  fields_.clear();
  unshowable_.clear();
  inputs_.clear();
  header_ = nullptr;
  endPreviews();
  isSlow_ = false;
  faulty_ = nullptr;
  QWidget* const before = std::exchange(form_, new QWidget(widget()));
  column_ = new QVBoxLayout(form_);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(7);
  const bool something = !shown_.empty();
  resultTitle_->setVisible(something);
  result_->setVisible(something);
  if (!something) notice_->hide();
  if (something) {
    addFeature(session_.document().at(shown_));
    refreshFields();
    refreshResult();
  } else {
    column_->addWidget(title(tr("PROPERTIES"), form_));
    column_->addWidget(styled(session_.document().features().empty()
                                  ? tr("There is nothing in this document yet.")
                                  : tr("Select a feature to see what it is made from and what it came to."),
                              "note", form_));
  }
  if (QWidget* focused = before->focusWidget()) focused->clearFocus();
  before->hide();
  delete widget()->layout()->replaceWidget(before, form_);
  before->deleteLater();  // one of its buttons may have been clicked
  form_->show();          // at last, for what is hidden yet is laid out only once
  verticalScrollBar()->setValue(0);
}

void PropertyPanel::addFeature(const Feature& feature) {
  type_ = session_.app().registry->find(feature.type);
  header_ = new FeatureHeader(form_);
  if (type_)
    header_->setType(registryText(type_->title), registryText(type_->summary), qt(referencePageName(type_->id)));
  else
    header_->setProblem(tr("The plugin that makes \"%1\" is not installed.").arg(qt(feature.type)));
  connect(header_, &FeatureHeader::renamed, this, &PropertyPanel::rename);
  connect(header_, &FeatureHeader::manualWanted, this, &PropertyPanel::manualWanted);
  column_->addWidget(header_);
  if (type_ && !type_->inputs.empty()) addInputs();
  if (type_ && !type_->parameters.empty()) addParameters();
}

void PropertyPanel::addInputs() {
  column_->addSpacing(4);
  column_->addWidget(title(tr("INPUTS"), form_));
  for (std::size_t spec = 0; spec < type_->inputs.size(); ++spec) {
    auto* input = new InputEditor(session_, shown_, type_, spec, form_);
    connect(input, &InputEditor::hint, this, &PropertyPanel::hint);
    connect(input, &InputEditor::pickWanted, this,
            [this](InputEditor* from, const PickRequest& request) { wantPick(nullptr, from, request); });
    connect(input, &InputEditor::pickUnwanted, this, [this](InputEditor* from) {
      if (picking_.isFor(from)) endPick();
    });
    column_->addWidget(input);
    inputs_.push_back(input);
  }
}

void PropertyPanel::addParameters() {
  column_->addSpacing(4);
  column_->addWidget(title(tr("PROPERTIES"), form_));
  for (const ParameterSpec& spec : type_->parameters) {
    ParameterField* field = ParameterField::make(spec, form_, context_);
    connectField(field);
    column_->addWidget(field);
    fields_.push_back(field);
  }
}

void PropertyPanel::connectField(ParameterField* field) {
  connect(field, &ParameterField::edited, this, [this, field](const Value& value) {
    if (!wantTime(*field, value)) commit(field, value);
  });
  connect(field, &ParameterField::previewed, this, [this, field](const Value& value) {
    if (!wantTime(*field, value, true)) preview(field, value);
  });
  connect(field, &ParameterField::reverted, this, [this, field] {
    if (!wantTime(*field, field->value())) revert();
  });
  connect(field, &ParameterField::hint, this, &PropertyPanel::hint);
  connect(field, &ParameterField::pickWanted, this, [this, field](ParameterField* from, PickRequest request) {
    const QString name = qt(field->spec().name);
    request.parameter = request.parameter.isEmpty() ? name : name + u'/' + request.parameter;
    wantPick(from, nullptr, request);
  });
  connect(field, &ParameterField::pickUnwanted, this, [this](ParameterField* from) {
    if (picking_.isFor(from)) endPick();
  });
}

/// Sub-shapes are named after the features that stand in the inputs now.
void PropertyPanel::refreshContext() {
  const InputSlots taken(session_, session_.document().at(shown_), *type_);
  std::vector<FieldContext::Source> sources;
  context_->shapes.clear();
  for (std::size_t k = 0; k < type_->inputs.size(); ++k) {
    context_->shapes[type_->inputs[k].name] = taken.of(k).size();
    for (const FeatureId& id : taken.of(k)) {
      const bool first = sources.empty() || sources.back().input != type_->inputs[k].name;
      if (first) sources.push_back({type_->inputs[k].name, id, qt(shownName(session_.document().at(id)))});
    }
  }
  context_->parameters = shownParameters(*type_, session_.document().at(shown_));
  context_->sources = std::move(sources);
  context_->names = namedNumbersOf(session_.document());
  refreshLost();
}

void PropertyPanel::refreshFields() {
  const Feature& feature = session_.document().at(shown_);
  header_->setName(qt(shownName(feature)));
  if (!type_) return;
  refreshContext();
  for (InputEditor* input : inputs_) input->refresh();
  for (ParameterField* field : fields_) {
    if (field != previewed_ && !refreshTime(*field)) {  // what is dragged is ahead of the document
      const auto given = feature.parameters.find(field->spec().name);
      const bool absent = given == feature.parameters.end() || given->is_null();
      refreshField(*field, absent ? field->spec().fallback : *given);
    }
    showOrHide(*field);
  }
}

// A row that says nothing stays while something is typed in it, which would be lost or entered unasked, and while something
// is wrong with it, which could not be mended otherwise.
void PropertyPanel::showOrHide(ParameterField& field) {
  const Feature& feature = session_.document().at(shown_);
  const auto isGiven = [&](const std::string& name) {
    const auto spec =
        std::find_if(type_->inputs.begin(), type_->inputs.end(), [&](const InputSpec& each) { return each.name == name; });
    return !InputSlots(session_, feature, *type_).of(static_cast<std::size_t>(spec - type_->inputs.begin())).empty();
  };
  const bool says = saysAnything(field.spec(), *type_, feature, *session_.app().formats, isGiven);
  const bool shown = says || field.editing() || !field.problem().isEmpty();
  if (!shown && picking_.isFor(&field)) endPick();
  field.setVisible(shown);
}

// A document may hold what a field cannot show, from another version or another hand: the feature's own error stands there
// then, beside the default.
void PropertyPanel::refreshField(ParameterField& field, const Value& given) {
  Value value = given;
  QString fault;
  try {
    if (!value.is_null()) value = checked(field.spec(), given);
  } catch (const Error& error) {
    value = field.spec().fallback;
    fault = sentenceCase(qt(error.message()));
  }
  // What is being typed, and what is wrong with it, stays until the value really changes.
  const bool busy = field.editing() || !field.problem().isEmpty();
  if (!busy || field.value() != value) {
    field.setWritten(given);
    field.setValue(value);
  }
  QString& told = unshowable_[&field];
  if (fault.isEmpty() && !told.isEmpty() && field.problem() == told) field.setFault({});
  if (!fault.isEmpty() && field.problem().isEmpty()) field.setFault(fault);
  told = fault;
}

void PropertyPanel::followViews(const std::set<FeatureId>& features) {
  if (shown_.empty()) return;
  lookForQuick();
  const bool own = features.contains(shown_), others = features.size() > (own ? 1U : 0U);
  if (own) {
    refreshTimes();
    refreshLost();
    refreshResult();
  } else if (!inputs_.empty()) {
    countRefresh(WindowPart::Panel);
  }
  // The kind of another feature's result may tell which inputs it fits.
  if (others)
    for (InputEditor* input : inputs_) input->refresh();
}

void PropertyPanel::setKeying(std::function<bool()> setKey) { context_->setKey = std::move(setKey); }

void PropertyPanel::refreshResult() {
  if (shown_.empty() || !session_.document().contains(shown_)) return;
  countRefresh(WindowPart::Panel);
  if (session_.cancelled(shown_)) return result_->showCancelled();
  std::vector<std::string> besides;  // what is set above need not be told below
  for (const ParameterField* field : fields_) besides.push_back(field->spec().name);
  const auto view = session_.view(shown_);
  const bool isKnown = std::exchange(told_, shown_) == shown_;
  const bool isHeldBack = session_.coarse() && isKnown;
  heldBack_ = isHeldBack;
  // The few frames that follow a drag stand for the whole sequence.
  const bool standIn = isHeldBack && view && view->result->evaluated.shape.kind() == ShapeKind::Sequence;
  if (!standIn) result_->show(view.get(), besides, session_.outdated(shown_));
  showFault();
  if (isHeldBack) return;  // what is told of a preview must not push away the slider that is dragged
  showNotice(view && !view->result->error ? view->result->evaluated.warnings : std::vector<std::string>());
}

// A warning must be seen without scrolling to the results, where all of them stand.
void PropertyPanel::showNotice(const std::vector<std::string>& warnings) {
  notice_->setVisible(!warnings.empty());
  if (warnings.empty()) return;
  QString text = shownWarning(warnings.front());
  if (warnings.size() > 1) text += QStringLiteral("\n") + tr("%1 more with the results below.").arg(warnings.size() - 1);
  notice_->setText(text);
}

// An error that names a parameter is shown where that parameter is.
void PropertyPanel::showFault() {
  ParameterField* const before = std::exchange(faulty_, nullptr);
  if (before && before->problem() == fault_) before->setFault({});
  const auto view = session_.view(shown_);
  if (view && view->result->error && view->result->error->code() == ErrorCode::InvalidParameter) {
    const QString message = qt(view->result->error->message());
    faulty_ = faultyField(message);
    fault_ = sentenceCase(message);
  }
  if (faulty_) faulty_->setFault(fault_);
  if (before) showOrHide(*before);
  if (faulty_ && faulty_ != before) showOrHide(*faulty_);
}

/// The one that the message names, unless it tells already what is wrong.
ParameterField* PropertyPanel::faultyField(const QString& message) const {
  ParameterField* const named = fieldOfError(fields_, message);
  return named && named->problem().isEmpty() ? named : nullptr;
}

}  // namespace blossom::ui
