#include "scene/camera.h"

#include <vtkActor.h>
#include <vtkActorCollection.h>
#include <vtkCamera.h>
#include <vtkMapper.h>
#include <vtkPolyData.h>
#include <vtkRenderWindow.h>
#include <vtkRenderer.h>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>

#include "core/angle.h"
#include "core/error.h"
#include "scene/scene.h"

namespace blossom {

namespace {

const std::map<std::string, Turn>& namedTurns() {
  static const std::map<std::string, Turn> turns{{"iso", {35, 28}}, {"top", {0, 90}},   {"bottom", {0, -90}},
                                                 {"front", {0, 0}}, {"back", {180, 0}}, {"left", {-90, 0}},
                                                 {"right", {90, 0}}};
  return turns;
}

bool liesFlat(const std::vector<Vec3>& points) {
  if (points.empty()) return false;
  const double z = points.front().z();
  return std::all_of(points.begin(), points.end(), [z](const Vec3& p) { return p.z() == z; });
}

struct Extent {
  double minimum = std::numeric_limits<double>::infinity();
  double maximum = -std::numeric_limits<double>::infinity();
  void add(double value) {
    minimum = std::min(minimum, value);
    maximum = std::max(maximum, value);
  }
  [[nodiscard]] double middle() const { return (minimum + maximum) / 2; }
  [[nodiscard]] double half() const { return (maximum - minimum) / 2; }
};

}  // namespace

Vec3 Turn::toCamera() const {
  const double y = toRadians(yaw), p = toRadians(pitch);
  return {std::sin(y) * std::cos(p), -std::cos(y) * std::cos(p), std::sin(p)};
}

Vec3 Turn::up() const {
  const double y = toRadians(yaw), p = toRadians(pitch);
  return {-std::sin(y) * std::sin(p), std::cos(y) * std::sin(p), std::cos(p)};
}

Vec3 Turn::right() const { return {std::cos(toRadians(yaw)), std::sin(toRadians(yaw)), 0}; }

Turn turnTowards(const Vec3& normal) {
  const double flat = std::hypot(normal.x(), normal.y()), steep = 1e-9;
  const double pitch = toDegrees(std::atan2(normal.z(), flat));
  return {flat <= steep * normal.norm() ? 0 : toDegrees(std::atan2(normal.x(), -normal.y())), pitch};
}

Turn turnOf(const std::string& view) {
  const auto it = namedTurns().find(view);
  if (it != namedTurns().end()) return it->second;
  throw Error(ErrorCode::InvalidParameter, "There is no view \"" + view + "\".",
              "Views are auto, iso, top, bottom, front, back, left and right.");
}

Turn turnOf(const std::string& view, const std::vector<Vec3>& seen) {
  return turnOf(view == "auto" ? (liesFlat(seen) ? "top" : "iso") : view);
}

const std::vector<std::string>& viewNames() {
  static const std::vector<std::string> names{"auto", "iso", "top", "bottom", "front", "back", "left", "right"};
  return names;
}

Framing frameAll(const std::vector<Vec3>& points, const Turn& turn, double aspect, double viewAngle, double margin) {
  Framing framing;
  if (points.empty()) return {Vec3::Zero(), 100 / std::tan(toRadians(viewAngle) / 2), 100};
  const Vec3 right = turn.right(), up = turn.up(), back = turn.toCamera();
  Extent x, y, z;
  for (const Vec3& p : points) {
    x.add(p.dot(right));
    y.add(p.dot(up));
    z.add(p.dot(back));
  }
  framing.target = right * x.middle() + up * y.middle() + back * z.middle();
  const double usable = 1 - 2 * margin;
  if (std::max({x.half(), y.half(), z.half()}) <= 1e-9) {  // one point, which has no size of its own
    framing.parallelScale = 10;
    framing.distance = framing.parallelScale / std::tan(toRadians(viewAngle) / 2);
    return framing;
  }
  const double size = std::max({x.half(), y.half(), z.half(), 1e-9});
  framing.parallelScale = std::max({y.half(), x.half() / aspect, size * 1e-3}) / usable;
  const double tangent = std::tan(toRadians(viewAngle) / 2) * usable;
  for (const Vec3& p : points) {
    const Vec3 q = p - framing.target;
    const double reach = std::max(std::abs(q.dot(up)), std::abs(q.dot(right)) / aspect) / tangent;
    framing.distance = std::max(framing.distance, reach + q.dot(back));
  }
  framing.distance = std::max(framing.distance, z.half() * 1.05 + size * 1e-2);
  return framing;
}

void addPointsOf(vtkActor& actor, std::vector<Vec3>& found) {
  vtkDataSet* data = actor.GetMapper() ? actor.GetMapper()->GetInputAsDataSet() : nullptr;
  if (!data) return;
  const vtkIdType count = data->GetNumberOfPoints();
  const vtkIdType step = std::max<vtkIdType>(1, count / 50'000);
  for (vtkIdType i = 0; i < count; i += step) {
    Vec3 p;
    data->GetPoint(i, p.data());
    found.push_back(p);
  }
}

std::vector<Vec3> visiblePoints(vtkRenderer* renderer) {
  std::vector<Vec3> found;
  vtkActorCollection* actors = renderer->GetActors();
  actors->InitTraversal();
  while (vtkActor* actor = actors->GetNextActor()) {
    if (actor->GetVisibility() && actor->GetUseBounds()) addPointsOf(*actor, found);
  }
  return found;
}

void place(vtkCamera* camera, const Turn& turn, const Framing& framing) {
  const Vec3 position = framing.target + turn.toCamera() * framing.distance;
  const Vec3 up = turn.up();
  camera->SetFocalPoint(framing.target.data());
  camera->SetPosition(position.data());
  camera->SetViewUp(up.data());
  camera->SetParallelScale(framing.parallelScale);
}

namespace {

constexpr double viewAngleOfPictures = 22;  // degrees; about a portrait lens: little distortion, still depth

void aim(const std::vector<Vec3>& points, vtkRenderer* renderer, const std::string& view) {
  const Turn turn = turnOf(view, points);
  vtkCamera* camera = renderer->GetActiveCamera();
  camera->SetViewAngle(viewAngleOfPictures);
  camera->SetParallelProjection(liesFlat(points));
  const int* size = renderer->GetRenderWindow() ? renderer->GetRenderWindow()->GetSize() : nullptr;
  const double aspect = size && size[1] > 0 ? static_cast<double>(size[0]) / size[1] : 1.6;
  place(camera, turn, frameAll(points, turn, aspect, camera->GetViewAngle()));
}

/// What frameAll takes the largest value of, along each of these: extents, and the reach of the cone that is seen.
void addMeasuredDirections(const Turn& turn, double aspect, std::vector<Vec3>& directions) {
  const Vec3 right = turn.right(), up = turn.up(), back = turn.toCamera();
  const double tangent = std::tan(toRadians(viewAngleOfPictures) / 2) * (1 - 2 * marginOfFrames);
  for (const double sign : {1.0, -1.0}) {
    for (const Vec3& axis : {right, up, back}) directions.emplace_back(sign * axis);
    directions.emplace_back(back + sign * up / tangent);
    directions.emplace_back(back + sign * right / (aspect * tangent));
  }
}

}  // namespace

std::vector<Vec3> outermostPoints(const std::vector<Vec3>& points, const std::string& view, double aspect) {
  if (points.empty()) return {};
  std::vector<Vec3> directions;
  for (const double sign : {1.0, -1.0})
    for (int axis = 0; axis < 3; ++axis) directions.emplace_back(sign * Vec3::Unit(axis));
  if (view != "auto") addMeasuredDirections(turnOf(view), aspect, directions);
  if (view == "auto")
    for (const char* either : {"top", "iso"}) addMeasuredDirections(turnOf(either), aspect, directions);
  std::vector<Vec3> outermost;
  outermost.reserve(directions.size());
  for (const Vec3& direction : directions)
    outermost.push_back(*std::max_element(
        points.begin(), points.end(), [&](const Vec3& a, const Vec3& b) { return a.dot(direction) < b.dot(direction); }));
  return outermost;
}

void fitCamera(vtkRenderer* renderer, const std::string& view) {
  aim(visiblePoints(renderer), renderer, view);
  renderer->ResetCameraClippingRange();
}

void fitCameraTo(const std::vector<Vec3>& points, vtkRenderer* renderer, const std::string& view) {
  aim(points, renderer, view);
  Extent x, y, z;
  for (const Vec3& p : points) {
    x.add(p.x());
    y.add(p.y());
    z.add(p.z());
  }
  const double box[6] = {x.minimum, x.maximum, y.minimum, y.maximum, z.minimum, z.maximum};
  if (!points.empty()) renderer->ResetCameraClippingRange(box);
}

}  // namespace blossom
