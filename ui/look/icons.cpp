#include "ui/look/icons.h"

#include <QHash>
#include <QIconEngine>
#include <QPainter>
#include <QSvgRenderer>

#include "app/app.h"
#include "core/file.h"
#include "ui/look/theme.h"

namespace blossom::ui {

namespace {

std::filesystem::path iconFile(const QString& name) { return resourceFolder() / "icons" / (name.toStdString() + ".svg"); }

// Text of the file, with `currentColor`, `accent` and `onMade` still to be replaced.
const QByteArray& rawSource(const QString& name) {
  static QHash<QString, QByteArray> cache;
  auto it = cache.find(name);
  if (it == cache.end()) {
    const QString known = hasIcon(name) ? name : QStringLiteral("feature");
    it = cache.insert(name, QByteArray::fromStdString(readFile(iconFile(known))));
  }
  return *it;
}

class ThemedEngine final : public QIconEngine {
 public:
  explicit ThemedEngine(QString name) : name_(std::move(name)) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const char* token = mode == QIcon::Disabled                            ? "faint"
                        : mode == QIcon::Active || mode == QIcon::Selected ? "text"
                                                                           : "muted";
    const Theme& colors = theme();
    QByteArray source = iconSource(name_, colors.color(token), colors);
    if (mode == QIcon::Disabled) source = iconSource(name_, colors.color(token), disabledTheme(colors));
    QSvgRenderer(source).render(painter, rect);
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    if (size.isEmpty()) return {};  // of a button that is squeezed to nothing
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return pixmap;
  }
  QIconEngine* clone() const override { return new ThemedEngine(name_); }

 private:
  static Theme disabledTheme(Theme colors) {
    colors.colors.insert(QStringLiteral("made"), colors.color("faint"));
    return colors;
  }
  QString name_;
};

}  // namespace

bool hasIcon(const QString& name) { return !name.isEmpty() && std::filesystem::exists(iconFile(name)); }

QByteArray iconSource(const QString& name, const QColor& color, const Theme& theme) {
  QByteArray source = rawSource(name);
  source.replace("currentColor", color.name().toLatin1());
  source.replace("\"accent\"", '"' + theme.color("made").name().toLatin1() + '"');
  source.replace("\"onMade\"", '"' + theme.color("onMade").name().toLatin1() + '"');
  return source;
}

QIcon icon(const QString& name) { return QIcon(new ThemedEngine(name)); }

void paintIcon(QPainter& painter, const QRectF& rect, const QString& name, const QColor& color) {
  QSvgRenderer(iconSource(name, color, theme())).render(&painter, rect);
}

}  // namespace blossom::ui
