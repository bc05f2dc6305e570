#include "ui/window/application.h"

#include <QApplication>
#include <QLocale>
#include <QProxyStyle>
#include <QStyleOption>
#include <QSurfaceFormat>
#include <algorithm>
#include <clocale>

#include "core/version.h"
#include "scene/scene.h"
#include "ui/look/icons.h"
#include "ui/settings/language.h"

namespace blossom::ui {

namespace {

// Menus read calmer without underlined letters; Alt still works.
class QuietStyle final : public QProxyStyle {
 public:
  QuietStyle() : QProxyStyle(QStringLiteral("Fusion")) {}
  int styleHint(StyleHint hint, const QStyleOption* option, const QWidget* widget, QStyleHintReturn* data) const override {
    if (hint == SH_UnderlineShortcut) return 0;
    return QProxyStyle::styleHint(hint, option, widget, data);
  }
  // Fusion's own signs for what found no room in a bar are dark, and too small to be hit.
  QIcon standardIcon(StandardPixmap which, const QStyleOption* option, const QWidget* widget) const override {
    if (which == SP_ToolBarHorizontalExtensionButton) return clearIcon(QStringLiteral("overflow"));
    return QProxyStyle::standardIcon(which, option, widget);
  }
  int pixelMetric(PixelMetric which, const QStyleOption* option, const QWidget* widget) const override {
    return which == PM_ToolBarExtensionExtent ? 24 : QProxyStyle::pixelMetric(which, option, widget);
  }
  // Buttons of a tool bar stand in even steps. A least width in the style sheet would let a crowded bar cut their labels.
  QSize sizeFromContents(ContentsType type, const QStyleOption* option, const QSize& contents,
                         const QWidget* widget) const override {
    QSize size = QProxyStyle::sizeFromContents(type, option, contents, widget);
    const auto* button = type == CT_ToolButton ? qstyleoption_cast<const QStyleOptionToolButton*>(option) : nullptr;
    if (button && button->toolButtonStyle == Qt::ToolButtonTextUnderIcon) size.setWidth(std::max(size.width(), 46));
    return size;
  }
};

}  // namespace

void prepareApplication() {
  QSurfaceFormat format;
  format.setVersion(3, 2);
  format.setProfile(QSurfaceFormat::CoreProfile);
  format.setRenderableType(QSurfaceFormat::OpenGL);
  format.setDepthBufferSize(24);
  QSurfaceFormat::setDefaultFormat(format);
}

void setUpApplication() {
  QCoreApplication::setOrganizationName(QStringLiteral("Blossom"));
  QCoreApplication::setApplicationName(QStringLiteral("blossom-workbench"));
  QCoreApplication::setApplicationVersion(QLatin1String(versionText));
  QGuiApplication::setApplicationDisplayName(QStringLiteral("Blossom"));
  QGuiApplication::setDesktopFileName(QStringLiteral("blossom"));
  // QApplication has set LC_NUMERIC from the environment; readers of every format rely on the C locale.
  std::setlocale(LC_NUMERIC, "C");
  QLocale::setDefault(QLocale::c());
  installLanguage();
  QApplication::setStyle(new QuietStyle);
  quietVtk();
}

}  // namespace blossom::ui
