#include "document/evaluation/background_evaluation.h"

#include <algorithm>

#include "core/stopwatch.h"
#include "feature/frame_by_frame.h"

namespace blossom {
namespace {

/// A count called `frames` makes a sequence, and so does an input that is taken frame by frame.
bool makesFrames(const Value& parameters, const FeatureWork* work) {
  if (work && sequenceTakenByFrames(*work->type, work->inputs)) return true;
  const auto frames = parameters.find("frames");
  return frames != parameters.end() && frames->is_number() && frames->get<double>() > 1;
}

}  // namespace

BackgroundEvaluation::BackgroundEvaluation(Document document, const EvaluationSources& sources, Workshop& workshop,
                                           Evaluator::Show show, std::function<void(const Evaluation::Worthy&)> worthKeeping)
    : evaluation_(std::move(document), sources),
      sources_(sources),
      generation_(sources.cache.generation()),
      workshop_(workshop),
      show_(show ? std::make_shared<const Evaluator::Show>(std::move(show)) : nullptr),
      worthKeeping_(std::move(worthKeeping)) {
  for (const auto& feature : evaluation_.document().features()) {
    Place place;
    place.feature = feature;
    weigh(place, feature->parameters, nullptr);
    places_.push_back(std::move(place));
  }
}

Results BackgroundEvaluation::run(const Progress& progress) {
  progress.check();
  workshop_.wantNothing();
  const auto done = [](const Place& place) { return place.stage == Stage::Done; };
  for (bool first = true; !std::all_of(places_.begin(), places_.end(), done); first = false) {
    while (beginReady(progress)) progress.check();
    if (first) workshop_.dropUnwanted();
    report(progress);
    bool moved = false;
    for (Place& place : places_) moved |= advance(place);
    if (!moved) workshop_.waitForNews(progress.token());
    progress.check();
  }
  workshop_.dropUnwanted();  // of a document without features
  progress.report(1);
  return concluded_;
}

/// Whether any feature came so far that its users may be begun, too.
bool BackgroundEvaluation::beginReady(const Progress& progress) {
  bool concluded = false;
  for (Place& place : places_) {
    if (place.stage != Stage::Ahead || !ready(place)) continue;
    start(place, progress);
    concluded |= place.stage != Stage::Computing;
  }
  return concluded;
}

bool BackgroundEvaluation::ready(const Place& place) const {
  return std::all_of(place.feature->inputs.begin(), place.feature->inputs.end(),
                     [&](const FeatureId& input) { return concluded_.contains(input); });
}

void BackgroundEvaluation::start(Place& place, const Progress& progress) {
  place.prepared = evaluation_.prepare(*place.feature, Progress(progress.token()));
  Evaluation::Prepared& prepared = place.prepared;
  if (prepared.work) weigh(place, prepared.work->parameters, prepared.work.get());
  const Workshop::Joined joined = workshop_.join(prepared.key, generation_, showing(place, prepared.work != nullptr));
  if (joined.piece) {
    place.piece = joined.piece;
    place.shows = joined.shows;
    place.joined = std::any_of(places_.begin(), places_.end(),
                               [&](const Place& other) { return &other != &place && other.piece == place.piece; });
    place.stage = Stage::Computing;
    if (prepared.result) concludeWith(place, prepared.result);
    return;
  }
  // It may have come since it was prepared.
  if (const auto found = prepared.work ? sources_.cache.find(prepared.key) : nullptr) prepared.result = asKnown(*found);
  if (prepared.result) {
    concludeWith(place, prepared.result);
    show(place);
  } else {
    startWork(place);
  }
}

/// How long it takes, as far as that is known, and which share of it is showing.
/// @param work as soon as the inputs are known
void BackgroundEvaluation::weigh(Place& place, const Value& parameters, const FeatureWork* work) const {
  place.sequence = makesFrames(parameters, work);
  const double timesAsLong = show_ ? sources_.costs.expectedShowing(*place.feature, place.sequence) : 0;
  place.costMs = sources_.costs.expected(*place.feature) * (1 + timesAsLong);
  place.computingShare = 1 / (1 + timesAsLong);
}

void BackgroundEvaluation::startWork(Place& place) {
  Workshop::Piece piece;
  piece.key = place.prepared.key;
  piece.generation = generation_;
  // How many frames there are decides, more than what the last ones took: a sequence never takes the place of quick ones.
  piece.expectedMs = place.sequence ? std::max(place.costMs, Workshop::longFrom) : place.costMs;
  piece.computing = place.computingShare;
  piece.compute = [work = place.prepared.work, sources = sources_, keep = worthKeeping_](const Progress& progress) {
    const FeatureMade made = resultOf(*work, sources, progress);
    if (made.worthKeeping && keep) keep({work->key, made.result});
    return made.result;
  };
  piece.show = showing(place, true);
  place.shows = true;
  place.piece = workshop_.begin(std::move(piece));
  place.stage = Stage::Computing;
}

/// @param measured it is made for the first time, so that it tells how long that takes
std::function<void(const Workshop::Result&, const Progress&)> BackgroundEvaluation::showing(const Place& place,
                                                                                            bool measured) const {
  if (!show_) return {};
  return [show = show_, feature = place.feature, parts = place.prepared.parts, sequence = place.sequence, measured,
          costs = &sources_.costs](const Workshop::Result& result, const Progress& progress) {
    const Stopwatch watch;
    (*show)(feature->id, withParts(result, parts), progress);
    if (measured && !result->fromCache && result->kernelMs > 0 && !progress.cancelled())
      costs->showingTook(*feature, sequence, watch.elapsedMs() / result->kernelMs);
  };
}

void BackgroundEvaluation::concludeWith(Place& place, const std::shared_ptr<const FeatureResult>& result) {
  concluded_[place.feature->id] =
      evaluation_.conclude(*place.feature, place.prepared, place.joined ? asKnown(*result) : result);
  place.stage = place.shows ? Stage::Showing : Stage::WaitingToShow;
}

/// Shows what is known already.
void BackgroundEvaluation::show(Place& place) {
  Workshop::Piece piece;
  piece.key = place.prepared.key;
  piece.generation = generation_;
  piece.result = concluded_.at(place.feature->id);
  piece.show = showing(place, false);
  place.piece = workshop_.begin(std::move(piece));
  place.shows = true;
  place.stage = Stage::Showing;
}

/// Whether it came further.
bool BackgroundEvaluation::advance(Place& place) {
  if (place.stage == Stage::Ahead || place.stage == Stage::Done) return false;
  const Workshop::Look now = workshop_.look(place.piece);
  if (place.stage == Stage::Computing && now.result) {
    concludeWith(place, now.result);
    return true;
  }
  if (!now.ended) return false;
  if (!now.result) throw Error(ErrorCode::Cancelled, "The work was cancelled.");
  if (place.stage == Stage::WaitingToShow)
    show(place);
  else
    place.stage = Stage::Done;
  return true;
}

/// By the time that all takes, as far as that is known; what is there already is no work.
void BackgroundEvaluation::report(const Progress& progress) {
  double all = 0, done = 0, most = -1;
  std::string stage;
  for (const Place& place : places_) {
    const bool known = place.prepared.result != nullptr, over = place.stage == Stage::Done;
    if (place.feature->suppressed || (known && over)) continue;
    const Workshop::Look now = place.piece ? workshop_.look(place.piece) : Workshop::Look{};
    // What is shown as before is no work; what is drawn anew tells how far it is.
    if (known && (now.fraction == 0 || now.fraction == 1)) continue;
    all += place.costMs;
    done += place.costMs * (over ? 1 : now.fraction);
    if (over || !place.piece) continue;
    if (place.costMs <= most) continue;
    most = place.costMs;
    stage = shownName(*place.feature) + (now.stage.empty() ? "" : ": " + now.stage);
  }
  if (all > 0) reached_ = std::max(reached_, done / all);
  progress.report(reached_, stage);
}

}  // namespace blossom
