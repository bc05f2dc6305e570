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

/// The feature types of one plugin, as commands in the order of its manifest.
struct FeatureGroup {
  QString title, icon;
  QMenu* menu;
  std::vector<QAction*> actions;
};

/// One menu per plugin, made from the registry: every entry adds a feature that takes the selected features as its inputs.
class FeatureMenus : public QObject {
  Q_OBJECT
 public:
  FeatureMenus(const App&, Commands&, QWidget* window);
  void addTo(QMenuBar*);
  [[nodiscard]] const std::vector<FeatureGroup>& groups() const { return groups_; }
  /// Commands of the types that can be made from just these features.
  [[nodiscard]] std::vector<QAction*> taking(const std::vector<FeatureId>&) const;
  /// What is still to be selected for a type, in a sentence; empty when nothing is, or when the command is no feature type.
  [[nodiscard]] QString wants(const QString& commandId) const;
  /// Begins a feature as by its command, with the parameters that a keyword of its type stands for.
  void startAs(const QString& commandId, const QString& keyword);
  void setPage(DocumentPage* page) { page_ = page; }  ///< where features are added
  void setSelection(std::vector<FeatureId> selected) { selected_ = std::move(selected); }

 private:
  void addGroup(const LoadedPlugin&);
  void add(const FeatureType&, const Value& preset);
  /// Adds a feature that takes what is chosen so far, or asks for more.
  void begin(const FeatureType&, std::vector<FeatureId> chosen, const Value& preset);
  void tellNothingFits(const FeatureType&, const InputSpec& missing);
  void tellHidden(const FeatureType&, const std::vector<FeatureId>& hidden);
  void tellLeftOut(const FeatureType&, std::size_t taken, const std::vector<FeatureId>& left);
  [[nodiscard]] std::vector<std::shared_ptr<const FeatureType>> makersOf(const InputSpec&, const FeatureType& user,
                                                                         std::size_t count) const;
  void addFromFile(const FeatureType&);
  const App& app_;
  Commands& commands_;
  DocumentPage* page_ = nullptr;
  QWidget* window_;
  std::vector<FeatureGroup> groups_;
  std::vector<std::pair<QAction*, std::shared_ptr<const FeatureType>>> types_;
  std::vector<FeatureId> selected_;
};

/// "All files that can be read (*.step *.stp ..)", then one line per format.
QStringList readFilters(const App&);

}  // namespace blossom::ui
