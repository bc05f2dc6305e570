#include "ui/fields/list_row.h"

#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QLineEdit>
#include <QMouseEvent>
#include <QToolButton>
#include <cstdlib>

#include "ui/fields/record_field.h"
#include "ui/look/icons.h"
#include "ui/look/popup_menu.h"
#include "ui/look/text.h"

namespace blossom::ui {

namespace {

constexpr int numberWidth = 20;

QToolButton* rowButton(const char* iconName, const QString& what) {
  auto* button = new QToolButton;
  button->setObjectName(QStringLiteral("rowButton"));
  button->setIcon(icon(QLatin1String(iconName)));
  button->setIconSize({14, 14});
  button->setToolTip(what);
  button->setAccessibleName(what);
  return button;
}

}  // namespace

ListRow::ListRow(const ParameterSpec& element, std::size_t index, const ParameterField::Context& context, QWidget* parent)
    : QWidget(parent),
      element_(element),
      context_(context),
      record_(element.kind == ParameterKind::Record),
      column_(new QVBoxLayout(this)),
      number_(new QLabel(QString::number(index + 1))) {
  element_.name = "item " + std::to_string(index + 1);
  column_->setContentsMargins(0, 0, 0, 0);
  column_->setSpacing(3);
  auto* line = new QHBoxLayout;
  line->setSpacing(2);
  number_->setObjectName(QStringLiteral("rowNumber"));
  number_->setFixedWidth(numberWidth);
  number_->setAlignment(Qt::AlignTop | Qt::AlignLeft);
  number_->setCursor(Qt::SizeVerCursor);
  number_->setToolTip(tr("Drag to another place"));
  number_->installEventFilter(this);
  line->addWidget(number_);
  if (record_) {
    addRecordTitle(line);
  } else {
    makeField();
    line->addWidget(field_, 1);
  }
  auto* more = rowButton("more", tr("Move or copy this item"));
  auto* away = rowButton("close", tr("Remove this item"));
  line->addWidget(more, 0, Qt::AlignTop);
  line->addWidget(away, 0, Qt::AlignTop);
  connect(more, &QToolButton::clicked, this, &ListRow::showMenu);
  connect(away, &QToolButton::clicked, this, &ListRow::removeWanted);
  column_->addLayout(line);
}

void ListRow::addRecordTitle(QHBoxLayout* line) {
  title_ = new QToolButton;
  title_->setObjectName(QStringLiteral("rowTitle"));
  title_->setCheckable(true);
  title_->setToolButtonStyle(Qt::ToolButtonTextBesideIcon);
  title_->setIconSize({12, 12});
  title_->setSizePolicy(QSizePolicy::Ignored, QSizePolicy::Fixed);
  line->addWidget(title_, 1);
  connect(title_, &QToolButton::toggled, this, &ListRow::open);
  open(false);
}

void ListRow::makeField() {
  field_ = ParameterField::make(element_, nullptr, context_);
  if (auto* record = dynamic_cast<RecordField*>(field_))
    record->showAsItem();
  else
    field_->hideLabel();
  connect(field_, &ParameterField::edited, this, &ListRow::edited);
  connect(field_, &ParameterField::previewed, this, &ListRow::previewed);
  connect(field_, &ParameterField::reverted, this, &ListRow::reverted);
  connect(field_, &ParameterField::hint, this, &ListRow::hint);
  connect(field_, &ParameterField::pickWanted, this, &ListRow::pickWanted);
  connect(field_, &ParameterField::pickUnwanted, this, &ListRow::pickUnwanted);
}

void ListRow::open(bool on) {
  if (!record_) return;
  if (on && !field_) {
    makeField();
    column_->addWidget(field_);
    field_->setWritten(written_);
    field_->setValue(value_);
  }
  if (field_) field_->setVisible(on);
  title_->setIcon(icon(on ? QStringLiteral("chevron-down") : QStringLiteral("chevron-right")));
  if (title_->isChecked() != on) title_->setChecked(on);
}

// A field as a whole answers no keys: they would go to the shortcuts of the view.
void ListRow::startTyping() {
  if (!field_) return;
  auto* const line = field_->findChild<QLineEdit*>();
  if (!line) return field_->setFocus();
  line->setFocus();
  line->selectAll();
}

void ListRow::setWritten(const Value& given) {
  written_ = given;
  if (field_) field_->setWritten(given);
}

void ListRow::setValue(const Value& value) {
  value_ = value;
  if (field_) field_->setValue(value);
  if (!title_) return;
  const QString summary = summaryOf(element_, value);
  title_->setText(summary.isEmpty() ? sentenceCase(qt(element_.name)) : summary);
}

void ListRow::setEnds(bool first, bool last) {
  first_ = first;
  last_ = last;
}

void ListRow::showMenu() {
  QMenu& menu = popupMenu(this);
  menu.addAction(tr("Move up"), this, [this] { emit moveWanted(-1); })->setEnabled(!first_);
  menu.addAction(tr("Move down"), this, [this] { emit moveWanted(1); })->setEnabled(!last_);
  menu.addAction(tr("Copy below"), this, &ListRow::copyWanted);
  menu.addSeparator();
  menu.addAction(tr("Remove"), this, &ListRow::removeWanted);
  menu.popup(QCursor::pos());
}

// Alt with an arrow moves the item that has the focus.
void ListRow::keyPressEvent(QKeyEvent* event) {
  const int by = event->key() == Qt::Key_Up ? -1 : event->key() == Qt::Key_Down ? 1 : 0;
  if (by == 0 || !event->modifiers().testFlag(Qt::AltModifier)) return QWidget::keyPressEvent(event);
  if ((by < 0 && !first_) || (by > 0 && !last_)) emit moveWanted(by);
}

bool ListRow::eventFilter(QObject* object, QEvent* event) {
  if (object != number_) return QWidget::eventFilter(object, event);
  if (event->type() == QEvent::MouseButtonPress) {
    from_ = static_cast<QMouseEvent*>(event)->globalPosition().toPoint().y();
    return true;
  }
  if (event->type() == QEvent::MouseMove) {
    const int at = static_cast<QMouseEvent*>(event)->globalPosition().toPoint().y();
    dragging_ = dragging_ || std::abs(at - from_) > 4;
    if (dragging_) emit dragged(at);
    return true;
  }
  if (event->type() == QEvent::MouseButtonRelease && dragging_) {
    dragging_ = false;
    emit dropped(static_cast<QMouseEvent*>(event)->globalPosition().toPoint().y());
    return true;
  }
  return QWidget::eventFilter(object, event);
}

}  // namespace blossom::ui
