#include "manipulators/pull_tool.h"

#include <vtkProp.h>

#include <QKeyEvent>
#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "kernel/subdivide.h"
#include "pulls.h"
#include "ui/tools/view_props.h"

namespace blossom::subdivision {
namespace {

constexpr double gripPixels = 8;
constexpr std::size_t mostFaces = 20000;  // of a cage whose points can be dragged live

double distanceTo(const Ray& ray, const Vec3& p) {
  const Vec3 from = p - ray.origin;
  return (from - std::max(0.0, from.dot(ray.direction)) * ray.direction).norm();
}

}  // namespace

PullTool::PullTool(ui::ToolHost& toolHost, FeatureId feature) : Tool(toolHost), feature_(std::move(feature)) { load(); }

void PullTool::load() {
  grips_.clear();
  surface_.reset();
  pulls_.clear();
  options_ = {};
  base_ = Shape();
  place_ = deformPlace(host(), feature_);
  if (!place_) return;
  base_ = host().result(place_->base)->evaluated.shape;
  const Mesh* mesh = base_.get<Mesh>();
  if (!mesh || mesh->faceCount() > mostFaces) return;
  if (!place_->existing.empty()) {
    const Feature& feature = host().document().at(place_->existing);
    const Value all = completed(host().registry().at(feature.type)->parameters, feature.parameters);
    pulls_ = pullsOf(all.at("pulls").get<std::vector<Value>>());
    options_.lambda = all.at("lambda").get<double>();
    options_.free = ruleOf(all.at("free").get<std::string>());
  }
  try {
    loadGrips();
  } catch (const Error&) {
    grips_.clear();  // what is wrong with the cage, the features that take it say
  }
}

/// The limit points of all vertices; those of pulls stand where they were pulled to.
void PullTool::loadGrips() {
  const Mesh& mesh = *base_.get<Mesh>();
  const Scheme scheme = place_->scheme == "loop" ? Scheme::Loop : Scheme::CatmullClark;
  surface_ = std::make_unique<LimitSurface>(mesh, scheme);
  std::vector<Vec3> now = mesh.points;
  if (!place_->existing.empty())
    if (const auto result = host().result(place_->existing); result && !result->error)
      if (const Mesh* moved = result->evaluated.shape.get<Mesh>(); moved && moved->points.size() == now.size())
        now = moved->points;
  std::vector<bool> known(mesh.points.size());
  for (std::size_t f = 0; f < mesh.faceCount(); ++f)
    for (std::size_t k = 0; k < mesh.face(f).size(); ++k) {
      const auto v = static_cast<std::size_t>(mesh.face(f)[k]);
      if (known[v]) continue;
      known[v] = true;
      const Row row = surface_->cornerRow(f, k);
      grips_.push_back({combined(row, mesh.points), combined(row, now), surface_->cornerFoot(f, k), {}});
    }
  for (std::size_t p = 0; p < pulls_.size(); ++p) {
    const auto same = std::find_if(grips_.begin(), grips_.end(), [&](const Grip& grip) {
      return (grip.base - pulls_[p].at).norm() <= 1e-9 * (1 + pulls_[p].at.norm());
    });
    if (same != grips_.end()) same->pull = p;
  }
}

void PullTool::documentChanged() {
  if (working_ || held_) return;
  if (!host().document().contains(feature_)) {
    emit finished();
    return;
  }
  load();
  hovered_.reset();
  emit changed();
}

std::optional<std::size_t> PullTool::under(const ui::ToolEvent& event) const {
  std::optional<std::size_t> best;
  double nearest = gripPixels * event.millimetresPerPixel, depth = 0;
  for (std::size_t k = 0; k < grips_.size(); ++k) {
    const double distance = distanceTo(event.ray, grips_[k].now);
    if (distance > gripPixels * event.millimetresPerPixel) continue;
    const double along = (grips_[k].now - event.ray.origin).dot(event.ray.direction);
    // What the surface hides cannot be taken hold of; of what is seen, the nearest to the mouse is.
    if (!event.pick.feature.empty() && along > event.pick.part.distance + 3 * gripPixels * event.millimetresPerPixel)
      continue;
    if (best && distance > nearest && along > depth) continue;
    best = k;
    nearest = distance;
    depth = along;
  }
  return best;
}

bool PullTool::press(const ui::ToolEvent& event) {
  if (event.button != Qt::LeftButton) return false;
  const auto grip = under(event);
  if (!grip) return false;
  try {
    begin(*grip, event);
  } catch (const Error&) {
    end();
    return false;
  }
  emit changed();
  return true;
}

void PullTool::begin(std::size_t grip, const ui::ToolEvent& event) {
  const Mesh& mesh = *base_.get<Mesh>();
  std::vector<LivePull::Handle> handles;
  moving_ = pulls_.size();
  for (const Grip& each : grips_)
    if (each.pull) handles.push_back({each.foot, pulls_[*each.pull].to});
  // In the order of the pulls, so that the numbers agree.
  handles.clear();
  for (std::size_t p = 0; p < pulls_.size(); ++p)
    for (const Grip& each : grips_)
      if (each.pull == p) handles.push_back({each.foot, pulls_[p].to});
  if (handles.size() != pulls_.size())
    throw Error(ErrorCode::InvalidInput, "Some pulls take hold between vertices.", "Edit them in the panel.");
  if (grips_[grip].pull)
    moving_ = *grips_[grip].pull;
  else
    handles.push_back({grips_[grip].foot, grips_[grip].now});
  const Frame frame = surface_->frame(grips_[grip].foot, mesh.points);
  const Vec3 across = frame.du.cross(frame.dv);
  normal_ = across.norm() > 0 ? Vec3(across.normalized()) : Vec3::UnitZ();
  grabbed_ = target_ = handles[moving_].to;
  towards_ = event.ray.direction;
  live_ = std::make_unique<LivePull>(*surface_, mesh.points, std::move(handles), options_);
  held_ = grip;
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

bool PullTool::move(const ui::ToolEvent& event) {
  if (held_) {
    target_ = dragged(event);
    live_->drag(moving_, target_);
    emit changed();
    return true;
  }
  const auto found = under(event);
  if (found != hovered_) {
    hovered_ = found;
    emit changed();
  }
  return hovered_.has_value() && event.button == Qt::NoButton;
}

bool PullTool::release(const ui::ToolEvent& event) {
  if (!held_ || event.button != Qt::LeftButton) return false;
  if ((target_ - grabbed_).norm() > 0) {
    commit();
  } else {
    end();
    emit changed();
  }
  return true;
}

void PullTool::commit() {
  std::vector<Pull> pulls = pulls_;
  if (moving_ == pulls.size()) pulls.push_back({grips_[*held_].base, target_});
  pulls[moving_].to = target_;
  Value records = Value::array();
  for (const Pull& pull : pulls) records.push_back(recordOf(pull));
  FeatureId id;
  working_ = true;  // the host tells of the change before it returns
  Document document = withDeform(host(), host().document(), *place_, {{"pulls", records}}, {}, id);
  end();
  host().commit(std::move(document), tr("Pull a point"));
  working_ = false;
  documentChanged();
}

void PullTool::end() {
  held_.reset();
  live_.reset();
}

void PullTool::revert() { end(); }

bool PullTool::key(const QKeyEvent& event) {
  if (event.key() != Qt::Key_Escape || !held_) return false;
  end();
  emit changed();
  return true;
}

QString PullTool::hint() const {
  if (held_) return tr("Let go to pull the point here · Shift: along the normal · Esc takes it back");
  if (hovered_) return tr("Drag to pull this point of the surface");
  return tr("Drag a point of the smooth surface to pull it");
}

std::vector<vtkSmartPointer<vtkProp>> PullTool::props() const {
  const double ratio = host().pixelRatio();
  const Look& look = host().look();
  std::vector<vtkSmartPointer<vtkProp>> props;
  std::vector<Vec3> pulled;
  for (const Grip& grip : grips_)
    if (grip.pull) pulled.push_back(grip.now);
  if (!pulled.empty()) props.push_back(ui::pointsProp(pulled, look.made, 7 * ratio));
  if (hovered_ && !held_) props.push_back(ui::pointsProp({grips_[*hovered_].now}, look.control, 10 * ratio));
  if (!live_) return props;
  std::vector<std::array<Vec3, 3>> triangles;
  const auto at = [&](int i) { return live_->samples()[static_cast<std::size_t>(i)]; };
  for (const auto& [a, b, c] : live_->triangles()) triangles.push_back({at(a), at(b), at(c)});
  props.push_back(ui::trianglesProp(triangles, look.made, 0.55));
  std::vector<std::vector<Vec3>> cage;
  const std::vector<int>& free = live_->freePoints();
  for (const auto& [from, to] : surface_->edges())
    if (std::binary_search(free.begin(), free.end(), from) || std::binary_search(free.begin(), free.end(), to))
      cage.push_back({live_->points()[static_cast<std::size_t>(from)], live_->points()[static_cast<std::size_t>(to)]});
  props.push_back(ui::linesProp(cage, look.control, 1.2 * ratio));
  props.push_back(ui::linesProp({{grabbed_, target_}}, look.made, 1.5 * ratio));
  props.push_back(ui::pointsProp({target_}, look.made, 10 * ratio));
  return props;
}

}  // namespace blossom::subdivision
