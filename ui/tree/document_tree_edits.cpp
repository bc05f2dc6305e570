// What the document tree does to the document.
#include <QClipboard>
#include <QGuiApplication>
#include <algorithm>

#include "document/edits.h"
#include "ui/look/text.h"
#include "ui/panel/input_slots.h"
#include "ui/session/session.h"
#include "ui/tree/document_clipboard.h"
#include "ui/tree/document_model.h"
#include "ui/tree/document_tree.h"

namespace blossom::ui {

QString DocumentTree::nameOf(const FeatureId& id) const { return qt(session_.document().at(id).name); }

QString DocumentTree::titled(const std::vector<FeatureId>& ids, const QString& one, const QString& several) const {
  return ids.size() == 1 ? one.arg(nameOf(ids.front())) : several.arg(ids.size());
}

// What changes nothing is no step of undo.
template <class Make>
bool DocumentTree::attempt(const QString& what, const Make& make) {
  try {
    Document document = make();
    const auto now = session_.document().features(), then = document.features();
    if (std::equal(now.begin(), now.end(), then.begin(), then.end())) return false;
    session_.commit(std::move(document), what);
    return true;
  } catch (const Error& error) {
    emit refused(error, {});
    return false;
  }
}

void DocumentTree::renameCurrent() {
  if (!currentIndex().isValid()) return;
  setFocus();
  scrollTo(currentIndex());
  edit(currentIndex());
}

void DocumentTree::toggleVisible(const FeatureId& id) {
  const bool visible = !session_.document().at(id).visible;
  attempt((visible ? tr("Show %1") : tr("Hide %1")).arg(nameOf(id)),
          [&] { return withVisible(session_.document(), {id}, visible); });
}

// All of them become what the first one becomes.
void DocumentTree::toggleSelected() {
  const std::vector<FeatureId> ids = selected();
  if (ids.empty()) return;
  const bool visible = !session_.document().at(ids.front()).visible;
  attempt(visible ? titled(ids, tr("Show %1"), tr("Show %1 features")) : titled(ids, tr("Hide %1"), tr("Hide %1 features")),
          [&] { return withVisible(session_.document(), ids, visible); });
}

void DocumentTree::showAll() {
  std::vector<FeatureId> ids;
  for (const auto& feature : session_.document().features()) ids.push_back(feature->id);
  attempt(tr("Show everything"), [&] { return withVisible(session_.document(), ids, true); });
}

void DocumentTree::isolateSelected() {
  const std::vector<FeatureId> ids = selected();
  if (ids.empty()) return;
  const Document& document = session_.document();
  if (!beforeIsolation_.empty() && areOnlyVisible(document, ids)) {
    const std::map<FeatureId, bool> before = std::exchange(beforeIsolation_, {});
    attempt(tr("End isolation"), [&] {
      std::vector<FeatureId> shown, hidden;
      for (const auto& [id, visible] : before)
        if (document.contains(id)) (visible ? shown : hidden).push_back(id);
      return withVisible(withVisible(document, shown, true), hidden, false);
    });
    return;
  }
  std::map<FeatureId, bool> before;
  for (const auto& feature : document.features()) before[feature->id] = feature->visible;
  if (attempt(titled(ids, tr("Isolate %1"), tr("Isolate %1 features")), [&] { return withOnlyVisible(document, ids); }))
    beforeIsolation_ = std::move(before);
}

void DocumentTree::suppress(const std::vector<FeatureId>& ids, bool suppressed) {
  attempt(suppressed ? titled(ids, tr("Suppress %1"), tr("Suppress %1 features"))
                     : titled(ids, tr("Compute %1 again"), tr("Compute %1 features again")),
          [&] { return withSuppressed(session_.document(), ids, suppressed); });
}

void DocumentTree::toggleSuppressed() {
  const std::vector<FeatureId> ids = selected();
  if (!ids.empty()) suppress(ids, !session_.document().at(ids.front()).suppressed);
}

void DocumentTree::remove(const std::vector<FeatureId>& ids) {
  attempt(titled(ids, tr("Delete %1"), tr("Delete %1 features")), [&] { return withoutAll(session_.document(), ids); });
}

void DocumentTree::removeAlone(const std::vector<FeatureId>& ids) {
  attempt(titled(ids, tr("Delete %1"), tr("Delete %1 features")),
          [&] { return withoutAlone(ids).value_or(session_.document()); });
}

std::optional<Document> DocumentTree::withoutAlone(const std::vector<FeatureId>& ids) const {
  auto without = withoutSteps(session_.document(), ids);
  return without ? std::move(without) : withoutInputs(session_, ids);
}

void DocumentTree::removeSelected() {
  const std::vector<FeatureId> ids = selected();
  if (ids.empty()) return;
  const std::vector<FeatureId> users = dependants(session_.document(), ids);
  if (users.empty()) return remove(ids);
  refuseRemoval(ids, users);
}

void DocumentTree::refuseRemoval(const std::vector<FeatureId>& ids, const std::vector<FeatureId>& users) {
  QStringList names;
  for (const FeatureId& user : users) names << u'"' + nameOf(user) + u'"';
  const QString last = names.size() > 1 ? tr(" and %1").arg(names.takeLast()) : QString();
  const QString subject = ids.size() == 1 ? u'"' + nameOf(ids.front()) + u'"' : tr("What is selected");
  const QString list = names.join(QStringLiteral(", ")) + last;
  const QString hint = users.size() == 1 ? tr("Delete that too, or suppress: what is suppressed stays but is not computed.")
                                         : tr("Delete them too, or suppress: what is suppressed stays but is not computed.");
  std::vector<FeatureId> all = ids;
  all.insert(all.end(), users.begin(), users.end());
  const auto there = [this](std::vector<FeatureId> wanted) {
    std::erase_if(wanted, [this](const FeatureId& id) { return !session_.document().contains(id); });
    return wanted;
  };
  std::vector<Offer> offers{{tr("Delete all %1").arg(all.size()), [this, all, there] { remove(there(all)); }},
                            {tr("Suppress"), [this, ids, there] { suppress(there(ids), true); }}};
  if (withoutAlone(ids))
    offers.insert(offers.begin(), {tr("Delete alone"), [this, ids, there] { removeAlone(there(ids)); }});
  emit refused(Error(ErrorCode::InUse, tr("%1 is used by %2.").arg(subject, list).toStdString(), hint.toStdString()),
               offers);
}

/// Steps stand beneath their result, the last one first: up there is on in the document.
void DocumentTree::stepSelected(int by) {
  const std::vector<FeatureId> ids = selected();
  if (ids.empty()) return;
  const auto isStep = [this](const FeatureId& id) { return !model_->parentOf(id).empty(); };
  std::optional<Document> exchanged;
  if (ids.size() == 1 && isStep(ids.front()))
    exchanged = withEditsExchanged(*session_.app().registry, session_.document(), ids.front(), -by);
  const std::vector<FeatureId> users = exchanged ? exchanged->usersOf(ids.front()) : std::vector<FeatureId>();
  if (exchanged && users.empty()) exchanged.reset();  // it would be the result
  attempt(titled(ids, tr("Move %1"), tr("Move %1 features")), [&] {
    return exchanged ? *std::move(exchanged)
                     : withStepped(session_.document(), withSteps(ids), by).value_or(session_.document());
  });
}

void DocumentTree::moveSelectedBefore(std::size_t row) {
  const std::vector<FeatureId> ids = selected();
  if (ids.empty()) return;
  attempt(titled(ids, tr("Move %1"), tr("Move %1 features")),
          [&] { return withMoved(session_.document(), withSteps(ids), placeBefore(row)); });
}

void DocumentTree::copySelected() const {
  const std::vector<FeatureId> ids = selected();
  if (!ids.empty()) QGuiApplication::clipboard()->setMimeData(toMimeData({session_.document(), ids}));
}

void DocumentTree::cutSelected() {
  copySelected();
  removeSelected();
}

void DocumentTree::addCopies(const Document& clip, const std::vector<FeatureId>& wanted, const QString& one,
                             const QString& several) {
  if (wanted.empty()) return;
  std::vector<FeatureId> added;
  const QString what = wanted.size() == 1 ? one.arg(qt(clip.at(wanted.front()).name)) : several.arg(wanted.size());
  if (attempt(what, [&] { return withCopies(session_.document(), clip, wanted, added); })) selectThese(added);
}

void DocumentTree::paste() {
  try {
    if (const auto clip = fromMimeData(QGuiApplication::clipboard()->mimeData()))
      addCopies(clip->document, clip->wanted, tr("Paste %1"), tr("Paste %1 features"));
    else
      emit refused(Error(ErrorCode::InvalidInput, tr("There are no features on the clipboard.").toStdString(),
                         tr("Select some and copy them first.").toStdString()),
                   {});
  } catch (const Error& error) {
    emit refused(error, {});
  }
}

void DocumentTree::duplicateSelected() {
  addCopies(session_.document(), selected(), tr("Duplicate %1"), tr("Duplicate %1 features"));
}

}  // namespace blossom::ui
