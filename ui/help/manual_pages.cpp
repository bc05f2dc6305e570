#include "ui/help/manual_pages.h"

#include <QCoreApplication>
#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QHash>
#include <QRegularExpression>
#include <algorithm>

#include "app/app.h"
#include "app/reference_page.h"
#include "core/file.h"
#include "ui/commands/commands.h"
#include "ui/look/text.h"

namespace blossom::ui {

namespace {

struct Texts {
  Q_DECLARE_TR_FUNCTIONS(Manual)
};

const QString indexName = QStringLiteral("index.md");
const QString keysMark = QStringLiteral("<!-- keys -->");          // in keyboard.md: where the table goes
const QString featuresMark = QStringLiteral("<!-- features -->");  // in index.md: where the feature types are listed

QString titleOf(const QString& text, const QString& name) {
  static const QRegularExpression heading(QStringLiteral("^# +(.+)$"), QRegularExpression::MultilineOption);
  const auto match = heading.match(text);
  return match.hasMatch() ? match.captured(1).trimmed() : QFileInfo(name).completeBaseName();
}

QString escaped(QString text) { return text.replace(u'|', QStringLiteral("\\|")).replace(u'`', QStringLiteral("\\`")); }

// What index.md says of order and headings: pages in the order they are linked, each with the heading above its link.
std::vector<std::pair<QString, QString>> orderOf(const QString& index) {
  static const QRegularExpression link(QStringLiteral("\\]\\(([\\w-]+\\.md)\\)"));
  std::vector<std::pair<QString, QString>> order{{indexName, {}}};
  QString group;
  for (const QString& line : index.split(u'\n')) {
    if (line.startsWith(QLatin1String("## "))) group = line.mid(3).trimmed();
    for (auto it = link.globalMatch(line); it.hasNext();) order.emplace_back(it.next().captured(1), group);
  }
  return order;
}

std::vector<ManualPage> writtenPages() {
  const QDir folder(qt((resourceFolder() / "manual").string()));
  QHash<QString, QString> texts;
  for (const QString& name : folder.entryList({QStringLiteral("*.md")}, QDir::Files, QDir::Name))
    texts.insert(name, qt(readFile(folder.filePath(name).toStdString())));
  auto order = orderOf(texts.value(indexName));
  QStringList rest = texts.keys();
  rest.sort();
  for (const QString& name : rest) order.emplace_back(name, Texts::tr("More"));
  std::vector<ManualPage> pages;
  for (const auto& [name, group] : order) {
    if (!texts.contains(name)) continue;
    const QString text = texts.take(name);  // a page that is linked twice stands where it is linked first
    pages.push_back({name, titleOf(text, name), group, text});
  }
  return pages;
}

QString pluginTitle(const App& app, const std::string& featureId) {
  for (const LoadedPlugin& plugin : app.plugins)
    if (std::find(plugin.manifest.features.begin(), plugin.manifest.features.end(), featureId) !=
        plugin.manifest.features.end())
      return Texts::tr("Reference: %1").arg(qt(plugin.manifest.title));
  return Texts::tr("Reference: built in");
}

std::vector<ManualPage> referencePages(const App& app) {
  std::vector<ManualPage> pages;
  for (const auto& type : app.registry->types())
    pages.push_back(
        {qt(referencePageName(type->id)), qt(type->title), pluginTitle(app, type->id), qt(referencePage(*type))});
  std::stable_sort(pages.begin(), pages.end(), [](const ManualPage& a, const ManualPage& b) { return a.group < b.group; });
  return pages;
}

// One paragraph per plugin with links to its feature types.
QString featureList(const std::vector<ManualPage>& reference) {
  QString list, group;
  for (const ManualPage& page : reference) {
    list += page.group == group ? QStringLiteral(" · ") : QStringLiteral("\n\n**%1**: ").arg(page.group);
    list += QStringLiteral("[%1](%2)").arg(page.title, page.name);
    group = page.group;
  }
  return list;
}

struct Section {
  QString heading, text;
};

std::vector<Section> sectionsOf(const QString& page) {
  std::vector<Section> sections(1);
  bool code = false;
  for (const QString& line : page.split(u'\n')) {
    if (line.startsWith(QLatin1String("```"))) code = !code;
    const bool heading = !code && line.startsWith(QLatin1String("##"));
    if (heading) sections.push_back({QString(line).remove(QRegularExpression(QStringLiteral("^#+ *"))), {}});
    if (!heading && !line.startsWith(QLatin1String("# ")) && !line.startsWith(QLatin1String("|--")))
      sections.back().text += line + u'\n';
  }
  return sections;
}

// The section as it reads, without the marks of Markdown.
QString readText(QString text) {
  static const QRegularExpression image(QStringLiteral("!\\[[^\\]]*\\]\\([^)]*\\)"));
  static const QRegularExpression link(QStringLiteral("\\[([^\\]]*)\\]\\([^)]*\\)"));
  static const QRegularExpression marks(QStringLiteral("[`*|\\\\]|<!--.*-->"));
  return text.remove(image).replace(link, QStringLiteral("\\1")).remove(marks).simplified();
}

QString excerptOf(const QString& text, const QString& word) {
  constexpr qsizetype before = 32, length = 100;
  const qsizetype at = std::max<qsizetype>(0, text.indexOf(word, 0, Qt::CaseInsensitive));
  const qsizetype from = at > before ? text.indexOf(u' ', at - before) + 1 : 0;
  const qsizetype end = from + length < text.size() ? text.lastIndexOf(u' ', from + length) : text.size();
  return (from > 0 ? QStringLiteral("… ") : QString()) + text.mid(from, end - from) +
         (end < text.size() ? QStringLiteral(" …") : QString());
}

// 0 when a word is missing. Words in titles and headings count more than those in the text.
int weightOf(const QStringList& words, const QString& title, const Section& section, const QString& text) {
  int weight = 0;
  for (const QString& word : words) {
    const int here = (title.contains(word, Qt::CaseInsensitive) ? 20 : 0) +
                     (section.heading.contains(word, Qt::CaseInsensitive) ? 30 : 0) +
                     std::min(8, static_cast<int>(text.count(word, Qt::CaseInsensitive)));
    if (here == 0) return 0;
    weight += here;
  }
  return weight;
}

}  // namespace

QString anchorOf(const QString& heading) {
  QString anchor;
  for (const QChar c : heading.toLower())
    if (c.isLetterOrNumber())
      anchor += c;
    else if (c.isSpace() || c == u'-')
      anchor += u'-';
  return anchor;
}

QString keyTable(const Commands& commands) {
  QString table, group;
  for (const Command& command : commands.all()) {
    if (command.action->shortcuts().isEmpty()) continue;
    if (command.group != group)
      table += QStringLiteral("\n## %1\n\n| %2 | %3 | |\n|---|---|---|\n")
                   .arg(command.group, Texts::tr("Command"), Texts::tr("Keys"));
    group = command.group;
    QStringList keys;
    for (const QKeySequence& sequence : command.action->shortcuts())
      keys << QStringLiteral("`%1`").arg(escaped(sequence.toString(QKeySequence::NativeText)));
    table += QStringLiteral("| %1 | %2 | %3 |\n")
                 .arg(escaped(command.action->iconText()), keys.join(u' '), escaped(command.help));
  }
  return table;
}

ManualPages::ManualPages(const App& app, const Commands& commands) : pages_(writtenPages()) {
  std::vector<ManualPage> reference = referencePages(app);
  for (ManualPage& page : pages_)
    page.text.replace(keysMark, keyTable(commands)).replace(featuresMark, featureList(reference));
  std::move(reference.begin(), reference.end(), std::back_inserter(pages_));
}

const ManualPage* ManualPages::find(const QString& name) const {
  const auto found = std::find_if(pages_.begin(), pages_.end(), [&](const ManualPage& page) { return page.name == name; });
  return found == pages_.end() ? nullptr : &*found;
}

std::vector<ManualHit> ManualPages::search(const QString& words) const {
  const QStringList wanted = words.split(u' ', Qt::SkipEmptyParts);
  std::vector<ManualHit> hits;
  if (wanted.isEmpty()) return hits;
  for (const ManualPage& page : pages_)
    for (const Section& section : sectionsOf(page.text)) {
      const QString text = readText(section.text);
      const int weight = weightOf(wanted, page.title, section, text);
      if (weight > 0)
        hits.push_back({page.name, page.title, section.heading, anchorOf(section.heading), excerptOf(text, wanted.first()),
                        weight + (section.heading.isEmpty() ? 5 : 0)});
    }
  std::stable_sort(hits.begin(), hits.end(), [](const ManualHit& a, const ManualHit& b) { return a.weight > b.weight; });
  return hits;
}

}  // namespace blossom::ui
