#pragma once
#include <QToolButton>

namespace blossom::ui {

/// A checkable button; while it is down, something is to be picked in the view.
class PickButton final : public QToolButton {
  Q_OBJECT
 public:
  /// @param iconName pick-point, pick-face, ..
  PickButton(const QString& iconName, const QString& what, QWidget* parent = nullptr);
};

}  // namespace blossom::ui
