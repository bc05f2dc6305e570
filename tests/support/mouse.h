#pragma once
#include <QApplication>
#include <QMouseEvent>
#include <QPointingDevice>
#include <QtTest>

namespace blossom::test {

/// As QTest::mouseMove, but certain, and now: with no button down, that puts the pointer there and hopes that the window
/// system tells the widget in time.
inline void moveMouse(QWidget* widget, QPoint at) {
  if (QTestPrivate::qtestMouseButtons != Qt::NoButton) return QTest::mouseMove(widget, at);
  QMouseEvent moved(QEvent::MouseMove, at, widget->mapToGlobal(at), Qt::NoButton, Qt::NoButton, Qt::NoModifier,
                    QPointingDevice::primaryPointingDevice());
  QApplication::sendEvent(widget, &moved);
  QCoreApplication::processEvents();
}

}  // namespace blossom::test
