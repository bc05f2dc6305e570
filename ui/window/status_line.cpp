#include "ui/window/status_line.h"

#include <QAction>
#include <QEvent>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QProgressBar>
#include <QToolButton>
#include <algorithm>
#include <cmath>

#include "ui/look/icons.h"

namespace blossom::ui {

namespace {

constexpr int barWidth = 120, narrowBarWidth = 24;

}  // namespace

StatusLine::StatusLine(QWidget* parent)
    : QFrame(parent),
      pickMode_(new QToolButton),
      hint_(new QLabel),
      whereabouts_(new QLabel),
      workText_(new QToolButton),
      bar_(new QProgressBar),
      cancel_(new QToolButton) {
  setObjectName(QStringLiteral("statusLine"));
  setFixedHeight(24);
  bar_->setRange(0, 1000);
  bar_->setTextVisible(false);
  bar_->setFixedWidth(barWidth);
  cancel_->setObjectName(QStringLiteral("cancelWork"));
  cancel_->setIcon(icon(QStringLiteral("close")));
  cancel_->setIconSize({12, 12});
  cancel_->setToolTip(tr("Cancel"));
  cancel_->setAccessibleName(tr("Cancel"));
  whereabouts_->setAlignment(Qt::AlignRight | Qt::AlignVCenter);
  workText_->setObjectName(QStringLiteral("work"));
  workText_->setToolTip(tr("Show all jobs"));
  connect(workText_, &QToolButton::clicked, this, &StatusLine::jobsWanted);
  pickMode_->setObjectName(QStringLiteral("pickMode"));
  pickMode_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  pickMode_->setIconSize({14, 14});
  pickMode_->setPopupMode(QToolButton::InstantPopup);
  pickMode_->setToolTip(tr("What a click in the view selects"));
  pickMode_->hide();
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 0, 14, 0);
  row->setSpacing(10);
  row->addWidget(pickMode_);  // first, so that no text that grows moves it
  row->addWidget(hint_, 1);
  row->addWidget(whereabouts_);
  row->addWidget(workText_);
  row->addWidget(bar_);
  row->addWidget(cancel_);  // last, so that no text that grows moves it from under the mouse
  hint_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Preferred);
  // On a small screen they give way: no text may make the window wider.
  for (QWidget* text : {static_cast<QWidget*>(whereabouts_), static_cast<QWidget*>(workText_)}) text->setMinimumWidth(1);
  hint_->installEventFilter(this);
  announcing_.setSingleShot(true);
  announcing_.setInterval(6000);
  connect(&announcing_, &QTimer::timeout, this, [this] { say(idle_); });
  // What is done at once needs no bar that flickers.
  patience_.setSingleShot(true);
  patience_.setInterval(150);
  connect(&patience_, &QTimer::timeout, this, &StatusLine::refresh);
  // Long enough to read what is there.
  turning_.setInterval(4000);
  connect(&turning_, &QTimer::timeout, this, [this] {
    ++page_;
    fitHint();
  });
  connect(cancel_, &QToolButton::clicked, this, &StatusLine::cancelled);
  refresh();
}

void StatusLine::setHint(const QString& text) {
  idle_ = text.isEmpty() ? standing_ : text;
  if (!announcing_.isActive()) say(idle_);
}

void StatusLine::setStandingHint(const QString& text) {
  if (idle_.isEmpty() || idle_ == standing_) setHint(text);
  standing_ = text;
}

QString StatusLine::hint() const { return said_; }

void StatusLine::say(const QString& text) {
  if (said_ != text) page_ = 0, turning_.stop();
  said_ = text;
  fitHint();
}

// What there is no room for comes a moment later, and is told by the tool tip, rather than cut in the midst of a letter.
void StatusLine::fitHint() {
  const QStringList all = pages();
  if (all.size() < 2) turning_.stop();
  if (all.size() > 1 && !turning_.isActive()) turning_.start();
  page_ = page_ < all.size() ? page_ : 0;
  const QString shown = hint_->fontMetrics().elidedText(all[page_], Qt::ElideRight, hint_->width());
  hint_->setToolTip(shown == said_ ? QString() : said_);
  if (shown != hint_->text()) hint_->setText(shown);
}

QStringList StatusLine::pages() const {
  const QString separator = QStringLiteral(" · "), more(QChar(0x2026));
  const auto fits = [this](const QString& text) { return hint_->fontMetrics().horizontalAdvance(text) <= hint_->width(); };
  if (fits(said_)) return {said_};
  QStringList all, page;
  const auto written = [&](const QStringList& parts, bool last) {
    return ((all.empty() ? QStringList() : QStringList{more}) + parts + (last ? QStringList() : QStringList{more}))
        .join(separator);
  };
  for (const QString& part : said_.split(separator, Qt::SkipEmptyParts)) {
    if (!page.empty() && !fits(written(page + QStringList{part}, false))) {
      all << written(page, false);
      page.clear();
    }
    page << part;
  }
  return all << written(page, true);
}

bool StatusLine::eventFilter(QObject* object, QEvent* event) {
  if (object == hint_ && event->type() == QEvent::Resize) fitHint();
  return QFrame::eventFilter(object, event);
}

void StatusLine::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  shareRoom();
}

// The hint gives way first, then the bar, then the end of the place; what is being done is read in full. At once, for a text
// that is painted in the room of the one before it is cut.
void StatusLine::shareRoom() {
  const QMargins margins = layout()->contentsMargins();
  const int gap = layout()->spacing();
  int room = width() - margins.left() - margins.right() - gap;
  for (const QToolButton* each : {pickMode_, workText_, cancel_})
    if (!each->isHidden()) room -= each->sizeHint().width() + gap;
  const QFontMetrics font = whereabouts_->fontMetrics();
  if (!bar_->isHidden()) {
    bar_->setFixedWidth(std::clamp(room - gap - font.horizontalAdvance(where_), narrowBarWidth, barWidth));
    room -= bar_->minimumWidth() + gap;
  }
  whereabouts_->setText(font.elidedText(where_, Qt::ElideRight, std::max(0, room)));
  layout()->activate();
}

void StatusLine::setJobs(int running) {
  jobs_ = running;
  if (!patience_.isActive()) refresh();
}

void StatusLine::setPickModes(QMenu* modes) {
  pickMode_->setMenu(modes);
  pickMode_->show();
}

void StatusLine::showPickMode(const QAction& chosen) {
  pickMode_->setText(tr("Select: %1").arg(chosen.iconText()));
  pickMode_->setIcon(chosen.icon());
  shareRoom();
}

void StatusLine::setWhereabouts(const QString& text) {
  where_ = text;
  shareRoom();
}

void StatusLine::announce(const QString& text) {
  say(text);
  announcing_.start();
}

void StatusLine::setWork(const QString& key, const QString& what, double fraction) {
  const bool first = work_.isEmpty();
  work_[key] = {what, fraction};
  if (first)
    patience_.start();
  else if (!patience_.isActive())
    refresh();
}

void StatusLine::endWork(const QString& key) {
  work_.remove(key);
  if (work_.isEmpty()) patience_.stop();
  if (!patience_.isActive()) refresh();
}

void StatusLine::refresh() {
  const bool busy = !work_.isEmpty();
  workText_->setVisible(busy);
  bar_->setVisible(busy);
  cancel_->setVisible(busy);
  if (!busy) return shareRoom();
  const Work& shown = work_.last();
  const QString percent = shown.fraction > 0 ? tr(" %1 %").arg(std::lround(shown.fraction * 100)) : QString();
  workText_->setText((jobs_ > 1 ? tr("%1 jobs: ").arg(jobs_) : QString()) + shown.what + percent);
  // It would paint the whole window at once, in the midst of what else is to be done.
  bar_->setUpdatesEnabled(false);
  bar_->setValue(static_cast<int>(std::lround(shown.fraction * 1000)));
  bar_->setUpdatesEnabled(true);
  shareRoom();
}

}  // namespace blossom::ui
