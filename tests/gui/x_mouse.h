#pragma once
#include <dlfcn.h>

#include <QApplication>
#include <QMouseEvent>
#include <QWidget>
#include <QtTest>
#include <optional>

namespace blossom::test {

/// The mouse as the window system moves it: events are sent to the X server by its extension XTEST; clicks are counted.
class XMouse : public QObject {
 public:
  XMouse() {
    void* const x11 = dlopen("libX11.so.6", RTLD_NOW);
    void* const xtest = dlopen("libXtst.so.6", RTLD_NOW);
    if (!x11 || !xtest) return;
    const auto open = reinterpret_cast<void* (*)(const char*)>(dlsym(x11, "XOpenDisplay"));
    flush_ = reinterpret_cast<int (*)(void*)>(dlsym(x11, "XFlush"));
    keycode_ = reinterpret_cast<unsigned char (*)(void*, unsigned long)>(dlsym(x11, "XKeysymToKeycode"));
    move_ = reinterpret_cast<int (*)(void*, int, int, int, unsigned long)>(dlsym(xtest, "XTestFakeMotionEvent"));
    button_ = reinterpret_cast<int (*)(void*, unsigned, int, unsigned long)>(dlsym(xtest, "XTestFakeButtonEvent"));
    key_ = reinterpret_cast<int (*)(void*, unsigned, int, unsigned long)>(dlsym(xtest, "XTestFakeKeyEvent"));
    display_ = open ? open(nullptr) : nullptr;
    qApp->installEventFilter(this);
  }
  [[nodiscard]] bool there() const { return display_ && flush_ && keycode_ && move_ && button_ && key_; }
  [[nodiscard]] int clicks() const { return clicks_; }

  void click(QWidget* widget, QPoint at, bool control = false) {
    const QPoint global = widget->mapToGlobal(at);
    const int before = released_;
    move_(display_, -1, global.x(), global.y(), 0);
    if (control) key_(display_, keycode_(display_, controlKey), 1, 0);
    button_(display_, 1, 1, 0);
    button_(display_, 1, 0, 0);
    if (control) key_(display_, keycode_(display_, controlKey), 0, 0);
    flush_(display_);
    ++clicks_;
    QVERIFY2(QTest::qWaitFor([&] { return released_ > before; }), "the click does not arrive");
  }

  /// Waits until the window was told; of a pointer that is there already nothing is told.
  void moveTo(QWidget* widget, QPoint at) {
    const QPoint global = widget->mapToGlobal(at);
    if (at_ == global) return;
    move_(display_, -1, global.x(), global.y(), 0);
    flush_(display_);
    QVERIFY2(QTest::qWaitFor([&] { return at_ == global; }), "the movement does not arrive");
  }
  void press() {
    const int before = pressed_;
    button_(display_, 1, 1, 0);
    flush_(display_);
    QVERIFY2(QTest::qWaitFor([&] { return pressed_ > before; }), "the press does not arrive");
  }
  void release() {
    const int before = released_;
    button_(display_, 1, 0, 0);
    flush_(display_);
    QVERIFY2(QTest::qWaitFor([&] { return released_ > before; }), "the release does not arrive");
  }
  /// For what the mouse does from now on.
  void holdShift(bool down) {
    key_(display_, keycode_(display_, shiftKey), down ? 1 : 0, 0);
    flush_(display_);
  }

 private:
  static constexpr unsigned long controlKey = 0xffe3, shiftKey = 0xffe1;  // XK_Control_L, XK_Shift_L

  bool eventFilter(QObject* object, QEvent* event) override {
    if (!event->spontaneous() || !object->isWindowType()) return false;
    if (event->type() == QEvent::MouseButtonPress) ++pressed_;
    if (event->type() == QEvent::MouseButtonRelease) ++released_;
    if (event->type() == QEvent::MouseMove) at_ = static_cast<QMouseEvent*>(event)->globalPosition().toPoint();
    return false;
  }

  void* display_ = nullptr;
  int (*flush_)(void*) = nullptr;
  unsigned char (*keycode_)(void*, unsigned long) = nullptr;
  int (*move_)(void*, int, int, int, unsigned long) = nullptr;
  int (*button_)(void*, unsigned, int, unsigned long) = nullptr;
  int (*key_)(void*, unsigned, int, unsigned long) = nullptr;
  int clicks_ = 0, pressed_ = 0, released_ = 0;
  std::optional<QPoint> at_;
};

}  // namespace blossom::test
