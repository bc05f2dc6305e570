#include <fmt/format.h>

#include "core/angle.h"
#include "core/error.h"
#include "feature/input_image.h"
#include "feature_groups.h"
#include "isolate/in_worker.h"
#include "kernel/parts/boolean.h"
#include "kernel/parts/crossing_warning.h"
#include "kernel/parts/placement.h"
#include "kernel/parts/shape_parts.h"
#include "kernel/solid/arrange.h"

namespace blossom::modeling {

namespace {

using Map = Eigen::Affine3d;

InputSpec anyInput(const char* asks) {
  return {.name = "shape",
          .help = "The shape to arrange.",
          .kinds = {ShapeKind::Brep, ShapeKind::Region, ShapeKind::Curves, ShapeKind::Curve, ShapeKind::Surface,
                    ShapeKind::Mesh},
          .use = InputUse::Consumed,
          .asks = asks};
}

Vec3 unitVector(const Vec3& v, const char* what) { return toVec(toDirection(v, what).XYZ()); }

Map turned(const Vec3& centre, const Vec3& axis, double degrees) {
  return Eigen::Translation3d(centre) * Eigen::AngleAxisd(toRadians(degrees), unitVector(axis, "axis")) *
         Eigen::Translation3d(-centre);
}

struct TransformParameters {
  Vec3 move{0, 0, 0}, axis{0, 0, 1}, centre{0, 0, 0}, stretch{1, 1, 1};
  double angle = 0, scale = 1;
};

Map mapOf(const TransformParameters& p) {
  Map map = Map::Identity();
  map.translate(p.move + p.centre);
  if (p.angle != 0) map.rotate(Eigen::AngleAxisd(toRadians(p.angle), unitVector(p.axis, "axis")));
  map.scale(p.scale * p.stretch);
  map.translate(-p.centre);
  return map;
}

FeatureType transformFeature() {
  using P = TransformParameters;
  return feature<P>("modeling.transform", "Transform", "A shape moved, turned and scaled.")
      .icon("transform")
      .keywords({"move", "translate", "rotate", "turn", "scale", "resize", "place", "shift"})
      .input(anyInput("a shape to move"))
      .parameter("move", &P::move, displacement(), "Translation, after rotation and scaling.")
      .parameter("angle", &P::angle, angle(), "Rotation about the axis.")
      .parameter("axis", &P::axis, vector(), "Direction of the axis.")
      .parameter("centre", &P::centre, point(), "The fixed point of rotation and scaling.")
      .parameter("scale", &P::scale, number(1e-6, 1e6), "Scale factor.")
      .parameter("stretch", &P::stretch, vector(), "Factors along x, y and z on top of the scale, before it is turned.")
      .images([](const P& p, const Inputs&) {
        return std::vector<InputImage>{{0, mapOf(p)}};
      })
      .example("blossom transform part.step --move 0,0,25 -o lifted.step")
      .example("blossom transform part.stl --angle 90 --axis 1,0,0 --scale 25.4 -o upright.stl")
      .evaluate([](const P& p, const Inputs& inputs, const Progress& progress) {
        progress.check();
        return Evaluated{transformed(inputs.of(0)[0], mapOf(p)), Value::object(), {}};
      });
}

/// Copies as one shape; solids that are to be joined as one body.
Shape assembled(const std::vector<Shape>& copies, bool join, const Progress& progress) {
  if (!join || copies.front().get<Region>()) return gathered(copies);
  std::vector<TopoDS_Shape> solids;
  solids.reserve(copies.size());
  for (const Shape& copy : copies) {
    if (!copy.get<Brep>())
      throw Error(ErrorCode::InvalidInput,
                  "Only solids and regions can be joined; the input is " + std::string(shapeKindName(copy.kind())) + ".",
                  "Turn \"join\" off.");
    solids.push_back(copy.get<Brep>()->shape());
  }
  return Brep(combine(solids, {}, progress).shape);
}

/// Joining solids is what may hang; the rest is cheap.
bool joinsSolids(const Value& parameters, const Inputs& inputs) {
  return parameters.value("join", false) && inputs.of(0)[0].kind() == ShapeKind::Brep;
}

/// Tells of copies that hold the same space and stay separate. Those compared with all others stand at the corners of a row.
void tellOverlaps(const std::vector<Shape>& copies, const std::vector<std::size_t>& compared, Evaluated& out,
                  const Progress& progress) {
  std::vector<TopoDS_Shape> solids;
  for (const Shape& copy : copies) {
    const Brep* brep = copy.get<Brep>();
    if (!brep || subShapesOf(brep->shape(), TopAbs_SOLID).empty()) return;
    solids.push_back(brep->shape());
  }
  warnOfOverlap(solids, compared, out.warnings, progress);
}

enum class PatternKind { Linear, Circular };

struct PatternParameters {
  PatternKind kind = PatternKind::Linear;
  int count = 3, secondCount = 1;
  Vec3 step{50, 0, 0}, secondStep{0, 50, 0}, axis{0, 0, 1}, centre{0, 0, 0};
  double angle = 360;
  bool join = false;
};

std::vector<Map> linearMaps(const PatternParameters& p) {
  std::vector<Map> maps;
  maps.reserve(static_cast<std::size_t>(p.count) * static_cast<std::size_t>(p.secondCount));
  for (int j = 0; j < p.secondCount; ++j)
    for (int i = 0; i < p.count; ++i) maps.emplace_back(Eigen::Translation3d(i * p.step + j * p.secondStep));
  return maps;
}

/// A full turn is shared by all; of a part of one, the last copy stands at its end.
std::vector<Map> circularMaps(const PatternParameters& p) {
  const bool full = std::abs(std::abs(p.angle) - 360) < 1e-9;
  const double step = p.angle / std::max(1, full ? p.count : p.count - 1);
  std::vector<Map> maps;
  maps.reserve(static_cast<std::size_t>(p.count));
  for (int i = 0; i < p.count; ++i) maps.push_back(turned(p.centre, p.axis, i * step));
  return maps;
}

std::vector<Map> mapsOf(const PatternParameters& p) {
  return p.kind == PatternKind::Linear ? linearMaps(p) : circularMaps(p);
}

std::vector<InputImage> copiesOf(const PatternParameters& p, const Inputs&) {
  std::vector<InputImage> images;
  const auto row = static_cast<std::size_t>(std::max(1, p.count));
  for (const Map& map : mapsOf(p)) {
    const std::size_t k = images.size();
    images.push_back({0, map, k == 0 ? std::string() : fmt::format("copy {},{}", k % row, k / row)});
  }
  return images;
}

Evaluated patternOf(const PatternParameters& p, const Inputs& inputs, const Progress& progress) {
  const bool linear = p.kind == PatternKind::Linear;
  if (static_cast<long>(p.count) * (linear ? p.secondCount : 1) > 10000)
    throw Error(ErrorCode::LimitExceeded, "A pattern has at most 10000 copies.", "Use smaller counts.");
  const auto maps = mapsOf(p);
  std::vector<Shape> copies;
  copies.reserve(maps.size());
  for (const Map& map : maps) {
    progress.check();
    copies.push_back(copies.empty() ? inputs.of(0)[0] : transformed(inputs.of(0)[0], map));
  }
  const bool join = p.join && copies.size() > 1;
  Evaluated out{assembled(copies, join, progress), {{"copies", maps.size()}}, {}};
  if (!join) tellOverlaps(copies, {0, linear ? static_cast<std::size_t>(p.count) - 1 : 0}, out, progress);
  return out;
}

FeatureType patternFeature() {
  using P = PatternParameters;
  return inWorker(
      feature<P>("modeling.pattern", "Pattern", "Copies of a shape in rows or round an axis.")
          .icon("pattern")
          .keywords({"array", "repeat", "copies", "row", "grid", "polar", "linear", "circular"})
          .input(anyInput("a shape to repeat"))
          .parameter("kind", &P::kind, choice({"linear", "circular"}), "Whether the copies stand in rows or round an axis.")
          .parameter("count", &P::count, count(1, 1000), "Number of copies in a row, including the original.")
          .parameter("step", &P::step, onlyFor(displacement(), "kind", {"linear"}),
                     "Distance from one copy to the next in a row.")
          .parameter("second-count", &P::secondCount, onlyFor(count(1, 1000), "kind", {"linear"}), "Number of rows.")
          .parameter("second-step", &P::secondStep, onlyFor(displacement(), "kind", {"linear"}),
                     "Distance from one row to the next.")
          .parameter("axis", &P::axis, onlyFor(vector(), "kind", {"circular"}),
                     "Direction of the axis of a circular pattern.")
          .parameter("centre", &P::centre, onlyFor(point(), "kind", {"circular"}), "A point that this axis passes through.")
          .parameter("angle", &P::angle, onlyFor(turn(), "kind", {"circular"}), "The angle that the copies divide.")
          .parameter("join", &P::join, flag(), "Unite the copies to one body; off: an assembly of copies.")
          .example("blossom pattern hole.step --count 4 --step 25,0,0 --second-count 2 --second-step 0,40,0 -o holes.step")
          .example("blossom pattern tooth.step --kind circular --count 12 --join -o gear.step")
          .images(copiesOf)
          .evaluate(patternOf),
      {.activity = "for the pattern", .when = joinsSolids});
}

struct MirrorParameters {
  Vec3 point{0, 0, 0}, normal{1, 0, 0};
  bool keep = true, join = false;
};

Map reflection(const Vec3& point, const Vec3& normal) {
  const Vec3 n = unitVector(normal, "normal");
  Map map = Map::Identity();
  map.linear() -= 2 * n * n.transpose();
  map.translation() = 2 * n.dot(point) * n;
  return map;
}

FeatureType mirrorFeature() {
  using P = MirrorParameters;
  return inWorker(
      feature<P>("modeling.mirror", "Mirror", "A shape and its mirror image in a plane.")
          .icon("mirror")
          .keywords({"reflect", "flip", "symmetry"})
          .input(anyInput("a shape to mirror"))
          .parameter("normal", &P::normal, vector(), "Normal of the mirror plane.")
          .parameter("point", &P::point, point(), "A point in the mirror plane.")
          .parameter("keep", &P::keep, flag(), "Keep the original beside its image.")
          .parameter("join", &P::join, flag(), "Unite both to one body.")
          .images([](const P& p, const Inputs&) {
            const Map map = reflection(p.point, p.normal);
            return p.keep ? std::vector<InputImage>{{0}, {0, map, "mirrored"}} : std::vector<InputImage>{{0, map}};
          })
          .example("blossom mirror half.step --join -o whole.step")
          .example("blossom mirror left.stl --normal 0,1,0 --no-keep -o right.stl")
          .evaluate([](const P& p, const Inputs& inputs, const Progress& progress) {
            const Shape& shape = inputs.of(0)[0];
            const Shape image = transformed(shape, reflection(p.point, p.normal));
            Evaluated out{p.keep ? assembled({shape, image}, p.join, progress) : image, Value::object(), {}};
            if (p.keep && !p.join) tellOverlaps({shape, image}, {0}, out, progress);
            return out;
          }),
      {.activity = "for the mirror image", .when = joinsSolids});
}

}  // namespace

void registerArrangements(Registry& registry) { registry.addAll(transformFeature(), patternFeature(), mirrorFeature()); }

}  // namespace blossom::modeling
