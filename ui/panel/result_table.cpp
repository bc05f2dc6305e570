#include "ui/panel/result_table.h"

#include <QLabel>
#include <QPushButton>
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

}  // namespace

ResultTable::ResultTable(QWidget* parent)
    : QWidget(parent),
      late_(new QLabel(tr("Out of date: computing…"), this)),
      shown_(new ResultRows(this)),
      words_(new QVBoxLayout),
      compute_(new QPushButton(tr("Compute"), this)) {
  auto* column = new QVBoxLayout(this);
  column->setContentsMargins(0, 0, 0, 0);
  column->setSpacing(7);
  words_->setSpacing(4);
  column->addWidget(late_);
  column->addWidget(shown_);
  column->addLayout(words_);
  column->addWidget(compute_, 0, Qt::AlignLeft);
  compute_->setObjectName(QStringLiteral("compute"));
  compute_->hide();
  late_->setObjectName(QStringLiteral("warning"));
  late_->setWordWrap(true);
  late_->hide();
  connect(compute_, &QPushButton::clicked, this, &ResultTable::computeWanted);
  connect(shown_, &ResultRows::copied, this, &ResultTable::copied);
}

void ResultTable::clear() {
  for (QLabel* sentence : sentences_) sentence->deleteLater();
  for (QLabel* sentence : sentences_) sentence->hide();
  sentences_.clear();
  rows_.clear();
  compute_->hide();
  late_->hide();
}

void ResultTable::showCancelled() {
  clear();
  addWords(tr("Cancelled."), "note");
  compute_->show();
  shown_->hide();
  shown_->setRows({});
}

bool ResultTable::showsCancelled() const { return !compute_->isHidden(); }

void ResultTable::show(const FeatureView* view, const std::vector<std::string>& besides, bool outdated) {
  clear();
  late_->setVisible(outdated);
  if (!view)
    addWords(tr("Computing…"), "note");
  else if (view->result->error)
    addError(*view->result->error);
  else
    addResult(*view, besides);
  shown_->setOutdated(outdated);
  shown_->setVisible(!rows_.empty());
  shown_->setRows(std::move(rows_));
}

void ResultTable::addError(const Error& error) {
  addWords(qt(error.message()), "problemBox");
  if (!error.hint().empty()) addWords(qt(error.hint()), "note");
}

void ResultTable::addResult(const FeatureView& view, const std::vector<std::string>& besides) {
  if (!view.measures.kind.empty()) addText(tr("Kind"), shownShapeKind(view.measures.kind));
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
      addRow(measureLabel(name), statText(shownStat(name, value)), statUnit(name).trimmed(),
             qt(shownStat(name, value).dump()));
    else
      addText(measureLabel(name), statText(shownStat(name, value)) + statUnit(name));
  }
  const FeatureResult& result = *view.result;
  if (result.fromCache || result.kernelMs == 0)
    addText(tr("Time"), tr("from the cache"));
  else
    addRow(tr("Time"), readable(result.kernelMs, 3), tr("ms"), qt(formatNumber(result.kernelMs)));
  for (const std::string& warning : result.evaluated.warnings) addWords(shownWarning(warning), "warning");
}

void ResultTable::addRow(const QString& name, const QString& number, const QString& unit, const QString& copy) {
  rows_.push_back({name, number, unit, {}, copy});
}

void ResultTable::addText(const QString& name, const QString& text) {
  constexpr int asNarrowAsANumber = 14;
  if (text.size() <= asNarrowAsANumber) return addRow(name, text, {}, text);
  rows_.push_back({name, {}, {}, text, text});
}

void ResultTable::addWords(const QString& text, const char* style) {
  auto* label = new QLabel(text);
  label->setObjectName(QLatin1String(style));
  label->setWordWrap(true);
  label->setTextInteractionFlags(Qt::TextSelectableByMouse);
  words_->addWidget(label);
  sentences_.push_back(label);
}

}  // namespace blossom::ui
