#include "ui/tools/measure_panel.h"

#include <QClipboard>
#include <QGuiApplication>
#include <QHBoxLayout>
#include <QKeyEvent>
#include <QLabel>
#include <QListWidget>
#include <QSignalBlocker>
#include <QToolButton>
#include <QVBoxLayout>
#include <algorithm>

#include "ui/look/icons.h"
#include "ui/look/text.h"
#include "ui/tools/measurements.h"

namespace blossom::ui {

namespace {

constexpr int panelWidth = 236;
constexpr int maximumRows = 6;

QToolButton* iconButton(const QString& iconName, const QString& what) {
  auto* made = new QToolButton;
  made->setIcon(icon(iconName));
  made->setIconSize({16, 16});
  made->setToolTip(what);
  made->setAccessibleName(what);
  return made;
}

QLabel* label(const char* name) {
  auto* made = new QLabel;
  made->setObjectName(QLatin1String(name));
  made->setTextInteractionFlags(Qt::TextSelectableByMouse | Qt::TextSelectableByKeyboard);
  made->setFocusPolicy(Qt::NoFocus);
  return made;
}

}  // namespace

MeasurePanel::MeasurePanel(Measurements& measurements, QWidget* view)
    : FloatingPanel(view, Place::UpperLeft),
      measurements_(measurements),
      list_(new QListWidget),
      parts_(label("note")),
      empty_(new QLabel(tr("Click a face, an edge or a point."))),
      names_(label("resultName")),
      values_(label("resultValue")),
      copy_(iconButton(QStringLiteral("copy"), tr("Copy the figures (Ctrl+C)"))),
      delete_(iconButton(QStringLiteral("delete"), tr("Delete the measurement (Del)"))),
      clear_(iconButton(QStringLiteral("close"), tr("Delete all measurements"))) {
  setAccessibleName(tr("Measurements"));
  build();
  connect(copy_, &QToolButton::clicked, this, &MeasurePanel::copy);
  connect(delete_, &QToolButton::clicked, this, &MeasurePanel::removeSelected);
  connect(clear_, &QToolButton::clicked, this, [this] { measurements_.clear(); });
  connect(list_, &QListWidget::currentRowChanged, this, [this](int row) {
    const auto& entries = measurements_.entries();
    if (row >= 0 && row < static_cast<int>(entries.size())) measurements_.select(entries[static_cast<std::size_t>(row)].id);
  });
  connect(&measurements_, &Measurements::changed, this, &MeasurePanel::refresh);
  refresh();
}

void MeasurePanel::build() {
  setFixedWidth(panelWidth);
  auto* title = new QLabel(tr("MEASUREMENTS"));
  title->setObjectName(QStringLiteral("sectionTitle"));
  auto* head = new QHBoxLayout;
  head->setSpacing(0);
  head->addWidget(title, 1);
  for (QToolButton* each : {copy_, delete_, clear_}) head->addWidget(each);
  empty_->setObjectName(QStringLiteral("note"));
  parts_->setWordWrap(true);
  values_->setAlignment(Qt::AlignRight | Qt::AlignTop);
  list_->setAccessibleName(tr("Measurements"));
  list_->setHorizontalScrollBarPolicy(Qt::ScrollBarAlwaysOff);
  list_->setUniformItemSizes(true);
  list_->installEventFilter(this);
  auto* figures = new QHBoxLayout;
  figures->setContentsMargins(6, 0, 6, 0);
  figures->addWidget(names_, 1);
  figures->addWidget(values_);
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(12, 8, 8, 10);
  column->setSpacing(6);
  column->addLayout(head);
  column->addWidget(empty_);
  column->addWidget(list_);
  column->addWidget(parts_);
  column->addLayout(figures);
  parts_->setContentsMargins(6, 0, 6, 0);
}

void MeasurePanel::refresh() {
  const QSignalBlocker quiet(list_);
  const auto& entries = measurements_.entries();
  while (list_->count() > static_cast<int>(entries.size())) delete list_->takeItem(list_->count() - 1);
  while (list_->count() < static_cast<int>(entries.size())) list_->addItem(QString());
  for (int row = 0; row < list_->count(); ++row) {
    const auto& entry = entries[static_cast<std::size_t>(row)];
    const QString kind = entry.figures.kind.empty()  ? QString()
                         : entry.figures.kind == "x" ? tr("Point")
                                                     : figureName(entry.figures.kind);
    list_->item(row)->setText(QStringLiteral("%1   %2").arg(kind, measurements_.headline(entry)).trimmed());
    if (entry.id == measurements_.selected()) list_->setCurrentRow(row);
  }
  const bool some = !entries.empty();
  for (QWidget* each : std::initializer_list<QWidget*>{list_, copy_, delete_, clear_, parts_, names_, values_})
    each->setVisible(some);
  empty_->setVisible(!some);
  if (some) list_->setFixedHeight(list_->sizeHintForRow(0) * std::min(maximumRows, list_->count()) + 4);
  showFigures();
  settle();
}

void MeasurePanel::showFigures() {
  const Measurements::Entry* shown = measurements_.find(measurements_.selected());
  if (!shown) return;
  QString parts = measurements_.partName(shown->first);
  if (shown->second) parts += QStringLiteral("\n→ ") + measurements_.partName(*shown->second);
  if (!shown->problem.isEmpty()) parts += u'\n' + shown->problem;
  parts_->setText(parts);
  QStringList names, values;
  if (shown->state != Measurements::State::Lost)
    for (const Measure& value : shown->figures.values) {
      names << figureName(value.name);
      values << readable(value);
    }
  names_->setText(names.join(u'\n'));
  values_->setText(values.join(u'\n'));
}

void MeasurePanel::copy() const {
  if (const Measurements::Entry* entry = measurements_.find(measurements_.selected()))
    QGuiApplication::clipboard()->setText(measurements_.text(*entry));
}

void MeasurePanel::removeSelected() { measurements_.remove(measurements_.selected()); }

bool MeasurePanel::eventFilter(QObject* watched, QEvent* event) {
  if (watched == list_ && event->type() == QEvent::KeyPress) {
    const auto* key = static_cast<QKeyEvent*>(event);
    if (key->matches(QKeySequence::Copy)) {
      copy();
      return true;
    }
    if (key->key() == Qt::Key_Delete || key->key() == Qt::Key_Backspace) {
      removeSelected();
      return true;
    }
  }
  return FloatingPanel::eventFilter(watched, event);
}

}  // namespace blossom::ui
