#include "ui/fields/number_field.h"

#include <cmath>
#include <utility>

#include "core/error.h"
#include "parameter/start_value.h"
#include "ui/controls/field_label.h"
#include "ui/controls/number_line.h"
#include "ui/controls/stepping.h"
#include "ui/controls/typed_expression.h"

namespace blossom::ui {

namespace {

constexpr double pixelsPerStep = 4;

}  // namespace

NumberField::NumberField(const ParameterSpec& given, const Context& context, QWidget* parent)
    : ParameterField(given, context, parent), line_(new NumberLine) {
  setEditor(line_);
  line_->setPlaceholderText(given.mayBeAbsent ? tr("none") : tr("must be given"));
  connect(line_, &QLineEdit::textEdited, this, &NumberField::tellResult);
  connect(line_, &QLineEdit::editingFinished, this, &NumberField::finish);
  forgiveWhatIsTakenBack(line_);
  connect(line_, &NumberLine::stepped, this, &NumberField::step);
  connect(line_, &NumberLine::stepsEnded, this, [this] {
    if (ParameterField::editing()) offer(shown_);
  });
  caption().setScrubbable(true);
  caption().setToolTip(tr("%1\nDrag sideways to change it.").arg(caption().toolTip()));
  connect(&caption(), &FieldLabel::scrubStarted, this, [this] { line_->setFocus(); });
  connect(&caption(), &FieldLabel::scrubbed, this, &NumberField::scrub);
  connect(&caption(), &FieldLabel::scrubEnded, this, [this] {
    if (ParameterField::editing()) offer(shown_);
  });
  connect(&caption(), &FieldLabel::clicked, this, [this] {
    line_->setFocus();
    line_->selectAll();
  });
}

bool NumberField::editing() const { return ParameterField::editing() || line_->isModified(); }

void NumberField::display(const Value& value) {
  shown_ = value;
  fraction_ = 0;
  caption().cancelScrub();
  const bool expressed = typedComesTo(spec(), expression_, value, names());
  line_->setText(expressed ? expression_ : displayText(spec(), value));
  line_->setCursorPosition(0);
  if (expressed) tellResult(expression_);
}

double NumberField::shownNumber() const {
  if (shown_.is_number()) return shown_.get<double>();
  const Value start = startValue(spec());
  return start.is_number() ? start.get<double>() : 0;
}

// What is typed and not yet taken over is where the steps begin.
void NumberField::step(double steps, Qt::KeyboardModifiers modifiers) {
  if (line_->isModified()) {
    try {
      shown_ = parseTyped(spec(), line_->text(), names());
    } catch (const Error&) {
      return offerText(line_->text());  // says why
    }
  }
  fraction_ += steps;
  const double whole = std::trunc(fraction_);
  fraction_ -= whole;
  if (whole == 0) return;
  const double now = shownNumber();
  shown_ = stepped(spec(), now, whole, stepOf(spec(), now, modifiers));
  line_->setText(displayText(spec(), checked(spec(), shown_)));
  offer(shown_, true);
}

void NumberField::scrub(int pixels, Qt::KeyboardModifiers modifiers) {
  const double from = value().is_number() ? value().get<double>() : shownNumber();
  shown_ = stepped(spec(), from, std::trunc(pixels / pixelsPerStep), stepOf(spec(), from, modifiers));
  line_->setText(displayText(spec(), checked(spec(), shown_)));
  offer(shown_, true);
}

void NumberField::finish() {
  if (line_->isModified())
    takeTyped(line_->text());
  else if (!ParameterField::editing() && problem().isEmpty())
    display(value());
}

// An expression for the same value is an edit, too.
void NumberField::takeTyped(const QString& text) {
  const Value before = written();
  const QString kept = std::exchange(expression_, isExpression(text) ? text.trimmed() : QString());
  const Value valueBefore = value();
  offerText(text);
  if (!problem().isEmpty())
    expression_ = kept;
  else if (value() == valueBefore && written() != before)
    emit edited(value());
}

Value NumberField::written() const { return writtenAs(spec(), expression_, value(), names()); }

// A document's lengths without a unit are in mm; what another unit here would make something else of is shown as its value.
void NumberField::setWritten(const Value& given) {
  if (given == written()) return;
  expression_ = expressionOf(given);
}

// "= 72.7 mm" under what is typed, as soon as it is more than a number.
void NumberField::tellResult(const QString& typed) {
  QString told;
  try {
    const Value result = parseTyped(spec(), typed, names());
    const QString text = displayText(spec(), result);
    bool plain = false;
    typed.toDouble(&plain);
    if (!plain && text.simplified() != typed.simplified()) told = QStringLiteral("= ") + text;
  } catch (const Error&) {
    told.clear();  // not finished yet
  }
  showNote(told);
}

}  // namespace blossom::ui
