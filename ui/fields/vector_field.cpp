#include "ui/fields/vector_field.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "core/units.h"
#include "ui/controls/number_line.h"
#include "ui/controls/pick_button.h"
#include "ui/controls/stepping.h"
#include "ui/controls/typed_expression.h"
#include "ui/look/text.h"
#include "ui/plugin/tool.h"

namespace blossom::ui {

namespace {

constexpr std::array<const char*, 3> axisNames{"x", "y", "z"};

/// 0.1 + 0.2 from a picture is not worth seventeen digits.
double tidy(double value) { return std::round(value * 1e6) / 1e6; }

}  // namespace

VectorField::VectorField(const ParameterSpec& given, const Context& outside, QWidget* parent)
    : ParameterField(given, outside, parent), component_(coordinateOf(given)) {
  auto* all = new QWidget;
  auto* row = new QHBoxLayout(all);
  row->setContentsMargins(0, 0, 0, 0);
  row->setSpacing(4);
  for (std::size_t axis = 0; axis < 3; ++axis) {
    auto* name = new QLabel(QLatin1String(axisNames[axis]));
    name->setObjectName(QStringLiteral("axisName"));
    NumberLine* line = lines_[axis] = new NumberLine;
    line->setObjectName(QLatin1String(axisNames[axis]));
    line->setProperty("tight", true);
    line->setAccessibleName(QStringLiteral("%1 %2").arg(qt(label(given)), QLatin1String(axisNames[axis])));
    row->addWidget(name);
    row->addWidget(line, 1);
    connect(line, &QLineEdit::editingFinished, this, [this, axis] { finish(axis); });
    forgiveWhatIsTakenBack(line);
    connect(line, &NumberLine::stepped, this,
            [this, axis](double steps, Qt::KeyboardModifiers modifiers) { step(axis, steps, modifiers); });
    connect(line, &NumberLine::stepsEnded, this, [this] {
      if (ParameterField::editing()) offer(shown_);
    });
  }
  if (context()->picking && given.kind != ParameterKind::Displacement) {
    pick_ = given.kind == ParameterKind::Point
                ? new PickButton(QStringLiteral("pick-point"), tr("Pick a point in the view"))
                : new PickButton(QStringLiteral("pick-face"), tr("Pick a face in the view; its normal is taken"));
    connect(pick_, &QToolButton::toggled, this, &VectorField::togglePick);
  }
  setWideEditor(all, pick_);
  all->setFocusProxy(lines_[0]);
}

bool VectorField::typing() const {
  return std::any_of(lines_.begin(), lines_.end(), [](const NumberLine* line) { return line->isModified(); });
}

bool VectorField::editing() const { return ParameterField::editing() || typing(); }

// Without the unit, for which there is no room.
QString VectorField::plainText(double value) const { return displayText(component_, value).section(u' ', 0, 0); }

void VectorField::display(const Value& value) {
  shown_ = value;
  double largest = 0;
  if (value.is_array())
    for (const Value& each : value) largest = std::max(largest, std::abs(each.get<double>()));
  QStringList results;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool there = value.is_array() && value.size() > axis;
    const bool expressed = there && typedComesTo(component_, expressions_[axis], value[axis], names());
    const QString plain = there ? plainText(withoutNoise(value[axis].get<double>(), largest)) : QString();
    lines_[axis]->setText(expressed ? expressions_[axis] : plain);
    lines_[axis]->setCursorPosition(0);
    if (expressed)
      results << QStringLiteral("%1 = %2").arg(QLatin1String(axisNames[axis]), displayText(component_, value[axis]));
  }
  showNote(results.join(QStringLiteral(", ")));
}

Value VectorField::written() const {
  Value all = value();
  for (std::size_t axis = 0; all.is_array() && axis < all.size(); ++axis)
    all[axis] = writtenAs(component_, expressions_[axis], all[axis], names());
  return all;
}

void VectorField::setWritten(const Value& given) {
  if (given == written()) return;
  for (std::size_t axis = 0; axis < 3; ++axis) {
    const bool there = given.is_array() && given.size() > axis;
    expressions_[axis] = there ? expressionOf(given[axis]) : QString();
  }
}

// In the row of a list there is room for the numbers alone.
void VectorField::hideLabel() {
  ParameterField::hideLabel();
  for (QLabel* name : findChildren<QLabel*>(QStringLiteral("axisName"))) name->hide();
  for (std::size_t axis = 0; axis < 3; ++axis) lines_[axis]->setToolTip(QLatin1String(axisNames[axis]));
}

void VectorField::finish(std::size_t axis) {
  if (!lines_[axis]->isModified()) return;
  const bool allEmpty =
      std::all_of(lines_.begin(), lines_.end(), [](const NumberLine* line) { return line->text().trimmed().isEmpty(); });
  if (allEmpty && spec().mayBeAbsent) return offer(Value());
  try {
    takeTyped(axis);
  } catch (const Error& error) {
    showProblem(sentenceCase(qt(error.message())) + tr(" The value before is kept."));
  }
}

// An expression for the same value is an edit, too.
void VectorField::takeTyped(std::size_t axis) {
  const QString typed = lines_[axis]->text().trimmed();
  ParameterSpec named = component_;
  named.name = axisNames[axis];
  Value wanted = value().is_array() ? value() : Value::array({0.0, 0.0, 0.0});
  wanted[axis] = parseTyped(named, typed, names());
  const Value before = written(), valueBefore = value();
  expressions_[axis] = isExpression(typed) ? typed : QString();
  offer(wanted);
  if (value() == valueBefore && written() != before) emit edited(value());
}

void VectorField::step(std::size_t axis, double steps, Qt::KeyboardModifiers modifiers) {
  if (!shown_.is_array()) shown_ = Value::array({0.0, 0.0, 0.0});
  const double now = shown_[axis].get<double>();
  shown_[axis] = stepped(component_, now, std::trunc(steps), stepOf(component_, now, modifiers));
  lines_[axis]->setText(plainText(shown_[axis].get<double>()));
  offer(shown_, true);
}

void VectorField::togglePick(bool on) {
  if (!on) {
    emit pickUnwanted(this);
    return;
  }
  PickRequest request;
  const bool point = spec().kind == ParameterKind::Point;
  request.want = point ? PickRequest::Want::Point : PickRequest::Want::Direction;
  request.hint = point ? tr("Click where %1 is to be; Esc ends").arg(qt(label(spec())))
                       : tr("Click a face whose normal is to be %1; Esc ends").arg(qt(label(spec())));
  emit pickWanted(this, request);
}

bool VectorField::takePick(const Pick& pick) {
  const bool point = spec().kind == ParameterKind::Point;
  if (pick.feature.empty() && !point) return false;  // a point may lie on nothing
  const Vec3& from = point ? pick.part.point : pick.part.normal;
  offer(Value::array({tidy(from.x()), tidy(from.y()), tidy(from.z())}));
  return true;
}

void VectorField::pickEnded() {
  if (pick_) pick_->setChecked(false);
}

void VectorField::addToMenu(QMenu& menu) {
  if (pick_) menu.addAction(tr("Pick in the view"), pick_, &QToolButton::click);
}

}  // namespace blossom::ui
