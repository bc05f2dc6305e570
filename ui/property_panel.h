#pragma once
#include <QScrollArea>
#include <vector>

#include "document/document.h"

class QLabel;
class QVBoxLayout;
class QGridLayout;

namespace blossom::ui {

class ParameterField;
class Session;

/// What the selected feature is made from and what it came to: a form made from the declared parameters, and the measures.
class PropertyPanel : public QScrollArea {
  Q_OBJECT
 public:
  explicit PropertyPanel(Session&, QWidget* parent = nullptr);
  /// Empty: nothing is selected.
  void show(const FeatureId&);
  [[nodiscard]] ParameterField* field(const QString& parameter) const;

 signals:
  void hint(const QString&);

 private:
  void rebuild();
  void refreshFields();
  void refreshResult();
  void addParameters(const Feature&);
  void change(const std::string& parameter, const Value&, bool preview);
  void addResult(const QString& name, const QString& value);
  void addWords(const QString& text, const char* style);

  Session& session_;
  FeatureId shown_;
  std::string shownType_;
  std::vector<ParameterField*> fields_;
  QVBoxLayout* column_ = nullptr;
  QWidget* result_ = nullptr;
  QVBoxLayout* resultColumn_ = nullptr;
  QGridLayout* resultGrid_ = nullptr;
  QLabel* name_ = nullptr;
};

}  // namespace blossom::ui
