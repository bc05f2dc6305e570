#pragma once
#include <QColor>
#include <QHash>
#include <QObject>
#include <QPalette>
#include <QString>
#include <memory>

#include "scene/scene.h"

namespace blossom::ui {

/// Chosen theme; System follows the desktop, and is dark when the desktop does not say.
enum class ThemeChoice { System, Dark, Light };

/// A table of named colours (resources/themes/*.json), from which style sheet, palette, icons and canvas are made.
struct Theme {
  QString name;
  bool dark = true;
  QHash<QString, QColor> colors;

  /// @pre the name is in the table.
  [[nodiscard]] QColor color(const char* token) const;
  [[nodiscard]] Look look() const { return dark ? Look::dark() : Look::light(); }
  [[nodiscard]] QPalette palette() const;
};

/// The current theme. One instance per application; widgets that paint themselves read `theme()` and connect to `changed`.
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
