#include "ui/palette/command_palette.h"

#include <QApplication>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListView>
#include <QSettings>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look/icons.h"
#include "ui/palette/palette_delegate.h"

namespace blossom::ui {

namespace {

constexpr int widest = 620, maximumRows = 10, margin = 8, maximumRemembered = 30;
const QString latelyKey = QStringLiteral("palette/lately");

QStringList lately() { return QSettings().value(latelyKey).toStringList(); }

void remember(const QString& id) {
  QStringList ids = lately();
  ids.removeAll(id);
  ids.prepend(id);
  QSettings().setValue(latelyKey, QStringList(ids.mid(0, maximumRemembered)));
}

}  // namespace

CommandPalette::CommandPalette(QWidget* window)
    : QFrame(window),
      window_(window),
      field_(new QLineEdit),
      list_(new QListView),
      nothing_(new QLabel),
      model_(new PaletteModel(this)) {
  setObjectName(QStringLiteral("palette"));
  setAccessibleName(tr("Find a command"));
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(margin, margin, margin, margin);
  column->setSpacing(6);
  field_->setObjectName(QStringLiteral("paletteField"));
  field_->setPlaceholderText(tr("Find a command, a sample, a feature, a page of the manual"));
  field_->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  field_->installEventFilter(this);
  list_->setModel(model_);
  list_->setItemDelegate(new PaletteDelegate(list_));
  list_->setUniformItemSizes(true);
  list_->setMouseTracking(true);
  list_->setFocusPolicy(Qt::NoFocus);
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  nothing_->setObjectName(QStringLiteral("note"));
  nothing_->setAlignment(Qt::AlignCenter);
  nothing_->setMinimumHeight(48);
  column->addWidget(field_);
  column->addWidget(list_);
  column->addWidget(nothing_);
  connect(field_, &QLineEdit::textChanged, this, &CommandPalette::refresh);
  connect(list_, &QListView::clicked, this, &CommandPalette::run);
  connect(list_, &QListView::entered, this, [this](const QModelIndex& index) { list_->setCurrentIndex(index); });
  connect(list_->selectionModel(), &QItemSelectionModel::currentChanged, this, &CommandPalette::tellHint);
  hide();
}

void CommandPalette::addSource(PaletteSource source) { sources_.push_back(std::move(source)); }

void CommandPalette::open() {
  if (isVisible()) return dismiss();
  std::vector<PaletteEntry> entries;
  for (const PaletteSource& source : sources_) {
    std::vector<PaletteEntry> some = source();
    std::move(some.begin(), some.end(), std::back_inserter(entries));
  }
  before_ = QApplication::focusWidget();
  model_->setEntries(std::move(entries), lately());
  field_->clear();
  show();
  raise();
  refresh({});
  field_->setFocus();
  qApp->installEventFilter(this);
}

void CommandPalette::dismiss() {
  if (isHidden()) return;
  hide();
  if (before_) before_->setFocus();
}

void CommandPalette::hideEvent(QHideEvent* event) {
  QFrame::hideEvent(event);
  qApp->removeEventFilter(this);
  emit hint({});
}

void CommandPalette::place() {
  const int rows = std::min(maximumRows, model_->rowCount());
  list_->setVisible(rows > 0);
  nothing_->setVisible(rows == 0);
  const int most = std::max(PaletteDelegate::rowHeight, window_->height() - 220);
  list_->setFixedHeight(std::min(rows * PaletteDelegate::rowHeight, most));
  const int width = std::min(widest, window_->width() - 24);
  setFixedWidth(width);
  adjustSize();
  move((window_->width() - width) / 2, std::max(12, window_->height() / 9));
}

void CommandPalette::refresh(const QString& pattern) {
  model_->setPattern(pattern);
  nothing_->setText(tr("Nothing is called \"%1\".").arg(pattern));
  list_->setCurrentIndex(model_->index(0));
  list_->scrollToTop();
  if (model_->rowCount() == 0) emit hint(nothing_->text());
  place();
}

void CommandPalette::step(int by) {
  const int rows = model_->rowCount();
  if (rows == 0) return;
  const int last = rows - 1, now = list_->currentIndex().row();
  const bool around = (by == 1 && now == last) || (by == -1 && now == 0);
  list_->setCurrentIndex(model_->index(around ? last - now : std::clamp(now + by, 0, last)));
  list_->scrollTo(list_->currentIndex());
}

void CommandPalette::tellHint(const QModelIndex& index) {
  if (!isVisible() || !index.isValid()) return;
  const PaletteEntry& entry = model_->at(index.row());
  emit hint(entry.enabled ? tr("Return or click: %1 · Up and down: choose · Esc: close").arg(entry.text)
                          : tr("%1 cannot be done now. %2").arg(entry.text, entry.whyNot));
}

// The list may be made anew by what is done: the entry is copied first.
void CommandPalette::run(const QModelIndex& index) {
  if (!index.isValid()) return;
  const PaletteEntry entry = model_->at(index.row());
  const QString keyword = model_->keywordOf(index.row());
  if (!entry.enabled) return tellHint(index);
  dismiss();
  remember(entry.id);
  if (entry.goAs && !keyword.isEmpty()) return entry.goAs(keyword);
  entry.go();
}

bool CommandPalette::eventFilter(QObject* watched, QEvent* event) {
  if (event->type() == QEvent::MouseButtonPress) {
    const auto* widget = qobject_cast<QWidget*>(watched);
    if (widget && widget != this && !isAncestorOf(widget)) dismiss();
  }
  if (watched == window_ && event->type() == QEvent::Resize) place();
  if (watched != field_ || event->type() != QEvent::KeyPress) return QFrame::eventFilter(watched, event);
  switch (static_cast<QKeyEvent*>(event)->key()) {
    case Qt::Key_Escape:
      dismiss();
      return true;
    case Qt::Key_Up:
    case Qt::Key_Backtab:
      step(-1);
      return true;
    case Qt::Key_Down:
    case Qt::Key_Tab:
      step(1);
      return true;
    case Qt::Key_PageUp:
      step(-maximumRows);
      return true;
    case Qt::Key_PageDown:
      step(maximumRows);
      return true;
    case Qt::Key_Return:
    case Qt::Key_Enter:
      run(list_->currentIndex());
      return true;
    default:
      return QFrame::eventFilter(watched, event);
  }
}

}  // namespace blossom::ui
