#include "ui/start_page.h"

#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QLabel>
#include <QPushButton>
#include <QVBoxLayout>

#include "app/app.h"
#include "ui/icons.h"
#include "ui/text.h"

namespace blossom::ui {

namespace {

constexpr int mostRows = 7;

QLabel* label(const QString& text, const char* name) {
  auto* made = new QLabel(text);
  made->setObjectName(QLatin1String(name));
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

StartPage::StartPage(QWidget* parent) : QFrame(parent), recent_(new QVBoxLayout), recentColumn_(new QWidget) {
  setObjectName(QStringLiteral("startCard"));
  auto* all = new QVBoxLayout(this);
  all->setContentsMargins(36, 30, 36, 30);
  all->setSpacing(6);
  all->addWidget(label(tr("Start with a shape"), "startTitle"));
  auto* words =
      label(tr("Open a document, import geometry, or take a sample. Files can be dropped anywhere on the window."), "note");
  words->setWordWrap(true);
  all->addWidget(words);
  all->addSpacing(16);
  auto* buttons = new QHBoxLayout;
  auto* open = new QPushButton(tr("Open…"));
  open->setProperty("primary", true);
  open->setDefault(true);
  auto* import = new QPushButton(tr("Import…"));
  connect(open, &QPushButton::clicked, this, &StartPage::openWanted);
  connect(import, &QPushButton::clicked, this, &StartPage::importWanted);
  buttons->addWidget(open);
  buttons->addWidget(import);
  buttons->addStretch();
  all->addLayout(buttons);
  all->addSpacing(18);
  auto* columns = new QHBoxLayout;
  columns->setSpacing(28);
  auto* samples = new QVBoxLayout;
  samples->setSpacing(2);
  samples->addWidget(label(tr("SAMPLES"), "sectionTitle"));
  fill(samples, sampleFiles(), this);
  samples->addStretch();
  columns->addLayout(samples, 1);
  auto* second = new QVBoxLayout(recentColumn_);
  second->setContentsMargins(0, 0, 0, 0);
  second->setSpacing(2);
  second->addWidget(label(tr("RECENT"), "sectionTitle"));
  second->addLayout(recent_);
  second->addStretch();
  recent_->setSpacing(2);
  columns->addWidget(recentColumn_, 1);
  all->addLayout(columns);
  setFixedWidth(460);
  setRecent({});
}

void StartPage::setRecent(const QStringList& files) {
  clear(recent_);
  fill(recent_, files, this);
  recentColumn_->setVisible(!files.isEmpty());
  adjustSize();
}

}  // namespace blossom::ui
