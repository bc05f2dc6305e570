#include "manipulators/factors/factor_net.h"

#include <QKeyEvent>
#include <QMouseEvent>
#include <algorithm>
#include <cmath>
#include <utility>

#include "ui/plugin/tool.h"

namespace blossom::sweep {

namespace {

constexpr double poleReach = 9;  // pixels around a pole
constexpr double netMargin = 16;

bool extends(Qt::KeyboardModifiers modifiers) { return modifiers & (Qt::ControlModifier | Qt::ShiftModifier); }

}  // namespace

FactorNet::FactorNet(QWidget* parent) : QWidget(parent) {
  setObjectName(QStringLiteral("factorNet"));
  setAccessibleName(tr("Poles over the (u, v) domain"));
  setFocusPolicy(Qt::StrongFocus);
  setMouseTracking(true);
  setMinimumSize(220, 130);
}

void FactorNet::setPoles(FactorLayout layout) {
  const bool other = layout.factor != layout_.factor;
  layout_ = std::move(layout);
  under_.reset();
  candidate_.reset();
  Chosen left;
  if (!other)
    for (const FactorPole& pole : chosen_)
      if (layout_.contains(pole)) left.insert(pole);
  update();
  setChosen(std::move(left));
}

void FactorNet::setSigns(std::vector<double> sizes, std::vector<double> directions) {
  sizes_ = std::move(sizes);
  directions_ = std::move(directions);
  update();
}

void FactorNet::choose(Chosen chosen) {
  if (chosen == chosen_) return;
  chosen_ = std::move(chosen);
  update();
}

void FactorNet::setChosen(Chosen chosen) {
  if (chosen == chosen_) return;
  choose(std::move(chosen));
  emit chosenChanged();
}

QRectF FactorNet::area() const { return QRectF(rect()).adjusted(netMargin + 8, 10, -12, -netMargin - 8); }

QPointF FactorNet::pixelsOf(double u, double v) const {
  const QRectF all = area();
  const auto share = [](double t, std::pair<double, double> domain) {
    return (t - domain.first) / (domain.second - domain.first);
  };
  return {all.left() + share(u, layout_.domainU) * all.width(), all.bottom() - share(v, layout_.domainV) * all.height()};
}

QPointF FactorNet::polePosition(int row, int column) const {
  const FactorPole pole{static_cast<std::size_t>(row), static_cast<std::size_t>(column)};
  if (!layout_.contains(pole)) return {-1, -1};
  return pixelsOf(layout_.us[pole.row], layout_.vs[pole.column]);
}

QPointF FactorNet::knotPosition(bool alongU, double knot) const {
  const QRectF all = area();
  return alongU ? QPointF(pixelsOf(knot, layout_.domainV.first).x(), all.bottom() + 6 + netMargin / 2)
                : QPointF(all.left() - 6 - netMargin / 2, pixelsOf(layout_.domainU.first, knot).y());
}

std::optional<FactorPole> FactorNet::poleAt(const QPointF& at) const {
  std::optional<FactorPole> nearest;
  double least = poleReach;
  for (std::size_t i = 0; i < layout_.rows(); ++i)
    for (std::size_t j = 0; j < layout_.columns(); ++j) {
      const QPointF apart = pixelsOf(layout_.us[i], layout_.vs[j]) - at;
      if (const double distance = std::hypot(apart.x(), apart.y()); distance < least)
        least = distance, nearest = FactorPole{i, j};
    }
  return nearest;
}

/// The knot that a click in the margin inserts, on a thousandth of the domain, and inside it.
std::optional<FactorNet::Knot> FactorNet::knotAt(const QPointF& at) const {
  const QRectF all = area();
  const bool below = at.y() > all.bottom() + 5, left = at.x() < all.left() - 5;
  if (below == left || (below && layout_.knotsU.empty())) return std::nullopt;
  const double share = below ? (at.x() - all.left()) / all.width() : (all.bottom() - at.y()) / all.height();
  const auto [first, last] = below ? layout_.domainU : layout_.domainV;
  constexpr double steps = 1000;
  const double rounded = std::round(share * steps) / steps;
  if (!(rounded > 0 && rounded < 1)) return std::nullopt;
  return Knot{below, first + rounded * (last - first)};
}

FactorNet::Chosen FactorNet::inside(const QRectF& frame) const {
  Chosen found;
  for (std::size_t i = 0; i < layout_.rows(); ++i)
    for (std::size_t j = 0; j < layout_.columns(); ++j)
      if (frame.contains(pixelsOf(layout_.us[i], layout_.vs[j]))) found.insert({i, j});
  return found;
}

void FactorNet::takePole(const FactorPole& pole, bool extend) {
  Chosen chosen = chosen_;
  toggle_ = extend && chosen.contains(pole);  // taken away when it is not dragged
  if (!extend && !chosen.contains(pole)) chosen.clear();
  chosen.insert(pole);
  drag_ = Drag::Poles;
  setChosen(std::move(chosen));
}

void FactorNet::mousePressEvent(QMouseEvent* event) {
  event->accept();
  if (event->button() != Qt::LeftButton || drag_ != Drag::None || layout_.rows() == 0) return;
  pressed_ = now_ = event->position();
  moved_ = toggle_ = false;
  if (const auto pole = poleAt(pressed_)) return takePole(*pole, extends(event->modifiers()));
  if (const auto knot = knotAt(pressed_)) {
    candidate_.reset();
    emit knotWanted(knot->alongU, knot->at);
    return;
  }
  drag_ = Drag::Frame;
  before_ = extends(event->modifiers()) ? chosen_ : Chosen();
  setChosen(before_);
}

void FactorNet::mouseMoveEvent(QMouseEvent* event) {
  event->accept();
  now_ = event->position();
  if (drag_ == Drag::None) return hoverAt(now_);
  const QPointF by = now_ - pressed_;
  moved_ = moved_ || by.manhattanLength() >= ui::clickReach;
  if (!moved_) return;
  if (drag_ == Drag::Poles) {
    emit dragged({by.x(), -by.y()});
  } else {
    Chosen chosen = inside(QRectF(pressed_, now_).normalized());
    chosen.insert(before_.begin(), before_.end());
    setChosen(std::move(chosen));
  }
  update();
}

void FactorNet::mouseReleaseEvent(QMouseEvent* event) {
  event->accept();
  if (event->button() != Qt::LeftButton) return;
  const Drag ended = std::exchange(drag_, Drag::None);
  update();
  if (ended != Drag::Poles) return;
  if (moved_) {
    emit dropped();
  } else if (const auto pole = poleAt(pressed_)) {
    Chosen chosen = extends(event->modifiers()) ? chosen_ : Chosen{*pole};
    if (toggle_) chosen.erase(*pole);
    setChosen(std::move(chosen));
  }
}

void FactorNet::giveUp() {
  const Drag ended = std::exchange(drag_, Drag::None);
  if (ended == Drag::Poles) emit cancelled();
  update();
}

/// An arrow key goes to the neighbour of a single pole; around a closed motion it goes on.
bool FactorNet::step(int key) {
  if (chosen_.size() != 1) return false;
  FactorPole pole = *chosen_.begin();
  const int right = (key == Qt::Key_Right) - (key == Qt::Key_Left), up = (key == Qt::Key_Up) - (key == Qt::Key_Down);
  if (right == 0 && up == 0) return false;
  const auto moved = [](std::size_t index, int by, std::size_t count, bool around) {
    const auto n = static_cast<int>(count), to = static_cast<int>(index) + by;
    return static_cast<std::size_t>(around ? (to + n) % n : std::clamp(to, 0, n - 1));
  };
  pole = {moved(pole.row, right, layout_.rows(), layout_.closed), moved(pole.column, up, layout_.columns(), false)};
  setChosen({pole});
  return true;
}

void FactorNet::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Escape && drag_ != Drag::None) return giveUp();
  if (event->matches(QKeySequence::SelectAll)) return setChosen(inside(QRectF(rect())));
  if (drag_ != Drag::None || !step(event->key())) QWidget::keyPressEvent(event);
}

// Shortcuts of the window come before the keys of a widget.
bool FactorNet::event(QEvent* event) {
  if (event->type() == QEvent::ShortcutOverride) {
    const auto& key = static_cast<const QKeyEvent&>(*event);
    if ((key.key() == Qt::Key_Escape && drag_ != Drag::None) || key.matches(QKeySequence::SelectAll)) event->accept();
  }
  return QWidget::event(event);
}

void FactorNet::hoverAt(const QPointF& at) {
  under_ = poleAt(at);
  candidate_ = under_ ? std::nullopt : knotAt(at);
  setCursor(under_ ? Qt::PointingHandCursor : candidate_ ? Qt::CrossCursor : Qt::ArrowCursor);
  update();
  if (candidate_)
    emit hovered(tr("Click to insert a knot at %1 = %2")
                     .arg(candidate_->alongU ? QStringLiteral("u") : QStringLiteral("v"))
                     .arg(candidate_->at));
  else if (!under_)
    emit hovered(tr("Click a pole to choose it, drag a frame around several · click in the margin to insert a knot"));
  else if (layout_.factor == Factor::Orientation)
    emit hovered(tr("Drag to the right or left to turn the pole about the axis · Ctrl: choose several"));
  else if (layout_.factor == Factor::Scaling)
    emit hovered(tr("Drag up or down to scale the pole · Ctrl: choose several"));
  else
    emit hovered(tr("Drag up or down to change the weight of the pole · Ctrl: choose several"));
}

void FactorNet::leaveEvent(QEvent*) {
  under_.reset();
  candidate_.reset();
  update();
  emit hovered({});
}

}  // namespace blossom::sweep
