#pragma once
#include <QToolButton>

namespace blossom::ui {

/// Wants something picked in the view while it is down.
class PickButton final : public QToolButton {
  Q_OBJECT
 public:
  /// @param iconName pick-point, pick-face, ..
  PickButton(const QString& iconName, const QString& what, QWidget* parent = nullptr);
};

}  // namespace blossom::ui
