#include "ui/jobs/jobs_panel.h"

#include <QClipboard>
#include <QContextMenuEvent>
#include <QGuiApplication>
#include <QMenu>
#include <QMouseEvent>
#include <QPainter>

#include "ui/jobs/jobs_delegate.h"
#include "ui/jobs/jobs_list.h"
#include "ui/look/theme.h"

namespace blossom::ui {

JobsPanel::JobsPanel(JobsList& jobs, QWidget* parent) : QListView(parent), jobs_(jobs) {
  setObjectName(QStringLiteral("jobs"));
  setAccessibleName(tr("Jobs"));
  setModel(&jobs);
  setItemDelegate(new JobsDelegate(this));
  setUniformItemSizes(true);
  setMouseTracking(true);
  setVerticalScrollMode(ScrollPerPixel);
  setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  viewport()->setAttribute(Qt::WA_Hover);
}

bool JobsPanel::onCancel(const QModelIndex& index, QPoint at) const {
  return index.isValid() && JobsDelegate::cancelRect(visualRect(index)).adjusted(-6, -6, 6, 6).contains(at);
}

void JobsPanel::mousePressEvent(QMouseEvent* event) {
  const QModelIndex index = indexAt(event->position().toPoint());
  if (event->button() == Qt::LeftButton && onCancel(index, event->position().toPoint())) return jobs_.cancel(index.row());
  QListView::mousePressEvent(event);
}

void JobsPanel::mouseMoveEvent(QMouseEvent* event) {
  const QModelIndex index = indexAt(event->position().toPoint());
  const bool running = index.data(JobsList::StateRole).toInt() == static_cast<int>(JobsList::State::Running);
  if (!index.isValid())
    emit hint({});
  else if (running)
    emit hint(onCancel(index, event->position().toPoint()) ? tr("Click: cancel %1").arg(index.data().toString())
                                                           : tr("Cross: cancel · Right click: more"));
  else
    emit hint(tr("Right click: copy the message, forget what has finished"));
  QListView::mouseMoveEvent(event);
}

void JobsPanel::leaveEvent(QEvent* event) {
  emit hint({});
  QListView::leaveEvent(event);
}

void JobsPanel::keyPressEvent(QKeyEvent* event) {
  if (event->key() == Qt::Key_Delete && currentIndex().isValid()) return jobs_.cancel(currentIndex().row());
  QListView::keyPressEvent(event);
}

void JobsPanel::contextMenuEvent(QContextMenuEvent* event) {
  const QPersistentModelIndex index = indexAt(event->pos());
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  if (index.isValid() && index.data(JobsList::StateRole).toInt() == static_cast<int>(JobsList::State::Running))
    menu->addAction(tr("Cancel"), this, [this, index] {
      if (index.isValid()) jobs_.cancel(index.row());
    });
  const QString message = index.data(JobsList::MessageRole).toString();
  if (!message.isEmpty())
    menu->addAction(tr("Copy the message"), this, [message] { QGuiApplication::clipboard()->setText(message); });
  menu->addAction(tr("Forget what has finished"), &jobs_, &JobsList::clearFinished);
  menu->popup(event->globalPos());
}

void JobsPanel::paintEvent(QPaintEvent* event) {
  QListView::paintEvent(event);
  if (jobs_.rowCount() > 0) return;
  QPainter painter(viewport());
  painter.setPen(theme().color("faint"));
  painter.drawText(viewport()->rect(), Qt::AlignCenter, tr("Nothing is being computed, read or written."));
}

}  // namespace blossom::ui
