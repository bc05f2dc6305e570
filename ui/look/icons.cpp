#include "ui/look/icons.h"

#include <QCache>
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

// Text of the file, with `currentColor`, `accent` and `onMade` still to be replaced; empty when there is none.
const QByteArray& rawSource(const QString& name) {
  static QHash<QString, QByteArray> cache;
  auto it = cache.find(name);
  if (it == cache.end()) {
    const std::filesystem::path file = iconFile(name);
    it = cache.insert(name, std::filesystem::exists(file) ? QByteArray::fromStdString(readFile(file)) : QByteArray());
  }
  return *it;
}

/// Lists ask for the same few icons whenever they are painted: what was read once is kept.
QSvgRenderer& renderer(const QByteArray& source) {
  constexpr int kept = 200;
  static QCache<QByteArray, QSvgRenderer> cache(kept);
  QSvgRenderer* known = cache.object(source);
  if (!known) cache.insert(source, known = new QSvgRenderer(source));
  return *known;
}

class ThemedEngine final : public QIconEngine {
 public:
  explicit ThemedEngine(QString name, bool clear = false) : name_(std::move(name)), clear_(clear) {}

  void paint(QPainter* painter, const QRect& rect, QIcon::Mode mode, QIcon::State) override {
    const char* token = mode == QIcon::Disabled                                      ? "faint"
                        : clear_ || mode == QIcon::Active || mode == QIcon::Selected ? "text"
                                                                                     : "muted";
    const Theme& colors = theme();
    QByteArray source = iconSource(name_, colors.color(token), colors);
    if (mode == QIcon::Disabled) source = iconSource(name_, colors.color(token), disabledTheme(colors));
    renderer(source).render(painter, rect);
  }
  QPixmap pixmap(const QSize& size, QIcon::Mode mode, QIcon::State state) override {
    if (size.isEmpty()) return {};  // of a button that is squeezed to nothing
    QPixmap pixmap(size);
    pixmap.fill(Qt::transparent);
    QPainter painter(&pixmap);
    paint(&painter, QRect(QPoint(), size), mode, state);
    return pixmap;
  }
  QIconEngine* clone() const override { return new ThemedEngine(name_, clear_); }

 private:
  static Theme disabledTheme(Theme colors) {
    colors.colors.insert(QStringLiteral("made"), colors.color("faint"));
    return colors;
  }
  QString name_;
  bool clear_;
};

}  // namespace

bool hasIcon(const QString& name) { return !name.isEmpty() && !rawSource(name).isEmpty(); }

QByteArray iconSource(const QString& name, const QColor& color, const Theme& theme) {
  QByteArray source = rawSource(hasIcon(name) ? name : QStringLiteral("feature"));
  source.replace("currentColor", color.name().toLatin1());
  source.replace("\"accent\"", '"' + theme.color("made").name().toLatin1() + '"');
  source.replace("\"onMade\"", '"' + theme.color("onMade").name().toLatin1() + '"');
  return source;
}

QIcon icon(const QString& name) { return QIcon(new ThemedEngine(name)); }

QIcon clearIcon(const QString& name) { return QIcon(new ThemedEngine(name, true)); }

void paintIcon(QPainter& painter, const QRectF& rect, const QString& name, const QColor& color) {
  renderer(iconSource(name, color, theme())).render(&painter, rect);
}

}  // namespace blossom::ui
