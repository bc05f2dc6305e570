#include "ui/panel/result_table.h"

#include <QApplication>
#include <QClipboard>
#include <QGridLayout>
#include <QLabel>
#include <QMenu>
#include <QMouseEvent>
#include <QTimer>
#include <QVBoxLayout>
#include <algorithm>

#include "core/units.h"
#include "ui/look/text.h"

namespace blossom::ui {

namespace {

// {"LINE": 29, "ARC": 3} reads "29 LINE, 3 ARC".
QString statText(const Value& value) {
  if (value.is_structured()) {
    QStringList parts;
    for (const auto& [name, part] : value.items())
      parts << (value.is_object() ? counted(statText(part), qt(name).replace(u'_', u' ')) : statText(part));
    return parts.join(QStringLiteral(", "));
  }
  if (value.is_boolean()) return value.get<bool>() ? ResultTable::tr("yes") : ResultTable::tr("no");
  if (value.is_number_integer()) return readable(value.get<std::int64_t>());
  if (value.is_number()) return readable(value.get<double>());
  return value.is_string() ? qt(value.get<std::string>()) : qt(value.dump());
}

/// Number without unit as it is shown, and with all digits; empty for words.
struct Figure {
  QString shown, copied;
};
Figure figureOf(const Measure& measure) {
  if (const auto* number = std::get_if<double>(&measure.value))
    return {readable(inShownUnit(*number, measure.unit), 6), qt(formatNumber(inShownUnit(*number, measure.unit)))};
  if (const auto* count = std::get_if<std::int64_t>(&measure.value)) return {readable(*count), QString::number(*count)};
  return {};
}

QLabel* cell(const char* style, Qt::Alignment alignment) {
  auto* label = new QLabel;
  label->setObjectName(QLatin1String(style));
  label->setAlignment(alignment | Qt::AlignTop);
  return label;
}

}  // namespace

ResultTable::ResultTable(QWidget* parent) : QWidget(parent), grid_(new QGridLayout), words_(new QVBoxLayout) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  grid_->setVerticalSpacing(5);
  grid_->setHorizontalSpacing(8);
  grid_->setColumnStretch(1, 1);
  words_->setSpacing(4);
  column->addLayout(grid_);
  column->addLayout(words_);
  QTimer::singleShot(0, this, &ResultTable::makeRows);
}

// Before the first result comes, when there is most to do.
void ResultTable::makeRows() {
  constexpr std::size_t usual = 10;
  const std::size_t used = used_;
  while (used_ < usual) {
    const Row& row = next({});
    for (QLabel* label : {row.name, row.number, row.unit, row.text}) {
      label->ensurePolished();
      label->hide();
    }
  }
  used_ = used;
}

void ResultTable::show(const FeatureView* view, const std::vector<std::string>& besides) {
  used_ = 0;
  for (QLabel* sentence : sentences_) sentence->deleteLater();
  for (QLabel* sentence : sentences_) sentence->hide();
  sentences_.clear();
  if (!view)
    addWords(tr("Computing…"), "note");
  else if (view->result->error)
    showError(*view->result->error);
  else
    showResult(*view, besides);
  for (std::size_t i = used_; i < rows_.size(); ++i)
    for (QLabel* label : {rows_[i].name, rows_[i].number, rows_[i].unit, rows_[i].text}) label->hide();
}

void ResultTable::showError(const Error& error) {
  addWords(qt(error.message()), "problemBox");
  if (!error.hint().empty()) addWords(qt(error.hint()), "note");
}

void ResultTable::showResult(const FeatureView& view, const std::vector<std::string>& besides) {
  if (!view.measures.kind.empty()) addText(tr("Kind"), qt(view.measures.kind));
  std::vector<std::string> shown = besides;
  for (const Measure& measure : view.measures.values) {
    shown.push_back(measure.name);
    const Figure figure = figureOf(measure);
    if (figure.shown.isEmpty())
      addText(measureLabel(measure.name), readable(measure));
    else
      addRow(measureLabel(measure.name), figure.shown, readable(measure).mid(figure.shown.size()).trimmed(), figure.copied);
  }
  for (const auto& [name, value] : view.result->evaluated.stats.items()) {
    if (std::find(shown.begin(), shown.end(), name) != shown.end() || !worthReading(name, value)) continue;
    if (value.is_number())
      addRow(measureLabel(name), statText(value), statUnit(name).trimmed(), qt(value.dump()));
    else
      addText(measureLabel(name), statText(value) + statUnit(name));
  }
  const FeatureResult& result = *view.result;
  if (result.fromCache || result.kernelMs == 0)
    addText(tr("Time"), tr("from the cache"));
  else
    addRow(tr("Time"), readable(result.kernelMs, 3), tr("ms"), qt(formatNumber(result.kernelMs)));
  for (const std::string& warning : result.evaluated.warnings) addWords(qt(warning), "warning");
}

ResultTable::Row& ResultTable::next(const QString& name) {
  if (used_ == rows_.size()) {
    const int line = static_cast<int>(used_);
    Row row{cell("resultName", Qt::AlignLeft),
            cell("resultValue", Qt::AlignRight),
            cell("resultUnit", Qt::AlignLeft),
            cell("resultValue", Qt::AlignRight),
            {}};
    row.text->setWordWrap(true);
    row.unit->setContentsMargins(6, 0, 0, 0);  // the grid leaves no space beside the cells that span both columns
    grid_->addWidget(row.name, line, 0);
    grid_->addWidget(row.number, line, 1);
    grid_->addWidget(row.unit, line, 2);
    grid_->addWidget(row.text, line, 1, 1, 2);
    for (QLabel* label : {row.number, row.unit, row.text}) {
      label->installEventFilter(this);
      label->setCursor(Qt::PointingHandCursor);
      label->setToolTip(tr("Click to copy"));
    }
    rows_.push_back(row);
  }
  Row& row = rows_[used_++];
  row.name->setText(name);
  row.name->show();
  return row;
}

void ResultTable::addRow(const QString& name, const QString& number, const QString& unit, const QString& copy) {
  Row& row = next(name);
  row.number->setText(number);
  row.unit->setText(unit);
  row.copy = copy;
  row.number->show();
  row.unit->show();
  row.text->hide();
}

void ResultTable::addText(const QString& name, const QString& text) {
  constexpr int asNarrowAsANumber = 14;
  if (text.size() <= asNarrowAsANumber) return addRow(name, text, {}, text);
  Row& row = next(name);
  row.text->setText(text);
  row.copy = text;
  row.number->hide();
  row.unit->hide();
  row.text->show();
}

void ResultTable::addWords(const QString& text, const char* style) {
  auto* label = new QLabel(text);
  label->setObjectName(QLatin1String(style));
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  words_->addWidget(label);
  sentences_.push_back(label);
}

const ResultTable::Row* ResultTable::rowOf(const QObject* label) const {
  for (const Row& row : rows_)
    if (label == row.number || label == row.unit || label == row.text) return &row;
  return nullptr;
}

bool ResultTable::eventFilter(QObject* object, QEvent* event) {
  const bool release = event->type() == QEvent::MouseButtonRelease;
  const bool menu = event->type() == QEvent::ContextMenu;
  const Row* row = release || menu ? rowOf(object) : nullptr;
  if (!row) return QWidget::eventFilter(object, event);
  if (menu) {
    copyMenu(*row, static_cast<QContextMenuEvent*>(event)->globalPos());
  } else if (static_cast<QMouseEvent*>(event)->button() == Qt::LeftButton) {
    QApplication::clipboard()->setText(row->copy);
    emit copied(tr("Copied %1").arg(row->copy));
  }
  return true;
}

void ResultTable::copyMenu(const Row& row, const QPoint& at) {
  QStringList all;
  for (std::size_t i = 0; i < used_; ++i)
    all << QStringLiteral("%1\t%2\t%3")
               .arg(rows_[i].name->text(), rows_[i].copy, rows_[i].unit->isHidden() ? QString() : rows_[i].unit->text());
  QMenu menu(this);
  const auto offer = [&](const QString& title, const QString& text) {
    menu.addAction(title, this, [this, text] {
      QApplication::clipboard()->setText(text);
      emit copied(tr("Copied"));
    });
  };
  offer(tr("Copy value"), row.copy);
  offer(tr("Copy name and value"), row.name->text() + u'\t' + row.copy);
  offer(tr("Copy all results"), all.join(u'\n'));
  menu.exec(at);
}

}  // namespace blossom::ui
