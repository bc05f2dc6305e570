#include "ui/files/start_page.h"

#include <QDateTime>
#include <QDir>
#include <QEvent>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QMenu>
#include <QPushButton>
#include <QScrollArea>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "app/app.h"
#include "ui/files/recent_files.h"
#include "ui/files/show_in_folder.h"
#include "ui/files/tile.h"
#include "ui/files/tile_grid.h"
#include "ui/look/icons.h"
#include "ui/look/text.h"
#include "ui/thread/refreshes.h"

namespace blossom::ui {

namespace {

constexpr int widest = 916;  // five tiles
constexpr int narrowWidth = 600;

QLabel* label(const QString& text, const char* name) {
  auto* made = new QLabel(text);
  made->setObjectName(QLatin1String(name));
  made->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  return made;
}

struct SampleWords {
  QString name, sentence;
};

// "name: sentence" in every line; the samples are shown in this order.
QList<SampleWords> sampleDescriptions() {
  QList<SampleWords> words;
  QFile file(qt((resourceFolder() / "samples" / "descriptions.txt").string()));
  if (!file.open(QIODevice::ReadOnly)) return words;
  for (const QString& line : QString::fromUtf8(file.readAll()).split(u'\n'))
    words.append({line.section(u':', 0, 0).trimmed(), line.section(u':', 1).trimmed()});
  return words;
}

auto wordsOf(const QList<SampleWords>& all, const QString& file) {
  const QString name = QFileInfo(file).completeBaseName();
  return std::find_if(all.begin(), all.end(), [&](const SampleWords& words) { return words.name == name; });
}

QPushButton* button(const QString& text, const char* iconName) {
  auto* made = new QPushButton(icon(QLatin1String(iconName)), text);
  made->setIconSize({16, 16});
  return made;
}

}  // namespace

QStringList sampleFiles() {
  const QDir folder(qt((resourceFolder() / "samples").string()));
  QStringList files;
  for (const QFileInfo& info :
       folder.entryInfoList({QStringLiteral("*.blossom"), QStringLiteral("*.json")}, QDir::Files, QDir::Name)) {
    // A sample may come as document and as motion file; one row is enough.
    const bool twice =
        info.suffix() == QLatin1String("json") && folder.exists(info.completeBaseName() + QStringLiteral(".blossom"));
    if (!twice) files << info.absoluteFilePath();
  }
  const QList<SampleWords> order = sampleDescriptions();
  std::stable_sort(files.begin(), files.end(),
                   [&](const QString& a, const QString& b) { return wordsOf(order, a) < wordsOf(order, b); });
  return files;
}

QString readableFileName(const QString& file) {
  return sentenceCase(QFileInfo(file).completeBaseName().replace(u'-', u' ').replace(u'_', u' '));
}

StartPage::StartPage(QWidget* parent)
    : QFrame(parent), samples_(new TileGrid), recent_(new TileGrid), recentTitle_(label(tr("RECENT"), "sectionTitle")) {
  setObjectName(QStringLiteral("startCard"));
  connect(&pictures_, &SamplePictures::ready, this, [this](const QString& file, const QPixmap& picture) {
    for (const TileGrid* grid : {samples_, recent_})
      for (Tile* tile : grid->tiles())
        if (tile->file() == file) tile->setPicture(picture);
  });
  connect(&RecentFiles::instance(), &RecentFiles::changed, this, [this] {
    if (isVisible()) fillRecent();
  });
  auto* content = new QWidget;
  content->setObjectName(QStringLiteral("startContent"));
  auto* all = new QVBoxLayout(content);
  all->setContentsMargins(36, 32, 36, 32);
  all->setSpacing(10);
  all_ = all;
  headings_ = headings();
  all->addLayout(headings_);
  all->addSpacing(16);
  all->addWidget(label(tr("SAMPLES"), "sectionTitle"));
  all->addWidget(samples_);
  all->addSpacing(16);
  all->addWidget(recentTitle_);
  all->addWidget(recent_);
  all->addStretch();
  content->setMaximumWidth(widest + 72);
  auto* middle = new QWidget;
  middle->setObjectName(QStringLiteral("startContent"));
  auto* across = new QHBoxLayout(middle);
  across->setContentsMargins(0, 0, 0, 0);
  across->addStretch();
  across->addWidget(content, 100);
  across->addStretch();
  auto* scroll = new QScrollArea;
  scroll->setWidgetResizable(true);
  scroll->setFrameShape(QFrame::NoFrame);
  scroll->setWidget(middle);
  auto* outer = new QVBoxLayout(this);
  outer->setContentsMargins(0, 0, 0, 0);
  outer->addWidget(scroll);
  fillSamples();
}

QBoxLayout* StartPage::headings() {
  auto* row = new QHBoxLayout;
  row->setSpacing(8);
  auto* words = new QVBoxLayout;
  words->setSpacing(6);
  words->addWidget(label(tr("Start with a shape"), "startTitle"));
  auto* note = label(tr("Take a sample, or drop files anywhere on the window."), "note");
  note->setWordWrap(true);
  words->addWidget(note);
  row->addLayout(words, 1);
  auto* fresh = button(tr("New"), "new");
  fresh->setToolTip(tr("Start an empty document."));
  auto* import = button(tr("Import…"), "import");
  import->setToolTip(tr("Start a document with geometry from files."));
  auto* open = new QPushButton(tr("Open…"));
  open->setProperty("primary", true);
  open->setDefault(true);
  connect(fresh, &QPushButton::clicked, this, &StartPage::newWanted);
  connect(open, &QPushButton::clicked, this, &StartPage::openWanted);
  connect(import, &QPushButton::clicked, this, &StartPage::importWanted);
  auto* buttons = new QHBoxLayout;
  buttons->setSpacing(8);
  for (QPushButton* each : {fresh, import, open}) buttons->addWidget(each, 0, Qt::AlignTop);
  buttons->addStretch();
  row->addLayout(buttons);
  return row;
}

void StartPage::fillSamples() {
  const QList<SampleWords> all = sampleDescriptions();
  std::vector<Tile*> tiles;
  for (const QString& file : sampleFiles()) {
    const auto words = wordsOf(all, file);
    auto* tile = new Tile(file, readableFileName(file), words == all.end() ? QString() : words->sentence);
    connect(tile, &QPushButton::clicked, this, [this, file] { emit fileChosen(file); });
    tiles.push_back(tile);
  }
  samples_->setTiles(std::move(tiles));
}

void StartPage::fillRecent() {
  std::vector<Tile*> tiles;
  QStringList wanted;
  for (const RecentFile& each : RecentFiles::instance().list()) {
    const QFileInfo info(each.file);
    auto* tile = new Tile(each.file, info.completeBaseName(), info.dir().dirName());
    tile->setPinned(each.pinned);
    if (each.missing)
      tile->setMissing();
    else
      wanted << each.file;
    tile->setContextMenuPolicy(Qt::CustomContextMenu);
    const auto menu = [this, each, tile](const QPoint& at) { showMenu(each.file, each.pinned, tile->mapToGlobal(at)); };
    connect(tile, &QWidget::customContextMenuRequested, this, menu);
    connect(tile, &QPushButton::clicked, this, [this, each, tile, menu] {
      if (each.missing) return menu(tile->rect().center());
      emit fileChosen(each.file);
    });
    tiles.push_back(tile);
  }
  recentTitle_->setVisible(!tiles.empty());
  recent_->setTiles(std::move(tiles));
  pictures_.request(wanted);
}

void StartPage::showMenu(const QString& file, bool pinned, const QPoint& at) {
  auto* menu = new QMenu(this);
  menu->setAttribute(Qt::WA_DeleteOnClose);
  menu->addAction(pinned ? tr("Unpin") : tr("Pin"), this,
                  [file, pinned] { RecentFiles::instance().setPinned(file, !pinned); });
  menu->addAction(tr("Show in folder"), this, [file] { showInFolder(file); });
  menu->addSeparator();
  menu->addAction(tr("Remove from this list"), this, [file] { RecentFiles::instance().remove(file); });
  menu->popup(at);
}

// In a narrow window the buttons stand below the words, and the margins go before a column of tiles does.
void StartPage::resizeEvent(QResizeEvent* event) {
  QFrame::resizeEvent(event);
  const bool narrow = width() < narrowWidth;
  headings_->setDirection(narrow ? QBoxLayout::TopToBottom : QBoxLayout::LeftToRight);
  const int side = narrow ? 14 : 36;
  all_->setContentsMargins(side, 32, side, 32);
}

void StartPage::showOver(QWidget* widget, std::function<int()> covered) {
  toldAbove_ = std::move(covered);
  raise();
  if (covered_ == widget && !isHidden()) return;
  countRefresh(WindowPart::StartPage);
  if (covered_) covered_->removeEventFilter(this);
  covered_ = widget;
  widget->installEventFilter(this);
  follow();
  show();
}

void StartPage::putAway() {
  if (isHidden()) return;
  countRefresh(WindowPart::StartPage);
  hide();
}

void StartPage::follow() {
  if (!covered_ || !parentWidget()) return;
  const int top = toldAbove_ ? toldAbove_() : 0;
  setGeometry(QRect(covered_->mapTo(parentWidget(), QPoint()), covered_->size()).adjusted(0, top, 0, 0));
}

bool StartPage::eventFilter(QObject* watched, QEvent* event) {
  if (watched == covered_ && (event->type() == QEvent::Resize || event->type() == QEvent::Move)) follow();
  return QFrame::eventFilter(watched, event);
}

void StartPage::showEvent(QShowEvent* event) {
  QFrame::showEvent(event);
  fillRecent();
  // After the first frame: the window must not wait for its pictures.
  QTimer::singleShot(0, this, [this] {
    if (isVisible()) pictures_.request(sampleFiles());
  });
}

void StartPage::hideEvent(QHideEvent* event) {
  QFrame::hideEvent(event);
  pictures_.stop();
}

}  // namespace blossom::ui
