// The part of PropertyPanel that changes the document: previews, edits and files.
#include <algorithm>
#include <set>
#include <utility>

#include "document/edits.h"
#include "document/evaluation/quick_preview.h"
#include "document/file_access.h"
#include "document/file_values.h"
#include "ui/fields/parameter_field.h"
#include "ui/look/registry_text.h"
#include "ui/look/text.h"
#include "ui/panel/feature_header.h"
#include "ui/panel/input_editor.h"
#include "ui/panel/property_panel.h"
#include "ui/plugin/tool.h"
#include "ui/session/session.h"

namespace blossom::ui {

namespace {

bool namesFiles(const ParameterSpec& spec, const Value& value) {
  if (value.is_null()) return false;
  if (spec.kind == ParameterKind::File) return value.value("asset", std::string()).empty();
  if (spec.kind == ParameterKind::List)
    return std::any_of(value.begin(), value.end(), [&](const Value& item) { return namesFiles(spec.fields.at(0), item); });
  if (spec.kind != ParameterKind::Record) return false;
  return std::any_of(spec.fields.begin(), spec.fields.end(), [&](const ParameterSpec& field) {
    return value.contains(field.name) && namesFiles(field, value.at(field.name));
  });
}

std::set<std::string> pathsIn(const ParameterSpec& spec, Value value) {
  std::set<std::string> paths;
  eachFile(spec, value, [&](Value& file) { paths.insert(file.value("path", std::string())); });
  return paths;
}

/// What the user has just chosen may be read, whatever else the document names.
void allowChosen(const ParameterSpec& spec, const Feature& before, const Value& now, const Document& document) {
  const auto had = before.parameters.find(spec.name);
  const std::set<std::string> known = pathsIn(spec, had == before.parameters.end() ? Value() : *had);
  for (const std::string& path : pathsIn(spec, now))
    if (document.access() && !known.contains(path)) document.access()->allow(path);
}

/// That parameter alone, so that nothing else is read.
Document withNothingBut(const Document& document, const FeatureId& id, const std::string& parameter) {
  Feature alone = document.at(id);
  alone.inputs.clear();
  alone.parameters = Value{{parameter, alone.parameters.at(parameter)}};
  return Document().withAccess(document.access()).with(std::move(alone));
}

/// One parameter as `other` has it, with the contents that it names.
Document withParameterOf(Document document, const Document& other, const FeatureId& id, const std::string& parameter) {
  Feature feature = document.at(id);
  feature.parameters[parameter] = other.at(id).parameters.at(parameter);
  for (const auto& [hash, content] : other.assets())
    if (!document.assets().contains(hash)) document = document.withAsset(hash, content);
  return document.with(feature);
}

/// The frames of a sequence and the list that keeps a feature from making one do not go together: of the two, the name of
/// the one that has to give way to the one that is set; empty when none has to.
std::string givingWay(const PlayedBy& played, const std::string& changed, const Value& parameters) {
  const auto isSet = [&](const std::string& name) {
    const auto at = parameters.find(name);
    return at != parameters.end() && *at != 0 && !at->empty();
  };
  if (played.excludedBy.empty() || !isSet(played.parameter) || !isSet(played.excludedBy)) return {};
  return changed == played.excludedBy ? played.parameter : changed == played.parameter ? played.excludedBy : std::string();
}

}  // namespace

Feature PropertyPanel::changed(const std::string& parameter, const Value& value) const {
  Feature feature = session_.document().at(shown_);
  if (value.is_null())
    feature.parameters.erase(parameter);
  else
    feature.parameters[parameter] = value;
  if (type_) feature.parameters.erase(givingWay(type_->playedBy, parameter, feature.parameters));
  return feature;
}

/// Something else was left out, so that what is set has an effect. The row that comes under the mouse tells about itself at
/// once: this has to stay for longer.
void PropertyPanel::tellWhatGaveWay(const ParameterSpec& set, const Value& before) {
  const Value& now = session_.document().at(shown_).parameters;
  const std::string& other = set.name == type_->playedBy.parameter ? type_->playedBy.excludedBy : type_->playedBy.parameter;
  if (set.name == other || !before.contains(other) || now.contains(other)) return;
  const auto name = [](std::string written) {
    ParameterSpec spec;
    spec.name = std::move(written);
    return registryText(label(spec));
  };
  emit session_.noted(tr("%1 is left out: it does not go with %2 · Undo brings it back").arg(name(other), name(set.name)));
}

void PropertyPanel::preview(ParameterField* field, const Value& value) {
  previewed_ = field;
  waiting_ = value;
  if (!session_.evaluating() || sentWhole_) sendPreview();
}

// Only the newest value goes off, and only when the one before has come, or the evaluation of it to its end: dragging never
// queues up, and slow features still show something while they are dragged.
void PropertyPanel::sendPreview() {
  const bool busy = session_.evaluating();
  if (sentWhole_) isSlow_ = sent_.elapsed() > previewPatience;  // has taken, or is taking
  if (!busy) sentWhole_ = false;
  if (!busy) quick_.clear();
  if (!waiting_ && previewed_ && isQuick_ && quick_.empty()) {
    if (!rest_.isActive()) rest_.start();
    return;
  }
  const bool isFree = !busy || (sentWhole_ && isSlow_) || (isQuick_ && quick_.empty());
  if (!waiting_ || !previewed_ || !isFree) return;
  Document document = session_.document().with(changed(previewed_->spec().name, *waiting_));
  auto quick = isSlow_ ? quickPreview(document, *session_.app().registry, shown_) : std::nullopt;
  if (busy && !quick) return;
  waiting_.reset();
  if (!quick) return sendWhole(std::move(document));
  sentWhole_ = false;
  isQuick_ = true;
  quick_ = quick->last;
  const auto view = session_.view(quick_);
  beforeQuick_ = view ? view->result : nullptr;
  rest_.stop();
  session_.preview(std::move(document), std::move(quick->document));
}

/// What is made of the quick preview may take long: neither the next one nor the whole waits for that.
void PropertyPanel::lookForQuick() {
  if (quick_.empty()) return;
  const auto view = session_.view(quick_);
  if (!view || view->result == beforeQuick_) return;
  quick_.clear();
  QMetaObject::invokeMethod(this, &PropertyPanel::sendPreview, Qt::QueuedConnection);
}

void PropertyPanel::sendWhole(Document document) {
  rest_.stop();
  isQuick_ = false;
  quick_.clear();
  sentWhole_ = true;
  sent_.start();
  QTimer::singleShot(previewPatience + 1, this,
                     &PropertyPanel::sendPreview);  // what waits meanwhile need not wait for all of it
  session_.preview(std::move(document));
}

void PropertyPanel::commit(ParameterField* field, const Value& value) {
  const bool isBehind = waiting_ || !quick_.empty();
  endPreviews();
  const Document document =
      session_.document().with(changed(field->spec().name, field->value() == value ? field->written() : value));
  if (namesFiles(field->spec(), value)) return takeFiles(field, document);
  const Value before = session_.document().at(shown_).parameters;
  auto quick = isSlow_ && isBehind ? quickPreview(document, *session_.app().registry, shown_) : std::nullopt;
  session_.commit(document,
                  tr("Change %1 of %2").arg(registryText(label(field->spec())), qt(shownName(document.at(shown_)))),
                  quick ? std::optional(std::move(quick->document)) : std::nullopt);
  if (type_) tellWhatGaveWay(field->spec(), before);
}

// The content of a file is kept in the document; it is read elsewhere than in the window's thread, while the user may go on.
void PropertyPanel::takeFiles(ParameterField* field, const Document& document) {
  if (session_.job().running()) {
    field->setFault(tr("Another file is still being read or written. Wait for it or cancel it."));
    return;
  }
  allowChosen(field->spec(), session_.document().at(shown_), document.at(shown_).parameters.at(field->spec().name),
              document);
  const auto embedded = std::make_shared<Document>(withNothingBut(document, shown_, field->spec().name));
  const QPointer<ParameterField> asking = field;
  session_.job().start(
      tr("Reading the file"),
      [embedded, app = session_.app()](const Progress&) { *embedded = withFilesEmbedded(*app.registry, *embedded); },
      [this, embedded, asking, feature = shown_, spec = field->spec()](const std::optional<Error>& error) {
        if (!session_.document().contains(feature)) return;
        if (error) {
          if (feature == shown_) refreshFields();  // back to the file before
          if (asking) asking->setFault(qt(error->message()));
          return;
        }
        session_.commit(withParameterOf(session_.document(), *embedded, feature, spec.name),
                        tr("Change %1 of %2").arg(registryText(label(spec)), qt(shownName(embedded->at(feature)))));
      });
}

void PropertyPanel::endPreviews() {
  waiting_.reset();
  rest_.stop();
  previewed_ = nullptr;
  sentWhole_ = isQuick_ = false;
  quick_.clear();
}

void PropertyPanel::revert() {
  endPreviews();
  session_.endPreview();
}

void PropertyPanel::rename(const QString& name) {
  Feature feature = session_.document().at(shown_);
  feature.name = name.toStdString();
  session_.commit(session_.document().with(feature), tr("Rename %1").arg(name));
}

void PropertyPanel::wantPick(ParameterField* field, InputEditor* input, PickRequest request) {
  if (request.want == PickRequest::Want::Feature) {
    const InputSlots taken(session_, session_.document().at(shown_), *type_);
    for (std::size_t k = 0; k < inputs_.size(); ++k)
      if (inputs_[k] == input) request.features = taken.candidates(k);
  }
  picking_.want(field, input, request);
}

}  // namespace blossom::ui
