#include "ui/fields/curve_field.h"

#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <cmath>

#include "core/error.h"
#include "core/units.h"
#include "ui/controls/curve_editor.h"
#include "ui/controls/number_line.h"
#include "ui/controls/stepping.h"
#include "ui/look/text.h"

namespace blossom::ui {

namespace {

Value toValue(const std::vector<QPointF>& points) {
  Value curve = Value::array();
  for (const QPointF& p : points) curve.push_back({p.x(), p.y()});
  return curve;
}

std::vector<QPointF> toPoints(const Value& curve) {
  std::vector<QPointF> points;
  for (const Value& pair : curve) points.emplace_back(pair.at(0).get<double>(), pair.at(1).get<double>());
  return points;
}

QLabel* axisName(const QString& text) {
  auto* label = new QLabel(text);
  label->setObjectName(QStringLiteral("axisName"));
  return label;
}

}  // namespace

CurveField::CurveField(const ParameterSpec& given, const Context& outside, QWidget* parent)
    : ParameterField(given, outside, parent), editor_(new CurveEditor), t_(new NumberLine), number_(new NumberLine) {
  auto* all = new QWidget;
  auto* grid = new QGridLayout(all);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setSpacing(6);
  grid->setColumnStretch(1, 1);
  grid->setColumnStretch(3, 1);
  grid->addWidget(editor_, 0, 0, 1, 4);
  grid->addWidget(axisName(QStringLiteral("t")), 1, 0);
  grid->addWidget(t_, 1, 1);
  grid->addWidget(axisName(tr("value")), 1, 2);
  grid->addWidget(number_, 1, 3);
  t_->setObjectName(QStringLiteral("curveT"));
  number_->setObjectName(QStringLiteral("curveValue"));
  t_->setAccessibleName(tr("t of the chosen point"));
  number_->setAccessibleName(tr("value of the chosen point"));
  setWideEditor(all);
  all->setFocusProxy(editor_);
  editor_->setBounds(given.minimum, given.maximum);
  connect(editor_, &CurveEditor::dragged, this, [this](const auto& points) { offer(toValue(points), true); });
  connect(editor_, &CurveEditor::changed, this, [this](const auto& points) { offer(toValue(points)); });
  connect(editor_, &CurveEditor::chosenChanged, this, &CurveField::showChosen);
  for (NumberLine* line : {t_, number_}) {
    forgiveWhatIsTakenBack(line);
    connect(line, &QLineEdit::editingFinished, this, [this, line] {
      if (line->isModified()) typed();
    });
    connect(line, &NumberLine::stepped, this, [this, line](double steps, Qt::KeyboardModifiers modifiers) {
      bool known = false;
      const double now = line->text().toDouble(&known);
      if (!known) return;
      line->setText(qt(formatNumber(stepped(number(), now, std::trunc(steps), stepOf(ratio(), now, modifiers)))));
      typed();
    });
  }
}

bool CurveField::editing() const { return ParameterField::editing() || t_->isModified() || number_->isModified(); }

void CurveField::display(const Value& shown) {
  editor_->setPoints(shown.is_array() ? toPoints(shown) : std::vector<QPointF>());
}

void CurveField::showChosen() {
  const int chosen = editor_->chosen();
  t_->setEnabled(chosen >= 0);
  number_->setEnabled(chosen >= 0);
  const QPointF p = chosen >= 0 ? editor_->points()[static_cast<std::size_t>(chosen)] : QPointF();
  t_->setText(chosen >= 0 ? qt(formatNumber(p.x())) : QString());
  number_->setText(chosen >= 0 ? qt(formatNumber(p.y())) : QString());
}

void CurveField::typed() {
  const int chosen = editor_->chosen();
  if (chosen < 0 || !value().is_array()) return;
  try {
    Value wanted = value();
    Value& point = wanted.at(static_cast<std::size_t>(chosen));
    point[0] = parseNumber(t_->text().toStdString());
    point[1] = parseNumber(number_->text().toStdString());
    offer(wanted);
  } catch (const Error& error) {
    showProblem(sentenceCase(qt(error.message())) + tr(" The value before is kept."));
  }
}

void CurveField::addToMenu(QMenu& menu) {
  menu.addAction(tr("Remove all points"), this, [this] { offer(Value::array()); })->setEnabled(!editor_->points().empty());
}

}  // namespace blossom::ui
