#pragma once
#include <QWidget>
#include <vector>

#include "ui/look/preferences.h"

namespace blossom::ui {

class ParameterField;

/// One group of preferences as a form, with a field and a help text for each; edits apply at once.
class PreferencesForm : public QWidget {
  Q_OBJECT
 public:
  explicit PreferencesForm(const PreferenceGroup&, QWidget* parent = nullptr);

  [[nodiscard]] const std::vector<ParameterField*>& fields() const { return fields_; }

 signals:
  void hint(const QString&);

 private:
  void add(const ParameterSpec&);
  std::vector<ParameterField*> fields_;
};

}  // namespace blossom::ui
