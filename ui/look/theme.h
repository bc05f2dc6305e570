#pragma once
#include <QColor>
#include <QHash>
#include <QObject>
#include <QPalette>
#include <QString>
#include <memory>

#include "scene/scene.h"

namespace blossom::ui {

/// What the user chose; System follows the desktop, and is dark where the desktop says nothing.
enum class ThemeChoice { System, Dark, Light };

/// One table of named colours (resources/themes/*.json); style sheet, palette, icons and canvas are all made from it.
struct Theme {
  QString name;
  bool dark = true;
  QHash<QString, QColor> colors;

  /// @pre the name is in the table.
  [[nodiscard]] QColor color(const char* token) const;
  [[nodiscard]] Look look() const { return dark ? Look::dark() : Look::light(); }
  [[nodiscard]] QPalette palette() const;
};

/// The theme in use. One per application; widgets that paint themselves read `theme()` and follow `changed`.
class ThemeManager : public QObject {
  Q_OBJECT
 public:
  static ThemeManager& instance();

  /// Reads the tables and applies the choice to the application; nothing happens when it looks like that already.
  /// @throws Error FileNotFound, FormatDamaged.
  void apply(ThemeChoice);
  [[nodiscard]] ThemeChoice choice() const { return choice_; }
  [[nodiscard]] const Theme& theme() const { return theme_; }

 signals:
  void changed();

 private:
  ThemeManager();
  ~ThemeManager() override;
  ThemeChoice choice_ = ThemeChoice::System;
  Theme theme_;
  std::unique_ptr<class DesktopColors> desktop_;
  std::unique_ptr<class IconFiles> iconFiles_;  // pictures that the style sheet refers to
};

/// What the preference "theme" says.
ThemeChoice preferredTheme();

inline const Theme& theme() { return ThemeManager::instance().theme(); }

}  // namespace blossom::ui
