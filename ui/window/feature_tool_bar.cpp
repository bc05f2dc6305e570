#include "ui/window/feature_tool_bar.h"

#include <QEvent>
#include <QFrame>
#include <QMenu>
#include <QToolButton>
#include <algorithm>
#include <numeric>

#include "ui/look/icons.h"

namespace blossom::ui {

namespace {

constexpr int lineSpace = 19, buttonGap = 1;

QToolButton* toolButton(QWidget* parent) {
  auto* button = new QToolButton(parent);
  button->setToolButtonStyle(Qt::ToolButtonTextUnderIcon);
  button->setIconSize({20, 20});
  button->setAutoRaise(true);
  return button;
}

bool looksLike(const QIcon& a, const QIcon& b) { return a.pixmap(20, 20).toImage() == b.pixmap(20, 20).toImage(); }

int widthOf(const QWidget* button) { return button->sizeHint().width() + buttonGap; }

}  // namespace

FeatureToolBar::FeatureToolBar(const FeatureMenus& menus, QWidget* field, QWidget* parent)
    : QWidget(parent), others_(toolButton(this)), field_(field) {
  field_->setParent(this);
  setSizePolicy(QSizePolicy::Expanding, QSizePolicy::Preferred);
  for (const FeatureGroup& source : menus.groups()) {
    Group group;
    for (QAction* action : source.actions) {
      group.buttons.push_back(toolButton(this));
      group.buttons.back()->setDefaultAction(action);
    }
    group.rest = toolButton(this);
    group.rest->setObjectName(QStringLiteral("featureGroup"));
    group.own = icon(source.icon);
    const auto twin = std::find_if(source.actions.begin(), source.actions.end(),
                                   [&](const QAction* action) { return looksLike(action->icon(), group.own); });
    group.twin = static_cast<std::size_t>(twin - source.actions.begin());
    group.rest->setIcon(group.own);
    group.rest->setText(source.title + QStringLiteral(" ▾"));
    group.rest->setToolTip(tr("Everything of %1").arg(source.title));
    group.rest->setAccessibleName(source.title);
    group.rest->setPopupMode(QToolButton::InstantPopup);
    group.rest->setMenu(source.menu);
    group.rest->installEventFilter(this);
    group.line = new QFrame(this);
    group.line->setObjectName(QStringLiteral("groupLine"));
    groups_.push_back(std::move(group));
  }
  offerRest();
}

void FeatureToolBar::offerRest() {
  auto* menu = new QMenu(this);
  others_->setObjectName(QStringLiteral("otherGroups"));
  others_->setIcon(clearIcon(QStringLiteral("overflow")));
  others_->setText(tr("More"));
  others_->setToolTip(tr("The groups for which the window is too narrow"));
  others_->setPopupMode(QToolButton::InstantPopup);
  others_->setMenu(menu);
  others_->installEventFilter(this);
  others_->setVisible(false);
  connect(menu, &QMenu::aboutToShow, this, [this, menu] {
    menu->clear();
    for (const Group& group : groups_)
      if (!group.hasRoom) menu->addAction(group.rest->menu()->menuAction());
  });
}

// With `shown` of its buttons, and the menu when that is not all.
int FeatureToolBar::widthOf(const Group& group, std::size_t shown) const {
  int width = shown < group.buttons.size() ? ui::widthOf(group.rest) : 0;
  for (std::size_t i = 0; i < shown; ++i) width += ui::widthOf(group.buttons[i]);
  return width;
}

QSize FeatureToolBar::sizeHint() const {
  int width = 0, height = 0;
  for (const Group& group : groups_) {
    width += lineSpace + widthOf(group, group.buttons.size());
    for (const QToolButton* button : group.buttons) height = std::max(height, button->sizeHint().height());
  }
  return {width + field_->maximumWidth(), height};
}

// One button a group.
int FeatureToolBar::leastOfAll() const {
  return std::accumulate(groups_.begin(), groups_.end(), 0,
                         [this](int sum, const Group& group) { return sum + lineSpace + leastWidth(group); });
}

QSize FeatureToolBar::minimumSizeHint() const {
  return {lineSpace + ui::widthOf(others_) + field_->minimumWidth(), sizeHint().height()};
}

// The first groups that find room, and the button for the others when those are not all.
void FeatureToolBar::chooseGroups(int width) {
  const bool all = leastOfAll() <= width;
  int left = all ? width : width - lineSpace - ui::widthOf(others_);
  for (Group& group : groups_) {
    left -= lineSpace + leastWidth(group);
    group.hasRoom = left >= 0;
  }
  others_->setVisible(!all);
}

// One button more for each group in turn, as long as there is room.
void FeatureToolBar::share(int width) {
  for (Group& group : groups_) group.shown = group.hasRoom && group.buttons.size() == 1 ? 1 : 0;
  const auto total = [this] {
    return std::accumulate(groups_.begin(), groups_.end(), 0, [this](int sum, const Group& group) {
      return group.hasRoom ? sum + lineSpace + widthOf(group, group.shown) : sum;
    });
  };
  for (bool grown = true; grown;) {
    grown = false;
    for (Group& group : groups_) {
      if (!group.hasRoom) continue;
      const std::size_t before = group.shown;
      // The last one takes the place of the menu; where both are equally wide it comes for free.
      for (std::size_t more = 1; more <= 2 && group.shown == before && before + more <= group.buttons.size(); ++more) {
        group.shown = before + more;
        if (total() > width) group.shown = before;
      }
      grown = grown || group.shown != before;
    }
  }
}

// Of the field: as much as all buttons leave, but its words are seen also where there are more buttons than room.
int FeatureToolBar::comfortable() const {
  constexpr int withWords = 150;
  const int all = sizeHint().width() - field_->maximumWidth();
  return std::clamp(width() - all, withWords, field_->maximumWidth());
}

void FeatureToolBar::arrange() {
  const int field = std::clamp(width() - leastOfAll(), field_->minimumWidth(), comfortable());
  const int room = width() - field;
  chooseGroups(room);
  share(others_->isHidden() ? room : room - lineSpace - ui::widthOf(others_));
  int x = 0;
  for (Group& group : groups_) group.hasRoom ? place(group, x) : hide(group);
  const QSize size = others_->sizeHint();
  others_->setGeometry(x + lineSpace, (height() - size.height()) / 2, size.width(), size.height());
  const int high = std::min(field_->sizeHint().height(), height());
  field_->setGeometry(room, (height() - high) / 2, field, high);
}

void FeatureToolBar::hide(Group& group) {
  group.line->hide();
  group.rest->hide();
  for (QToolButton* button : group.buttons) button->hide();
}

void FeatureToolBar::place(Group& group, int& x) {
  group.line->show();
  group.line->setGeometry(x + lineSpace / 2, 8, 1, height() - 16);
  x += lineSpace;
  const auto put = [&](QToolButton* button, bool visible) {
    button->setVisible(visible);
    if (!visible) return;
    const QSize size = button->sizeHint();
    button->setGeometry(x, (height() - size.height()) / 2, size.width(), size.height());
    x += size.width() + buttonGap;
  };
  for (std::size_t i = 0; i < group.buttons.size(); ++i) put(group.buttons[i], i < group.shown);
  const bool more = group.shown < group.buttons.size();
  put(group.rest, more);
  // Not the picture of a button beside it.
  const QIcon wanted = more && group.twin < group.shown ? group.buttons[group.shown]->icon() : group.own;
  if (group.rest->icon().cacheKey() != wanted.cacheKey()) group.rest->setIcon(wanted);
}

void FeatureToolBar::resizeEvent(QResizeEvent* event) {
  QWidget::resizeEvent(event);
  arrange();
}

bool FeatureToolBar::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::Enter) emit hint(static_cast<QWidget*>(watched)->toolTip());
  return QWidget::eventFilter(watched, event);
}

// Fonts and paddings come with the style sheet, after the buttons were made.
bool FeatureToolBar::event(QEvent* event) {
  const bool restyled =
      event->type() == QEvent::LayoutRequest || event->type() == QEvent::StyleChange || event->type() == QEvent::Polish;
  const bool handled = QWidget::event(event);
  if (restyled) arrange();
  return handled;
}

}  // namespace blossom::ui
