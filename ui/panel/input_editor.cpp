#include "ui/panel/input_editor.h"

#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/controls/chip.h"
#include "ui/controls/field_label.h"
#include "ui/controls/pick_button.h"
#include "ui/fields/parameter_field.h"
#include "ui/look/icons.h"
#include "ui/look/popup_menu.h"
#include "ui/look/registry_text.h"
#include "ui/look/text.h"
#include "ui/plugin/tool.h"
#include "ui/session/session.h"

namespace blossom::ui {

namespace {

constexpr int besideCaption = 10;

QString iconOf(const Registry& registry, const Feature& feature) {
  const auto type = registry.find(feature.type);
  return type && !type->icon.empty() ? qt(type->icon) : QStringLiteral("feature");
}

QToolButton* cornerButton(const QString& iconName, const QString& what) {
  auto* button = new QToolButton;
  button->setObjectName(QStringLiteral("fieldButton"));
  button->setIcon(icon(iconName));
  button->setToolTip(what);
  button->setAccessibleName(what);
  return button;
}

}  // namespace

InputEditor::InputEditor(Session& session, FeatureId feature, std::shared_ptr<const FeatureType> type, std::size_t spec,
                         QWidget* parent)
    : QWidget(parent),
      session_(session),
      feature_(std::move(feature)),
      type_(std::move(type)),
      spec_(spec),
      grid_(new QGridLayout(this)),
      chips_(new QVBoxLayout),
      add_(cornerButton(QStringLiteral("plus"), tr("Add an input"))),
      pick_(new PickButton(QStringLiteral("pick-feature"), tr("Pick in the view"))),
      problem_(new QLabel) {
  setObjectName(QStringLiteral("input:") + qt(input().name));
  grid_->setContentsMargins(0, 0, 0, 0);
  grid_->setHorizontalSpacing(besideCaption);
  grid_->setVerticalSpacing(3);
  auto* name = new FieldLabel(sentenceCase(registryText(input().name)));
  name->setFixedWidth(labelWidth);
  name->setToolTip(registryText(input().help));
  chips_->setSpacing(4);
  problem_->setObjectName(QStringLiteral("fieldError"));
  problem_->setWordWrap(true);
  problem_->hide();
  grid_->addWidget(name, 0, 0);
  if (input().maximum == 1) {
    line_ = new QHBoxLayout;
    line_->setSpacing(2);
    line_->addLayout(chips_, 1);
    line_->addWidget(add_);
    line_->addWidget(pick_);
    grid_->addLayout(line_, 0, 1);
  } else {
    auto* buttons = new QHBoxLayout;
    buttons->setSpacing(2);
    buttons->addStretch();
    buttons->addWidget(add_);
    buttons->addWidget(pick_);
    grid_->addLayout(buttons, 0, 1);
    grid_->addLayout(chips_, 1, 0, 1, 2);
  }
  grid_->addWidget(problem_, 2, 0, 1, 2);
  grid_->setColumnStretch(1, 1);
  connect(add_, &QToolButton::clicked, this, &InputEditor::showAddMenu);
  connect(pick_, &QToolButton::toggled, this, [this](bool on) {
    const auto slots_ = inputSlots();
    if (on && slots_)
      wantPick(input().maximum == 1 ? 0 : slots_->of(spec_).size());
    else
      emit pickUnwanted(this);
  });
  refresh();
}

std::optional<InputSlots> InputEditor::inputSlots() const {
  if (!session_.document().contains(feature_)) return std::nullopt;
  return InputSlots(session_, session_.document().at(feature_), *type_);
}

void InputEditor::refresh() {
  const auto now = inputSlots();
  if (!now) return;
  const std::vector<FeatureId>& taken = now->of(spec_);
  QStringList wanted;
  for (const FeatureId& id : taken) wanted << qt(id) + u'\n' + qt(shownName(session_.document().at(id)));
  add_->setVisible(taken.size() < input().maximum);
  if (wanted == shown_ && chips_->count() > 0) return;
  shown_ = wanted;
  showProblem({});
  rebuild(taken);
}

void InputEditor::rebuild(const std::vector<FeatureId>& taken) {
  int focused = -1;
  for (int k = 0; k < chips_->count(); ++k)
    if (chips_->itemAt(k)->widget()->hasFocus()) focused = k;
  if (focused >= 0) pick_->setFocus();  // or a field below would get it, and the form would scroll there
  while (const QLayoutItem* item = chips_->takeAt(0)) {
    item->widget()->hide();
    item->widget()->deleteLater();  // it may be the one that was clicked
    delete item;
  }
  chipWidth_ = 0;  // layouts leave out what is not shown yet
  for (std::size_t place = 0; place < taken.size(); ++place) addChip(taken[place], place, taken.size());
  if (taken.empty()) {
    auto* none = new QLabel(input().minimum > 0 ? tr("must be given") : tr("none"));
    none->setObjectName(input().minimum > 0 ? QStringLiteral("fieldError") : QStringLiteral("note"));
    none->setMinimumHeight(24);
    chips_->addWidget(none);
  }
  placeLine();
  if (focused >= 0 && !taken.empty()) chips_->itemAt(std::min(focused, chips_->count() - 1))->widget()->setFocus();
}

// A name that there is no room for beside the caption stands below it.
void InputEditor::placeLine() {
  if (!line_) return;
  int wanted = chipWidth_ + line_->spacing() + pick_->sizeHint().width();
  if (!add_->isHidden()) wanted += line_->spacing() + add_->sizeHint().width();
  const bool below = wanted > width() - labelWidth - besideCaption;
  if (below == below_) return;
  below_ = below;
  grid_->removeItem(line_);
  line_->setParent(nullptr);  // or it could not be added again
  grid_->addLayout(line_, below ? 1 : 0, below ? 0 : 1, 1, below ? 2 : 1);
}

void InputEditor::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  placeLine();
}

void InputEditor::addChip(const FeatureId& id, std::size_t place, std::size_t count) {
  const Feature& feature = session_.document().at(id);
  auto* chip = new Chip(qt(shownName(feature)));
  chip->setIconName(iconOf(*session_.app().registry, feature));
  chip->setRemovable(count > input().minimum);
  chip->setChevron(true);
  chips_->addWidget(chip);
  chipWidth_ = std::max(chipWidth_, chip->sizeHint().width());
  connect(chip, &Chip::clicked, this,
          [this, chip, place] { showChipMenu(place, chip->mapToGlobal(QPoint(0, chip->height()))); });
  connect(chip, &Chip::removed, this, [this, place] {
    auto rest = inputSlots()->of(spec_);
    rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(place));
    commit(rest);
  });
}

void InputEditor::addCandidates(QMenu& menu, std::size_t place) {
  const auto candidates = inputSlots()->candidates(spec_);
  for (const FeatureId& id : candidates) {
    const Feature& feature = session_.document().at(id);
    menu.addAction(icon(iconOf(*session_.app().registry, feature)), qt(shownName(feature)), this,
                   [this, place, id] { take(place, id); });
  }
  if (candidates.empty()) menu.addAction(tr("Nothing else fits here"))->setEnabled(false);
}

void InputEditor::showChipMenu(std::size_t place, const QPoint& at) {
  const auto taken = inputSlots()->of(spec_);
  QMenu& menu = popupMenu(this);
  addCandidates(menu, place);
  menu.addSeparator();
  menu.addAction(icon(QStringLiteral("pick-feature")), tr("Pick in the view"), this, [this, place] { wantPick(place); });
  const auto addMove = [&](const QString& title, std::ptrdiff_t by, bool possible) {
    menu.addAction(title, this,
                   [this, place, by] {
                     auto order = inputSlots()->of(spec_);
                     const auto item = order.begin() + static_cast<std::ptrdiff_t>(place);
                     std::iter_swap(item, item + by);
                     commit(order);
                   })
        ->setEnabled(possible);
  };
  if (taken.size() > 1) {
    addMove(tr("Move up"), -1, place > 0);
    addMove(tr("Move down"), 1, place + 1 < taken.size());
  }
  menu.popup(at);
}

void InputEditor::showAddMenu() {
  QMenu& menu = popupMenu(this);
  addCandidates(menu, inputSlots()->of(spec_).size());
  menu.popup(add_->mapToGlobal(QPoint(0, add_->height())));
}

void InputEditor::take(std::size_t place, const FeatureId& id) {
  const auto now = inputSlots();
  if (!now) return;
  auto taken = now->of(spec_);
  if (place < taken.size() && taken[place] == id) return;
  const QString name = qt(shownName(session_.document().at(id)));
  if (now->dependsOnThis(id))
    return showProblem(tr("\"%1\" needs this feature itself; taking it would go round in a circle.").arg(name));
  if (!now->accepts(spec_, id))
    return showProblem(tr("\"%1\" is %2, which does not fit here.")
                           .arg(name, qt(shapeKindName(session_.view(id)->result->evaluated.shape.kind()))));
  if (place < taken.size())
    taken[place] = id;
  else
    taken.push_back(id);
  commit(taken);
}

void InputEditor::commit(const std::vector<FeatureId>& taken) {
  const Feature feature = inputSlots()->with(spec_, taken);
  const QString what = tr("Change %1 of %2").arg(registryText(input().name), qt(shownName(feature)));
  try {
    const Document changed = session_.document().with(feature);
    showProblem({});
    session_.commit(changed, what);
  } catch (const Error& error) {
    showProblem(qt(error.message()));
  }
}

void InputEditor::wantPick(std::size_t place) {
  pickPlace_ = place;
  PickRequest request;
  request.want = PickRequest::Want::Feature;
  request.parameter = qt(input().name) + u'/' + QString::number(place);
  request.several = input().maximum > 1 && place >= inputSlots()->of(spec_).size();
  request.hint = tr("Click what %1 is to be; Esc ends").arg(qt(input().name));
  const QSignalBlocker quiet(pick_);
  pick_->setChecked(true);
  emit pickWanted(this, request);
}

bool InputEditor::takePick(const Pick& pick) {
  if (pick.feature.empty() || !session_.document().contains(pick.feature)) return false;
  const auto now = inputSlots();
  if (!now) return false;
  if (pickPlace_ >= input().maximum) {
    showProblem(tr("There is no room for more."));
    return false;
  }
  take(pickPlace_, pick.feature);
  if (!problem().isEmpty()) return false;
  pickPlace_ = std::min(pickPlace_ + 1, inputSlots()->of(spec_).size());
  return true;
}

void InputEditor::pickEnded() {
  const QSignalBlocker quiet(pick_);
  pick_->setChecked(false);
}

QString InputEditor::problem() const { return problem_->isHidden() ? QString() : problem_->text(); }

void InputEditor::showProblem(const QString& text) {
  problem_->setText(text);
  problem_->setVisible(!text.isEmpty());
}

void InputEditor::enterEvent(QEnterEvent*) {
  emit hint(QStringLiteral("%1: %2").arg(sentenceCase(registryText(input().name)), registryText(input().help)));
}

}  // namespace blossom::ui
