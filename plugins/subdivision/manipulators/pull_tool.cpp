#include "manipulators/pull_tool.h"

#include <vtkProp.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <limits>

#include "core/error.h"
#include "manipulators/pull_marks.h"
#include "pulls.h"
#include "ui/tools/view_props.h"

namespace blossom::subdivision {
namespace {

constexpr double gripPixels = 8;
constexpr std::size_t maximumFaces = 50000;  // of a cage whose points can be dragged live
constexpr std::size_t facesAtOnce = 1000;    // whose limit surface takes a few milliseconds

/// The surface within reach as a net of lines: seen wherever it goes, and drawn in no time where faces, shaded or
/// translucent, are not.
std::vector<std::vector<Vec3>> netOf(const LivePull& live, Scheme scheme) {
  std::vector<std::vector<Vec3>> net;
  const auto at = [&](int i) { return live.samples()[static_cast<std::size_t>(i)]; };
  bool lower = true;  // quads are two triangles each, whose common side is left out
  for (const auto& [a, b, c] : live.triangles()) {
    if (scheme == Scheme::Loop)
      net.push_back({at(a), at(b), at(c), at(a)});
    else
      net.push_back(lower ? std::vector{at(b), at(a), at(c)} : std::vector{at(a), at(b), at(c)});
    lower = !lower;
  }
  return net;
}

}  // namespace

PullTool::PullTool(ui::ToolHost& toolHost, FeatureId feature) : HandleTool(toolHost, std::move(feature)) { load(); }

PullTool::~PullTool() { loading_.cancel(); }

/// The limit surface is kept while the cage is the same: after a pull only the grips move.
void PullTool::load() {
  loading_.cancel();
  loading_ = {};
  pulls_.clear();
  options_ = {};
  base_ = Shape();
  place_ = deformPlace(host(), feature());
  if (place_) base_ = host().result(place_->base)->evaluated.shape;
  const Mesh* mesh = base_.get<Mesh>();
  if (!mesh || mesh->faceCount() > maximumFaces) return show({});
  scheme_ = place_->scheme == "loop" ? Scheme::Loop : Scheme::CatmullClark;
  if (!place_->existing.empty()) {
    const Feature& deform = host().document().at(place_->existing);
    const Value all = completed(host().registry().at(deform.type)->parameters, deform.parameters);
    try {
      pulls_ = pullsOf(all.at("pulls").get<std::vector<Value>>());
      options_.lambda = all.at("lambda").get<double>();
      options_.free = ruleOf(all.at("free").get<std::string>());
    } catch (const Error&) {
      return show({});  // the feature itself says what is wrong with it
    }
  }
  const bool same = surface_ && surface_->cage.get<Mesh>() == mesh && surface_->scheme == scheme_;
  const auto known = same ? surface_ : nullptr;
  if (mesh->faceCount() <= facesAtOnce || (known && onVertices(*known, pulls_)))
    return show(loaded(known, base_, scheme_, pulls_, pointsNow(), Progress::none()));
  thread_.start([this, known, base = base_, scheme = scheme_, pulls = pulls_, now = pointsNow(), token = loading_] {
    Loaded made = loaded(known, base, scheme, pulls, now, Progress(token));
    here_.post([this, token, made = std::move(made)] {
      if (!token.cancelled()) show(made);
    });
  });
}

PullTool::Loaded PullTool::loaded(std::shared_ptr<const GripSurface> known, const Shape& base, Scheme scheme,
                                  const std::vector<Pull>& pulls, const std::vector<Vec3>& now, const Progress& progress) {
  try {
    if (!known) known = gripSurface(base, scheme, progress);
    std::vector<Grip> grips = gripsOf(*known, pulls, now, progress);
    return {std::move(known), std::move(grips)};
  } catch (const std::exception&) {
    return {};  // the features made from the cage report its defects
  }
}

/// The control points after the pulls that there are.
std::vector<Vec3> PullTool::pointsNow() const {
  const std::vector<Vec3>& points = base_.get<Mesh>()->points;
  const auto result = place_->existing.empty() ? nullptr : host().result(place_->existing);
  const Mesh* moved = result && !result->error ? result->evaluated.shape.get<Mesh>() : nullptr;
  return moved ? moved->points : points;
}

void PullTool::show(Loaded loaded) {
  if (held()) return loadLater();
  surface_ = std::move(loaded.first);
  grips_ = std::move(loaded.second);
  forgetHovered();
  emit changed();
}

std::optional<std::size_t> PullTool::handleUnder(const ui::ToolEvent& event) const {
  if (!surface_) return std::nullopt;
  const double reach = gripPixels * event.millimetresPerPixel;
  // Points hidden by the surface cannot be grabbed.
  const double seen =
      event.pick.feature.empty() ? std::numeric_limits<double>::infinity() : event.pick.part.distance + 3 * reach;
  std::optional<std::size_t> best;
  double nearest = reach;
  for (std::size_t k = 0; k < grips_.size(); ++k) {
    const double distance = distanceTo(event.ray, grips_[k].now);
    if (distance > nearest || (grips_[k].now - event.ray.origin).dot(event.ray.direction) > seen) continue;
    best = k;
    nearest = distance;
  }
  return best;
}

bool PullTool::take(std::size_t grip, const ui::ToolEvent& event) {
  std::vector<LivePull::Handle> handles(pulls_.size());
  for (const Grip& each : grips_)
    if (each.pull) handles[*each.pull] = {each.foot, pulls_[*each.pull].to};
  moving_ = grips_[grip].pull.value_or(pulls_.size());
  if (!grips_[grip].pull) handles.push_back({grips_[grip].foot, grips_[grip].now});
  const Frame frame = surface_->surface->frame(grips_[grip].foot, surface_->mesh().points);
  const Vec3 across = frame.du.cross(frame.dv);
  normal_ = across.norm() > 0 ? Vec3(across.normalized()) : Vec3::UnitZ();
  grabbed_ = target_ = handles[moving_].to;
  towards_ = event.ray.direction;
  makeLive(std::move(handles));
  return true;
}

void PullTool::makeLive(std::vector<LivePull::Handle> handles) {
  try {
    live_ = std::make_unique<LivePull>(*surface_->surface, surface_->mesh().points, std::move(handles), options_);
  } catch (const Error&) {
    return;  // the feature will tell why it cannot be pulled there
  }
  findLiveEdges();
}

void PullTool::findLiveEdges() {
  const std::vector<int>& free = live_->freePoints();
  const auto moves = [&](int point) { return std::binary_search(free.begin(), free.end(), point); };
  liveEdges_.clear();
  for (const auto& [from, to] : surface_->edges)
    if (moves(from) || moves(to)) liveEdges_.emplace_back(from, to);
}

/// In the plane that faces the viewer; with Shift along the normal of the surface.
Vec3 PullTool::dragged(const ui::ToolEvent& event) const {
  const Vec3& d = event.ray.direction;
  const Vec3 from = grabbed_ - event.ray.origin;
  if (event.modifiers.testFlag(Qt::ShiftModifier)) {
    const double slant = normal_.dot(d), across = 1 - slant * slant;
    if (across < 1e-6) return target_;
    return grabbed_ + (slant * from.dot(d) - from.dot(normal_)) / across * normal_;
  }
  const double slope = towards_.dot(d);
  return slope > 1e-6 ? Vec3(event.ray.origin + towards_.dot(from) / slope * d) : target_;
}

void PullTool::drag(const ui::ToolEvent& event) {
  target_ = dragged(event);
  if (!live_) return;
  const std::vector<int> free = live_->freePoints();
  try {
    live_->drag(moving_, target_);
  } catch (const Error&) {
    return;  // the feature will tell why it cannot be pulled there
  }
  if (live_->freePoints() != free) findLiveEdges();
}

void PullTool::place() {
  if (target_ == grabbed_) return;
  std::vector<Pull> pulls = pulls_;
  if (moving_ == pulls.size()) pulls.push_back({grips_[*held()].base, target_});
  pulls[moving_].to = target_;
  commit(withPulls(host(), *place_, pulls), tr("Pull a point"));
}

QString PullTool::hint() const {
  if (grips_.empty()) return {};  // the view says what it does by itself
  if (held()) return tr("Let go to pull the point here · Shift: along the normal · Esc takes it back");
  if (hovered()) return tr("Drag to pull this point of the surface");
  return tr("Drag a place over a vertex of the cage to pull the smooth surface there");
}

std::vector<vtkSmartPointer<vtkProp>> PullTool::props() const {
  const double ratio = host().pixelRatio();
  const Look& look = host().look();
  std::vector<Vec3> pulled;
  for (const Grip& grip : grips_)
    if (grip.pull) pulled.push_back(grip.now);
  const bool hovers = hovered() && !held();
  Props props = gripMarks(host(), pulled, hovers ? std::optional(grips_[*hovered()].now) : std::nullopt);
  if (!held()) return props;
  if (live_) {
    props.push_back(ui::linesProp(netOf(*live_, scheme_), look.made, ratio));
    std::vector<std::vector<Vec3>> cage;
    for (const auto& [from, to] : liveEdges_)
      cage.push_back({live_->points()[static_cast<std::size_t>(from)], live_->points()[static_cast<std::size_t>(to)]});
    props.push_back(ui::linesProp(cage, look.control, 1.2 * ratio));
  }
  addPullMark(host(), grabbed_, target_, props);
  return props;
}

}  // namespace blossom::subdivision
