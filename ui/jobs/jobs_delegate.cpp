#include "ui/jobs/jobs_delegate.h"

#include <QPainter>

#include "ui/jobs/jobs_list.h"
#include "ui/look/icons.h"
#include "ui/look/theme.h"

namespace blossom::ui {

namespace {

constexpr int rowHeight = 38, sideMargin = 16, iconSize = 16, textLeft = 28, timeWidth = 90, barWidth = 140, barHeight = 4;

struct StateLook {
  const char *icon, *color;
};

StateLook lookOf(JobsList::State state) {
  switch (state) {
    case JobsList::State::Running:
      return {"pending", "made"};
    case JobsList::State::Done:
      return {"done", "muted"};
    case JobsList::State::Cancelled:
      return {"cancel", "faint"};
    case JobsList::State::Failed:
      return {"error", "error"};
  }
  return {"feature", "muted"};
}

QString secondLine(const QModelIndex& index, JobsList::State state) {
  const QString document = index.data(JobsList::DocumentRole).toString();
  const QString stage = index.data(JobsList::StageRole).toString(), message = index.data(JobsList::MessageRole).toString();
  if (state == JobsList::State::Failed) return document + QStringLiteral(" · ") + message;
  if (state == JobsList::State::Cancelled) return document + QStringLiteral(" · ") + JobsDelegate::tr("cancelled");
  return stage.isEmpty() ? document : document + QStringLiteral(" · ") + stage;
}

void drawBar(QPainter& painter, const QRect& bar, double fraction, const Theme& colors) {
  painter.setPen(Qt::NoPen);
  painter.setBrush(colors.color("field"));
  painter.drawRoundedRect(bar, 2, 2);
  QRect done = bar;
  done.setWidth(static_cast<int>(bar.width() * fraction));
  painter.setBrush(colors.color("made"));
  painter.drawRoundedRect(done, 2, 2);
}

}  // namespace

QRect JobsDelegate::cancelRect(const QRect& row) { return {row.right() - sideMargin - 16, row.center().y() - 8, 16, 16}; }

QSize JobsDelegate::sizeHint(const QStyleOptionViewItem&, const QModelIndex&) const { return {200, rowHeight}; }

void JobsDelegate::paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const {
  const Theme& colors = theme();
  const auto state = static_cast<JobsList::State>(index.data(JobsList::StateRole).toInt());
  const StateLook look = lookOf(state);
  const bool running = state == JobsList::State::Running;
  painter->save();
  painter->setRenderHint(QPainter::Antialiasing);
  if (option.state & QStyle::State_MouseOver) painter->fillRect(option.rect, colors.color("hover"));
  const QRect row = option.rect.adjusted(sideMargin, 0, -sideMargin, 0);
  paintIcon(*painter, QRectF(row.left(), row.center().y() - iconSize / 2.0, iconSize, iconSize), QLatin1String(look.icon),
            colors.color(look.color));
  const int right = running ? cancelRect(option.rect).left() - 12 : row.right();
  const QRect time(right - timeWidth, row.top(), timeWidth, row.height());
  const QRect bar(time.left() - barWidth, row.center().y() - barHeight / 2, barWidth, barHeight);
  const int textRight = (running ? bar.left() : time.left()) - 12;
  const QRect text(row.left() + textLeft, row.top() + 4, textRight - row.left() - textLeft, 16);
  const auto write = [&](const QRect& where, const QString& words, const char* color, Qt::Alignment side = Qt::AlignLeft) {
    painter->setPen(colors.color(color));
    painter->drawText(where, side | Qt::AlignVCenter,
                      painter->fontMetrics().elidedText(words, Qt::ElideRight, where.width()));
  };
  write(text, index.data().toString(), "text");
  write(time, index.data(JobsList::TimeRole).toString(), "muted", Qt::AlignRight);
  QFont font = option.font;
  font.setPixelSize(10);
  painter->setFont(font);
  write(text.translated(0, 15), secondLine(index, state), state == JobsList::State::Failed ? "error" : "muted");
  if (running) {
    drawBar(*painter, bar, index.data(JobsList::FractionRole).toDouble(), colors);
    paintIcon(*painter, cancelRect(option.rect), QStringLiteral("close"), colors.color("muted"));
  }
  painter->restore();
}

}  // namespace blossom::ui
