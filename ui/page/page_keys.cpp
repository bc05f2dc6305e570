// The keys of the selected sequence on the timeline.
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "feature/frame_keys.h"
#include "parameter/written.h"
#include "ui/look/text.h"
#include "ui/page/page.h"
#include "ui/panel/property_panel.h"
#include "ui/timeline/key_marks.h"
#include "ui/timeline/timeline_bar.h"
#include "ui/tree/document_tree.h"

namespace blossom::ui {

/// Of the one that is selected, if it makes frames itself; its keys in canonical form.
std::optional<DocumentPage::KeyedSequence> DocumentPage::keyedSequence() const {
  const std::vector<FeatureId> chosen = selection();
  if (chosen.size() != 1 || !document().contains(chosen.front())) return std::nullopt;
  const Feature& feature = document().at(chosen.front());
  const auto type = registry().find(feature.type);
  if (!type || type->playedBy.keys.empty() || feature.suppressed) return std::nullopt;
  try {
    const Value parameters = completed(type->parameters, feature.parameters);
    const int frames = parameters.at(type->playedBy.parameter).get<int>();
    if (frames < 2) return std::nullopt;
    return KeyedSequence{feature.id, type->playedBy.keys, parameters.at(type->playedBy.keys), frames};
  } catch (const Error&) {
    return std::nullopt;  // the feature tells what is wrong
  }
}

void DocumentPage::refreshKeys() {
  const auto keyed = keyedSequence();
  if (!keyed) return timeline_->setKeys(std::nullopt);
  TimelineKeys keys{{}, keyed->frames};
  for (const Value& key : keyed->keys) keys.frames.push_back(key.at("frame").get<int>());
  timeline_->setKeys(std::move(keys));
}

Document DocumentPage::withKeys(const KeyedSequence& keyed, const Value& keys) const {
  Feature feature = document().at(keyed.feature);
  const auto& specs = registry().at(feature.type)->parameters;
  Value parameters = completed(specs, feature.parameters);
  parameters[keyed.parameter] = keys;
  feature.parameters = keepWritten(specs, feature.parameters, parameters);
  return document().with(std::move(feature));
}

void DocumentPage::moveKey(int key, int frame, bool placed) {
  const auto keyed = keyedSequence();
  const auto number = static_cast<std::size_t>(key);
  if (!keyed || number >= keyed->keys.size()) return;
  Document moved = withKeys(*keyed, withKeyMoved(keyed->keys, number, frame, keyed->frames));
  if (!placed) return preview(std::move(moved));
  commit(std::move(moved), tr("Move a key of %1").arg(qt(shownName(document().at(keyed->feature)))));
}

void DocumentPage::setKey(int frame) {
  const auto keyed = keyedSequence();
  if (!keyed) return;
  try {
    const Value keys = withKeyAt(keyed->keys, frame, keyed->frames);
    if (keys == keyed->keys) return;  // there is one
    commit(withKeys(*keyed, keys), tr("Set a key of %1").arg(qt(shownName(document().at(keyed->feature)))));
  } catch (const Error& error) {
    showError(error);  // two keys at one frame
  }
}

namespace {

/// The frame that is shown; where it has a key already, the one in the middle of the widest gap between keys.
int frameForNewKey(const std::vector<FrameKey>& sorted, int shown) {
  const auto isThere = [&](const FrameKey& key) { return key.frame == shown; };
  if (std::none_of(sorted.begin(), sorted.end(), isThere)) return shown;
  int widest = 0, middle = shown;
  for (std::size_t k = 1; k < sorted.size(); ++k) {
    const int gap = sorted[k].frame - sorted[k - 1].frame;
    if (gap <= widest) continue;
    widest = gap;
    middle = sorted[k - 1].frame + gap / 2;
  }
  return middle;
}

}  // namespace

bool DocumentPage::setAnotherKey() {
  const auto keyed = keyedSequence();
  if (!keyed) return false;
  try {
    setKey(frameForNewKey(frameKeysOf(keyed->keys), playback_.frameOf(keyed->frames) + 1));
  } catch (const Error& error) {
    showError(error);  // two keys at one frame
  }
  return true;
}

void DocumentPage::removeKey(int key) {
  const auto keyed = keyedSequence();
  const auto number = static_cast<std::size_t>(key);
  if (!keyed || number >= keyed->keys.size()) return;
  Value rest = keyed->keys;
  rest.erase(number);
  commit(withKeys(*keyed, rest), tr("Remove a key of %1").arg(qt(shownName(document().at(keyed->feature)))));
}

void DocumentPage::removeKeyAt(int frame) {
  const auto keyed = keyedSequence();
  if (!keyed) return;
  for (std::size_t k = 0; k < keyed->keys.size(); ++k)
    if (keyed->keys[k].at("frame") == frame) return removeKey(static_cast<int>(k));
}

void DocumentPage::connectKeys() {
  const KeyMarks& marks = timeline_->marks();
  connect(&marks, &KeyMarks::dragged, this, [this](int key, int frame) { moveKey(key, frame, false); });
  connect(&marks, &KeyMarks::moved, this, [this](int key, int frame) { moveKey(key, frame, true); });
  connect(&marks, &KeyMarks::reverted, this, [this] {
    if (session_.previewing()) endPreview();
  });
  connect(&marks, &KeyMarks::removed, this, &DocumentPage::removeKey);
  connect(&marks, &KeyMarks::added, this, &DocumentPage::setKey);
  connect(&marks, &KeyMarks::clicked, this, [this](int frame) {
    const auto keyed = keyedSequence();
    if (keyed) playback_.show(static_cast<int>(std::lround((frame - 1.0) * (playback_.count() - 1) / (keyed->frames - 1))));
  });
  properties_->setKeying([this] { return setAnotherKey(); });
  connect(timeline_, &TimelineBar::keyWanted, this, &DocumentPage::setKey);
  connect(timeline_, &TimelineBar::keyUnwanted, this, &DocumentPage::removeKeyAt);
}

}  // namespace blossom::ui
