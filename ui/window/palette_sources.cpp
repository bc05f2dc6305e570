#include "ui/window/palette_sources.h"

#include <QAction>
#include <QCoreApplication>
#include <QFileInfo>
#include <QPointer>
#include <QRegularExpression>
#include <QWidget>
#include <memory>

#include "ui/commands/commands.h"
#include "ui/files/recent_files.h"
#include "ui/files/start_page.h"
#include "ui/help/manual_pages.h"
#include "ui/look/text.h"
#include "ui/page/feature_menus.h"
#include "ui/page/page.h"
#include "ui/tree/document_model.h"
#include "ui/tree/document_tree.h"

namespace blossom::ui {

namespace {

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(blossom::ui::CommandPalette)
};

QString withoutMnemonic(QString text) {
  static const QRegularExpression behind(QStringLiteral("\\(&\\w\\)"));  // "파일(&F)"
  return text.remove(behind).remove(QStringLiteral("&&")).remove(u'&');
}

QString readableName(const QString& file) {
  return sentenceCase(QFileInfo(file).completeBaseName().replace(u'-', u' ').replace(u'_', u' '));
}

PaletteEntry entryOf(const Command& command, FeatureMenus& menus, const QString& iconName) {
  const QString wants = menus.wants(command.id);
  PaletteEntry entry;
  entry.id = command.id;
  entry.group = command.group;
  entry.icon = iconName;
  entry.text = withoutMnemonic(command.action->text());
  entry.keys = command.action->shortcut().toString(QKeySequence::NativeText);
  entry.help = wants.isEmpty() ? command.help : command.help + u' ' + wants;
  entry.enabled = command.action->isEnabled();
  entry.whyNot = command.whyNot;
  entry.keywords = command.keywords;
  if (command.id.startsWith(QLatin1String("feature.")))
    entry.goAs = [menus = QPointer<FeatureMenus>(&menus), id = command.id](const QString& keyword) {
      if (menus) menus->startAs(id, keyword);
    };
  entry.go = [action = QPointer<QAction>(command.action)] {
    if (action) action->trigger();
  };
  return entry;
}

}  // namespace

PaletteSource commandEntries(const Commands& commands, FeatureMenus& menus) {
  return [&] {
    std::vector<PaletteEntry> entries;
    entries.reserve(commands.all().size());
    for (const Command& command : commands.all()) entries.push_back(entryOf(command, menus, command.icon));
    return entries;
  };
}

PaletteSource fileEntries(std::function<void(const QString&)> open) {
  return [open = std::move(open)] {
    std::vector<PaletteEntry> entries;
    const auto add = [&](const char* kind, const QString& group, const char* icon, const QString& file) {
      PaletteEntry entry;
      entry.id = QLatin1String(kind) + file;
      entry.group = group;
      entry.icon = QLatin1String(icon);
      entry.text = readableName(file);
      entry.help = file;
      entry.go = [open, file] { open(file); };
      entries.push_back(std::move(entry));
    };
    for (const QString& file : sampleFiles()) add("sample:", Texts::tr("Sample"), "samples", file);
    for (const RecentFile& each : RecentFiles::instance().list())
      if (!each.missing) add("recent:", Texts::tr("Recent"), "recent", each.file);
    return entries;
  };
}

PaletteSource featureEntries(std::function<DocumentPage&()> page) {
  return [page = std::move(page)] {
    std::vector<PaletteEntry> entries;
    const QAbstractItemModel& rows = *page().tree().model();
    for (int row = 0; row < rows.rowCount(); ++row) {
      const QModelIndex index = rows.index(row, 0);
      const QString id = index.data(DocumentModel::IdRole).toString();
      PaletteEntry entry;
      entry.id = QStringLiteral("go-to:") + id;
      entry.group = Texts::tr("Go to");
      entry.icon = index.data(DocumentModel::IconRole).toString();
      entry.text = index.data().toString();
      entry.help = index.data(DocumentModel::TypeRole).toString() + QStringLiteral(" · ") +
                   index.data(DocumentModel::StateRole).toString();
      entry.go = [page, id] { page().tree().select(id.toStdString()); };
      entries.push_back(std::move(entry));
    }
    return entries;
  };
}

PaletteSource manualEntries(std::function<ManualPages()> read, std::function<void(const QString&)> open) {
  return [read = std::move(read), open = std::move(open), pages = std::make_shared<std::optional<ManualPages>>()] {
    if (!*pages) pages->emplace(read());
    std::vector<PaletteEntry> entries;
    for (const ManualPage& page : (*pages)->all()) {
      PaletteEntry entry;
      entry.id = QStringLiteral("manual:") + page.name;
      entry.group = Texts::tr("Manual");
      entry.icon = QStringLiteral("manual");
      entry.text = page.title;
      entry.help = page.group;
      entry.go = [open, name = page.name] { open(name); };
      entries.push_back(std::move(entry));
    }
    return entries;
  };
}

}  // namespace blossom::ui
