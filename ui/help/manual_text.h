#pragma once
#include <QTextBrowser>
#include <vector>

#include "ui/help/manual_pages.h"

class QTextTable;

namespace blossom::ui {

struct ManualHeading {
  QString text, anchor;
  int level = 1;
};

/// A page of the manual in the colours of the theme; pictures are never wider than the column.
class ManualText : public QTextBrowser {
  Q_OBJECT
 public:
  explicit ManualText(QWidget* parent = nullptr);

  void setPages(const ManualPages*);
  void open(const QString& page, const QString& anchor = {});
  [[nodiscard]] const QString& page() const { return shown_; }
  [[nodiscard]] const std::vector<ManualHeading>& headings() const { return headings_; }
  /// Marks every occurrence of the words.
  void highlight(const QString& words);

 signals:
  void pageChanged(const QString& page);

 protected:
  QVariant loadResource(int type, const QUrl&) override;
  void resizeEvent(QResizeEvent*) override;

 private:
  void pageLoaded(const QUrl&);
  void style();
  void styleBlock(QTextCursor&, const QTextBlock&);
  void styleTable(QTextTable&);
  void fitColumn();
  [[nodiscard]] int columnWidth() const;
  const ManualPages* pages_ = nullptr;
  std::vector<ManualHeading> headings_;
  QString shown_;
  bool fresh_ = false;  // read anew and not yet styled
};

}  // namespace blossom::ui
