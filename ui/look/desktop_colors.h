#pragma once
#include <QObject>

class QDBusVariant;

namespace blossom::ui {

/// Whether the desktop is dark: initially from the palette of Qt, then from the desktop's settings portal when it answers or
/// the user changes the setting. Never blocks.
class DesktopColors : public QObject {
  Q_OBJECT
 public:
  explicit DesktopColors(QObject* parent = nullptr);

  [[nodiscard]] bool dark() const { return dark_; }
  /// Begins to listen to the portal; without a session bus there is nothing to hear.
  void listen();

 signals:
  void changed();

 private:
  Q_SLOT void settingChanged(const QString& group, const QString& key, const QDBusVariant& value);
  void take(const QVariant& scheme);
  bool dark_;
};

}  // namespace blossom::ui
