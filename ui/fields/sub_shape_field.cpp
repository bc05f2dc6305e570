#include "ui/fields/sub_shape_field.h"

#include <QLabel>
#include <QMenu>
#include <QToolButton>
#include <algorithm>

#include "geometry/occt/sub_shape.h"
#include "parameter/wording.h"
#include "ui/controls/chip.h"
#include "ui/controls/flow_layout.h"
#include "ui/controls/pick_button.h"
#include "ui/look/text.h"
#include "ui/plugin/tool.h"

namespace blossom::ui {

SubShapeField::SubShapeField(const ParameterSpec& given, const Context& outside, QWidget* parent)
    : ParameterField(given, outside, parent), chips_(new QWidget), flow_(new FlowLayout(chips_)) {
  const QString what = qt(subShapeKind(element()));
  if (context()->picking) {
    pick_ = new PickButton(QStringLiteral("pick-") + what,
                           several() ? tr("Pick in the view: %1").arg(counted(QStringLiteral("0"), what).mid(2))
                                     : tr("Pick in the view: %1").arg(what));
    connect(pick_, &QToolButton::toggled, this, &SubShapeField::togglePick);
  }
  setWideEditor(chips_, pick_);
  if (pick_) chips_->setFocusProxy(pick_);
}

Value SubShapeField::items() const {
  if (several()) return value().is_array() ? value() : Value::array();
  return value().is_null() ? Value::array() : Value::array({value()});
}

void SubShapeField::display(const Value&) {
  while (const QLayoutItem* item = flow_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();  // it may be the one that was clicked
    delete item;
  }
  const Value all = items();
  for (std::size_t i = 0; i < all.size(); ++i) {
    auto* chip = new Chip(context()->nameOf(all[i], several()));
    flow_->addWidget(chip);
    connect(chip, &Chip::removed, this, [this, i] { remove(i); });
  }
  if (all.empty()) {
    const QString means = spec().noneMeans.empty() ? tr("none") : qt(spec().noneMeans);
    auto* none = new QLabel(context()->picking ? tr("%1; pick in the view").arg(means) : means);
    none->setObjectName(QStringLiteral("note"));
    flow_->addWidget(none);
  }
  chips_->updateGeometry();
}

void SubShapeField::remove(std::size_t index) {
  if (!several()) {
    if (!spec().mayBeAbsent && spec().fallback.is_null())
      return showProblem(tr("One must be given; pick another one instead."));
    return offer(Value());
  }
  Value rest = items();
  rest.erase(index);
  offer(rest);
}

void SubShapeField::togglePick(bool on) {
  if (!on) {
    emit pickUnwanted(this);
    return;
  }
  PickRequest request;
  request.want = PickRequest::Want::SubShape;
  request.kind = subShapeKindOf(subShapeKind(element()));
  request.several = several();
  for (const FieldContext::Source& source : context()->sources) request.features.push_back(source.feature);
  const QString what = qt(subShapeKind(element()));
  request.hint = several() ? tr("Click every %1 for %2, again to let go; Esc ends").arg(what, qt(label(spec())))
                           : tr("Click the %1 for %2; Esc ends").arg(what, qt(label(spec())));
  emit pickWanted(this, request);
}

bool SubShapeField::takePick(const Pick& pick) {
  const std::string wanted = subShapeKind(element());
  const auto& sources = context()->sources;
  const auto source =
      std::find_if(sources.begin(), sources.end(), [&](const auto& known) { return known.feature == pick.feature; });
  if (source == sources.end()) {
    showProblem(tr("That is not a part of an input of this feature."));
    return false;
  }
  if (pick.part.kind != subShapeKindOf(wanted)) {
    showProblem(tr("That is no %1 but a %2.").arg(qt(wanted), qt(subShapeKindName(pick.part.kind))));
    return false;
  }
  const Value found{{"input", source->input}, {"kind", wanted}, {"index", pick.part.index}};
  if (!several()) {
    offer(found);
    return true;
  }
  Value all = items();
  const auto isSame = [&](const Value& each) {
    return std::all_of(found.items().begin(), found.items().end(),
                       [&](const auto& entry) { return each.value(entry.key(), Value()) == entry.value(); });
  };
  const auto known = std::find_if(all.begin(), all.end(), isSame);
  if (known == all.end())
    all.push_back(found);
  else
    all.erase(known);
  offer(all);
  return true;
}

void SubShapeField::pickEnded() {
  if (pick_) pick_->setChecked(false);
}

void SubShapeField::addToMenu(QMenu& menu) {
  if (pick_) menu.addAction(tr("Pick in the view"), pick_, &QToolButton::click);
  if (several() && !items().empty()) menu.addAction(tr("Remove all"), this, [this] { offer(Value::array()); });
}

}  // namespace blossom::ui
