#include "ui/files/tile.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QVBoxLayout>

#include "ui/look/icons.h"
#include "ui/look/theme.h"

namespace blossom::ui {

namespace {

QLabel* label(const char* name) {
  auto* made = new QLabel;
  made->setObjectName(QLatin1String(name));
  made->setTextFormat(Qt::PlainText);
  made->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  return made;
}

}  // namespace

Tile::Tile(const QString& file, const QString& title, const QString& about, QWidget* parent)
    : QPushButton(parent),
      file_(file),
      titleText_(title),
      aboutText_(about),
      picture_(new QLabel),
      title_(label("tileTitle")),
      about_(label("note")),
      pin_(new QLabel) {
  setObjectName(QStringLiteral("tile"));
  setAccessibleName(title);
  setAccessibleDescription(about);
  setToolTip(file);
  setCursor(Qt::PointingHandCursor);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 12, 10);
  column->setSpacing(2);
  picture_->setFixedHeight(pictureSize.height());
  picture_->setAlignment(Qt::AlignCenter);
  picture_->setPixmap(ui::icon(QStringLiteral("document")).pixmap(28, 28));
  auto* heading = new QHBoxLayout;
  heading->setSpacing(4);
  heading->addWidget(title_, 1);
  heading->addWidget(pin_);
  pin_->setPixmap(ui::icon(QStringLiteral("lock")).pixmap(12, 12));
  pin_->hide();
  column->addWidget(picture_);
  column->addSpacing(2);
  column->addLayout(heading);
  column->addWidget(about_);
  for (QLabel* part : findChildren<QLabel*>()) part->setAttribute(Qt::WA_TransparentForMouseEvents);
  setFixedHeight(height);
  setMinimumWidth(smallestWidth);
}

void Tile::setPicture(const QPixmap& picture) {
  pictured_ = true;
  const double ratio = devicePixelRatioF();
  QPixmap scaled = picture.scaled(pictureSize * ratio, Qt::KeepAspectRatio, Qt::SmoothTransformation);
  scaled.setDevicePixelRatio(ratio);
  picture_->setPixmap(scaled);
}

void Tile::setPinned(bool pinned) {
  pin_->setVisible(pinned);
  pin_->setToolTip(tr("Pinned"));
}

void Tile::setMissing() {
  aboutText_ = tr("Not there any more");
  setAccessibleDescription(aboutText_);
  setProperty("missing", true);
  for (QLabel* part : {title_, about_}) part->setEnabled(false);
  elide();
}

void Tile::elide() {
  const int room = width() - 24;
  title_->setText(title_->fontMetrics().elidedText(titleText_, Qt::ElideMiddle, room - (pin_->isHidden() ? 0 : 16)));
  about_->setText(about_->fontMetrics().elidedText(aboutText_, Qt::ElideRight, room));
}

void Tile::resizeEvent(QResizeEvent* event) {
  QPushButton::resizeEvent(event);
  elide();
}

}  // namespace blossom::ui
