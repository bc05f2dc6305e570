#include "ui/page/feature_menus.h"

#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <algorithm>

#include "feature/acceptance.h"
#include "ui/commands/commands.h"
#include "ui/look/text.h"
#include "ui/page/page.h"

namespace blossom::ui {

namespace {

QString kindsOf(const InputSpec& spec) {
  QStringList names;
  for (const ShapeKind kind : spec.kinds) names << qt(shapeKindName(kind));
  return names.isEmpty() ? FeatureMenus::tr("shape") : names.join(FeatureMenus::tr(" or "));
}

}  // namespace

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
  FeatureGroup group{qt(plugin.manifest.title), qt(plugin.manifest.icon), nullptr, {}};
  group.menu = new QMenu(group.title, window_);
  group.menu->setToolTipsVisible(true);
  for (const std::string& id : plugin.manifest.features) {
    const auto type = app_.registry->find(id);
    if (!type) continue;
    const std::string iconName = type->icon.empty() ? plugin.manifest.icon : type->icon;
    const CommandSpec spec{QStringLiteral("feature.") + qt(id), group.title, qt(iconName), qt(type->title),
                           qt(type->summary)};
    QAction* action = commands_.add(spec, [this, type] { add(*type); });
    group.menu->addAction(action);
    group.actions.push_back(action);
    types_.emplace_back(action, type);
  }
  if (!group.actions.empty()) groups_.push_back(std::move(group));
}

void FeatureMenus::addTo(QMenuBar* bar) {
  for (const FeatureGroup& group : groups_) bar->addMenu(group.menu);
}

std::vector<FeatureId> FeatureMenus::inputsFor(const FeatureType& type, std::vector<FeatureId> left,
                                               const InputSpec*& missing) const {
  std::vector<FeatureId> taken;
  for (const InputSpec& spec : type.inputs) {
    std::size_t count = 0;
    for (auto it = left.begin(); it != left.end() && count < spec.maximum;) {
      const auto view = page_->session().view(*it);
      if (view && accepts(spec, view->result->evaluated.shape)) {
        taken.push_back(*it);
        it = left.erase(it);
        ++count;
      } else {
        ++it;
      }
    }
    if (count < spec.minimum) {
      missing = &spec;
      return taken;
    }
  }
  return taken;
}

std::vector<QAction*> FeatureMenus::taking(const std::vector<FeatureId>& selected) const {
  std::vector<QAction*> found;
  for (const auto& [action, type] : types_) {
    const InputSpec* missing = nullptr;
    const bool all = !type->inputs.empty() && inputsFor(*type, selected, missing).size() == selected.size();
    if (all && !missing) found.push_back(action);
  }
  return found;
}

QString FeatureMenus::wants(const QString& commandId) const {
  const auto found =
      std::find_if(types_.begin(), types_.end(), [&](const auto& each) { return each.first->objectName() == commandId; });
  if (found == types_.end() || !page_) return {};
  const InputSpec* missing = nullptr;
  static_cast<void>(inputsFor(*found->second, selected_, missing));
  if (!missing) return {};
  return missing->minimum == 1
             ? tr("Takes a %1 as \"%2\".").arg(kindsOf(*missing), qt(missing->name))
             : tr("Takes %1 × %2 as \"%3\".").arg(missing->minimum).arg(kindsOf(*missing), qt(missing->name));
}

void FeatureMenus::add(const FeatureType& type) {
  if (page_->startDrawing(type.id)) return;
  const InputSpec* missing = nullptr;
  const std::vector<FeatureId> inputs = inputsFor(type, selected_, missing);
  if (!missing) return page_->session().addFeature(type, inputs);
  if (type.inputs.size() == 1 && missing->minimum == 1) {
    const QString title = tr("%1: choose a file with a %2").arg(qt(type.title), kindsOf(*missing));
    const QString file = QFileDialog::getOpenFileName(window_, title, {}, readFilters(app_).join(QStringLiteral(";;")));
    if (!file.isEmpty()) page_->session().addFeatureFromFile(type, file.toStdString());
    return;
  }
  const QString hintText = tr("Select in the document: %1").arg(qt(missing->help));
  page_->showError(Error(ErrorCode::InvalidInput,
                         tr("%1 needs at least %2 %3 as \"%4\".")
                             .arg(qt(type.title))
                             .arg(missing->minimum)
                             .arg(kindsOf(*missing), qt(missing->name))
                             .toStdString(),
                         hintText.toStdString()));
}

}  // namespace blossom::ui
