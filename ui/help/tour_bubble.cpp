#include "ui/help/tour_bubble.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QPainter>
#include <QPainterPath>
#include <QPushButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look/theme.h"

namespace blossom::ui {

namespace {

constexpr int tipSize = 10, radius = 10, bubbleGap = 6, bubbleWidth = 340;

}  // namespace

TourFrame::TourFrame(QWidget* window) : QWidget(window) {
  setAttribute(Qt::WA_TransparentForMouseEvents);
  setFocusPolicy(Qt::NoFocus);
}

void TourFrame::paintEvent(QPaintEvent*) {
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setPen(QPen(theme().color("control"), 2));
  painter.drawRoundedRect(QRectF(rect()).adjusted(2, 2, -2, -2), 6, 6);
}

TourBubble::TourBubble(QWidget* window)
    : QWidget(window),
      title_(new QLabel),
      text_(new QLabel),
      where_(new QLabel),
      skip_(new QPushButton(tr("&Skip"))),
      back_(new QPushButton(tr("&Back"))),
      next_(new QPushButton) {
  setObjectName(QStringLiteral("tourBubble"));
  setAccessibleName(tr("Tour"));
  setFixedWidth(bubbleWidth);
  title_->setObjectName(QStringLiteral("featureName"));
  text_->setWordWrap(true);
  where_->setObjectName(QStringLiteral("note"));
  skip_->setObjectName(QStringLiteral("link"));
  next_->setProperty("primary", true);
  connect(skip_, &QPushButton::clicked, this, &TourBubble::endWanted);
  connect(back_, &QPushButton::clicked, this, &TourBubble::backWanted);
  connect(next_, &QPushButton::clicked, this, &TourBubble::nextWanted);
  auto* buttons = new QHBoxLayout;
  buttons->addWidget(skip_);
  buttons->addWidget(where_);
  buttons->addStretch(1);
  buttons->addWidget(back_);
  buttons->addWidget(next_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(18 + tipSize, 16 + tipSize, 18 + tipSize, 14 + tipSize);
  column->setSpacing(8);
  column->addWidget(title_);
  column->addWidget(text_);
  column->addSpacing(6);
  column->addLayout(buttons);
}

void TourBubble::showStep(const QString& title, const QString& text, std::size_t step, std::size_t steps) {
  title_->setText(title);
  text_->setText(text);
  where_->setText(tr("%1 of %2").arg(step + 1).arg(steps));
  const bool last = step + 1 == steps;
  next_->setText(last ? tr("&Done") : tr("&Next"));
  back_->setVisible(step > 0);
  skip_->setVisible(!last);
  const int room = bubbleWidth - 36 - 2 * tipSize;
  text_->setMinimumHeight(text_->heightForWidth(room));
  layout()->activate();
  resize(bubbleWidth, layout()->hasHeightForWidth() ? layout()->totalHeightForWidth(bubbleWidth) : sizeHint().height());
}

// The bubble's own margin holds the tip, so its edge may touch what it points at.
QPoint TourBubble::placeFor(Tip tip, const QRect& target) const {
  const QPoint middle = target.center() - QPoint(width() / 2, height() / 2);
  switch (tip) {
    case Tip::Left:
      return {target.right() + bubbleGap, middle.y()};
    case Tip::Right:
      return {target.left() - bubbleGap - width(), middle.y()};
    case Tip::Top:
      return {middle.x(), target.bottom() + bubbleGap};
    case Tip::Bottom:
      return {middle.x(), target.top() - bubbleGap - height()};
    case Tip::None:
      break;
  }
  return middle;
}

void TourBubble::pointAt(const QRect& target) {
  const QRect room = parentWidget()->rect();
  tip_ = Tip::None;
  QPoint at = room.center() - QPoint(width() / 2, height() / 2);
  // Inside what is too large to stand beside: at its foot, where it hides least.
  if (!target.isEmpty()) at = {placeFor(Tip::None, target).x(), target.bottom() - height() - 2 * tipSize};
  for (const Tip tip : {Tip::Left, Tip::Right, Tip::Top, Tip::Bottom}) {
    if (target.isEmpty()) break;
    QPoint wanted = placeFor(tip, target);
    const bool across = tip == Tip::Left || tip == Tip::Right;
    if (across)
      wanted.setY(std::clamp(wanted.y(), 0, std::max(0, room.height() - height())));
    else
      wanted.setX(std::clamp(wanted.x(), 0, std::max(0, room.width() - width())));
    if (!room.contains(QRect(wanted, size()))) continue;
    tip_ = tip;
    at = wanted;
    const int place = across ? target.center().y() - at.y() : target.center().x() - at.x();
    const int side = across ? height() : width();
    tipAt_ = std::clamp(place, 2 * tipSize + radius, side - 2 * tipSize - radius);
    break;
  }
  move(at);
  update();
}

void TourBubble::takeFocus() { next_->setFocus(); }

QString TourBubble::title() const { return title_->text(); }

void TourBubble::paintEvent(QPaintEvent*) {
  const Theme& colors = theme();
  const QRectF body = QRectF(rect()).adjusted(tipSize, tipSize, -tipSize, -tipSize).adjusted(0.5, 0.5, -0.5, -0.5);
  QPainterPath shape;
  shape.addRoundedRect(body, radius, radius);
  QPolygonF tip;
  const double t = tipAt_;
  if (tip_ == Tip::Left)
    tip << QPointF(body.left() + 1, t - tipSize) << QPointF(1, t) << QPointF(body.left() + 1, t + tipSize);
  if (tip_ == Tip::Right)
    tip << QPointF(body.right() - 1, t - tipSize) << QPointF(width() - 1, t) << QPointF(body.right() - 1, t + tipSize);
  if (tip_ == Tip::Top) tip << QPointF(t - tipSize, body.top() + 1) << QPointF(t, 1) << QPointF(t + tipSize, body.top() + 1);
  if (tip_ == Tip::Bottom)
    tip << QPointF(t - tipSize, body.bottom() - 1) << QPointF(t, height() - 1) << QPointF(t + tipSize, body.bottom() - 1);
  if (!tip.isEmpty()) {
    QPainterPath pointer;
    pointer.addPolygon(tip);
    pointer.closeSubpath();
    shape = shape.united(pointer);
  }
  QPainter painter(this);
  painter.setRenderHint(QPainter::Antialiasing);
  painter.setBrush(colors.color("panel"));
  painter.setPen(QPen(colors.color("control"), 1));
  painter.drawPath(shape);
}

void TourBubble::keyPressEvent(QKeyEvent* event) {
  switch (event->key()) {
    case Qt::Key_Escape:
      return emit endWanted();
    case Qt::Key_Return:
    case Qt::Key_Enter:
    case Qt::Key_Right:
      return emit nextWanted();
    case Qt::Key_Left:
      return emit backWanted();
    default:
      QWidget::keyPressEvent(event);
  }
}

}  // namespace blossom::ui
