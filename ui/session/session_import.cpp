// The part of Session that makes features of files, and others; files are read by a Job.
#include "app/read_import.h"
#include "document/edits.h"
#include "ui/look/registry_text.h"
#include "ui/look/text.h"
#include "ui/session/session.h"

namespace blossom::ui {

namespace {

QString importedName(const std::filesystem::path& file) { return qt(file.filename().string()); }

}  // namespace

// Those that cannot be read are told together, and no feature is made of them; the others are there. What is edited
// meanwhile stays: the files are read into a document of their own, which joins the one that is there then.
void Session::import(const std::vector<std::filesystem::path>& files) {
  struct Result {
    Document imported;
    std::vector<FeatureId> features;
    QStringList problems;
  };
  auto result = std::make_shared<Result>();
  const QString what =
      files.size() == 1 ? tr("Import %1").arg(importedName(files.front())) : tr("Import %1 files").arg(files.size());
  begin(
      what,
      [this, files, result](const Progress& progress) {
        for (std::size_t i = 0; i < files.size(); ++i) {
          const double before = static_cast<double>(i) / static_cast<double>(files.size());
          const Progress part = progress.part(before, before + 1.0 / static_cast<double>(files.size()));
          progress.report(before);
          try {
            FeatureId added;
            const Document more = withImported(app_, result->imported, files[i], &added);
            readImport(app_, evaluator_, more, added, part);
            result->imported = more;
            result->features.push_back(added);
          } catch (const Error& error) {
            if (files.size() == 1 || error.code() == ErrorCode::Cancelled) throw;
            result->problems << qt(error.message());
          }
        }
      },
      [this, result, what] {
        if (!result->features.empty()) {
          Document joined = history_.committed();
          FeatureId last;
          for (const FeatureId& id : result->features)
            joined = withFeatureOf(*app_.registry, joined, result->imported, id, &last);
          commit(std::move(joined), what);
          emit featureAdded(qt(last));
        }
        if (!result->problems.isEmpty()) emit warned(result->problems);
      },
      files.front());
}

void Session::addFeature(const FeatureType& type, const std::vector<FeatureId>& inputs, const Value& parameters,
                         const std::vector<FeatureId>& users) {
  Feature feature = namedFeature(document(), type, inputs);
  feature.parameters = parameters;
  commit(users.empty() ? document().with(feature) : withInserted(document(), feature, users),
         tr("Add %1").arg(registryText(type.title)));
  emit featureAdded(qt(feature.id));
}

void Session::addFeatureFromFile(const FeatureType& type, const std::filesystem::path& file) {
  struct Result {
    Document imported;
    FeatureId feature;
  };
  auto result = std::make_shared<Result>();
  begin(
      tr("Importing %1").arg(importedName(file)),
      [this, file, result](const Progress& progress) {
        result->imported = withImported(app_, Document(), file, &result->feature);
        readImport(app_, evaluator_, result->imported, result->feature, progress);
      },
      [this, result, type] {
        FeatureId input;
        const Document joined =
            withFeatureOf(*app_.registry, history_.committed(), result->imported, result->feature, &input);
        const Feature feature = namedFeature(joined, type, {input});
        commit(joined.with(feature), tr("Add %1").arg(registryText(type.title)));
        emit featureAdded(qt(feature.id));
      },
      file);
}

}  // namespace blossom::ui
