#pragma once
#include <QObject>
#include <vector>

#include "app/app.h"
#include "document/document.h"
#include "feature/feature_type.h"

class QAction;
class QMenu;
class QMenuBar;
class QWidget;

namespace blossom::ui {

class Commands;
class DocumentPage;

/// One menu per plugin, made from the registry: every entry adds a feature that takes the selected features as its inputs.
class FeatureMenus : public QObject {
  Q_OBJECT
 public:
  FeatureMenus(const App&, Commands&, QWidget* window);
  void addTo(QMenuBar*);
  [[nodiscard]] const std::vector<QAction*>& actions() const { return actions_; }
  void setPage(DocumentPage* page) { page_ = page; }  ///< where features are added
  void setSelection(std::vector<FeatureId> selected) { selected_ = std::move(selected); }

 private:
  void add(const FeatureType&);
  /// The selected features in order of the type's inputs; `missing` is the first input that has too few.
  [[nodiscard]] std::vector<FeatureId> inputsFor(const FeatureType&, const InputSpec*& missing) const;
  const App& app_;
  DocumentPage* page_ = nullptr;
  QWidget* window_;
  std::vector<QMenu*> menus_;
  std::vector<QAction*> actions_;
  std::vector<FeatureId> selected_;
};

/// "All files that can be read (*.step *.stp ..)", then one line per format.
QStringList readFilters(const App&);

}  // namespace blossom::ui
