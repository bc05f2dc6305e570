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
#include "ui/fields/lost_parts.h"
#include "ui/look/registry_text.h"
#include "ui/look/text.h"
#include "ui/plugin/tool.h"

namespace blossom::ui {

SubShapeField::SubShapeField(const ParameterSpec& given, const Context& outside, QWidget* parent)
    : ParameterField(given, outside, parent), chips_(new QWidget), flow_(new FlowLayout(chips_)) {
  const QString kind = qt(subShapeKind(element())), translated = registryText(kind.toStdString());
  const QString many = counted(QStringLiteral("0"), kind).mid(2);  // "edges"; an English plural
  if (context()->picking) {
    pick_ = new PickButton(QStringLiteral("pick-") + kind,
                           tr("Pick in the view: %1").arg(several() && translated == kind ? many : translated));
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
  pointAt(Value(pointed_), false);  // its chip has gone
  for (std::size_t i = 0; i < all.size(); ++i) addChip(all[i], i);
  if (all.empty()) {
    const QString means = spec().noneMeans.empty() ? tr("none") : registryText(spec().noneMeans);
    auto* none = new QLabel(context()->picking ? tr("%1; pick in the view").arg(means) : means);
    none->setObjectName(QStringLiteral("note"));
    flow_->addWidget(none);
  }
  chips_->updateGeometry();
  if (picking()) markChosen();
}

void SubShapeField::addChip(const Value& part, std::size_t index) {
  auto* chip = new Chip(context()->nameOf(part, several()));
  if (isLost(part, context()->lost))
    chip->setProblem(tr("Lost: not found again after an edit. Pick it anew, or remove it."));
  flow_->addWidget(chip);
  connect(chip, &Chip::removed, this, [this, index] { remove(index); });
  connect(chip, &Chip::pointedAt, this, [this, part](bool on) { pointAt(part, on); });
}

void SubShapeField::pointAt(const Value& part, bool on) {
  if (!on && (pointed_.is_null() || pointed_ != part)) return;
  pointed_ = on ? part : Value();
  context()->markPointed(pickOf(pointed_));
}

/// Nothing of one that is lost: another part may have its number.
std::optional<Pick> SubShapeField::pickOf(const Value& part) const {
  if (!part.is_object() || isLost(part, context()->lost)) return std::nullopt;
  const std::string input = part.value("input", std::string());
  for (const FieldContext::Source& source : context()->sources)
    if (input.empty() || source.input == input) {
      Pick pick;
      pick.feature = source.feature;
      pick.part.kind = subShapeKindOf(subShapeKind(element()));
      pick.part.index = part.value("index", -1);
      return pick;
    }
  return std::nullopt;
}

void SubShapeField::markChosen() {
  std::vector<Pick> chosen;
  if (picking())
    for (const Value& part : items())
      if (const auto pick = pickOf(part)) chosen.push_back(*pick);
  context()->markChosen(chosen);
}

bool SubShapeField::picking() const { return pick_ && pick_->isChecked(); }

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
    markChosen();
    return;
  }
  PickRequest request;
  request.want = PickRequest::Want::SubShape;
  request.kind = subShapeKindOf(subShapeKind(element()));
  request.several = several();
  for (const FieldContext::Source& source : context()->sources) request.features.push_back(source.feature);
  const QString what = registryText(subShapeKind(element()));
  request.hint = several() ? tr("Click every %1 for %2, again to let go; Esc ends").arg(what, registryText(label(spec())))
                           : tr("Click the %1 for %2; Esc ends").arg(what, registryText(label(spec())));
  emit pickWanted(this, request);
  markChosen();
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
    if (isLost(each, context()->lost)) return false;  // its number tells nothing any more
    return std::all_of(found.items().begin(), found.items().end(),
                       [&](const auto& entry) { return each.value(entry.key(), Value()) == entry.value(); });
  };
  const auto known = std::find_if(all.begin(), all.end(), isSame);
  const auto likeness = known == all.end() ? context()->likenessOf(pick) : std::nullopt;
  const auto lost = likeness ? lostPartFor(*likeness, all, context()->lost) : std::nullopt;
  if (known != all.end())
    all.erase(known);
  else if (lost)
    all[*lost] = found;
  else
    all.push_back(found);
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
