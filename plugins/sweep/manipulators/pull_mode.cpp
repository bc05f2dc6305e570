#include "manipulators/pull_mode.h"

#include <QStringList>
#include <algorithm>
#include <cmath>
#include <cstdlib>

namespace blossom::sweep {

namespace {

constexpr double halfOfTheWay = 0.5;

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

PullMode::PullMode(const MotionEdit& edit) {
  std::visit([this](const auto& each) { symmetry_ = each.symmetry, level_ = each.level; }, edit);
  const auto* const pull = std::get_if<MotionPull>(&edit);
  twists_ = !pull;
  if (!pull) return;
  shares_ = {pull->weights.translate, pull->weights.rotate, pull->weights.scale};
  shares_[lastShare()] = 1;
}

std::optional<PullMode::Share> PullMode::shareOfKey(int key) {
  switch (key) {
    case Qt::Key_T:
      return Translate;
    case Qt::Key_R:
      return Rotate;
    case Qt::Key_S:
      return Scale;
    default:
      return std::nullopt;
  }
}

std::size_t PullMode::lastShare() const { return shares_[Scale] > 0 ? Scale : shares_[Rotate] > 0 ? Rotate : Translate; }

bool PullMode::only(Share share) const {
  return std::count_if(shares_.begin(), shares_.end(), [](double each) { return each > 0; }) == 1 && shares_[share] > 0;
}

std::optional<std::size_t> PullMode::adjustableShare() const {
  if (twists_) return std::nullopt;
  if (named_ && *named_ < lastShare() && shares_[*named_] > 0) return named_;
  for (std::size_t k = 0; k < lastShare(); ++k)
    if (shares_[k] > 0) return k;
  return std::nullopt;
}

PullWeights PullMode::weights() const {
  if (twists_) return {0, 0, 0};
  Shares all = shares_;
  all[lastShare()] = 1;
  return {all[Translate], all[Rotate], all[Scale]};
}

bool PullMode::keyWithShift(int key) {
  const auto share = shareOfKey(key);
  if (!share) return false;
  if (twists_) {
    twists_ = false;
    shares_ = turnAndScale;
  }
  named_ = share;
  if (only(*share)) return true;
  shares_[*share] = shares_[*share] > 0 ? 0 : 1;
  if (shares_[Translate] == 1 && lastShare() != Translate) shares_[Translate] = halfOfTheWay;  // all of it leaves nothing
  return true;
}

bool PullMode::addTenths(int tenths) {
  const auto share = adjustableShare();
  if (!share) return false;
  // Sections that went all the way would leave nothing to the others; none of it is what Shift and the key are for.
  const int most = *share == Translate ? 9 : 10;
  shares_[*share] = std::clamp(static_cast<int>(std::lround(shares_[*share] * 10)) + tenths, 1, most) / 10.0;
  return true;
}

QString PullMode::adjustable() const {
  const auto share = adjustableShare();
  if (!share) return {};
  return QString(*share == Translate ? u'T' : u'R');  // scaling would be the last
}

bool PullMode::key(int key) {
  if (const auto share = shareOfKey(key)) {
    const bool again = !twists_ && only(*share);
    twists_ = false;
    shares_ = again ? turnAndScale : Shares{};
    if (!again) shares_[*share] = 1;
    named_ = share;
  } else if (key == Qt::Key_W) {
    twists_ = !twists_;
    shares_ = turnAndScale;
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
  if (twists_) return tr("by twisting");
  if (only(Translate)) return tr("by moving the sections");
  if (only(Rotate)) return tr("by turning alone");
  if (only(Scale)) return tr("by scaling alone");
  if (shares_ == turnAndScale) return tr("by turning and scaling");
  const std::array<QString, 3> names{tr("moving"), tr("turning"), tr("scaling")};
  QStringList parts;
  for (std::size_t k = 0; k <= lastShare(); ++k)
    if (shares_[k] > 0)
      parts << (k == lastShare() || shares_[k] == 1
                    ? names[k]
                    : QStringLiteral("%1 %2 %").arg(names[k]).arg(std::lround(100 * shares_[k])));
  return tr("by %1").arg(parts.join(QStringLiteral(", ")));
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
