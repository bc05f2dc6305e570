#include "manipulators/pull_mode.h"

#include <algorithm>
#include <cstdlib>
#include <optional>

namespace blossom::sweep {

namespace {

std::optional<PullMode::Way> wayOfKey(int key) {
  switch (key) {
    case Qt::Key_T:
      return PullMode::Way::Translate;
    case Qt::Key_R:
      return PullMode::Way::Rotate;
    case Qt::Key_S:
      return PullMode::Way::Scale;
    case Qt::Key_W:
      return PullMode::Way::Twist;
    default:
      return std::nullopt;
  }
}

/// "=" is the key of "+" on many keyboards.
std::optional<int> levelOfKey(int key, int level) {
  switch (key) {
    case Qt::Key_Plus:
    case Qt::Key_Equal:
      return std::min(level + 1, finestLevel);
    case Qt::Key_Minus:
      return std::max(level - 1, coarsestLevel);
    case Qt::Key_0:
      return 0;
    default:
      return std::nullopt;
  }
}

}  // namespace

PullWeights PullMode::weights() const {
  switch (way_) {
    case Way::Combined:
      return {0, 1, 1};
    case Way::Translate:
      return {1, 0, 0};
    case Way::Rotate:
      return {0, 1, 0};
    case Way::Scale:
      return {0, 0, 1};
    case Way::Twist:
      break;
  }
  return {0, 0, 0};
}

bool PullMode::key(int key) {
  if (const auto way = wayOfKey(key)) {
    way_ = way_ == *way ? Way::Combined : *way;
  } else if (key >= Qt::Key_1 && key <= Qt::Key_9) {
    symmetry_.fold = key - Qt::Key_0;
    if (symmetry_.fold == 1) symmetry_.mirror = false;
  } else if (key == Qt::Key_A && twists()) {
    axis_ = axis_ == Axis::Tangent ? Axis::Arm : axis_ == Axis::Arm ? Axis::Across : Axis::Tangent;
  } else if (key == Qt::Key_M) {
    symmetry_.mirror = !symmetry_.mirror;
  } else if (const auto level = levelOfKey(key, level_)) {
    level_ = *level;
  } else {
    return false;
  }
  return true;
}

QString PullMode::wayText() const {
  switch (way_) {
    case Way::Combined:
      return tr("by turning and scaling");
    case Way::Translate:
      return tr("by moving the sections");
    case Way::Rotate:
      return tr("by turning alone");
    case Way::Scale:
      return tr("by scaling alone");
    case Way::Twist:
      break;
  }
  return tr("by twisting");
}

QString PullMode::axisText() const {
  switch (axis_) {
    case Axis::Tangent:
      return tr("the tangent of the trajectory");
    case Axis::Arm:
      return tr("the arm from the trajectory to the point");
    case Axis::Across:
      break;
  }
  return tr("the axis across tangent and arm");
}

QString PullMode::symmetryText() const {
  const bool copies = symmetry_.fold > 1;
  if (copies && symmetry_.mirror) return tr("%1 copies, mirrored").arg(symmetry_.fold);
  if (copies) return tr("%1 copies").arg(symmetry_.fold);
  return symmetry_.mirror ? tr("mirrored") : QString();
}

QString PullMode::levelText() const {
  switch (level_) {
    case 0:
      return {};
    case 1:
      return tr("one level finer");
    case -1:
      return tr("one level coarser");
    default:
      return (level_ > 0 ? tr("%1 levels finer") : tr("%1 levels coarser")).arg(std::abs(level_));
  }
}

}  // namespace blossom::sweep
