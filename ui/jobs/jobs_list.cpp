#include "ui/jobs/jobs_list.h"

#include <QWidget>
#include <algorithm>

#include "ui/look/text.h"
#include "ui/page/page.h"

namespace blossom::ui {

namespace {

constexpr int patienceMs = 200, tickMs = 200;
constexpr std::size_t maximumRecords = 200;

/// What failed in the document, in one line; empty when nothing did.
QString failuresOf(const Session& session) {
  QStringList failed;
  for (const auto& feature : session.document().features()) {
    const auto view = session.view(feature->id);
    if (!feature->suppressed && view && view->result->error)
      failed << QStringLiteral("%1: %2").arg(qt(feature->name), qt(view->result->error->message()));
  }
  return failed.join(u' ');
}

}  // namespace

QString timeTaken(qint64 ms) {
  if (ms < 60'000) return JobsList::tr("%1 s").arg(static_cast<double>(ms) / 1000, 0, 'f', 1);
  return JobsList::tr("%1 min %2 s").arg(ms / 60'000).arg(ms / 1000 % 60, 2, 10, QLatin1Char('0'));
}

JobsList::JobsList(QObject* parent) : QAbstractListModel(parent) {
  tick_.setInterval(tickMs);
  connect(&tick_, &QTimer::timeout, this, [this] {
    for (const Record& record : records_)
      if (record.state == State::Running) changed(record);
  });
}

JobsList::~JobsList() = default;

void JobsList::watch(DocumentPage& page) {
  watchFiles(page);
  watchEvaluations(page);
  connect(&page, &QObject::destroyed, this, [this, gone = &page] {
    starting_.erase(gone);
    for (Record& record : records_)
      if (!record.page && record.state == State::Running) finish(record, State::Cancelled, {});
  });
}

// It is on the stack when its time has come; a newer one of the same page stays.
void JobsList::forgetStarted(const DocumentPage* page) {
  const auto found = starting_.find(page);
  if (found != starting_.end() && !found->second->patience.isActive()) starting_.erase(found);
}

void JobsList::watchFiles(DocumentPage& page) {
  DocumentPage* const watched = &page;
  const Job& job = page.session().job();
  connect(&job, &Job::started, this, [this, watched](const QString& title) {
    QElapsedTimer clock;
    clock.start();
    begin(*watched, Kind::File, title, clock);
  });
  connect(&job, &Job::progressed, this,
          [this, watched](double fraction, const QString& stage) { progress(*watched, Kind::File, fraction, stage); });
  connect(&job, &Job::finished, this, [this, watched] {
    const std::optional<Error>& error = watched->session().job().lastError();
    if (!error)
      end(*watched, Kind::File, State::Done);
    else if (error->code() == ErrorCode::Cancelled)
      end(*watched, Kind::File, State::Cancelled);
    else
      end(*watched, Kind::File, State::Failed, qt(error->message()));
  });
}

// An edit while something is computed goes on with the same row.
void JobsList::watchEvaluations(DocumentPage& page) {
  DocumentPage* const watched = &page;
  const Session& session = page.session();
  connect(&session, &Session::evaluationStarted, this, [this, watched] {
    if (find(*watched, Kind::Evaluation) || starting_.contains(watched)) return;
    auto& starting = *(starting_[watched] = std::make_unique<Starting>());
    starting.clock.start();
    starting.patience.setSingleShot(true);
    starting.patience.setInterval(patienceMs);
    connect(&starting.patience, &QTimer::timeout, this, [this, watched] {
      const Starting& begun = *starting_.at(watched);
      QMetaObject::invokeMethod(
          this, [this, watched] { forgetStarted(watched); }, Qt::QueuedConnection);
      begin(*watched, Kind::Evaluation, tr("Computing"), begun.clock);
      progress(*watched, Kind::Evaluation, begun.fraction, begun.stage);
    });
    starting.patience.start();
  });
  connect(&session, &Session::evaluationProgressed, this, [this, watched](double fraction, const QString& stage) {
    if (const auto found = starting_.find(watched); found != starting_.end())
      found->second->fraction = fraction, found->second->stage = stage;
    progress(*watched, Kind::Evaluation, fraction, stage);
  });
  connect(&session, &Session::evaluationCancelled, this,
          [this, watched] { end(*watched, Kind::Evaluation, State::Cancelled); });
  connect(&session, &Session::evaluationFinished, this, [this, watched] { endEvaluation(*watched); });
}

void JobsList::endEvaluation(const DocumentPage& page) {
  starting_.erase(&page);
  const QString failures = failuresOf(page.session());
  end(page, Kind::Evaluation, failures.isEmpty() ? State::Done : State::Failed, failures);
}

JobsList::Record* JobsList::find(const DocumentPage& page, Kind kind) {
  const auto found = std::find_if(records_.begin(), records_.end(), [&](const Record& record) {
    return record.page == &page && record.kind == kind && record.state == State::Running;
  });
  return found == records_.end() ? nullptr : &*found;
}

void JobsList::begin(DocumentPage& page, Kind kind, const QString& title, const QElapsedTimer& clock) {
  if (records_.size() >= maximumRecords) {
    const int last = static_cast<int>(records_.size()) - 1;
    beginRemoveRows({}, last, last);
    records_.erase(records_.begin());
    endRemoveRows();
  }
  beginInsertRows({}, 0, 0);
  Record record{&page, kind, page.session().title(), title, {}, {}, 0, State::Running, clock, 0};
  records_.push_back(std::move(record));
  endInsertRows();
  countChanged();
}

void JobsList::progress(const DocumentPage& page, Kind kind, double fraction, const QString& stage) {
  Record* record = find(page, kind);
  if (!record) return;
  record->fraction = fraction;
  record->stage = stage;
  changed(*record);
}

void JobsList::end(const DocumentPage& page, Kind kind, State state, const QString& message) {
  if (Record* record = find(page, kind)) finish(*record, state, message);
}

void JobsList::finish(Record& record, State state, const QString& message) {
  record.state = state;
  record.ms = record.clock.elapsed();
  record.message = message;
  record.stage.clear();
  changed(record);
  countChanged();
}

void JobsList::changed(const Record& record) {
  const auto place = static_cast<int>(&record - records_.data());
  const QModelIndex row = index(rowCount() - 1 - place);
  emit dataChanged(row, row);
}

int JobsList::running() const {
  return static_cast<int>(
      std::count_if(records_.begin(), records_.end(), [](const Record& r) { return r.state == State::Running; }));
}

void JobsList::countChanged() {
  const int count = running();
  if (count > 0 && !tick_.isActive()) tick_.start();
  if (count == 0) tick_.stop();
  emit runningChanged(count);
}

void JobsList::cancel(int row) {
  const Record& record = records_.at(records_.size() - 1 - static_cast<std::size_t>(row));
  if (record.state != State::Running || !record.page) return;
  if (record.kind == Kind::File)
    record.page->session().job().cancel();
  else
    record.page->session().cancelEvaluation();
}

void JobsList::clearFinished() {
  beginResetModel();
  std::erase_if(records_, [](const Record& record) { return record.state != State::Running; });
  endResetModel();
}

int JobsList::rowCount(const QModelIndex& parent) const { return parent.isValid() ? 0 : static_cast<int>(records_.size()); }

QVariant JobsList::data(const QModelIndex& index, int role) const {
  if (!index.isValid() || index.row() >= rowCount()) return {};
  const Record& record = records_[records_.size() - 1 - static_cast<std::size_t>(index.row())];
  switch (role) {
    case Qt::DisplayRole:
      return record.title;
    case DocumentRole:
      return record.document;
    case StateRole:
      return static_cast<int>(record.state);
    case StageRole:
      return record.stage;
    case FractionRole:
      return record.fraction;
    case TimeRole:
      return timeTaken(record.state == State::Running ? record.clock.elapsed() : record.ms);
    case Qt::ToolTipRole:
    case MessageRole:
      return record.message;
    default:
      return {};
  }
}

}  // namespace blossom::ui
