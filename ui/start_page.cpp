#include "ui/start_page.h"

#include <QDir>
#include <QFileInfo>
#include <QGridLayout>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QTimer>
#include <QVBoxLayout>

#include "app/app.h"
#include "ui/icons.h"
#include "ui/sample_pictures.h"
#include "ui/text.h"

namespace blossom::ui {

namespace {

constexpr int mostRows = 4;
constexpr int tilesPerRow = 3;
constexpr QSize pictureSize(150, 84);

QLabel* label(const QString& text, const char* name) {
  auto* made = new QLabel(text);
  made->setObjectName(QLatin1String(name));
  made->setSizePolicy(QSizePolicy::Preferred, QSizePolicy::Fixed);
  return made;
}

QString readableName(const QString& file) {
  return sentenceCase(QFileInfo(file).completeBaseName().replace(u'-', u' ').replace(u'_', u' '));
}

void clear(QLayout* layout) {
  while (QLayoutItem* item = layout->takeAt(0)) {
    if (QWidget* widget = item->widget()) widget->deleteLater();
    delete item;
  }
}

void fill(QVBoxLayout* layout, const QStringList& files, StartPage* page) {
  for (const QString& file : files.mid(0, mostRows)) {
    auto* row = new QPushButton(icon(QStringLiteral("document")), readableName(file));
    row->setObjectName(QStringLiteral("row"));
    row->setToolTip(file);
    row->setCursor(Qt::PointingHandCursor);
    QObject::connect(row, &QPushButton::clicked, page, [page, file] { emit page->fileChosen(file); });
    layout->addWidget(row);
  }
}

// "name: sentence" in every line.
QHash<QString, QString> sampleDescriptions() {
  QHash<QString, QString> words;
  QFile file(qt((resourceFolder() / "samples" / "descriptions.txt").string()));
  if (!file.open(QIODevice::ReadOnly)) return words;
  for (const QString& line : QString::fromUtf8(file.readAll()).split(u'\n'))
    words.insert(line.section(u':', 0, 0).trimmed(), line.section(u':', 1).trimmed());
  return words;
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
  return files;
}

StartPage::StartPage(QWidget* parent)
    : QFrame(parent),
      pictures_(new SamplePictures(pictureSize * 2, this)),
      recent_(new QVBoxLayout),
      recentColumn_(new QWidget) {
  setObjectName(QStringLiteral("startCard"));
  connect(pictures_, &SamplePictures::ready, this, [this](const QString& file, const QPixmap& picture) {
    QLabel* label = pictureOf_.value(file);
    if (!label) return;
    const double ratio = devicePixelRatioF();
    QPixmap scaled = picture.scaled(pictureSize * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    scaled.setDevicePixelRatio(ratio);
    label->setPixmap(scaled);
  });
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(32, 28, 32, 28);
  all->setSpacing(8);
  all->addLayout(headings());
  all->addSpacing(14);
  all->addWidget(label(tr("SAMPLES"), "sectionTitle"), 0, Qt::AlignTop);
  all->addLayout(sampleTiles());
  auto* second = new QVBoxLayout(recentColumn_);
  second->setContentsMargins(0, 12, 0, 0);
  second->setSpacing(2);
  second->addWidget(label(tr("RECENT"), "sectionTitle"));
  second->addLayout(recent_);
  recent_->setSpacing(0);
  all->addWidget(recentColumn_);
  setFixedWidth(620);
  setRecent({});
}

QLayout* StartPage::headings() {
  auto* row = new QHBoxLayout;
  auto* words = new QVBoxLayout;
  words->setSpacing(6);
  words->addWidget(label(tr("Start with a shape"), "startTitle"));
  auto* note = label(tr("Take a sample, or drop a file anywhere on the window."), "note");
  note->setWordWrap(true);
  words->addWidget(note);
  row->addLayout(words, 1);
  auto* open = new QPushButton(tr("Open…"));
  open->setProperty("primary", true);
  open->setDefault(true);
  auto* import = new QPushButton(tr("Import…"));
  connect(open, &QPushButton::clicked, this, &StartPage::openWanted);
  connect(import, &QPushButton::clicked, this, &StartPage::importWanted);
  row->addWidget(open);
  row->addWidget(import);
  return row;
}

QLayout* StartPage::sampleTiles() {
  auto* grid = new QGridLayout;
  grid->setSpacing(10);
  const QHash<QString, QString> words = sampleDescriptions();
  const QStringList files = sampleFiles();
  for (int i = 0; i < files.size(); ++i) {
    const QString& file = files[i];
    auto* tile = new QPushButton;
    tile->setObjectName(QStringLiteral("tile"));
    tile->setAccessibleName(readableName(file));
    tile->setToolTip(file);
    tile->setCursor(Qt::PointingHandCursor);
    auto* column = new QVBoxLayout(tile);
    column->setContentsMargins(10, 8, 10, 9);
    column->setSpacing(2);
    auto* picture = new QLabel;
    picture->setFixedHeight(pictureSize.height());
    picture->setAlignment(Qt::AlignCenter);
    auto* about = label(words.value(QFileInfo(file).completeBaseName()), "note");
    about->setWordWrap(true);
    about->setAlignment(Qt::AlignTop | Qt::AlignLeft);
    column->addWidget(picture);
    column->addWidget(label(readableName(file), "tileTitle"));
    column->addWidget(about);
    column->addStretch();
    for (QLabel* part : tile->findChildren<QLabel*>()) part->setAttribute(Qt::WA_TransparentForMouseEvents);
    tile->setFixedHeight(pictureSize.height() + 54);
    pictureOf_.insert(file, picture);
    connect(tile, &QPushButton::clicked, this, [this, file] { emit fileChosen(file); });
    grid->addWidget(tile, i / tilesPerRow, i % tilesPerRow);
  }
  for (int i = 0; i < tilesPerRow; ++i) grid->setColumnStretch(i, 1);
  return grid;
}

void StartPage::showEvent(QShowEvent* event) {
  QFrame::showEvent(event);
  // After the first frame: the window must not wait for its pictures.
  QTimer::singleShot(0, this, [this] {
    if (isVisible()) pictures_->request(sampleFiles());
  });
}

void StartPage::hideEvent(QHideEvent* event) {
  QFrame::hideEvent(event);
  pictures_->stop();
}

void StartPage::setRecent(const QStringList& files) {
  clear(recent_);
  fill(recent_, files, this);
  recentColumn_->setVisible(!files.isEmpty());
  adjustSize();
}

}  // namespace blossom::ui
