#pragma once
#include <QString>
#include <QStringList>
#include <vector>

namespace blossom {
struct App;
}

namespace blossom::ui {

class Commands;

/// One page of the manual, in Markdown.
struct ManualPage {
  QString name;   ///< "sweep.md", "reference/sweep.sweep.md"
  QString title;  ///< its first heading
  QString group;  ///< its heading in the index, or the plugin of a feature type
  QString text;
};

/// A section that contains all words of a search.
struct ManualHit {
  QString page, title;      ///< title of the page
  QString heading, anchor;  ///< of the section; empty above the first heading
  QString excerpt;          ///< one line around the first word
  int weight = 0;           ///< larger: a better hit
};

/// All pages: the files of resources/manual in the order of index.md, a reference page per feature type, and the current
/// keys.
class ManualPages {
 public:
  ManualPages(const App&, const Commands&);

  [[nodiscard]] const std::vector<ManualPage>& all() const { return pages_; }
  [[nodiscard]] const ManualPage* find(const QString& name) const;
  /// Hits, best first; none when there are no words.
  [[nodiscard]] std::vector<ManualHit> search(const QString& words) const;

 private:
  std::vector<ManualPage> pages_;
};

/// Anchor of a heading for links: "Mouse and keys" becomes "mouse-and-keys".
QString anchorOf(const QString& heading);
/// Markdown table of every command and its keys, by group.
QString keyTable(const Commands&);

}  // namespace blossom::ui
