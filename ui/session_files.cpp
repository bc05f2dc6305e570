// The part of Session that reads and writes files; all of it runs as a Job.
#include <algorithm>

#include "document/storage.h"
#include "ui/session.h"
#include "ui/text.h"

namespace blossom::ui {

namespace {

void removeNothing() {}

QString fileName(const std::filesystem::path& file) { return qt(file.filename().string()); }

QStringList toList(const std::vector<std::string>& sentences) {
  QStringList list;
  for (const std::string& sentence : sentences) list << qt(sentence);
  return list;
}

Feature newFeature(const Document& document, const FeatureType& type, std::vector<FeatureId> inputs) {
  Feature feature;
  feature.id = document.freshId(type.command);
  feature.type = type.id;
  feature.name = type.title;
  const auto sameName = [&](const auto& other) { return other->name == feature.name; };
  for (int n = 2; std::any_of(document.features().begin(), document.features().end(), sameName); ++n)
    feature.name = type.title + " " + std::to_string(n);
  feature.inputs = std::move(inputs);
  return feature;
}

}  // namespace

bool Session::begin(const QString& title, Job::Work work, std::function<void()> then, const std::filesystem::path& file) {
  if (job_.running()) {
    emit failed(Error(ErrorCode::InUse, "Another file is still being read or written.",
                      "Wait for it or cancel it in the status line."),
                {});
    return false;
  }
  job_.start(title, std::move(work), [this, then = std::move(then), file](const std::optional<Error>& error) {
    if (!error)
      then();
    else if (error->code() != ErrorCode::Cancelled)
      emit failed(*error, qt(file.string()));
  });
  return true;
}

void Session::clear() { replace(Document(), {}, {}); }

void Session::open(const std::filesystem::path& file, bool salvage) {
  auto result = std::make_shared<OpenedDocument>();
  begin(
      tr("Opening %1").arg(fileName(file)),
      [this, file, salvage, result](const Progress&) { *result = openAny(app_, file, salvage); },
      [this, file, salvage, result] {
        // What was salvaged must not overwrite the damaged file by mistake; other formats have no document of their own yet.
        const bool own = isDocument(file) && !salvage;
        replace(std::move(result->document), own ? file : std::filesystem::path(), qt(file.stem().string()));
        if (!result->warnings.empty()) emit warned(toList(result->warnings));
      },
      file);
}

void Session::import(const std::vector<std::filesystem::path>& files) {
  struct Result {
    Document document;
    FeatureId last;
  };
  auto result = std::make_shared<Result>();
  const QString what =
      files.size() == 1 ? tr("Import %1").arg(fileName(files.front())) : tr("Import %1 files").arg(files.size());
  begin(
      what,
      [this, files, result, before = document()](const Progress& progress) {
        result->document = before;
        for (std::size_t i = 0; i < files.size(); ++i) {
          progress.report(static_cast<double>(i) / static_cast<double>(files.size()));
          result->document = withImported(app_, result->document, files[i], &result->last);
        }
      },
      [this, result, what] {
        commit(std::move(result->document), what);
        emit featureAdded(qt(result->last));
      },
      files.front());
}

void Session::save(const std::filesystem::path& file, std::function<void()> then) {
  const std::uint64_t edits = edits_;
  begin(
      tr("Saving %1").arg(fileName(file)),
      [file, saved = document()](const Progress& progress) { saveDocument(saved, file, progress); },
      [this, file, edits, then = then ? std::move(then) : removeNothing] {
        file_ = file;
        if (edits == edits_) history_.markSaved();
        emit fileChanged();
        emit noted(tr("Saved as %1.").arg(fileName(file)));
        if (edits == edits_) then();  // what was edited meanwhile is not saved: nothing may be closed
      },
      file);
}

void Session::exportFeature(const FeatureId& id, const std::filesystem::path& file, const Value& options) {
  const auto shown = view(id);
  if (!shown || shown->result->evaluated.shape.empty()) {
    emit failed(Error(ErrorCode::InvalidInput, "There is no result to export yet.",
                      "Select a feature that has been computed without an error."),
                {});
    return;
  }
  begin(
      tr("Exporting %1").arg(fileName(file)),
      [this, file, options, shape = shown->result->evaluated.shape](const Progress& progress) {
        writeShape(*app_.formats, shape, file, options, progress);
      },
      [this, file] { emit noted(tr("Exported %1.").arg(fileName(file))); }, file);
}

void Session::addFeature(const FeatureType& type, const std::vector<FeatureId>& inputs) {
  const Feature feature = newFeature(document(), type, inputs);
  commit(document().with(feature), tr("Add %1").arg(qt(type.title)));
  emit featureAdded(qt(feature.id));
}

void Session::addFeatureFromFile(const FeatureType& type, const std::filesystem::path& file) {
  struct Result {
    Document document;
    FeatureId imported;
  };
  auto result = std::make_shared<Result>();
  begin(
      tr("Importing %1").arg(fileName(file)),
      [this, file, result, before = document()](const Progress&) {
        result->document = withImported(app_, before, file, &result->imported);
      },
      [this, result, type] {
        const Feature feature = newFeature(result->document, type, {result->imported});
        commit(result->document.with(feature), tr("Add %1").arg(qt(type.title)));
        emit featureAdded(qt(feature.id));
      },
      file);
}

}  // namespace blossom::ui
