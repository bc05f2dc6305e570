#include "ui/page/first_look.h"

#include <string>
#include <utility>

#include "ui/look/preferences.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

namespace {

void lookByItself(ViewWidget& view, bool animated) {
  view.lookFrom(QStringLiteral("auto"), animated);
  if (Preferences::instance().get<std::string>("projection") == "parallel") view.setParallel(true);
}

bool looksFromAbove(const ViewWidget& view) { return view.camera().heading().toCamera().z() > 1 - 1e-9; }

}  // namespace

void FirstLook::expect() {
  pending_ = true;
  drawn_ = fromAbove_ = false;
}

void FirstLook::show(ViewWidget& view) {
  pending_ = false;
  if (drawn_) return view.fit(true);
  lookByItself(view, false);
  fromAbove_ = looksFromAbove(view);
}

// Only a view that has not been turned since.
void FirstLook::showSolid(ViewWidget& view, bool mayTurn) {
  if (std::exchange(fromAbove_, false) && mayTurn && looksFromAbove(view)) lookByItself(view, true);
}

}  // namespace blossom::ui
