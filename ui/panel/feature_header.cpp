#include "ui/panel/feature_header.h"

#include <QGridLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QToolButton>

#include "ui/controls/window_keys.h"
#include "ui/look/icons.h"

namespace blossom::ui {

FeatureHeader::FeatureHeader(QWidget* parent)
    : QWidget(parent), name_(new QLineEdit), manual_(new QToolButton), type_(new QLabel), summary_(new QLabel) {
  leaveKeysToTheWindow(name_);
  auto* grid = new QGridLayout(this);
  grid->setContentsMargins(0, 0, 0, 0);
  grid->setVerticalSpacing(2);
  grid->setHorizontalSpacing(4);
  name_->setObjectName(QStringLiteral("featureNameEdit"));
  name_->setAccessibleName(tr("Name of the feature"));
  name_->setToolTip(tr("Name of the feature; type another one"));
  name_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  name_->installEventFilter(this);
  manual_->setObjectName(QStringLiteral("fieldButton"));
  manual_->setIcon(icon(QStringLiteral("help")));
  manual_->setToolTip(tr("Read about it in the manual"));
  manual_->setAccessibleName(tr("Read about it in the manual"));
  type_->setObjectName(QStringLiteral("featureType"));
  summary_->setObjectName(QStringLiteral("featureSummary"));
  summary_->setWordWrap(true);
  grid->addWidget(name_, 0, 0);
  grid->addWidget(manual_, 0, 1);
  grid->addWidget(type_, 1, 0, 1, 2);
  grid->addWidget(summary_, 2, 0, 1, 2);
  connect(name_, &QLineEdit::editingFinished, this, [this] {
    const QString wanted = name_->text().trimmed();
    name_->setCursorPosition(0);
    if (wanted.isEmpty())
      name_->setText(given_);
    else if (wanted != given_)
      emit renamed(wanted);
  });
  connect(manual_, &QToolButton::clicked, this, [this] { emit manualWanted(page_); });
}

void FeatureHeader::setName(const QString& name) {
  if (name == given_) return;  // what is being typed stays
  given_ = name;
  name_->setText(name);
  name_->setCursorPosition(0);
  type_->setVisible(!type_->text().isEmpty() && type_->text() != name);  // "Sweep" need not be said twice
}

void FeatureHeader::setType(const QString& title, const QString& summary, const QString& page) {
  page_ = page;
  manual_->setVisible(!page.isEmpty());
  type_->setText(title);
  summary_->setText(summary);
}

void FeatureHeader::setProblem(const QString& problem) {
  manual_->hide();
  type_->hide();
  summary_->setObjectName(QStringLiteral("problem"));
  summary_->setText(problem);
}

// Esc takes the typed name back before anything else of the window gets the key.
bool FeatureHeader::eventFilter(QObject* object, QEvent* event) {
  const bool key = event->type() == QEvent::ShortcutOverride || event->type() == QEvent::KeyPress;
  if (object != name_ || !key || static_cast<QKeyEvent*>(event)->key() != Qt::Key_Escape || name_->text() == given_)
    return QWidget::eventFilter(object, event);
  if (event->type() == QEvent::KeyPress) name_->setText(given_);
  event->accept();
  return true;
}

}  // namespace blossom::ui
