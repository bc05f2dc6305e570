// The legs of the ladder: each is a linear morph of its own, whose in-between can be shown.
#include <vtkProp.h>

#include <algorithm>

#include "manipulators/morph_tool.h"
#include "ui/look/text.h"
#include "ui/tools/view_props.h"

namespace blossom::minkowski {
namespace {

constexpr double legPixels = 5;

Vec3 inPlane(const Vec2& p) { return {p.x(), p.y(), 0}; }

}  // namespace

std::vector<Vec2> MorphTool::centres() const {
  std::vector<Vec2> all;
  for (std::size_t i = 0; i < controls_.size(); ++i) all.push_back(centreOf(i));
  return all;
}

/// The last one leads to the result, which is seen anyway.
std::optional<LadderLeg> MorphTool::legUnder(const ui::ToolEvent& event) const {
  const auto at = ui::inGround(event.ray);
  if (!habits_.ladder || !ladder_ || !at) return std::nullopt;
  const auto leg = legNear(*at, centres(), levels_, legPixels * event.millimetresPerPixel);
  return leg && shapeOn(*leg) ? leg : std::nullopt;
}

/// The ladder arrives later than the shapes and numbers of the document, which may have become fewer or more meanwhile: a
/// leg counts only where both have it.
const LadderShape* MorphTool::shapeOn(const LadderLeg& leg) const {
  if (!ladder_ || leg.level > std::min(levels_.size(), ladder_->levels.size())) return nullptr;
  if (leg.level + leg.index >= controls_.size()) return nullptr;
  const std::vector<LadderShape>& level = ladder_->levels[leg.level - 1];
  return leg.index < level.size() ? &level[leg.index] : nullptr;
}

/// Of another number of shapes it tells nothing about these.
void MorphTool::forgetOldLadder() {
  if (ladder_ && !ladder_->levels.empty() && ladder_->levels.front().size() + 1 != controls_.size()) ladder_.reset();
  forgetLostLeg();
}

void MorphTool::forgetLostLeg() {
  if (legShown_ && !shapeOn(*legShown_)) legShown_.reset();
  if (legHovered_ && !shapeOn(*legHovered_)) legHovered_.reset();
}

QString MorphTool::legNote() const {
  const LadderShape* const shape = legShown_ ? shapeOn(*legShown_) : nullptr;
  if (!shape) return {};
  return tr("Level %1, leg %2: t %3 · area %4")
      .arg(legShown_->level)
      .arg(legShown_->index + 1)
      .arg(QString::number(levels_[legShown_->level - 1], 'g', 4),
           ui::readable(Measure{"area", shape->area, MeasureUnit::Area}));
}

/// The leg, the shapes at its ends, and the one between them, which lies where t divides it.
void MorphTool::drawLeg(std::vector<vtkSmartPointer<vtkProp>>& props) const {
  const double pixel = host().pixelRatio();
  const Look& look = host().look();
  if (legHovered_ && shapeOn(*legHovered_)) {
    const auto [a, b] = endsOf(*legHovered_, centres(), levels_);
    props.push_back(ui::linesProp({{inPlane(a), inPlane(b)}}, look.made, 1.5 * pixel));
  }
  const LadderShape* const shape = legShown_ ? shapeOn(*legShown_) : nullptr;
  if (!shape) return;
  const auto [a, b] = endsOf(*legShown_, centres(), levels_);
  const double t = levels_[legShown_->level - 1];
  props.push_back(ui::linesProp({{inPlane(a), inPlane(b)}}, look.made, 2 * pixel));
  props.push_back(ui::pointsProp({inPlane((1 - t) * a + t * b)}, look.made, 7 * pixel));
  props.push_back(ui::linesProp(shape->lines, look.made, 2 * pixel));
  for (const std::size_t end : {legShown_->index, legShown_->index + 1})
    if (const LadderShape* const lower = legShown_->level > 1 ? shapeOn({legShown_->level - 1, end}) : nullptr)
      props.push_back(ui::linesProp(lower->lines, look.control, 1.25 * pixel));
}

}  // namespace blossom::minkowski
