#include "ui/look/desktop_colors.h"

#include <QApplication>
#include <QDBusConnection>
#include <QDBusMessage>
#include <QDBusPendingCallWatcher>
#include <QDBusPendingReply>
#include <QDBusVariant>
#include <QPalette>

namespace blossom::ui {

namespace {

const QString service = QStringLiteral("org.freedesktop.portal.Desktop");
const QString path = QStringLiteral("/org/freedesktop/portal/desktop");
const QString interface = QStringLiteral("org.freedesktop.portal.Settings");
const QString colorGroup = QStringLiteral("org.freedesktop.appearance");
const QString schemeKey = QStringLiteral("color-scheme");

constexpr uint prefersDark = 1, prefersLight = 2;

// A desktop that says nothing about itself gets the dark canvas; any other is asked through Qt's palette.
bool paletteIsDark() {
  if (qEnvironmentVariableIsEmpty("XDG_CURRENT_DESKTOP")) return true;
  return QApplication::palette().color(QPalette::Window).lightness() < 128;
}

}  // namespace

DesktopColors::DesktopColors(QObject* parent) : QObject(parent), dark_(paletteIsDark()) {}

// Without an address Qt would start a bus of its own, and wait for it.
void DesktopColors::listen() {
  if (qEnvironmentVariableIsEmpty("DBUS_SESSION_BUS_ADDRESS")) return;
  QDBusConnection bus = QDBusConnection::sessionBus();
  if (!bus.isConnected()) return;
  bus.connect(service, path, interface, QStringLiteral("SettingChanged"), this,
              SLOT(settingChanged(QString, QString, QDBusVariant)));
  QDBusMessage question = QDBusMessage::createMethodCall(service, path, interface, QStringLiteral("Read"));
  question << colorGroup << schemeKey;
  auto* watcher = new QDBusPendingCallWatcher(bus.asyncCall(question), this);
  connect(watcher, &QDBusPendingCallWatcher::finished, this, [this, watcher] {
    const QDBusPendingReply<QDBusVariant> reply = *watcher;
    if (!reply.isError()) take(reply.value().variant());
    watcher->deleteLater();
  });
}

void DesktopColors::settingChanged(const QString& changedGroup, const QString& changedKey, const QDBusVariant& value) {
  if (changedGroup == colorGroup && changedKey == schemeKey) take(value.variant());
}

void DesktopColors::take(const QVariant& given) {
  // Read answers with a variant in a variant.
  const QVariant scheme = given.canConvert<QDBusVariant>() ? given.value<QDBusVariant>().variant() : given;
  const uint wish = scheme.toUInt();
  if (wish != prefersDark && wish != prefersLight) return;
  if (dark_ == (wish == prefersDark)) return;
  dark_ = wish == prefersDark;
  emit changed();
}

}  // namespace blossom::ui
