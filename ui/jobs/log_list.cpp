#include "ui/jobs/log_list.h"

#include <QColor>
#include <QWidget>

#include "ui/look/text.h"
#include "ui/look/theme.h"
#include "ui/page/page.h"
#include "ui/panel/error_bar.h"

namespace blossom::ui {

namespace {

constexpr std::size_t maximumEntries = 2000;

}  // namespace

void LogList::watch(DocumentPage& page) {
  DocumentPage* const watched = &page;
  const Session& session = page.session();
  connect(&session, &Session::opened, this, [this, watched] {
    said_[watched].clear();
    const auto& file = watched->session().file();
    const QString title = watched->session().title();
    add(Level::Note, title, file.empty() ? tr("Opened %1.").arg(title) : tr("Opened %1.").arg(qt(file.string())));
  });
  connect(&session, &Session::noted, this,
          [this, watched](const QString& sentence) { add(Level::Note, watched->session().title(), sentence); });
  for (const auto signal : {&Session::warned, &Session::exportWarned})
    connect(&session, signal, this, [this, watched](const QStringList& sentences) {
      for (const QString& sentence : sentences) add(Level::Warning, watched->session().title(), sentence);
    });
  // What failed and what was refused is all told there.
  connect(&page.errors(), &ErrorBar::errorShown, this,
          [this, watched](const QString& sentences) { add(Level::Error, watched->session().title(), sentences); });
  connect(&session, &Session::evaluationFinished, this, [this, watched] { addResults(*watched); });
  connect(&page, &QObject::destroyed, this, [this, watched] { said_.erase(watched); });
}

void LogList::addResults(const DocumentPage& page) {
  Said& said = said_[&page];
  const QString document = page.session().title();
  for (const auto& feature : page.session().document().features()) {
    const auto view = page.session().view(feature->id);
    if (!view || feature->suppressed) continue;
    QStringList words;
    for (const std::string& warning : view->result->evaluated.warnings) words << shownWarning(warning);
    const bool failed = view->result->error.has_value();
    if (failed) words = {saidInFull(*view->result->error)};
    const QString all = words.join(u' ');
    if (std::exchange(said[feature->id], all) == all || all.isEmpty()) continue;
    add(failed ? Level::Error : Level::Warning, document, QStringLiteral("%1: %2").arg(qt(feature->name), all));
  }
}

void LogList::add(Level level, const QString& document, const QString& text) {
  if (entries_.size() >= maximumEntries) {
    beginRemoveRows({}, 0, 0);
    entries_.erase(entries_.begin());
    endRemoveRows();
  }
  const int row = static_cast<int>(entries_.size());
  beginInsertRows({}, row, row);
  entries_.push_back({QDateTime::currentDateTime(), level, document, text});
  endInsertRows();
}

void LogList::clear() {
  beginResetModel();
  entries_.clear();
  endResetModel();
}

int LogList::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(entries_.size()); }
int LogList::columnCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : columns; }

QVariant LogList::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Entry& entry = entries_[static_cast<std::size_t>(index.row())];
  if (role == LevelRole) return static_cast<int>(entry.level);
  if (role == Qt::ToolTipRole) return entry.text;
  if (role == Qt::ForegroundRole) {
    if (index.column() != MessageColumn) return theme().color("muted");
    return theme().color(entry.level == Level::Error ? "error" : entry.level == Level::Warning ? "warning" : "text");
  }
  if (role != Qt::DisplayRole) return {};
  switch (index.column()) {
    case TimeColumn:
      return entry.time.toString(QStringLiteral("HH:mm:ss"));
    case DocumentColumn:
      return entry.document;
    default:
      return entry.text;
  }
}

}  // namespace blossom::ui
