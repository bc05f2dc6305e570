#include "ui/session/session.h"

#include <QFileInfo>
#include <algorithm>
#include <utility>

#include "document/edits.h"
#include "document/file_access.h"
#include "document/part_references.h"
#include "ui/look/preferences.h"
#include "ui/look/text.h"

namespace blossom::ui {

QStringList toList(const std::vector<std::string>& sentences) {
  QStringList list;
  for (const std::string& sentence : sentences) list << qt(sentence);
  return list;
}

namespace {

constexpr int patienceMs = 150;
constexpr int tellingMs = 50;  // between refreshes while results arrive; the last ones are shown at once

double drawingTolerance() { return Preferences::instance().get<double>("drawing-tolerance"); }

/// Features may have been made anew.
bool haveSameContents(const Document& a, const Document& b) {
  return std::ranges::equal(a.features(), b.features(), [](const auto& x, const auto& y) {
    return x == y || (x->id == y->id && x->type == y->type && x->inputs == y->inputs && x->parameters == y->parameters);
  });
}

/// What the user chooses is taken into the document at once; whatever else a document names was named by somebody.
Document guarded(Document document, const std::filesystem::path& file) {
  if (document.access()) return document;
  return document.withAccess(FileAccess::below(file.parent_path()));
}

}  // namespace

Session::Session(App app, QObject* parent)
    : QObject(parent), app_(std::move(app)), evaluator_(app_.registry, 256, app_.results) {
  history_ = History(guarded({}, {}));
  patience_.setSingleShot(true);
  patience_.setInterval(patienceMs);
  connect(&patience_, &QTimer::timeout, this, &Session::evaluationOverdue);
  telling_.setSingleShot(true);
  telling_.setInterval(tellingMs);
  connect(&telling_, &QTimer::timeout, this, &Session::tellViews);
  connect(&safety_, &SafetyCopy::failed, this, &Session::unsafe);
  connect(&Preferences::instance(), &Preferences::changed, this, [this](const QString& name) {
    if (name == QLatin1String("drawing-tolerance")) evaluate();  // results are at hand; they are drawn anew
  });
}

Session::~Session() {
  evaluator_.cancelBackground();
  evaluator_.waitForBackground();
}

std::shared_ptr<const FeatureView> Session::view(const FeatureId& id) const {
  const auto it = views_.find(id);
  return it == views_.end() ? nullptr : it->second;
}

const Shape* Session::shape(const FeatureId& id) const {
  const auto found = view(id);
  return found ? &found->shape : nullptr;
}

QString Session::suggestedName() const { return file_.empty() ? name_ : qt(file_.stem().string()); }

QString Session::title() const {
  return file_.empty() ? (name_.isEmpty() ? tr("Untitled") : name_) : qt(file_.filename().string());
}

void Session::commit(Document document, const QString& what, std::optional<Document> coarser) {
  if (!document.access()) document = document.withAccess(history_.committed().access());
  document = withAppearances(std::move(document), history_.committed(), *app_.registry,
                             [this](const FeatureId& id) { return shape(id); });
  // What stood in for the same document goes on to.
  std::set<FeatureId> standIns;
  if (haveSameContents(this->document(), document)) standIns = coarser_ ? arrived_ : standIns_;
  history_.commit(std::move(document), what.toStdString());
  keep(what);
  changed(std::move(coarser), std::move(standIns));
  tellWithheld();
}

void Session::preview(Document document, std::optional<Document> coarser) {
  const bool isSame = haveSameContents(document, this->document());
  std::set<FeatureId> standIns = isSame && coarser_ ? arrived_ : std::set<FeatureId>();
  history_.preview(std::move(document));
  changed(std::move(coarser), std::move(standIns));
}

void Session::endPreview() {
  history_.revert();
  changed();
}

// Called after every step; without one that is unsaved there is nothing to keep.
void Session::keep(const QString& what) {
  if (history_.modified())
    safety_.record(history_.committed(), what.toStdString(), {file_, title().toStdString()});
  else
    safety_.clear();
}

void Session::abandon() { safety_.clear(); }

void Session::undo() {
  const QString what = tr("Undo: %1").arg(qt(history_.undoText()));
  if (!history_.undo()) return;
  keep(what);
  changed();
}

void Session::redo() {
  if (!history_.redo()) return;
  keep(qt(history_.undoText()));
  changed();
}

void Session::changed(std::optional<Document> coarser, std::set<FeatureId> standIns) {
  ++edits_;
  standIns_ = std::move(standIns);
  coarser_ = std::move(coarser);
  coarseOnes_ = coarser_ ? coarseOnes() : std::set<FeatureId>();
  coarse_ = coarse_ || coarser_;
  dropOldViews();
  emit documentChanged();
  evaluate();
}

void Session::dropOldViews() {
  std::erase_if(views_, [&](const auto& entry) { return !document().contains(entry.first); });
  std::erase_if(untold_, [&](const FeatureId& id) { return !document().contains(id); });
}

void Session::tellViews() {
  telling_.stop();
  if (!untold_.empty()) emit viewsChanged(std::exchange(untold_, {}));
}

// Results, drawings and measures are made on the evaluator's threads and arrive here one by one; listeners are told of all
// that have come in a while together. What is being made, and is the same in this document, goes on.
void Session::evaluate() {
  const std::uint64_t generation = ++generation_;
  keepWaiting();
  evaluating_ = true;
  cut_ = false;
  arrived_.clear();
  watched_.emplace();
  cache_->makeRoomFor(document().features().size());
  emit evaluationStarted();
  const auto here = [this, generation](auto function) {
    here_.post([this, generation, function] {
      if (generation == generation_) function();
    });
  };
  evaluator_.evaluateInBackground(
      coarser_.value_or(document()),
      [this, here](double fraction, const std::string& stage) {
        here([this, fraction, text = qt(stage)] { emit evaluationProgressed(fraction, text); });
      },
      [here, cache = cache_, chord = drawingTolerance(), this](
          const FeatureId& id, const std::shared_ptr<const FeatureResult>& result, const Progress& progress) {
        const std::shared_ptr<const FeatureView> view = cache->view(result, chord, progress);  // or cancelled
        here([this, id, view] {
          if (document().contains(id)) take(id, view);
          if (coarser_ && !previewing() && coarseHasCome()) goOnWithTheWhole();
        });
      },
      [this, here](const Results& results) {
        std::map<FeatureId, Value> parts;
        for (const auto& [id, result] : results)
          if (!result->parts.empty()) parts.emplace(id, result->parts);
        here([this, parts = std::move(parts)] {
          if (coarser_ && !previewing()) return goOnWithTheWhole();
          coarse_ = coarser_.has_value();
          if (!coarse_) keepParts(parts);
          evaluating_ = false;
          patience_.stop();
          tellViews();
          emit evaluationFinished();
          if (!evaluating_) watched_.reset();
        });
      });
}

/// The features that are coarser in its place, without those that are made of them.
std::set<FeatureId> Session::coarseOnes() const {
  std::set<FeatureId> ids;
  for (const auto& feature : coarser_->features())
    if (document().contains(feature->id) && feature->parameters != document().at(feature->id).parameters)
      ids.insert(feature->id);
  return ids;
}

/// What is made of them, and takes its time, is not made twice.
bool Session::coarseHasCome() const {
  return std::all_of(coarseOnes_.begin(), coarseOnes_.end(), [this](const FeatureId& id) { return arrived_.contains(id); });
}

/// What was committed is known coarsely by now.
void Session::goOnWithTheWhole() {
  coarser_.reset();
  standIns_ = arrived_;
  tellViews();
  evaluate();
}

namespace {

/// Whether parameters name parts by other numbers, whatever they are found again by.
bool numbersDiffer(const Value& a, const Value& b) {
  if (a.is_array() && b.is_array() && a.size() == b.size())
    return !std::equal(a.begin(), a.end(), b.begin(), [](const Value& x, const Value& y) { return !numbersDiffer(x, y); });
  if (a.is_object() && b.is_object()) return a.value("index", -1) != b.value("index", -1);
  return a != b;
}

}  // namespace

// Faces and edges that were found again are kept with what they are found by next time.
void Session::keepParts(const std::map<FeatureId, Value>& parts) {
  Document kept = document();
  bool renumbered = false;
  for (const auto& [id, values] : parts) {
    for (const auto& [name, value] : values.items())
      renumbered = renumbered || numbersDiffer(document().at(id).parameters.value(name, Value()), value);
    kept = withKeptParts(kept, id, values);
  }
  history_.amend(std::move(kept));
  if (renumbered) emit documentChanged();
}

/// A feature that fails keeps the last shape that it had.
void Session::take(const FeatureId& id, std::shared_ptr<const FeatureView> view) {
  const auto before = this->view(id);
  if (view->result->error && before && !before->scene.empty()) {
    auto kept = std::make_shared<FeatureView>(*before);
    kept->result = view->result;
    kept->measures = {};
    view = std::move(kept);
  }
  views_[id] = std::move(view);
  arrived_.insert(id);
  untold_.insert(id);
  if (!telling_.isActive()) telling_.start();
}

void Session::cancel() {
  job_.cancel();
  cancelEvaluation();
}

void Session::cancelEvaluation() {
  if (!evaluating_) return;
  evaluator_.cancelBackground();
  ++generation_;
  evaluating_ = false;
  patience_.stop();
  cut_ = true;
  if (coarser_ && !previewing()) forgetCoarseOnes();
  watched_.reset();
  tellViews();
  emit evaluationCancelled();
  emit evaluationFinished();
  emit noted(tr("Computing was cancelled; what was ready is shown."));
}

/// Of a document that was committed: what is coarse, and what is made of it, is not what was asked for.
void Session::forgetCoarseOnes() {
  std::set<FeatureId> ids = coarseOnes_;
  for (const auto& feature : document().features()) {
    const auto& inputs = feature->inputs;
    if (std::any_of(inputs.begin(), inputs.end(), [&](const FeatureId& input) { return ids.contains(input); }))
      ids.insert(feature->id);
  }
  for (const FeatureId& id : ids) arrived_.erase(id);
  coarser_.reset();
}

bool Session::cancelled(const FeatureId& id) const { return cut_ && document().contains(id) && !arrived_.contains(id); }

bool Session::awaited(const FeatureId& id) const {
  const bool due = evaluating_ && document().contains(id) && !arrived_.contains(id);
  return due && (!patience_.isActive() || late_.contains(id));
}

bool Session::isComputed(const FeatureId& id) const {
  const bool isMissing = (evaluating_ || cut_) && !arrived_.contains(id);
  return document().contains(id) && !isMissing && !coarser_;
}

/// What is waited for already stays so when an edit begins the evaluation anew, or one that was cancelled goes on.
void Session::keepWaiting() {
  std::set<FeatureId> late;
  for (const auto& feature : document().features())
    if (awaited(feature->id) || cancelled(feature->id)) late.insert(feature->id);
  late_ = std::move(late);
  if (!patience_.isActive()) patience_.start();
}

bool Session::outdated(const FeatureId& id) const { return views_.contains(id) && (awaited(id) || cancelled(id)); }

// A shape that follows the hand is a moment behind it all the time: it does not turn pale for that.
bool Session::standsIn(const FeatureId& id) const { return awaited(id) && (coarser_ || standIns_.contains(id)); }

void Session::compute() { evaluate(); }

void Session::recompute() {
  evaluator_.forget();
  evaluate();
}

void Session::tellWithheld() {
  std::vector<std::filesystem::path> now = withheldFiles(*app_.registry, document());
  const bool news = std::any_of(now.begin(), now.end(), [this](const auto& file) {
    return std::find(withheld_.begin(), withheld_.end(), file) == withheld_.end();
  });
  withheld_ = std::move(now);
  if (!news) return;
  QStringList files;
  for (const std::filesystem::path& file : withheld_) files << qt(file.string());
  emit filesWithheld(files);
}

void Session::allowFiles() {
  for (const std::filesystem::path& file : withheld_) document().access()->allow(file);
  withheld_.clear();
  evaluate();
}

void Session::replace(Document document, const std::filesystem::path& file, const QString& name) {
  name_ = name;
  sample_ = false;
  history_ = History(guarded(std::move(document), file));
  withheld_.clear();
  history_.markSaved();
  safety_.clear();
  views_.clear();
  untold_.clear();
  coarse_ = false;
  file_ = file;
  emit opened();
  changed();
}

}  // namespace blossom::ui
