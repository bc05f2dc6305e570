#pragma once
#include <vtkProp.h>

#include <QObject>
#include <QString>
#include <QStringList>
#include <map>
#include <optional>
#include <vector>

#include "core/error.h"
#include "core/progress.h"
#include "geometry/measure/measure_between.h"
#include "ui/plugin/tool.h"
#include "ui/thread/background.h"
#include "ui/thread/mailbox.h"

namespace blossom::ui {

/// A feature, or one of its sub-shapes by number, that a measurement refers to.
struct PartReference {
  FeatureId feature;
  SubShapeKind kind = SubShapeKind::Whole;
  int index = -1;
  friend bool operator==(const PartReference&, const PartReference&) = default;
};

/// The measurements of one open document. They remain when the tool has ended, follow every edit and undo, and are lost only
/// while one of their parts is missing. Computed on a background thread, newest request first.
class Measurements : public QObject {
  Q_OBJECT
 public:
  enum class State { Computing, Ready, Lost };
  struct Entry {
    int id = 0;
    PartReference first;
    std::optional<PartReference> second;
    State state = State::Computing;
    Measurement figures;  ///< the latest figures
    QString problem;      ///< why it is lost
  };

  explicit Measurements(ToolHost& host, QObject* parent = nullptr);
  ~Measurements() override;

  /// @returns its id, which is never reused.
  int add(const PartReference&, const std::optional<PartReference>& second = {});
  /// Changes a measurement of one part to one of two parts.
  void extend(int id, const PartReference& second);
  void remove(int id);
  void clear();
  void select(int id);  ///< 0: none
  [[nodiscard]] int selected() const { return selected_; }
  [[nodiscard]] const std::vector<Entry>& entries() const { return entries_; }
  [[nodiscard]] const Entry* find(int id) const;

  /// Measures again what changed. Call it whenever the document or a result changes.
  void documentChanged();

  [[nodiscard]] QString partName(const PartReference&) const;  ///< "Box, face 2"
  [[nodiscard]] QString headline(const Entry&) const;          ///< "12.5 mm"
  [[nodiscard]] QString text(const Entry&) const;              ///< all figures, one per line, for copying
  [[nodiscard]] std::vector<vtkSmartPointer<vtkProp>> props() const;

 signals:
  void changed();

 private:
  struct Run {
    CancelToken token;
    std::vector<std::shared_ptr<const FeatureResult>> of;  // what is or was measured
  };
  Entry* entry(int id);
  void measure(Entry&);
  void finish(int id, const CancelToken&, const Measurement&, const std::optional<Error>&);
  /// Results of the parts; `missing` is the reason when one is missing.
  [[nodiscard]] std::vector<std::shared_ptr<const FeatureResult>> resultsOf(const Entry&, QString& missing) const;
  [[nodiscard]] bool isShown(const Entry&) const;

  ToolHost& host_;
  std::vector<Entry> entries_;
  std::map<int, Run> runs_;
  int lastId_ = 0;
  int selected_ = 0;
  Mailbox here_;
  Background thread_;  // ends first
};

/// "Diameter" for "diameter", in the user's language.
QString figureName(const std::string& name);

}  // namespace blossom::ui
