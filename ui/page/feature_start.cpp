#include "ui/page/feature_start.h"

#include <QCoreApplication>
#include <algorithm>
#include <optional>

#include "document/edits.h"
#include "document/shown.h"
#include "feature/acceptance.h"
#include "geometry/occt/sub_shape.h"
#include "geometry/shape/kind_names.h"
#include "parameter/wording.h"
#include "ui/look/registry_text.h"
#include "ui/look/text.h"
#include "ui/session/session.h"

namespace blossom::ui {

namespace {

/// Only here so that lupdate, too, sees the context of these texts.
struct FeatureStartTexts {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::FeatureStart)
};

bool contains(const std::vector<FeatureId>& ids, const FeatureId& id) {
  return std::find(ids.begin(), ids.end(), id) != ids.end();
}

/// The sub-shape that a parameter holds, or a list of it; nullptr: it holds none.
const ParameterSpec* subShapeOf(const ParameterSpec& spec) {
  if (spec.kind == ParameterKind::SubShape) return &spec;
  return spec.kind == ParameterKind::List && spec.fields.at(0).kind == ParameterKind::SubShape ? &spec.fields[0] : nullptr;
}

/// The first parameter that takes all of these parts; nullptr: none does.
const ParameterSpec* takerOf(const FeatureType& type, const std::vector<Pick>& parts) {
  for (const ParameterSpec& spec : type.parameters) {
    const ParameterSpec* element = subShapeOf(spec);
    if (!element || (element == &spec && parts.size() != 1)) continue;
    const auto suits = [&](const Pick& pick) { return subShapeKindName(pick.part.kind) == subShapeKind(*element); };
    if (!parts.empty() && std::all_of(parts.begin(), parts.end(), suits)) return &spec;
  }
  return nullptr;
}

/// Of which input a feature is the first shape, which its parts are named after; nullptr: of none.
const InputSpec* namedAfter(const FeatureType& type, const FeatureStart& start, const std::vector<std::size_t>& counts,
                            const FeatureId& id) {
  std::size_t first = 0;
  for (std::size_t k = 0; k < counts.size(); first += counts[k++])
    if (counts[k] > 0 && start.inputs[first] == id) return &type.inputs[k];
  return nullptr;
}

void takeParts(FeatureStart& start, const FeatureType& type, const std::vector<std::size_t>& counts,
               const ParameterSpec& taker, const std::vector<Pick>& parts) {
  Value all = Value::array();
  for (const Pick& pick : parts) {
    const InputSpec* input = namedAfter(type, start, counts, pick.feature);
    if (!input) return;  // parts of several shapes: the feature is made of the first alone, so they are picked again
    all.push_back({{"input", input->name}, {"kind", subShapeKindName(pick.part.kind)}, {"index", pick.part.index}});
  }
  start.parameters[taker.name] = subShapeOf(taker) == &taker ? all.at(0) : all;
}

/// Of a solid as an outline one face is meant, which is not told by choosing the solid.
bool fits(const InputSpec& spec, const Shape& shape) {
  return accepts(spec, shape) && (spec.use != InputUse::Outline || consumes(spec, shape));
}

/// What is chosen is given to the inputs that accept it, in their order.
FeatureStart startWith(const Session& session, const FeatureType& type, std::vector<FeatureId> left,
                       const ParameterSpec* taker, const std::vector<Pick>& parts) {
  FeatureStart start;
  std::vector<std::size_t> counts;
  for (const InputSpec& spec : type.inputs) {
    std::size_t& count = counts.emplace_back(0);
    for (auto it = left.begin(); it != left.end() && count < spec.maximum;) {
      const Shape* shape = session.shape(*it);
      const bool suits = shape && !shape->empty() && accepts(spec, *shape);
      if (suits) {
        start.inputs.push_back(*it);
        ++count;
      }
      it = suits ? left.erase(it) : std::next(it);
    }
    if (count >= spec.minimum) continue;
    start.missing = &spec;
    start.has = count;
    return start;
  }
  if (taker) takeParts(start, type, counts, *taker, parts);
  return start;
}

bool editsItsInput(const FeatureType& type) {
  return type.inputs.size() == 1 && type.inputs.front().use == InputUse::Edited;
}

bool acceptsResult(const Session& session, const InputSpec& spec, const FeatureId& id) {
  const Shape* shape = session.shape(id);
  return shape && !shape->empty() && accepts(spec, *shape);
}

struct Below {
  FeatureId found, user;
};

/// The nearest shape that a feature was made of and an input accepts, as long as there is only one way down to it.
std::optional<Below> shapeBelow(const Session& session, const InputSpec& spec, FeatureId id) {
  const Document& document = session.document();
  while (document.contains(id)) {
    const Feature& user = document.at(id);
    std::vector<FeatureId> fitting;
    for (const FeatureId& input : user.inputs)
      if (acceptsResult(session, spec, input) && !contains(fitting, input)) fitting.push_back(input);
    if (fitting.size() == 1) return Below{fitting.front(), user.id};
    if (!fitting.empty() || user.inputs.size() != 1) return std::nullopt;
    id = user.inputs.front();
  }
  return std::nullopt;
}

/// A shape and those that edits made it of, the first one first; those that are suppressed are no steps.
std::vector<FeatureId> wayTo(const Session& session, const InputSpec& spec, const FeatureId& end) {
  std::vector<FeatureId> way;
  for (FeatureId id = end;;) {
    const Feature& feature = session.document().at(id);
    const auto type = session.app().registry->find(feature.type);
    const bool further =
        type && editsItsInput(*type) && feature.inputs.size() == 1 && acceptsResult(session, spec, feature.inputs.front());
    if (!feature.suppressed || !further) way.push_back(id);
    if (!further) break;
    id = feature.inputs.front();
  }
  std::reverse(way.begin(), way.end());
  return way;
}

/// What is seen is made of what is edited: a sweep of its motion.
std::optional<FeatureStart> startBelow(const Session& session, const FeatureType& type, const FeatureId& chosen) {
  const InputSpec& spec = type.inputs.front();
  const bool ofSteps = spec.use == InputUse::Step && type.inputs.back().maximum == anyNumber;
  if (!editsItsInput(type) && !ofSteps) return std::nullopt;
  const auto below = shapeBelow(session, spec, chosen);
  if (!below) return std::nullopt;
  FeatureStart start;
  start.inputs = ofSteps ? wayTo(session, spec, below->found) : std::vector<FeatureId>{below->found};
  if (ofSteps) return start;
  start.users = usersOfEdited(*session.app().registry, session.document(), below->found);
  if (contains(start.users, below->user)) start.users = {below->user};  // others go on as they were
  return start;
}

}  // namespace

FeatureStart featureStart(const Session& session, const FeatureType& type, const std::vector<FeatureId>& selected,
                          const std::vector<Pick>& parts) {
  const ParameterSpec* taker = takerOf(type, parts);
  std::vector<FeatureId> chosen;
  if (taker)
    for (const Pick& pick : parts)
      if (!contains(chosen, pick.feature)) chosen.push_back(pick.feature);
  for (const FeatureId& id : selected)
    if (!contains(chosen, id)) chosen.push_back(id);

  FeatureStart start = startWith(session, type, chosen, taker, parts);
  if (start.missing && start.inputs.empty() && chosen.size() == 1)
    if (auto below = startBelow(session, type, chosen.front())) return *below;
  if (!start.missing && editsItsInput(type))
    start.users = usersOfEdited(*session.app().registry, session.document(), start.inputs.front());
  return start;
}

std::vector<FeatureId> leftOut(const Session& session, const FeatureType& type, const FeatureStart& start,
                               const std::vector<FeatureId>& selected) {
  std::vector<FeatureId> left;
  if (std::any_of(type.inputs.begin(), type.inputs.end(), [](const auto& spec) { return spec.use == InputUse::Edited; }))
    return left;
  for (const FeatureId& id : selected) {
    const auto takes = [&](const InputSpec& spec) { return acceptsResult(session, spec, id); };
    if (!contains(start.inputs, id) && std::any_of(type.inputs.begin(), type.inputs.end(), takes)) left.push_back(id);
  }
  return left;
}

std::vector<FeatureId> fittingFeatures(const Session& session, const InputSpec& spec, const std::vector<FeatureId>& taken) {
  const Document& document = session.document();
  const auto shapeOf = [&](const FeatureId& id) { return session.shape(id); };
  const std::vector<FeatureId> shown = shownFeatures(document, *session.app().registry, shapeOf);
  std::vector<FeatureId> fitting, others;
  for (const auto& feature : document.features()) {
    const Shape* shape = session.shape(feature->id);
    const bool there = feature->visible && !feature->suppressed && shape && !shape->empty();
    if (there && fits(spec, *shape) && !contains(taken, feature->id))
      (contains(shown, feature->id) ? fitting : others).push_back(feature->id);
  }
  return fitting.empty() ? others : fitting;
}

std::vector<FeatureId> hiddenFeatures(const Session& session, const InputSpec& spec, const std::vector<FeatureId>& taken) {
  std::vector<FeatureId> hidden;
  for (const auto& feature : session.document().features()) {
    const Shape* shape = session.shape(feature->id);
    const bool there = !feature->visible && !feature->suppressed && shape && !shape->empty();
    if (there && fits(spec, *shape) && !contains(taken, feature->id)) hidden.push_back(feature->id);
  }
  return hidden;
}

QString wantedShape(const InputSpec& spec) {
  if (!spec.asks.empty()) return registryText(spec.asks);
  return spec.kinds.empty() ? FeatureStartTexts::tr("a shape") : qt(kindNames(spec.kinds, true));
}

QString questionFor(const FeatureType& type, const FeatureStart& start) {
  const QString wanted = wantedShape(*start.missing);
  QString question = start.missing->asks.empty()
                         ? FeatureStartTexts::tr("Choose %1 for %2").arg(wanted, registryText(type.title))
                         : FeatureStartTexts::tr("Choose %1").arg(wanted);
  if (start.missing->minimum == 1) return question;
  return FeatureStartTexts::tr("%1 (%2 of %3)").arg(question).arg(start.has + 1).arg(start.missing->minimum);
}

}  // namespace blossom::ui
