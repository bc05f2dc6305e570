#include "ui/panel/error_bar.h"

#include <QHBoxLayout>
#include <QLabel>
#include <QPainter>
#include <QPushButton>
#include <QStyle>
#include <QToolButton>
#include <QVBoxLayout>

#include "ui/look/icons.h"
#include "ui/look/theme.h"

namespace blossom::ui {

ErrorBar::ErrorBar(QWidget* parent)
    : PassingBar(parent), icon_(new QLabel), message_(new QLabel), hint_(new QLabel), offers_(new QHBoxLayout) {
  setObjectName(QStringLiteral("errorBar"));
  message_->setObjectName(QStringLiteral("errorMessage"));
  hint_->setObjectName(QStringLiteral("errorHint"));
  for (QLabel* label : {message_, hint_}) {
    label->setWordWrap(true);
    label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  }
  auto* words = new QVBoxLayout;
  words->setSpacing(2);
  words->addWidget(message_);
  words->addWidget(hint_);
  auto* close = new QToolButton;
  close->setIcon(icon(QStringLiteral("close")));
  close->setIconSize({16, 16});
  close->setToolTip(tr("Dismiss (Esc)"));
  close->setAccessibleName(tr("Dismiss"));
  connect(close, &QToolButton::clicked, this, &QWidget::hide);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(14, 9, 10, 9);
  row->setSpacing(12);
  row->addWidget(icon_, 0, Qt::AlignTop);
  row->addLayout(words, 1);
  offers_->setSpacing(8);
  row->addLayout(offers_);
  row->addWidget(close, 0, Qt::AlignTop);
  hide();
}

void ErrorBar::present(const char* kind, const QString& message, const QString& hint) {
  setProperty("kind", QLatin1String(kind));
  style()->unpolish(this);
  style()->polish(this);
  const bool error = qstrcmp(kind, "error") == 0;
  QPixmap picture(QSize(18, 18) * devicePixelRatioF());
  picture.setDevicePixelRatio(devicePixelRatioF());
  picture.fill(Qt::transparent);
  QPainter painter(&picture);
  paintIcon(painter, QRectF(0, 0, 18, 18), error ? QStringLiteral("error") : QStringLiteral("note"),
            theme().color(error ? "error" : "control"));
  painter.end();
  icon_->setPixmap(picture);
  message_->setText(message);
  hint_->setText(hint);
  hint_->setVisible(!hint.isEmpty());
  while (QLayoutItem* old = offers_->takeAt(0)) {
    freeFocusOf(old->widget());
    old->widget()->hide();
    old->widget()->deleteLater();  // it may be the one whose click is being answered
    delete old;
  }
  untilChange_ = false;
  show();
}

void ErrorBar::documentChanged() {
  if (untilChange_) hide();
}

void ErrorBar::showError(const QString& message, const QString& hint) {
  present("error", message, hint);
  emit errorShown(QString(message + u' ' + hint).simplified());
}
void ErrorBar::showNote(const QString& message, const QString& details) { present("note", message, details); }

void ErrorBar::offer(const QString& label, std::function<void()> action) {
  auto* button = new QPushButton(label);
  connect(button, &QPushButton::clicked, this, [this, go = std::move(action)] {
    hide();
    go();
  });
  offers_->addWidget(button);
  button->show();
}

QString ErrorBar::message() const { return message_->text(); }
QString ErrorBar::hint() const { return hint_->text(); }

}  // namespace blossom::ui
