#pragma once
#include <QObject>
#include <QString>
#include <vector>

#include "parameter/parameter.h"

namespace blossom::ui {

/// A heading and its preferences.
struct PreferenceGroup {
  QString title;
  std::vector<ParameterSpec> specs;
};

/// Every preference, declared once: dialog, defaults and checks are made from this. Names are unique over all groups.
const std::vector<PreferenceGroup>& preferenceGroups();

/// The values of the preferences, stored in QSettings under "preferences/NAME". One instance per application.
class Preferences : public QObject {
  Q_OBJECT
 public:
  static Preferences& instance();

  /// @pre the name is declared. A stored value that no longer fits its declaration counts as absent.
  [[nodiscard]] Value value(const std::string& name) const;
  template <class T>
  [[nodiscard]] T get(const std::string& name) const {
    return value(name).get<T>();
  }
  /// @throws Error InvalidParameter.
  void set(const std::string& name, const Value&);
  void reset();  ///< resets everything to its default
  /// How often a value was changed: who remembers what follows from one sees that it is out of date.
  [[nodiscard]] int changes() const { return changes_; }

 signals:
  void changed(const QString& name);

 private:
  int changes_ = 0;
};

}  // namespace blossom::ui
