#include "ui/files/export_dialog.h"

#include <QComboBox>
#include <QHBoxLayout>
#include <QLabel>
#include <QLineEdit>
#include <QPushButton>
#include <QScreen>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>

#include "core/error.h"
#include "ui/controls/fitting_scroll.h"
#include "ui/fields/parameter_field.h"
#include "ui/look/text.h"

namespace blossom::ui {

namespace {

const QString lastFormatKey = QStringLiteral("export/format");
QString optionsKey(const Format& format) { return QStringLiteral("export/options/") + qt(format.id); }

Value storedOptions(const Format& format) {
  try {
    Value stored = parseJson(QSettings().value(optionsKey(format)).toString().toStdString());
    if (stored.is_object()) return stored;
  } catch (const Error&) {
    // never used, or written by another version
  }
  return Value::object();
}

Value usable(const ParameterSpec& spec, const Value& stored) {
  if (!stored.contains(spec.name)) return spec.fallback;
  try {
    return checked(spec, stored.at(spec.name));
  } catch (const Error&) {
    return spec.fallback;
  }
}

}  // namespace

std::vector<const Format*> formatsFor(const FormatRegistry& formats, const ExportScope& scope) {
  std::vector<const Format*> fitting;
  for (const Format& format : formats.formats()) {
    const bool storesFrames =
        !scope.frameKinds.empty() && std::all_of(scope.frameKinds.begin(), scope.frameKinds.end(),
                                                 [&](ShapeKind kind) { return canStore(format, kind); });
    if (format.write && (canStore(format, scope.kind) || storesFrames)) fitting.push_back(&format);
  }
  return fitting;
}

ExportDialog::ExportDialog(const FormatRegistry& formats, std::vector<ExportScope> scopes, QWidget* parent)
    : QDialog(parent),
      formats_(formats),
      scopes_(std::move(scopes)),
      what_(new QComboBox),
      format_(new QComboBox),
      rows_(new QVBoxLayout),
      none_(new QLabel(tr("Shapes of these kinds do not go into one file."))),
      cancel_(new QPushButton(tr("Cancel"))),
      go_(new QPushButton(tr("Export…"))) {
  setObjectName(QStringLiteral("exportDialog"));
  setWindowTitle(tr("Export"));
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(22, 20, 22, 18);
  all->setSpacing(10);
  const auto labelled = [&](const QString& text, QComboBox* box) {
    auto* caption = new QLabel(text);
    caption->setObjectName(QStringLiteral("fieldLabel"));
    caption->setFixedWidth(92);
    caption->setBuddy(box);
    auto* row = new QHBoxLayout;
    row->addWidget(caption);
    row->addWidget(box, 1);
    all->addLayout(row);
  };
  labelled(tr("What"), what_);
  labelled(tr("Format"), format_);
  none_->setObjectName(QStringLiteral("problem"));
  none_->setWordWrap(true);
  all->addWidget(none_);
  auto* column = new QWidget;
  column->setObjectName(QStringLiteral("exportOptions"));
  column->setLayout(rows_);
  rows_->setSpacing(10);
  rows_->setContentsMargins(0, 0, 0, 0);
  options_ = new FittingScroll(column);
  all->addWidget(options_, 1);
  go_->setProperty("primary", true);
  go_->setDefault(true);
  connect(cancel_, &QPushButton::clicked, this, &QDialog::reject);
  connect(go_, &QPushButton::clicked, this, &QDialog::accept);
  auto* buttons = new QHBoxLayout;
  buttons->addStretch();
  buttons->addWidget(cancel_);
  buttons->addWidget(go_);
  all->addLayout(buttons);
  setMinimumWidth(420);
  for (const ExportScope& each : scopes_) what_->addItem(each.title);
  connect(what_, &QComboBox::currentIndexChanged, this, &ExportDialog::fillFormats);
  connect(format_, &QComboBox::currentIndexChanged, this, &ExportDialog::fillOptions);
  fillFormats();
}

const ExportScope& ExportDialog::scope() const { return scopes_.at(static_cast<std::size_t>(what_->currentIndex())); }

const Format& ExportDialog::format() const { return *formats_.find(format_->currentData().toString().toStdString()); }

void ExportDialog::choose(const QString& formatId) {
  if (const int index = format_->findData(formatId); index >= 0) format_->setCurrentIndex(index);
}

void ExportDialog::fillFormats() {
  const QString before =
      format_->count() > 0 ? format_->currentData().toString() : QSettings().value(lastFormatKey).toString();
  {
    const QSignalBlocker quiet(format_);
    format_->clear();
    for (const Format* each : formatsFor(formats_, scope())) format_->addItem(qt(each->title), qt(each->id));
    choose(before);
  }
  const bool any = format_->count() > 0;
  none_->setVisible(!any);
  format_->setEnabled(any);
  go_->setEnabled(any);
  fillOptions();
}

void ExportDialog::fillOptions() {
  for (ParameterField* field : fields_) field->deleteLater();
  fields_.clear();
  if (format_->currentIndex() < 0) return;
  const Value stored = storedOptions(format());
  for (const ParameterSpec& spec : format().writeOptions) {
    ParameterField* field = ParameterField::make(spec, this);
    field->setValue(usable(spec, stored));
    fields_.push_back(field);
    rows_->addWidget(field);
  }
  orderTabs();
  QMetaObject::invokeMethod(this, &ExportDialog::fitToScreen, Qt::QueuedConnection);
}

/// The options are newer than the buttons: Tab would reach them last.
void ExportDialog::orderTabs() {
  QWidget* last = format_;
  for (QWidget* next = format_->nextInFocusChain(); next != format_; next = next->nextInFocusChain())
    if (options_->isAncestorOf(next)) last = next;
  setTabOrder(last, go_);
  setTabOrder(go_, cancel_);
}

/// The buttons stay in reach on small screens, too: the options scroll there.
void ExportDialog::fitToScreen() {
  constexpr int frame = 64;  // of the window, and room beside it
  resize(sizeHint().boundedTo(screen()->availableSize() - QSize(0, frame)));
}

// What is typed is taken first; a wrong value keeps the dialog open, with its message.
void ExportDialog::accept() {
  for (QLineEdit* line : findChildren<QLineEdit*>())
    if (line->isModified()) emit line->editingFinished();
  for (ParameterField* field : fields_)
    if (!field->problem().isEmpty()) {
      options_->ensureWidgetVisible(field);
      return field->setFocus();
    }
  QDialog::accept();
}

Value ExportDialog::options() const {
  Value values = Value::object();
  for (const ParameterField* field : fields_)
    if (!field->value().is_null()) values[field->spec().name] = field->value();
  return values;
}

void ExportDialog::remember() const {
  QSettings().setValue(lastFormatKey, qt(format().id));
  QSettings().setValue(optionsKey(format()), qt(options().dump()));
}

}  // namespace blossom::ui
