#include "ui/fields/parameter_field.h"

#include <QApplication>
#include <QClipboard>
#include <QContextMenuEvent>
#include <QGridLayout>
#include <QKeyEvent>
#include <QLineEdit>
#include <QToolButton>

#include "core/error.h"
#include "parameter/written.h"
#include "ui/controls/field_label.h"
#include "ui/look/icons.h"
#include "ui/look/popup_menu.h"
#include "ui/look/registry_text.h"
#include "ui/look/restyle.h"
#include "ui/look/text.h"
#include "ui/look/units.h"

namespace blossom::ui {

namespace {

constexpr int markSize = 18;

// The name stands beside the field already.
QString reason(const ParameterSpec& spec, const Error& error) {
  QString text = qt(error.message());
  const QString name = qt(label(spec)) + QStringLiteral(": ");
  if (text.startsWith(name)) text.remove(0, name.size());
  return sentenceCase(text);
}

QLabel* hiddenLine(const char* name) {
  auto* line = new QLabel;
  line->setObjectName(QLatin1String(name));
  line->setWordWrap(true);
  line->hide();
  return line;
}

}  // namespace

QString FieldContext::nameOf(const Value& subShape, bool brief) const {
  if (!subShape.is_object()) return {};
  const std::string input = subShape.value("input", std::string());
  QString part = sentenceCase(registryText(subShape.value("kind", std::string()))) + u' ' +
                 QString::number(subShape.value("index", -1));
  if (brief && sources.size() <= 1) return part;
  for (const Source& source : sources)
    if (source.input == input) return ParameterField::tr("%1 of %2").arg(part, source.name);
  return input.empty() ? part : ParameterField::tr("%1 of %2").arg(part, qt(input));
}

ParameterField::ParameterField(ParameterSpec spec, Context context, QWidget* parent)
    : QWidget(parent),
      spec_(std::move(spec)),
      context_(context ? std::move(context) : std::make_shared<const FieldContext>()),
      grid_(new QGridLayout(this)),
      caption_(new FieldLabel(shownLabel(spec_))),
      note_(hiddenLine("note")),
      problem_(hiddenLine("fieldError")),
      reset_(new QToolButton(this)) {
  caption_->setFixedWidth(labelWidth);
  caption_->setToolTip(registryText(spec_.help));
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(10);
  grid_->setVerticalSpacing(3);
  grid_->addWidget(caption_, 0, 0);
  grid_->addWidget(note_, 2, 0, 1, 2);
  grid_->addWidget(problem_, 3, 0, 1, 2);
  grid_->setColumnStretch(1, 1);
  reset_->setObjectName(QStringLiteral("fieldReset"));
  reset_->setIcon(icon(QStringLiteral("reset")));
  reset_->setIconSize({12, 12});
  reset_->setFixedSize(markSize, markSize);
  reset_->setFocusPolicy(Qt::NoFocus);
  reset_->setToolTip(tr("Reset to the default"));
  reset_->hide();
  connect(reset_, &QToolButton::clicked, this, &ParameterField::resetToDefault);
  setObjectName(QStringLiteral("parameter:") + qt(spec_.name));
}

void ParameterField::setEditor(QWidget* editor) {
  editor_ = editor;
  editor->setAccessibleName(shownLabel(spec_));
  editor->setAccessibleDescription(registryText(spec_.help));
  editor->setToolTip(registryText(spec_.help));
  caption_->setBuddy(editor);
  grid_->addWidget(editor, 0, 1);
}

void ParameterField::setWideEditor(QWidget* editor, QWidget* corner) {
  editor_ = editor;
  corner_ = corner;
  editor->setAccessibleName(shownLabel(spec_));
  editor->setAccessibleDescription(registryText(spec_.help));
  caption_->setBuddy(editor);
  if (corner) grid_->addWidget(corner, 0, 1, Qt::AlignRight);
  grid_->addWidget(editor, 1, 0, 1, 2);
}

void ParameterField::hideLabel() {
  labelled_ = false;
  caption_->hide();
  reset_->hide();
  grid_->setHorizontalSpacing(corner_ ? 2 : 0);
  if (corner_) grid_->addWidget(corner_, 1, 2, Qt::AlignTop);  // beside the editor: there is no line above it any more
}

void ParameterField::indentLabel(int pixels) { caption_->setFixedWidth(labelWidth - pixels); }

void ParameterField::setValue(const Value& value) {
  value_ = value;
  previewing_ = false;
  showProblem({});
  showNote({});
  display(value_);
  refreshMarks();
}

QString ParameterField::problem() const { return problem_->isHidden() ? QString() : problem_->text(); }

void ParameterField::setFault(const QString& text) {
  showProblem(text);
  refused_ = false;
}

// Undo within the line shows the value that is kept, which nothing is wrong with. The line may count as modified even so.
void ParameterField::forgiveWhatIsTakenBack(QLineEdit* line) {
  const auto kept = std::make_shared<QString>();
  connect(line, &QLineEdit::textChanged, this, [line, kept](const QString& text) {
    if (!line->isModified()) *kept = text;
  });
  connect(line, &QLineEdit::textEdited, this, [this, line, kept](const QString& text) {
    if (!refused_ || text != *kept) return;
    line->setModified(false);
    showProblem({});
  });
}

void ParameterField::showProblem(const QString& text) {
  refused_ = !text.isEmpty();
  if (problem_->text() == text && problem_->isHidden() == text.isEmpty()) return;
  problem_->setText(text);
  problem_->setVisible(!text.isEmpty());
  if (editor_) restyle(editor_, "wrong", !text.isEmpty());
}

void ParameterField::showNote(const QString& text) {
  note_->setText(text);
  note_->setVisible(!text.isEmpty());
}

void ParameterField::offer(const Value& wanted, bool preview) {
  try {
    const bool absent = wanted.is_null() && spec_.mayBeAbsent;
    const Value good = absent ? Value() : checked(spec_, wanted);
    showProblem({});
    if (preview) {
      previewing_ = true;
      emit previewed(good);
      return;
    }
    const bool changed = good != value_, previewed = previewing_;
    previewing_ = false;
    value_ = good;
    showNote({});
    display(value_);
    refreshMarks();
    if (changed)
      emit edited(value_);
    else if (previewed)
      emit reverted();
  } catch (const Error& error) {
    showNote({});
    showProblem(reason(spec_, error) + tr(" The value before is kept."));
  }
}

void ParameterField::offerText(const QString& text) {
  if (spec_.mayBeAbsent && text.trimmed().isEmpty() && spec_.kind != ParameterKind::Text) return offer(Value());
  try {
    offer(parseTyped(spec_, text, names()));
  } catch (const Error& error) {
    showNote({});
    showProblem(reason(spec_, error) + tr(" The value before is kept."));
  }
}

void ParameterField::revert() {
  const bool previewed = previewing_;
  previewing_ = false;
  showProblem({});
  showNote({});
  display(value_);
  if (previewed) emit reverted();
}

bool ParameterField::differsFromDefault() const {
  return labelled_ && value_ != spec_.fallback && (!spec_.fallback.is_null() || spec_.mayBeAbsent);
}

void ParameterField::resetToDefault() {
  if (!differsFromDefault()) return;
  revert();
  offer(spec_.fallback);
}

void ParameterField::refreshMarks() {
  const bool differs = differsFromDefault();
  restyle(caption_, "changed", differs);
  reset_->setVisible(differs && underMouse());
  if (reset_->isVisible()) reset_->raise();
}

void ParameterField::resizeEvent(QResizeEvent*) { reset_->move(caption_->maximumWidth() - markSize + 4, 4); }

void ParameterField::enterEvent(QEnterEvent*) {
  refreshMarks();
  emit hint(QStringLiteral("%1: %2 %3").arg(shownLabel(spec_), registryText(spec_.help), shownKind()).trimmed());
}

// Records are written as JSON on the command line alone.
QString ParameterField::shownKind() const {
  const bool items = spec_.kind == ParameterKind::List && !spec_.fields.empty();
  const ParameterSpec& each = items ? spec_.fields.front() : spec_;
  if (spec_.kind == ParameterKind::Choice && spec_.choices.size() > 1 && spec_.condition.choice.empty()) {
    QStringList names;
    for (const std::string& choice : spec_.choices) names << shownChoice(choice);
    const QString last = names.takeLast();
    return sentenceCase(tr("%1 or %2").arg(names.join(QStringLiteral(", ")), last)) + u'.';
  }
  if (each.kind != ParameterKind::Record) return sentenceCase(qt(describe(spec_, lengthUnit()))) + u'.';
  if (!items) return {};
  QStringList names;
  for (const ParameterSpec& field : each.fields) names << registryText(label(field));
  return tr("Each with %1.").arg(names.join(QStringLiteral(", ")));
}

void ParameterField::leaveEvent(QEvent*) { reset_->hide(); }

// Keys that the editor leaves come by here; so does the question whether Esc is wanted before the window's shortcuts get it.
bool ParameterField::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress) {
    auto* key = static_cast<QKeyEvent*>(event);
    if (key->key() == Qt::Key_Escape && (editing() || !problem().isEmpty())) {
      if (event->type() == QEvent::KeyPress) revert();
      event->accept();
      return true;
    }
  }
  return QWidget::event(event);
}

void ParameterField::contextMenuEvent(QContextMenuEvent* event) {
  QMenu& menu = popupMenu(this);
  addToMenu(menu);
  const QString text = qt(formatText(spec_, value_, lengthUnit()));
  menu.addAction(tr("Copy value"), this, [text] { QApplication::clipboard()->setText(text); })->setEnabled(!text.isEmpty());
  const QString pasted = QApplication::clipboard()->text();
  menu.addAction(tr("Paste value"), this, [this, pasted] { offerText(pasted); })->setEnabled(!pasted.isEmpty());
  menu.addSeparator();
  if (spec_.mayBeAbsent) menu.addAction(tr("Clear"), this, [this] { offer(Value()); })->setEnabled(!value_.is_null());
  if (labelled_) {
    const QString standard = displayText(spec_, spec_.fallback);
    const bool shortEnough = !standard.isEmpty() && standard.size() <= 24;
    menu.addAction(shortEnough ? tr("Reset to %1").arg(standard) : tr("Reset to the default"), this,
                   &ParameterField::resetToDefault)
        ->setEnabled(differsFromDefault());
  }
  menu.popup(event->globalPos());
}

namespace {

// A field shows the beginning of a text that is too long for it: of 1.8651746813e-15 that would be another number.
QString withExponentInSight(const QString& text) {
  const QString number = text.section(u' ', 0, 0).remove(u'°');
  constexpr int shortEnough = 8;
  if (!number.contains(u'e') || number.size() <= shortEnough) return text;
  return QString::number(number.toDouble(), 'g', 2) + text.mid(number.size());
}

}  // namespace

QString displayText(const ParameterSpec& spec, const Value& value) {
  if (value.is_null()) return {};
  if (spec.kind == ParameterKind::File && value.is_object()) return qt(value.value("path", std::string())).section(u'/', -1);
  if (spec.kind == ParameterKind::Choice && value.is_string()) return shownChoice(value.get<std::string>());
  const QString text = qt(formatText(spec, value, lengthUnit()));
  return isNumeric(spec) ? withExponentInSight(text) : text;
}

Value parseTyped(const ParameterSpec& spec, const QString& text, const NamedNumbers& names) {
  return parseText(spec, text.trimmed().toStdString(), lengthUnit(), names);
}

QString shownLabel(const ParameterSpec& spec) { return sentenceCase(registryText(label(spec))); }

QString shownChoice(const std::string& name) { return registryText(name); }

}  // namespace blossom::ui
