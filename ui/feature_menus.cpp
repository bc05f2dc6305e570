#include "ui/feature_menus.h"

#include <QFileDialog>
#include <QMenu>
#include <QMenuBar>
#include <algorithm>

#include "ui/commands.h"
#include "ui/page.h"
#include "ui/text.h"

namespace blossom::ui {

namespace {

bool accepts(const InputSpec& spec, ShapeKind kind) {
  if (kind == ShapeKind::None) return false;
  const auto has = [&](ShapeKind wanted) {
    return std::find(spec.kinds.begin(), spec.kinds.end(), wanted) != spec.kinds.end();
  };
  return spec.kinds.empty() || has(kind) || (kind == ShapeKind::Curves && has(ShapeKind::Region));
}

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
    : QObject(window), app_(app), window_(window) {
  for (const LoadedPlugin& plugin : app.plugins) {
    if (!plugin.problem.empty()) continue;
    const QString group = qt(plugin.manifest.title);
    auto* menu = new QMenu(group, window);
    menu->setToolTipsVisible(true);
    for (const std::string& id : plugin.manifest.features) {
      const auto type = app.registry->find(id);
      if (!type) continue;
      const std::string iconName = type->icon.empty() ? plugin.manifest.icon : type->icon;
      const CommandSpec spec{QStringLiteral("feature.") + qt(id), group, qt(iconName), qt(type->title), qt(type->summary)};
      QAction* action = commands.add(spec, [this, type] { add(*type); });
      menu->addAction(action);
      actions_.push_back(action);
    }
    menus_.push_back(menu);
  }
}

void FeatureMenus::addTo(QMenuBar* bar) {
  for (QMenu* menu : menus_)
    if (!menu->isEmpty()) bar->addMenu(menu);
}

std::vector<FeatureId> FeatureMenus::inputsFor(const FeatureType& type, const InputSpec*& missing) const {
  std::vector<FeatureId> left = selected_, taken;
  for (const InputSpec& spec : type.inputs) {
    std::size_t count = 0;
    for (auto it = left.begin(); it != left.end() && count < spec.most;) {
      const auto view = page_->session().view(*it);
      if (view && accepts(spec, view->result->evaluated.shape.kind())) {
        taken.push_back(*it);
        it = left.erase(it);
        ++count;
      } else {
        ++it;
      }
    }
    if (count < spec.least) {
      missing = &spec;
      return taken;
    }
  }
  return taken;
}

void FeatureMenus::add(const FeatureType& type) {
  if (page_->startDrawing(type.id)) return;
  const InputSpec* missing = nullptr;
  const std::vector<FeatureId> inputs = inputsFor(type, missing);
  if (!missing) return page_->session().addFeature(type, inputs);
  if (type.inputs.size() == 1 && missing->least == 1) {
    const QString title = tr("%1: choose a file with a %2").arg(qt(type.title), kindsOf(*missing));
    const QString file = QFileDialog::getOpenFileName(window_, title, {}, readFilters(app_).join(QStringLiteral(";;")));
    if (!file.isEmpty()) page_->session().addFeatureFromFile(type, file.toStdString());
    return;
  }
  const QString hintText = tr("Select in the document: %1").arg(qt(missing->help));
  page_->showError(Error(ErrorCode::InvalidInput,
                         tr("%1 needs at least %2 %3 as \"%4\".")
                             .arg(qt(type.title))
                             .arg(missing->least)
                             .arg(kindsOf(*missing), qt(missing->name))
                             .toStdString(),
                         hintText.toStdString()));
}

}  // namespace blossom::ui
