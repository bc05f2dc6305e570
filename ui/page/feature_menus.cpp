#include "ui/page/feature_menus.h"

#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <algorithm>

#include "ui/commands/commands.h"
#include "ui/look/registry_text.h"
#include "ui/look/text.h"
#include "ui/page/feature_start.h"
#include "ui/page/page.h"
#include "ui/panel/error_bar.h"
#include "ui/view/view_widget.h"

namespace blossom::ui {

QStringList readFilters(const App& app) {
  QStringList filters;
  QStringList all;
  for (const Format& format : app.formats->formats()) {
    if (!format.read) continue;
    QStringList patterns;
    for (const std::string& extension : format.extensions) patterns << QStringLiteral("*.") + qt(extension);
    all << patterns;
    filters << QStringLiteral("%1 (%2)").arg(qt(format.title).replace(u'(', u'[').replace(u')', u']'), patterns.join(u' '));
  }
  filters.prepend(FeatureMenus::tr("Everything that can be read (%1)").arg(all.join(u' ')));
  return filters;
}

FeatureMenus::FeatureMenus(const App& app, Commands& commands, QWidget* window)
    : QObject(window), app_(app), commands_(commands), window_(window) {
  for (const LoadedPlugin& plugin : app.plugins)
    if (plugin.problem.empty()) addGroup(plugin);
}

void FeatureMenus::addGroup(const LoadedPlugin& plugin) {
  FeatureGroup group{registryText(plugin.manifest.title), qt(plugin.manifest.icon), nullptr, {}};
  group.menu = new QMenu(group.title, window_);
  group.menu->setToolTipsVisible(true);
  for (const std::string& id : plugin.manifest.features) {
    const auto type = app_.registry->find(id);
    if (!type) continue;
    const std::string iconName = type->icon.empty() ? plugin.manifest.icon : type->icon;
    CommandSpec spec{QStringLiteral("feature.") + qt(id), group.title, qt(iconName), registryText(type->title),
                     registryText(type->summary)};
    for (const Keyword& each : type->keywords) spec.keywords << qt(each.word);
    if (spec.text != qt(type->title)) spec.keywords << qt(type->title).toLower();  // what tutorials call it
    QAction* action = commands_.add(spec, [this, type] { add(*type, Value::object()); });
    group.menu->addAction(action);
    group.actions.push_back(action);
    types_.emplace_back(action, type);
  }
  if (!group.actions.empty()) groups_.push_back(std::move(group));
}

void FeatureMenus::addTo(QMenuBar* bar) {
  for (const FeatureGroup& group : groups_) bar->addMenu(group.menu);
}

std::vector<QAction*> FeatureMenus::taking(const std::vector<FeatureId>& selected) const {
  std::vector<QAction*> found;
  for (const auto& [action, type] : types_) {
    if (type->inputs.empty()) continue;
    const FeatureStart start = featureStart(page_->session(), *type, selected, {});
    if (!start.missing && start.inputs.size() == selected.size()) found.push_back(action);
  }
  return found;
}

QString FeatureMenus::wants(const QString& commandId) const {
  const auto found =
      std::find_if(types_.begin(), types_.end(), [&](const auto& each) { return each.first->objectName() == commandId; });
  if (found == types_.end() || !page_) return {};
  const FeatureType& type = *found->second;
  const FeatureStart start = featureStart(page_->session(), type, selected_, page_->view().selectedParts());
  return start.missing ? tr("Takes %1.").arg(wantedShape(*start.missing)) : QString();
}

void FeatureMenus::add(const FeatureType& type, const Value& preset) {
  page_->endQuestion();
  if (!page_->startDrawing(type.id)) begin(type, selected_, preset);
}

void FeatureMenus::startAs(const QString& commandId, const QString& keyword) {
  for (const auto& [action, type] : types_) {
    if (action->objectName() != commandId || !action->isEnabled()) continue;
    for (const Keyword& each : type->keywords)
      if (qt(each.word) == keyword) return add(*type, each.preset);
    return action->trigger();
  }
}

namespace {

using Place = std::vector<FeatureId>::iterator;

void inDocumentOrder(const Document& document, Place from, Place to) {
  std::map<FeatureId, std::size_t> places;
  for (const auto& feature : document.features()) places.emplace(feature->id, places.size());
  std::sort(from, to, [&](const FeatureId& a, const FeatureId& b) { return places.at(a) < places.at(b); });
}

/// Of a sequence the frame that is seen is meant.
void takeShownFrame(const DocumentPage& page, const FeatureType& type, const std::vector<FeatureId>& inputs,
                    Value& parameters) {
  if (type.takesFrame.empty() || inputs.empty() || parameters.contains(type.takesFrame)) return;
  const Shape* const shape = page.session().shape(inputs.front());
  const auto* const sequence = shape ? shape->get<Sequence>() : nullptr;
  if (sequence) parameters[type.takesFrame] = page.shownFrame(static_cast<int>(sequence->frames.size())) + 1;
}

}  // namespace

// What is missing is taken where the document leaves no choice, else asked for in the view.
void FeatureMenus::begin(const FeatureType& type, std::vector<FeatureId> chosen, const Value& preset) {
  DocumentPage& page = *page_;
  while (true) {
    const FeatureStart start = featureStart(page.session(), type, chosen, page.view().selectedParts());
    if (!start.missing) {
      page.view().setSelectedParts({});
      Value parameters = preset;
      parameters.update(start.parameters);
      takeShownFrame(page, type, start.inputs, parameters);
      const std::vector<FeatureId> left = leftOut(page.session(), type, start, chosen);
      page.session().addFeature(type, start.inputs, parameters, start.users);
      return tellLeftOut(type, start.inputs.size(), left);
    }
    const std::vector<FeatureId> fitting = fittingFeatures(page.session(), *start.missing, start.inputs);
    const std::size_t wanted = start.missing->minimum - start.has;
    if (fitting.size() < wanted) {
      const std::vector<FeatureId> hidden = hiddenFeatures(page.session(), *start.missing, start.inputs);
      return fitting.size() + hidden.size() < wanted ? tellNothingFits(type, *start.missing) : tellHidden(type, hidden);
    }
    chosen = start.inputs;
    if (fitting.size() == wanted) {
      chosen.insert(chosen.end(), fitting.begin(), fitting.end());
      // What was made first is what the others are taken from: a part and then the tool for its hole, which is still
      // selected.
      inDocumentOrder(page.document(), chosen.end() - static_cast<std::ptrdiff_t>(start.missing->minimum), chosen.end());
      continue;
    }
    return page.choose(questionFor(type, start), fitting, [this, &type, chosen, preset](const FeatureId& id) {
      std::vector<FeatureId> more = chosen;
      more.push_back(id);
      begin(type, std::move(more), preset);
    });
  }
}

void FeatureMenus::tellLeftOut(const FeatureType& type, std::size_t taken, const std::vector<FeatureId>& left) {
  if (left.empty()) return;
  QStringList names;
  for (const FeatureId& id : left) names << qt(shownName(page_->document().at(id)));
  page_->errors().showNote(
      tr("%1 takes %2 of the %3 selected shapes.").arg(registryText(type.title)).arg(taken).arg(taken + left.size()),
      tr("Left out: %1.").arg(names.join(QStringLiteral(", "))));
  page_->errors().untilChange();
}

namespace {

/// Begins without anything, and gives what an input takes.
bool beginsWith(const FeatureType& type, const InputSpec& input) {
  const auto optional = [](const InputSpec& each) { return each.minimum == 0; };
  if (!std::all_of(type.inputs.begin(), type.inputs.end(), optional)) return false;
  const auto accepted = [&](ShapeKind kind) {
    return std::find(input.kinds.begin(), input.kinds.end(), kind) != input.kinds.end();
  };
  return std::any_of(type.produces.begin(), type.produces.end(), accepted);
}

}  // namespace

/// Types that make what an input takes, at most `count`; those of one plugin first.
std::vector<std::shared_ptr<const FeatureType>> FeatureMenus::makersOf(const InputSpec& input, const FeatureType& user,
                                                                       std::size_t count) const {
  const auto plugin = [](const FeatureType& type) { return type.id.substr(0, type.id.find('.')); };
  std::vector<std::shared_ptr<const FeatureType>> own, others;
  for (const auto& [action, type] : types_)
    if (action->isEnabled() && beginsWith(*type, input)) (plugin(*type) == plugin(user) ? own : others).push_back(type);
  own.insert(own.end(), others.begin(), others.end());
  own.resize(std::min(own.size(), count));
  return own;
}

void FeatureMenus::tellNothingFits(const FeatureType& type, const InputSpec& missing) {
  page_->showError(Error(ErrorCode::InvalidInput,
                         missing.minimum == 1 ? tr("There is nothing here yet for %1: it takes %2.")
                                                    .arg(registryText(type.title), wantedShape(missing))
                                                    .toStdString()
                                              : tr("There is too little here for %1, which takes %3 of these: %2.")
                                                    .arg(registryText(type.title), wantedShape(missing))
                                                    .arg(missing.minimum)
                                                    .toStdString(),
                         tr("Draw or make one, or import a file.").toStdString()));
  constexpr std::size_t offered = 2;
  for (const auto& maker : makersOf(missing, type, offered))
    page_->errors().offer(registryText(maker->title), [this, maker] { add(*maker, Value::object()); });
  if (type.inputs.size() != 1 || missing.minimum != 1) return;
  page_->errors().offer(tr("Import a file…"), [this, &type] { addFromFile(type); });
}

/// What nobody sees is not taken unasked.
void FeatureMenus::tellHidden(const FeatureType& type, const std::vector<FeatureId>& hidden) {
  QStringList names;
  for (const FeatureId& id : hidden) names << qt(shownName(page_->document().at(id)));
  page_->showError(
      Error(ErrorCode::InvalidInput,
            tr("%1 takes nothing hidden: %2.").arg(registryText(type.title), names.join(QStringLiteral(", "))).toStdString(),
            tr("Show them first, or select in the tree what it is to take.").toStdString()));
  page_->errors().untilChange();
}

void FeatureMenus::addFromFile(const FeatureType& type) {
  const QString title = tr("%1: choose a file with %2").arg(registryText(type.title), wantedShape(type.inputs.front()));
  const QString file = QFileDialog::getOpenFileName(window_, title, {}, readFilters(app_).join(QStringLiteral(";;")));
  if (!file.isEmpty()) page_->session().addFeatureFromFile(type, file.toStdString());
}

}  // namespace blossom::ui
