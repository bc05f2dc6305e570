// The part of Session that reads and writes files; all of it runs as a Job.
#include <QElapsedTimer>
#include <QFileInfo>
#include <QLocale>
#include <algorithm>

#include "app/read_import.h"
#include "document/edits.h"
#include "document/storage.h"
#include "exchange/format/export_shape.h"
#include "exchange/format/frames.h"
#include "geometry/occt/merged_shape.h"
#include "ui/look/text.h"
#include "ui/session/session.h"

namespace blossom::ui {

namespace {

void removeNothing() {}

QString fileName(const std::filesystem::path& file) { return qt(file.filename().string()); }

/// Whether the user has changed how fine polygons are to be.
bool chordChosen(const Format* format, const Value& options) {
  const auto chord = options.find("chord");
  if (!format || chord == options.end()) return false;
  return std::none_of(format->writeOptions.begin(), format->writeOptions.end(),
                      [&](const ParameterSpec& spec) { return spec.name == "chord" && spec.fallback == *chord; });
}

/// As it was when that step was made; another state, which nothing equals, when somebody has written it since.
FileStamp stampBefore(const std::filesystem::path& file, std::int64_t millisecondsOfStep) {
  using namespace std::chrono;
  const FileStamp now = FileStamp::of(file);
  if (!now.exists) return now;
  const auto changed = duration_cast<milliseconds>(file_clock::to_sys(now.time).time_since_epoch());
  return changed.count() > millisecondsOfStep ? FileStamp{} : now;
}

}  // namespace

bool Session::begin(const QString& title, Job::Work work, std::function<void()> then, const std::filesystem::path& file,
                    std::function<void()> otherwise) {
  if (job_.running()) {
    emit failed(Error(ErrorCode::InUse, "Another file is still being read or written.",
                      "Wait for it or cancel it in the status line."),
                {});
    return false;
  }
  // Whatever comes, what was done so far is safe before it begins.
  if (const std::shared_ptr<Journal> journal = safety_.snapshot()) {
    work = [journal, work = std::move(work)](const Progress& progress) {
      journal->settle();
      work(progress);
    };
  }
  job_.start(
      title, std::move(work),
      [this, title, then = std::move(then), file, otherwise = std::move(otherwise)](const std::optional<Error>& error) {
        writing_ = false;
        if (!error) return then();
        if (error->code() == ErrorCode::Cancelled) return emit noted(tr("Cancelled: %1.").arg(title));
        emit failed(*error, qt(file.string()));
        if (otherwise) otherwise();
      });
  return true;
}

bool Session::untouchedSince(std::uint64_t edits, const QString& title) {
  if (edits == edits_) return true;
  emit failed(Error(ErrorCode::InUse,
                    tr("%1 was not opened here: this document was edited while it was read.").arg(title).toStdString(),
                    tr("What was edited is kept. Open it again; it comes in a tab of its own.").toStdString()),
              {});
  return false;
}

void Session::clear() { replace(Document(), {}, {}); }

void Session::open(const std::filesystem::path& file, bool salvage) {
  auto result = std::make_shared<OpenedDocument>();
  auto stamp = std::make_shared<FileStamp>();
  const std::uint64_t edits = edits_;
  begin(
      tr("Opening %1").arg(fileName(file)),
      [this, file, salvage, result, stamp](const Progress& progress) {
        *stamp = FileStamp::of(file);  // before it is read: what comes later counts as a change
        *result = openAny(app_, file, salvage);
        if (!isDocument(file))
          readImport(app_, evaluator_, result->document, result->document.features().front()->id, progress);
      },
      [this, file, salvage, result, stamp, edits] {
        if (!untouchedSince(edits, fileName(file))) return;
        // What was salvaged must not overwrite the damaged file by mistake; other formats have no document of their own yet.
        // Samples are there for everybody: what is made of one is saved elsewhere.
        const bool sample = isResource(file), own = isDocument(file) && !salvage && !sample;
        replace(std::move(result->document), own ? file : std::filesystem::path(), qt(file.stem().string()));
        sample_ = sample;
        stamp_ = *stamp;
        if (!result->warnings.empty()) emit warned(toList(result->warnings));
        tellWithheld();
      },
      file);
}

void Session::save(const std::filesystem::path& file, std::function<void()> then) {
  auto stamp = std::make_shared<FileStamp>();
  const bool begun = begin(
      tr("Saving %1").arg(fileName(file)),
      [this, file, stamp, saved = history_.committed()](const Progress& progress) {
        refuseResource(file);
        saveDocument(withFoundFilesEmbedded(*app_.registry, saved), file, progress);
        *stamp = FileStamp::of(file);
      },
      [this, file, step = history_.step(), stamp, then = then ? std::move(then) : removeNothing] {
        file_ = file;
        stamp_ = *stamp;
        history_.markSaved(step);
        keep(qt(history_.undoText()));  // what was edited meanwhile, under the new name
        emit fileChanged();
        emit noted(tr("Saved as %1.").arg(fileName(file)));
        if (!modified()) then();  // what was edited meanwhile is not saved: nothing may be closed
      },
      file, [this] { emit saveFailed(); });
  writing_ |= begun;
}

void Session::recover(const LostDocument& lost) {
  auto result = std::make_shared<OpenedDocument>();
  const std::uint64_t edits = edits_;
  begin(
      tr("Recovering %1").arg(qt(lost.summary.origin.name)),
      [result, folder = lost.folder](const Progress&) { *result = recoverDocument(folder); },
      [this, result, lost, edits] {
        const JournalOrigin& origin = lost.summary.origin;
        if (!untouchedSince(edits, qt(origin.name))) return;
        replace(std::move(result->document), origin.file, qt(origin.name));
        stamp_ = stampBefore(origin.file, lost.summary.milliseconds);
        history_.markUnsaved();
        keep(qt(lost.summary.lastStep));
        safety_.replaces(lost.folder);
        emit fileChanged();
        if (result->warnings.empty())
          emit noted(tr("%1 is as it was after \"%2\".").arg(title(), qt(lost.summary.lastStep)));
        else
          emit warned(toList(result->warnings));
        tellWithheld();
      },
      {});
}

bool Session::changedOnDisk() const { return !file_.empty() && FileStamp::of(file_) != stamp_; }

void Session::exportFeatures(const std::vector<FeatureId>& ids, const std::filesystem::path& file, const Value& options) {
  const auto missing = std::find_if(ids.begin(), ids.end(), [this](const FeatureId& id) { return !isComputed(id); });
  if (missing != ids.end() && evaluating_) {
    emit noted(tr("The file is written as soon as all of it is computed."));
    connect(
        this, &Session::evaluationFinished, this, [this, ids, file, options] { exportFeatures(ids, file, options); },
        Qt::SingleShotConnection);
    return;
  }
  if (missing != ids.end()) {
    emit failed(Error(ErrorCode::InvalidInput, "Nothing is exported: what is shown is not what the document says now.",
                      "Let it be computed, and export it then."),
                {});
    return;
  }
  std::vector<NamedShape> shapes;
  auto warnings = std::make_shared<QStringList>();
  for (const FeatureId& id : ids) {
    const auto shown = view(id);
    if (!shown || shown->result->evaluated.shape.empty()) continue;
    shapes.push_back({document().at(id).name, shown->result->evaluated.shape});
    // What was doubtful when it was computed concerns whoever uses the file, too.
    for (const std::string& warning : shown->result->evaluated.warnings)
      warnings->append(ids.size() > 1 ? qt(document().at(id).name) + QStringLiteral(": ") + qt(warning) : qt(warning));
  }
  if (shapes.empty() || shapes.size() != ids.size()) {
    emit failed(Error(ErrorCode::InvalidInput, "There is no result to export yet.",
                      "Select a feature that has been computed without an error."),
                {});
    return;
  }
  auto figures = std::make_shared<QString>();
  writing_ |= begin(
      tr("Exporting %1").arg(fileName(file)),
      [this, file, options, shapes, figures, warnings](const Progress& progress) {
        refuseResource(file);
        QElapsedTimer clock;
        clock.start();
        const Shape shape = mergedShape(shapes);
        const Format* format = app_.formats->find(file.extension().string());
        const ExportReport report = exportShape(*app_.formats, shape, file, options, chordChosen(format, options), progress);
        for (const std::string& warning : report.warnings) warnings->append(qt(warning));
        const auto files = filesOf(*format, shape, file, completed(format->writeOptions, options));
        qint64 size = 0;
        for (const FileOfShape& each : files) size += QFileInfo(qt(each.path.string())).size();
        const QString written = tr("%1 in %2 s")
                                    .arg(QLocale::c().formattedDataSize(size, 1))
                                    .arg(static_cast<double>(clock.elapsed()) / 1000, 0, 'f', 1);
        *figures = files.size() == 1 ? written : tr("%1 files, %2").arg(files.size()).arg(written);
      },
      [this, file, figures, warnings] {
        emit noted(tr("Exported %1: %2.").arg(fileName(file), *figures));
        if (!warnings->isEmpty()) emit exportWarned(*warnings);
      },
      file);
}

}  // namespace blossom::ui
