#include "ui/look/theme.h"

#include <QApplication>
#include <QDir>
#include <QFile>
#include <QImage>
#include <QRegularExpression>
#include <QTemporaryDir>

#include "app/app.h"
#include "core/error.h"
#include "core/file.h"
#include "parameter/value.h"
#include "ui/look/desktop_colors.h"
#include "ui/look/icons.h"
#include "ui/look/preferences.h"

namespace blossom::ui {

// A style sheet takes pictures from files only; these are drawn anew for each theme.
class IconFiles {
 public:
  QString file(const QString& name, const Theme& theme) {
    QString path = folder_.filePath(QStringLiteral("%1-%2.svg").arg(name, theme.name.toLower()));
    if (!QFile::exists(path)) {
      QFile out(path);
      if (!out.open(QIODevice::WriteOnly))
        throw Error(ErrorCode::FileUnwritable, "The icons of the window cannot be written to the temporary folder.");
      out.write(iconSource(name, theme.color("muted"), theme));
    }
    return path;
  }

 private:
  QTemporaryDir folder_;
};

namespace {

QColor parseToken(const std::string& text) {
  // "#rrggbbaa": Qt would read alpha first.
  if (text.size() == 9) {
    QColor color(QString::fromStdString(text.substr(0, 7)));
    color.setAlpha(std::stoi(text.substr(7), nullptr, 16));
    return color;
  }
  return QColor(QString::fromStdString(text));
}

Theme readTheme(const std::filesystem::path& file) {
  const Value json = Value::parse(readFile(file), nullptr, false);
  if (!json.is_object()) throw Error(ErrorCode::FormatDamaged, "The theme " + file.string() + " is not a JSON object.");
  Theme theme;
  for (const auto& [key, value] : json.items()) {
    if (key == "name")
      theme.name = QString::fromStdString(value.get<std::string>());
    else if (key == "dark")
      theme.dark = value.get<bool>();
    else
      theme.colors.insert(QString::fromStdString(key), parseToken(value.get<std::string>()));
  }
  return theme;
}

QString cssColor(const QColor& c) {
  if (c.alpha() == 255) return c.name();
  return QStringLiteral("rgba(%1, %2, %3, %4)").arg(c.red()).arg(c.green()).arg(c.blue()).arg(c.alphaF());
}

QString styleSheet(const Theme& theme, IconFiles& icons) {
  static const QRegularExpression token(QStringLiteral("@(icon\\(([a-z-]+)\\)|[a-zA-Z]+)"));
  const QString source = QString::fromStdString(readFile(resourceFolder() / "themes" / "workbench.qss"));
  QString result;
  qsizetype last = 0;
  for (auto it = token.globalMatch(source); it.hasNext();) {
    const auto match = it.next();
    result += QStringView(source).mid(last, match.capturedStart() - last);
    if (match.hasCaptured(2))
      result += icons.file(match.captured(2), theme);
    else if (theme.colors.contains(match.captured(1)))
      result += cssColor(theme.colors.value(match.captured(1)));
    else
      result += match.captured(0);
    last = match.capturedEnd();
  }
  result += QStringView(source).mid(last);
  return result;
}

QFont uiFont() {
  QFont font;
  font.setFamilies({QStringLiteral("Inter"), QStringLiteral("Noto Sans"), QStringLiteral("DejaVu Sans")});
  font.setPixelSize(12);
  return font;
}

}  // namespace

QColor Theme::color(const char* token) const {
  const auto it = colors.find(QLatin1String(token));
  Q_ASSERT(it != colors.end());
  return it == colors.end() ? QColor(Qt::magenta) : *it;
}

QPalette Theme::palette() const {
  QPalette p;
  p.setColor(QPalette::Window, color("panel"));
  p.setColor(QPalette::WindowText, color("text"));
  p.setColor(QPalette::Base, color("field"));
  p.setColor(QPalette::AlternateBase, color("panel"));
  p.setColor(QPalette::Text, color("text"));
  p.setColor(QPalette::Button, color("raised"));
  p.setColor(QPalette::ButtonText, color("text"));
  p.setColor(QPalette::Highlight, color("control"));
  p.setColor(QPalette::HighlightedText, color("window"));
  p.setColor(QPalette::ToolTipBase, color("raised"));
  p.setColor(QPalette::ToolTipText, color("text"));
  p.setColor(QPalette::PlaceholderText, color("muted"));
  p.setColor(QPalette::Link, color("control"));
  for (const auto role : {QPalette::WindowText, QPalette::Text, QPalette::ButtonText})
    p.setColor(QPalette::Disabled, role, color("faint"));
  return p;
}

ThemeManager::ThemeManager() : desktop_(std::make_unique<DesktopColors>()), iconFiles_(std::make_unique<IconFiles>()) {
  connect(&Preferences::instance(), &Preferences::changed, this, [this](const QString& name) {
    if (name == QLatin1String("theme")) apply(preferredTheme());
  });
  connect(desktop_.get(), &DesktopColors::changed, this, [this] {
    if (choice_ == ThemeChoice::System) apply(choice_);
  });
  QMetaObject::invokeMethod(desktop_.get(), &DesktopColors::listen, Qt::QueuedConnection);  // the window comes first
}
ThemeManager::~ThemeManager() = default;

ThemeManager& ThemeManager::instance() {
  static ThemeManager manager;
  return manager;
}

ThemeChoice preferredTheme() {
  const std::string wanted = Preferences::instance().get<std::string>("theme");
  return wanted == "dark" ? ThemeChoice::Dark : wanted == "light" ? ThemeChoice::Light : ThemeChoice::System;
}

void ThemeManager::apply(ThemeChoice choice) {
  choice_ = choice;
  const bool dark = choice == ThemeChoice::Dark || (choice == ThemeChoice::System && desktop_->dark());
  if (!theme_.name.isEmpty() && theme_.dark == dark) return;
  theme_ = readTheme(resourceFolder() / "themes" / (dark ? "dark.json" : "light.json"));
  QApplication::setFont(uiFont());
  QApplication::setPalette(theme_.palette());
  qApp->setStyleSheet(styleSheet(theme_, *iconFiles_));
  emit changed();
}

}  // namespace blossom::ui
