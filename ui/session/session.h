#pragma once
#include <QObject>
#include <QString>
#include <QStringList>
#include <QTimer>
#include <filesystem>
#include <map>
#include <memory>
#include <optional>
#include <set>
#include <vector>

#include "app/app.h"
#include "core/error.h"
#include "document/history.h"
#include "document/recovery_area.h"
#include "ui/session/display_cache.h"
#include "ui/session/file_stamp.h"
#include "ui/session/job.h"
#include "ui/session/safety_copy.h"
#include "ui/thread/mailbox.h"

namespace blossom::ui {

/// Sentences of a reader.
QStringList toList(const std::vector<std::string>& sentences);

/// One open document: its history, its results as they arrive, and its file. No widgets; everything slow runs on other
/// threads.
class Session : public QObject {
  Q_OBJECT
 public:
  explicit Session(App app, QObject* parent = nullptr);
  ~Session() override;

  [[nodiscard]] const App& app() const { return app_; }
  [[nodiscard]] const Document& document() const { return history_.current(); }
  [[nodiscard]] const History& history() const { return history_; }
  [[nodiscard]] Job& job() { return job_; }
  [[nodiscard]] const Job& job() const { return job_; }
  /// Newest view of a feature; the one before while a new one is computed; nullptr when there never was one.
  [[nodiscard]] std::shared_ptr<const FeatureView> view(const FeatureId&) const;
  /// The newest shape of a feature that is drawn; nullptr when there is none.
  [[nodiscard]] const Shape* shape(const FeatureId&) const;
  [[nodiscard]] bool evaluating() const { return evaluating_; }
  /// Results may be those of a coarser document that was previewed in place of this one.
  [[nodiscard]] bool coarse() const { return coarse_; }
  /// Its result is being computed, and that takes more than a moment.
  [[nodiscard]] bool awaited(const FeatureId&) const;
  /// Its result is that of this document, whole.
  [[nodiscard]] bool isComputed(const FeatureId&) const;
  /// What is shown of it is that of an older document: it is awaited, or computing was cancelled before it.
  [[nodiscard]] bool outdated(const FeatureId&) const;
  /// What is shown of it is a coarse result of this document until its own comes, or of the one before while a coarse one is
  /// made.
  [[nodiscard]] bool standsIn(const FeatureId&) const;
  [[nodiscard]] const std::filesystem::path& file() const { return file_; }
  [[nodiscard]] bool modified() const { return history_.modified(); }
  [[nodiscard]] bool writing() const { return writing_; }       ///< a file is being saved or exported
  [[nodiscard]] std::uint64_t edits() const { return edits_; }  ///< grows with everything the user does
  [[nodiscard]] QString title() const;                          ///< name of the file, or what the document would be called
  [[nodiscard]] QString suggestedName() const;                  ///< without extension
  /// Begun from a file of the installation and not saved since: it has no file of its own.
  [[nodiscard]] bool fromSample() const { return sample_ && file_.empty(); }

  /// @param coarser computed and shown first, where the whole takes long
  void commit(Document, const QString& what, std::optional<Document> coarser = {});
  /// @param coarser computed in its place: it has the same features, and nothing of it is kept
  void preview(Document, std::optional<Document> coarser = {});
  void endPreview();
  [[nodiscard]] bool previewing() const { return &history_.current() != &history_.committed(); }
  /// Its unsaved steps are not wanted: their safety copy goes. One that ends without it can be recovered.
  void abandon();
  void undo();
  void redo();

  void clear();  ///< a new, empty document
  void open(const std::filesystem::path&, bool salvage = false);
  /// What a crash left; it opens unsaved. The lost copy goes when this one has a safety copy of its own, or was saved.
  void recover(const LostDocument&);
  void import(const std::vector<std::filesystem::path>&);
  void save(const std::filesystem::path&, std::function<void()> then = {});
  /// Somebody else wrote or removed the file since it was opened or saved here.
  [[nodiscard]] bool changedOnDisk() const;
  /// The features as one file; the format must be able to hold what they are together.
  void exportFeatures(const std::vector<FeatureId>&, const std::filesystem::path&, const Value& options);
  void exportFeature(const FeatureId& id, const std::filesystem::path& file, const Value& options) {
    exportFeatures({id}, file, options);
  }
  /// A feature of `type` that takes `inputs`; with a file, that file is imported first and is its input. `users` of its only
  /// input go on with what it makes.
  void addFeature(const FeatureType&, const std::vector<FeatureId>& inputs, const Value& parameters = Value::object(),
                  const std::vector<FeatureId>& users = {});
  void addFeatureFromFile(const FeatureType&, const std::filesystem::path&);
  void cancel();  ///< job and evaluation
  void cancelEvaluation();
  /// Computing was cancelled before it came to this feature; `compute` goes on with it.
  [[nodiscard]] bool cancelled(const FeatureId&) const;
  void compute();
  void recompute();  ///< everything, whatever is known already
  /// What `filesWithheld` told may be read from here on.
  void allowFiles();

 signals:
  void documentChanged();  ///< another document is shown, by an edit or a file
  void opened();           ///< a document of another file is shown
  void fileChanged();      ///< file name or modified mark, by anything but documentChanged
  /// New views have come, of one or many features: once in a turn of the event loop, and before evaluationFinished.
  void viewsChanged(const std::set<blossom::FeatureId>& features);
  void evaluationStarted();
  void evaluationOverdue();  ///< it takes more than a moment: what has not come yet is awaited
  void evaluationProgressed(double fraction, const QString& stage);
  void evaluationFinished();
  void evaluationCancelled();  ///< followed by evaluationFinished
  void featureAdded(const QString& feature);
  void failed(const blossom::Error&, const QString& file);
  void unsafe(const blossom::Error&);               ///< unsaved steps cannot be kept against a crash
  void saveFailed();                                ///< after `failed`: the document still has its changes
  void warned(const QStringList& sentences);        ///< of what was read
  void exportWarned(const QStringList& sentences);  ///< of what was written
  void filesWithheld(const QStringList& files);     ///< outside of the document's folder: not read
  void noted(const QString& sentence);              ///< something went right

 private:
  void take(const FeatureId&, std::shared_ptr<const FeatureView>);
  void evaluate();
  [[nodiscard]] std::set<FeatureId> coarseOnes() const;
  [[nodiscard]] bool coarseHasCome() const;
  void goOnWithTheWhole();
  void forgetCoarseOnes();
  void keepWaiting();
  void keepParts(const std::map<FeatureId, Value>&);
  void changed(std::optional<Document> coarser = {}, std::set<FeatureId> standIns = {});
  void tellWithheld();
  void replace(Document, const std::filesystem::path& file, const QString& name);
  /// False, and told, when the user began something here while the file was read.
  [[nodiscard]] bool untouchedSince(std::uint64_t edits, const QString& title);
  bool begin(const QString& title, Job::Work, std::function<void()> then, const std::filesystem::path& file,
             std::function<void()> otherwise = {});
  void dropOldViews();
  void tellViews();
  void keep(const QString& what);

  App app_;
  History history_;
  std::filesystem::path file_;
  QString name_;  // of the document while it has no file of its own
  bool sample_ = false;
  std::shared_ptr<DisplayCache> cache_ = std::make_shared<DisplayCache>();
  std::map<FeatureId, std::shared_ptr<const FeatureView>> views_;
  std::set<FeatureId> arrived_;                  // of the last evaluation
  std::set<FeatureId> untold_;                   // of those that arrived
  QTimer telling_;                               // of them, in the next turn of the event loop
  std::optional<Document> coarser_;              // computed in place of the document
  std::set<FeatureId> standIns_;                 // whose coarse results are shown until those of the same document come
  std::set<FeatureId> coarseOnes_;               // the features that are coarser in it
  bool coarse_ = false;                          // something of it may be shown
  bool cut_ = false;                             // the last evaluation was cancelled
  std::set<FeatureId> late_;                     // awaited since before the evaluation under way
  QTimer patience_;                              // what is computed at once is not said to be awaited
  std::vector<std::filesystem::path> withheld_;  // that were told
  std::uint64_t generation_ = 0;                 // of evaluations; late results of older ones are dropped
  std::uint64_t edits_ = 0;                      // tells whether the document changed while a file was read or written
  bool writing_ = false;
  bool evaluating_ = false;
  std::optional<StallWatch::Work> watched_;
  FileStamp stamp_;  // of the file when it was opened or saved here
  Mailbox here_;     // outlives all that post to it
  SafetyCopy safety_;
  Evaluator evaluator_;
  Job job_;
};

}  // namespace blossom::ui
