#include "ui/help/manual_window.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QListWidget>
#include <QPainter>
#include <QSplitter>
#include <QStackedWidget>
#include <QStyledItemDelegate>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/help/manual_contents.h"
#include "ui/help/manual_text.h"
#include "ui/look/icons.h"
#include "ui/look/theme.h"

namespace blossom::ui {

namespace {

constexpr int sideWidth = 260;
constexpr std::size_t maximumHits = 60;

enum HitRole { HitPage = Qt::UserRole, HitAnchor, HitExcerpt };

// Title, and what stands around the word below it.
class HitDelegate final : public QStyledItemDelegate {
 public:
  using QStyledItemDelegate::QStyledItemDelegate;

  QSize sizeHint(const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const int lines = index.data(HitExcerpt).isNull() ? 2 : 3;
    return {100, lines * option.fontMetrics.lineSpacing() + 2 * inset};
  }
  void paint(QPainter* painter, const QStyleOptionViewItem& option, const QModelIndex& index) const override {
    const Theme& colors = theme();
    const bool current = option.state.testFlag(QStyle::State_Selected);
    painter->save();
    painter->setRenderHint(QPainter::Antialiasing);
    painter->setPen(Qt::NoPen);
    if (current || option.state.testFlag(QStyle::State_MouseOver)) {
      painter->setBrush(colors.color(current ? "raised" : "hover"));
      painter->drawRoundedRect(option.rect.adjusted(0, 1, -8, -1), 5, 5);
    }
    const QRect room = option.rect.adjusted(inset, inset, -inset - 8, -inset);
    const int line = option.fontMetrics.lineSpacing();
    const QString excerpt = index.data(HitExcerpt).toString();
    painter->setPen(colors.color(excerpt.isEmpty() ? "muted" : "text"));
    painter->setFont(option.font);
    const QString title = index.data(Qt::DisplayRole).toString();
    if (excerpt.isEmpty())
      painter->drawText(room, Qt::TextWordWrap, title);
    else
      painter->drawText(room, option.fontMetrics.elidedText(title, Qt::ElideMiddle, room.width()));
    painter->setPen(colors.color("muted"));
    painter->drawText(room.adjusted(0, line, 0, 0), Qt::TextWordWrap, excerpt);
    painter->restore();
  }

 private:
  static constexpr int inset = 8;
};

}  // namespace

ManualWindow::ManualWindow(QWidget* workbench)
    : QWidget(workbench, Qt::Window),
      search_(new QLineEdit),
      left_(new QStackedWidget),
      contents_(new ManualContents),
      hits_(new QListWidget),
      text_(new ManualText) {
  setObjectName(QStringLiteral("manualWindow"));
  setAttribute(Qt::WA_StyledBackground);
  setWindowTitle(tr("Blossom manual"));
  resize(1060, 760);
  auto* across = new QSplitter(Qt::Horizontal);
  across->addWidget(buildSide());
  across->addWidget(buildMain());
  across->setSizes({sideWidth, 800});
  across->setStretchFactor(1, 1);
  across->setHandleWidth(1);
  across->setChildrenCollapsible(false);
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(0, 0, 0, 0);
  all->addWidget(across);

  connect(search_, &QLineEdit::textChanged, this, &ManualWindow::find);
  connect(search_, &QLineEdit::returnPressed, this, &ManualWindow::openHit);
  connect(hits_, &QListWidget::itemClicked, this, &ManualWindow::openHit);
  connect(hits_, &QListWidget::itemActivated, this, &ManualWindow::openHit);
  connect(contents_, &ManualContents::wanted, text_, &ManualText::open);
  connect(text_, &ManualText::pageChanged, this, [this](const QString& page) {
    contents_->showPage(page, text_->headings());
    text_->highlight(search_->text());
    const ManualPage* shown = pages_ ? pages_->find(page) : nullptr;
    setWindowTitle(shown ? tr("%1 – Blossom manual").arg(shown->title) : tr("Blossom manual"));
  });
}

ManualWindow::~ManualWindow() { text_->setPages(nullptr); }

QWidget* ManualWindow::buildSide() {
  search_->setPlaceholderText(tr("Search the manual"));
  search_->setClearButtonEnabled(true);
  search_->addAction(icon(QStringLiteral("search")), QLineEdit::LeadingPosition);
  search_->installEventFilter(this);
  hits_->setObjectName(QStringLiteral("manualHits"));
  hits_->setItemDelegate(new HitDelegate(hits_));
  hits_->setMouseTracking(true);
  hits_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  hits_->setFrameShape(QFrame::NoFrame);
  left_->addWidget(contents_);
  left_->addWidget(hits_);
  auto* side = new QWidget;
  side->setObjectName(QStringLiteral("sidePanel"));
  side->setMinimumWidth(200);
  auto* column = new QVBoxLayout(side);
  column->setContentsMargins(12, 12, 0, 0);
  column->setSpacing(8);
  auto* inset = new QHBoxLayout;
  inset->setContentsMargins(0, 0, 12, 0);
  inset->addWidget(search_);
  column->addLayout(inset);
  column->addWidget(left_, 1);
  return side;
}

QToolButton* ManualWindow::button(const QString& name, const QString& help, const QKeySequence& keys) {
  auto* made = new QToolButton;
  made->setIcon(icon(name));
  made->setIconSize({18, 18});
  made->setAutoRaise(true);
  made->setShortcut(keys);
  made->setToolTip(QStringLiteral("%1 (%2)").arg(help, keys.toString(QKeySequence::NativeText)));
  made->setAccessibleName(help);
  return made;
}

QWidget* ManualWindow::buildMain() {
  auto* bar = new QWidget;
  bar->setObjectName(QStringLiteral("manualBar"));
  auto* row = new QHBoxLayout(bar);
  row->setContentsMargins(10, 6, 10, 6);
  row->setSpacing(2);
  QToolButton* back = button(QStringLiteral("back"), tr("Back"), QKeySequence(tr("Alt+Left")));
  QToolButton* forward = button(QStringLiteral("forward"), tr("Forward"), QKeySequence(tr("Alt+Right")));
  QToolButton* home = button(QStringLiteral("manual"), tr("First page"), QKeySequence(tr("Alt+Home")));
  back->setEnabled(false);
  forward->setEnabled(false);
  connect(back, &QToolButton::clicked, text_, &QTextBrowser::backward);
  connect(forward, &QToolButton::clicked, text_, &QTextBrowser::forward);
  connect(home, &QToolButton::clicked, this, [this] { text_->open(QStringLiteral("index.md")); });
  connect(text_, &QTextBrowser::backwardAvailable, back, &QWidget::setEnabled);
  connect(text_, &QTextBrowser::forwardAvailable, forward, &QWidget::setEnabled);
  for (QToolButton* each : {back, forward, home}) row->addWidget(each);
  row->addStretch(1);
  auto* main = new QWidget;
  auto* column = new QVBoxLayout(main);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(0);
  column->addWidget(bar);
  column->addWidget(text_, 1);
  return main;
}

void ManualWindow::setPages(std::unique_ptr<ManualPages> pages) {
  pages_ = std::move(pages);
  text_->setPages(pages_.get());
  contents_->setPages(*pages_);
}

void ManualWindow::open(const QString& page, const QString& anchor) {
  text_->open(page, anchor);
  show();
  raise();
  activateWindow();
}

void ManualWindow::find(const QString& words) {
  hits_->clear();
  if (pages_ && !words.trimmed().isEmpty()) {
    auto found = pages_->search(words);
    if (found.size() > maximumHits) found.resize(maximumHits);
    for (const ManualHit& hit : found) {
      const QString title = hit.heading.isEmpty() ? hit.title : QStringLiteral("%1 › %2").arg(hit.title, hit.heading);
      auto* item = new QListWidgetItem(title, hits_);
      item->setData(HitExcerpt, hit.excerpt);
      item->setData(HitPage, hit.page);
      item->setData(HitAnchor, hit.anchor);
    }
    if (found.empty()) {
      auto* none = new QListWidgetItem(tr("Nothing in the manual has all of these words."), hits_);
      none->setFlags(Qt::NoItemFlags);
    }
    hits_->setCurrentRow(0);
  }
  left_->setCurrentWidget(words.trimmed().isEmpty() ? static_cast<QWidget*>(contents_) : hits_);
  text_->highlight(words);
}

void ManualWindow::openHit() {
  const QListWidgetItem* hit = hits_->currentItem();
  if (hit && hit->flags().testFlag(Qt::ItemIsSelectable))
    text_->open(hit->data(HitPage).toString(), hit->data(HitAnchor).toString());
}

// The arrows walk through what was found while the words can still be edited.
bool ManualWindow::eventFilter(QObject* watched, QEvent* event) {
  if (watched == search_ && event->type() == QEvent::KeyPress) {
    const int key = static_cast<QKeyEvent*>(event)->key();
    const int step = key == Qt::Key_Down ? 1 : key == Qt::Key_Up ? -1 : 0;
    if (step != 0 && hits_->count() > 0) {
      hits_->setCurrentRow(std::clamp(hits_->currentRow() + step, 0, hits_->count() - 1));
      return true;
    }
  }
  return QWidget::eventFilter(watched, event);
}

void ManualWindow::keyPressEvent(QKeyEvent* event) {
  if (event->matches(QKeySequence::Find)) {
    search_->setFocus();
    search_->selectAll();
  } else if (event->key() == Qt::Key_Escape && !search_->text().isEmpty()) {
    search_->clear();
  } else if (event->key() == Qt::Key_Escape) {
    close();
  } else {
    QWidget::keyPressEvent(event);
  }
}

}  // namespace blossom::ui
