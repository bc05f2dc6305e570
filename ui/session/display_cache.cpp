#include "ui/session/display_cache.h"

#include <algorithm>
#include <atomic>
#include <chrono>

#include "core/parallel.h"
#include "document/error_of.h"
#include "geometry/shape/bounds.h"
#include "scene/picking.h"

namespace blossom::ui {

namespace {

constexpr std::size_t keptVersions = 2;  // of every feature of a document
constexpr std::chrono::milliseconds pollEvery(20);

bool isSolid(const Measures& measures) {
  if (measures.kind == "solid") return true;
  return std::any_of(measures.values.begin(), measures.values.end(), [](const Measure& measure) {
    const bool* closed = std::get_if<bool>(&measure.value);
    return measure.name == "closed" && closed && *closed;
  });
}

const void* addressOf(const Shape& shape) {
  return shape.visit([](const auto& value) { return static_cast<const void*>(&value); });
}

std::shared_ptr<const FeatureView> failed(const FeatureResult& result, const Error& error) {
  auto copy = std::make_shared<FeatureResult>(result);
  copy->error = error;
  auto view = std::make_shared<FeatureView>();
  view->result = copy;
  return view;
}

/// Figures belong to the feature, the rest to the shape, which other features may share.
Measures withFigures(Measures measures, const FeatureResult& result) {
  const std::vector<Measure>& figures = result.evaluated.figures;
  measures.values.insert(measures.values.end(), figures.begin(), figures.end());
  return measures;
}

/// A wish that would make a picture of many millions of triangles is not granted.
double usable(double chord, const Shape& shape) { return chord > 0 ? std::max(chord, bounds(shape).diagonal() * 1e-5) : 0; }

SceneData drawn(const Shape& shape, double chord, const Progress& progress) {
  return toSceneData(tessellate(shape, drawnFineness(shape, chord), progress));
}

void addPicks(SceneData& scene) { scene.picks = std::make_shared<const PickIndex>(scene); }

/// With what picking needs, so that nothing is left to be done while it plays.
SceneData drawnFrame(const Shape& frame, double chord, const Progress& progress) {
  SceneData scene = drawn(frame, chord, progress);
  scene.solid = frame.get<Mesh>() && isSolid(measure(frame));
  addPicks(scene);
  return scene;
}

std::vector<SceneData> drawnFrames(const Sequence& sequence, double chord, const Progress& progress) {
  std::vector<SceneData> frames(sequence.frames.size());
  const Progress cancelOnly(progress.token());
  std::atomic<std::size_t> done = 0;
  parallelFor(frames.size(), 1, progress, [&](std::size_t begin, std::size_t end) {
    for (std::size_t i = begin; i < end; ++i) {
      frames[i] = drawnFrame(sequence.frames[i], chord, cancelOnly);
      progress.report(static_cast<double>(++done) / static_cast<double>(frames.size()));
    }
  });
  return frames;
}

void draw(FeatureView& view, const Shape& shape, double chord, const Progress& progress) {
  const auto* sequence = shape.get<Sequence>();
  if (sequence && !sequence->frames.empty()) {
    view.frames = std::make_shared<const std::vector<SceneData>>(drawnFrames(*sequence, chord, progress.part(0, 0.9)));
    view.scene = view.frames->back();
    view.measures = measure(shape, progress.part(0.9, 1));
    return;
  }
  view.scene = drawn(shape, chord, progress.part(0, 0.7));
  view.measures = measure(shape, progress.part(0.7, 0.95));
  view.scene.solid = isSolid(view.measures);
  addPicks(view.scene);
}

}  // namespace

TessellationOptions drawnFineness(const Shape& shape, double chord) { return {.chord = usable(chord, shape), .angle = 0.2}; }

void DisplayCache::makeRoomFor(std::size_t features) {
  const std::scoped_lock lock(guard_);
  most_ = std::max(most_, keptVersions * features);
}

/// Under the guard. It becomes the newest.
const FeatureView* DisplayCache::known(const Drawing& drawing) {
  const auto it = std::find_if(entries_.begin(), entries_.end(), [&](const Entry& e) {
    return addressOf(e.shape) == drawing.first && e.chord == drawing.second;
  });
  if (it == entries_.end()) return nullptr;
  entries_.splice(entries_.begin(), entries_, it);
  return &it->view;
}

/// True with a drawing that is there; else the caller is to make it.
bool DisplayCache::awaitOrBegin(const Drawing& drawing, FeatureView& view, const Progress& progress) {
  std::unique_lock lock(guard_);
  for (;;) {
    if (const FeatureView* const found = known(drawing)) {
      view = *found;
      return true;
    }
    if (underWay_.insert(drawing).second) return false;
    drawn_.wait_for(lock, pollEvery);
    progress.check();
  }
}

void DisplayCache::end(const Drawing& drawing) {
  {
    const std::scoped_lock lock(guard_);
    underWay_.erase(drawing);
  }
  drawn_.notify_all();
}

std::shared_ptr<const FeatureView> DisplayCache::view(const std::shared_ptr<const FeatureResult>& result, double chord,
                                                      const Progress& progress) {
  auto view = std::make_shared<FeatureView>();
  view->result = result;
  const Shape& shape = result->evaluated.shape;
  if (result->error || shape.empty()) return view;
  view->shape = shape;
  const auto finish = [&] {
    view->result = result;
    view->measures = withFigures(std::move(view->measures), *result);
    return view;
  };
  const Drawing drawing{addressOf(shape), chord};
  if (awaitOrBegin(drawing, *view, progress)) return finish();
  const std::shared_ptr<void> atEnd(nullptr, [&](void*) { end(drawing); });
  view->result = nullptr;
  if (const std::optional<Error> error = errorOf("Showing the result", [&] { draw(*view, shape, chord, progress); }))
    return failed(*result, *error);
  {
    const std::scoped_lock lock(guard_);
    entries_.push_front({chord, shape, *view});
    if (entries_.size() > most_) entries_.pop_back();
  }
  return finish();
}

}  // namespace blossom::ui
