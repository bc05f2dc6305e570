#pragma once
#include <QTreeWidget>

#include "ui/help/manual_pages.h"

namespace blossom::ui {

struct ManualHeading;

/// The pages of the manual by group, with the headings of the current page under it.
class ManualContents : public QTreeWidget {
  Q_OBJECT
 public:
  explicit ManualContents(QWidget* parent = nullptr);

  void setPages(const ManualPages&);
  void showPage(const QString& page, const std::vector<ManualHeading>&);

 signals:
  void wanted(const QString& page, const QString& anchor);

 private:
  QHash<QString, QTreeWidgetItem*> items_;
};

}  // namespace blossom::ui
