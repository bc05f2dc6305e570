#include "manipulators/curve_tool.h"

#include <vtkProp.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "kernel/foot_points.h"
#include "manipulators/pull_grips.h"
#include "manipulators/pull_marks.h"
#include "pulls.h"
#include "ui/tools/view_props.h"

namespace blossom::subdivision {
namespace {

constexpr double gripReach = 8;             // pixels
constexpr std::size_t maximumPoints = 500;  // of a polygon whose curve follows at every movement of the mouse
constexpr int piecesPerSpan = 12;

SchemeChoice chosenOf(const std::string& name) {
  const std::vector<std::string> names = schemeChoice().choices;
  return static_cast<SchemeChoice>(std::find(names.begin(), names.end(), name) - names.begin());
}

bool liesOnGround(const std::vector<Vec3>& points) {
  return std::all_of(points.begin(), points.end(), [](const Vec3& p) { return p.z() == 0; });
}

/// Points along the curve, a few for each of its pieces.
std::vector<Row> rowsAlong(const CurveCage& cage) {
  std::vector<Foot> ends = cage.joints;
  if (cage.closed) ends.push_back({0, 1, 0});
  std::vector<Row> rows;
  for (std::size_t k = 0; k + 1 < ends.size(); ++k)
    for (int i = 0; i < piecesPerSpan; ++i)
      rows.push_back(cage.curve->row({0, ends[k].u + (ends[k + 1].u - ends[k].u) * i / piecesPerSpan, 0}));
  if (!rows.empty()) rows.push_back(cage.closed ? rows.front() : cage.curve->row(ends.back()));
  return rows;
}

}  // namespace

CurveTool::CurveTool(ui::ToolHost& toolHost, FeatureId feature) : HandleTool(toolHost, std::move(feature)) { load(); }

void CurveTool::load() {
  grips_.clear();
  line_.clear();
  forgetHovered();
  place_ = deformPlace(host(), feature());
  if (!place_) return;
  try {
    readDeform();
    scheme_ = chosenOf(place_->scheme.get<std::string>());
    cage_ = curveCage(host().result(place_->base)->evaluated.shape, scheme_);
    flat_ = liesOnGround(cage_.points);
    if (cage_.points.size() <= maximumPoints) findGrips();
  } catch (const Error&) {
    grips_.clear();  // the features made from the cage report its defects
  }
}

void CurveTool::readDeform() {
  pulls_.clear();
  options_ = {};
  if (place_->existing.empty()) return;
  const Feature& deform = host().document().at(place_->existing);
  const Value all = completed(host().registry().at(deform.type)->parameters, deform.parameters);
  pulls_ = pullsOf(all.at("pulls").get<std::vector<Value>>());
  options_.lambda = all.at("lambda").get<double>();
  options_.free = ruleOf(all.at("free").get<std::string>());
}

/// The joints of the curve, and pulls that start between them.
void CurveTool::findGrips() {
  const std::vector<Vec3> now = pointsNow();
  const auto addGrip = [&](const Foot& foot, std::optional<std::size_t> pull) {
    const Row row = cage_.curve->row(foot);
    grips_.push_back({combined(row, cage_.points), combined(row, now), pull});
  };
  for (const Foot& joint : cage_.joints) addGrip(joint, {});
  std::vector<Vec3> between;
  std::vector<std::size_t> numbers;
  for (std::size_t p = 0; p < pulls_.size(); ++p) {
    const auto same = std::find_if(grips_.begin(), grips_.end(),
                                   [&](const Grip& grip) { return !grip.pull && samePlace(grip.base, pulls_[p].at); });
    if (same != grips_.end()) {
      same->pull = p;
    } else {
      between.push_back(pulls_[p].at);
      numbers.push_back(p);
    }
  }
  if (between.empty()) return;
  const std::vector<Foot> feet =
      FootFinder(*cage_.curve, Progress::none()).feet(between, cage_.points, {}, Progress::none());
  for (std::size_t i = 0; i < feet.size(); ++i) addGrip(feet[i], numbers[i]);
}

/// The control points after the pulls that there are.
std::vector<Vec3> CurveTool::pointsNow() const {
  const auto result = place_->existing.empty() ? nullptr : host().result(place_->existing);
  if (!result || result->error) return cage_.points;
  std::vector<Vec3> points = controlPoints(result->evaluated.shape, scheme_);
  return points.size() == cage_.points.size() ? points : cage_.points;  // while it is computed it may be that of before
}

std::optional<std::size_t> CurveTool::handleUnder(const ui::ToolEvent& event) const {
  std::optional<std::size_t> best;
  double nearest = gripReach * event.millimetresPerPixel;
  for (std::size_t k = 0; k < grips_.size(); ++k) {
    const double distance = distanceTo(event.ray, grips_[k].now);
    if (distance > nearest) continue;
    best = k;
    nearest = distance;
  }
  return best;
}

bool CurveTool::take(std::size_t grip, const ui::ToolEvent& event) {
  moving_ = pulls_;
  which_ = grips_[grip].pull.value_or(pulls_.size());
  if (!grips_[grip].pull) moving_.push_back({grips_[grip].base, grips_[grip].now});
  grabbed_ = target_ = moving_[which_].to;
  towards_ = event.ray.direction;
  if (line_.empty()) line_ = rowsAlong(cage_);
  return true;
}

Vec3 CurveTool::dragged(const ui::ToolEvent& event) const {
  if (flat_ && grabbed_.z() == 0) {
    const auto at = ui::inGround(event.ray);
    return at ? Vec3(at->x(), at->y(), 0) : target_;
  }
  const Vec3& d = event.ray.direction;
  const double slope = towards_.dot(d);
  return slope > 1e-6 ? Vec3(event.ray.origin + towards_.dot(grabbed_ - event.ray.origin) / slope * d) : target_;
}

void CurveTool::drag(const ui::ToolEvent& event) {
  target_ = dragged(event);
  moving_[which_].to = target_;
  DeformOptions options = options_;
  options.pulls = moving_;
  try {
    polygon_ = deform(*cage_.curve, cage_.points, {}, options).points;
    follows_ = lineOf(polygon_);
  } catch (const Error&) {
    return;  // the feature reports why it cannot be pulled there
  }
}

std::vector<Vec3> CurveTool::lineOf(const std::vector<Vec3>& points) const {
  std::vector<Vec3> line;
  line.reserve(line_.size());
  for (const Row& row : line_) line.push_back(combined(row, points));
  return line;
}

void CurveTool::place() {
  if (target_ == grabbed_) return;
  commit(withPulls(host(), *place_, moving_), tr("Pull a point"));
}

QString CurveTool::hint() const {
  if (grips_.empty()) return {};  // the view says what it does by itself
  if (held()) return tr("Let go to pull the curve here · Esc takes it back");
  if (hovered()) return tr("Drag to pull this point of the curve");
  return tr("Drag a place near a control point to pull the smooth curve there");
}

std::vector<vtkSmartPointer<vtkProp>> CurveTool::props() const {
  const double ratio = host().pixelRatio();
  const Look& look = host().look();
  std::vector<Vec3> pulled;
  for (const Grip& grip : grips_)
    if (grip.pull) pulled.push_back(grip.now);
  const bool hovers = hovered() && !held();
  Props props = gripMarks(host(), pulled, hovers ? std::optional(grips_[*hovered()].now) : std::nullopt);
  if (!held()) return props;
  if (!follows_.empty()) {
    std::vector<Vec3> polygon = polygon_;
    if (cage_.closed) polygon.push_back(polygon.front());
    props.push_back(ui::linesProp({polygon}, look.control, 1.2 * ratio));
    props.push_back(ui::linesProp({follows_}, look.made, 2 * ratio));
  }
  addPullMark(host(), grabbed_, target_, props);
  return props;
}

}  // namespace blossom::subdivision
