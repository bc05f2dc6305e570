#include "ui/jobs/log_panel.h"

#include <QClipboard>
#include <QComboBox>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QHeaderView>
#include <QKeyEvent>
#include <QLineEdit>
#include <QScopedValueRollback>
#include <QScrollBar>
#include <QToolButton>
#include <QTreeView>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/jobs/log_list.h"
#include "ui/look/icons.h"

namespace blossom::ui {

namespace {

QToolButton* quietButton(const char* iconName, const QString& help) {
  auto* button = new QToolButton;
  button->setObjectName(QStringLiteral("quiet"));
  button->setIcon(icon(QLatin1String(iconName)));
  button->setIconSize({16, 16});
  button->setToolTip(help);
  button->setAccessibleName(help);
  return button;
}

}  // namespace

void LogFilter::setLevel(int minimum) {
  least_ = minimum;
  invalidateFilter();
}

void LogFilter::setWords(const QString& words) {
  words_ = words.trimmed();
  invalidateFilter();
}

bool LogFilter::filterAcceptsRow(int row, const QModelIndex& parent) const {
  const auto cell = [&](int column) { return sourceModel()->index(row, column, parent); };
  if (cell(0).data(LogList::LevelRole).toInt() < least_) return false;
  return cell(LogList::MessageColumn).data().toString().contains(words_, Qt::CaseInsensitive) ||
         cell(LogList::DocumentColumn).data().toString().contains(words_, Qt::CaseInsensitive);
}

LogPanel::LogPanel(LogList& log, QWidget* parent) : QWidget(parent), filter_(new LogFilter(this)), rows_(new QTreeView) {
  filter_->setSourceModel(&log);
  rows_->setObjectName(QStringLiteral("log"));
  rows_->setAccessibleName(tr("Log"));
  rows_->setModel(filter_);
  rows_->setRootIsDecorated(false);
  rows_->setUniformRowHeights(true);
  rows_->setHeaderHidden(true);
  rows_->setSelectionMode(QAbstractItemView::ExtendedSelection);
  rows_->setVerticalScrollMode(QAbstractItemView::ScrollPerPixel);
  rows_->header()->resizeSection(LogList::TimeColumn, 76);
  rows_->header()->resizeSection(LogList::DocumentColumn, 160);
  rows_->header()->setStretchLastSection(true);
  rows_->installEventFilter(this);
  // The list is laid out late, and not at all while it is hidden: whether it stands at its end is asked when the user moves
  // it, not when something comes.
  const QScrollBar* scroll = rows_->verticalScrollBar();
  connect(scroll, &QScrollBar::valueChanged, this, [this, scroll](int value) {
    if (isVisible() && !settling_) follows_ = value >= scroll->maximum();
  });
  connect(scroll, &QScrollBar::rangeChanged, this, &LogPanel::scrollToNewest);
  connect(filter_, &QAbstractItemModel::rowsInserted, this, &LogPanel::scrollToNewest);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 2, 0, 0);
  column->setSpacing(4);
  column->addWidget(bar(log));
  column->addWidget(rows_, 1);
}

QWidget* LogPanel::bar(LogList& log) {
  auto* box = new QWidget;
  auto* row = new QHBoxLayout(box);
  row->setContentsMargins(16, 0, 14, 0);
  auto* level = new QComboBox;
  level->addItems({tr("Everything"), tr("Warnings and errors"), tr("Errors")});
  level->setAccessibleName(tr("Which messages"));
  auto* words = new QLineEdit;
  words->setPlaceholderText(tr("Filter"));
  words->setAccessibleName(tr("Filter"));
  words->setClearButtonEnabled(true);
  words->setMaximumWidth(260);
  auto* copyButton = quietButton("copy", tr("Copy what is selected, or everything shown"));
  auto* clearButton = quietButton("delete", tr("Clear the log"));
  row->addWidget(level);
  row->addWidget(words, 1);
  row->addStretch(1);
  row->addWidget(copyButton);
  row->addWidget(clearButton);
  connect(level, &QComboBox::currentIndexChanged, filter_, &LogFilter::setLevel);
  connect(words, &QLineEdit::textChanged, filter_, &LogFilter::setWords);
  connect(copyButton, &QToolButton::clicked, this, &LogPanel::copy);
  connect(clearButton, &QToolButton::clicked, &log, &LogList::clear);
  return box;
}

QString LogPanel::text() const {
  QModelIndexList chosen = rows_->selectionModel()->selectedRows();
  std::sort(chosen.begin(), chosen.end());
  if (chosen.isEmpty())
    for (int row = 0; row < filter_->rowCount(); ++row) chosen << filter_->index(row, 0);
  QString all;
  for (const QModelIndex& row : chosen) {
    QStringList cells;
    for (int column = 0; column < LogList::columns; ++column) cells << row.siblingAtColumn(column).data().toString();
    all += cells.join(u'\t') + u'\n';
  }
  return all;
}

void LogPanel::scrollToNewest() {
  if (!follows_ || !isVisible()) return;
  const QScopedValueRollback<bool> own(settling_, true);
  rows_->scrollToBottom();
}

// It opens at the newest line.
void LogPanel::showEvent(QShowEvent* event) {
  QWidget::showEvent(event);
  follows_ = true;
  scrollToNewest();
}

void LogPanel::copy() const { QGuiApplication::clipboard()->setText(text()); }

// Ctrl+C would otherwise copy the selected features.
bool LogPanel::eventFilter(QObject* watched, QEvent* event) {
  const bool key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (watched != rows_ || !key || !static_cast<QKeyEvent*>(event)->matches(QKeySequence::Copy))
    return QWidget::eventFilter(watched, event);
  event->accept();
  if (event->type() == QEvent::KeyPress) copy();
  return true;
}

}  // namespace blossom::ui
