#include <fmt/format.h>

#include "core/angle.h"
#include "core/error.h"
#include "feature/input_image.h"
#include "feature_groups.h"
#include "isolate/in_worker.h"
#include "kernel/parts/shape_parts.h"
#include "kernel/solid/arrange.h"
#include "kernel/solid/extrude.h"
#include "kernel/solid/loft.h"
#include "kernel/solid/pipe.h"
#include "kernel/solid/revolve.h"
#include "profile_input.h"

namespace blossom::modeling {

namespace {

const std::vector<ShapeKind> profileKinds{ShapeKind::Region, ShapeKind::Curves, ShapeKind::Curve, ShapeKind::Brep};

InputSpec profileInput(const char* asks) {
  return {.name = "profile",
          .help = "A region, curves or a flat face.",
          .kinds = profileKinds,
          .use = InputUse::Outline,
          .asks = asks};
}

constexpr const char* solidHelp = "Fill closed outlines and make solids; off: sheets over the curves.";
constexpr const char* faceHelp = "The flat face that is used when the profile is a solid.";

struct ExtrudeParameters {
  double height = 20, back = 0, taper = 0;
  Vec3 direction{0, 0, 0};
  bool solid = true;
  SubShapeValue face;
};

/// The outline where the extrusion begins and where it ends. With a taper the end is smaller, so only the outline itself
/// lies in the result.
std::vector<InputImage> endsOf(const ExtrudeParameters& p, const Inputs& inputs) {
  if (p.taper != 0) return {{0}};
  const Vec3 along = directionOf(profileShape(inputs.of(0)[0], p.face, p.solid), {.direction = p.direction});
  const auto moved = [&](double distance) { return Eigen::Affine3d(Eigen::Translation3d(distance * along)); };
  return {{0, moved(-p.back)}, {0, moved(p.height), "end"}};
}

ParameterSpec taperAngle() {
  ParameterSpec spec = angle();
  spec.minimum = -80;
  spec.maximum = 80;
  return spec;
}

FeatureType extrudeFeature() {
  using P = ExtrudeParameters;
  return inWorker(
      feature<P>("modeling.extrude", "Extrude", "A solid over an outline, straight or tapered.")
          .icon("extrude")
          .keywords({"3d", "push pull", "pushpull", "pad", "thicken", "raise", "prism"})
          .produces({ShapeKind::Brep})
          .input(profileInput("an outline to extrude"))
          .parameter("height", &P::height, length(), "Height along the direction; below 0: in the opposite direction.")
          .parameter("back", &P::back, lengthFromZero(), "Additional height in the opposite direction.")
          .parameter("taper", &P::taper, taperAngle(), "Inward inclination of the sides; below 0: outward.")
          .parameter("direction", &P::direction, vector(), "Direction; 0,0,0: perpendicular to the outline.")
          .parameter("solid", &P::solid, flag(), solidHelp)
          .parameter("face", &P::face, optional(subShape("face")), faceHelp)
          .images(endsOf)
          .example("blossom extrude outline.svg --height 12 -o part.step")
          .example("blossom extrude outline.dxf --height 30 --taper 3 -o cast.step")
          .example("blossom extrude block.step --face profile:face:0 --height 5 -o pad.step")
          .evaluate([](const P& p, const Inputs& inputs, const Progress& progress) {
            Evaluated out;
            const Shape& given = inputs.of(0)[0];
            const Shape drawn = p.taper != 0 && p.solid ? withoutSplines(given, out.warnings) : given;
            const ExtrudeOptions options{.height = p.height, .back = p.back, .taper = p.taper, .direction = p.direction};
            out.shape = Brep(extrude(profileShape(drawn, p.face, p.solid), options, progress).shape, "Extrusion");
            return out;
          }),
      // Leaning sides are what may take long; a region without them is swept at once.
      {.activity = "for the extrusion",
       .when = [](const Value& parameters, const Inputs&) { return parameters.value("taper", 0.0) != 0; }});
}

struct RevolveParameters {
  Vec3 point{0, 0, 0}, axis{0, 1, 0};
  double angle = 360;
  bool solid = true;
  SubShapeValue face;
};

std::vector<InputImage> endsOf(const RevolveParameters& p, const Inputs&) {
  if (std::abs(p.angle) >= 360) return {{0}};
  const Eigen::AngleAxisd turn(toRadians(p.angle), p.axis.normalized());
  return {{0}, {0, Eigen::Translation3d(p.point) * turn * Eigen::Translation3d(-p.point), "end"}};
}

FeatureType revolveFeature() {
  using P = RevolveParameters;
  return inWorker(feature<P>("modeling.revolve", "Revolve", "A solid that an outline sweeps when it turns about an axis.")
                      .icon("revolve")
                      .keywords({"lathe", "rotate", "spin", "turned part"})
                      .produces({ShapeKind::Brep})
                      .input(profileInput("an outline to revolve"))
                      .parameter("axis", &P::axis, vector(), "Direction of the axis; it lies beside the outline.")
                      .parameter("point", &P::point, point(), "A point that the axis passes through.")
                      .parameter("angle", &P::angle, turn(), "Angle of revolution; below 0: clockwise.")
                      .parameter("solid", &P::solid, flag(), solidHelp)
                      .parameter("face", &P::face, optional(subShape("face")), faceHelp)
                      .images([](const P& p, const Inputs& inputs) { return endsOf(p, inputs); })
                      .example("blossom revolve profile.svg -o vase.step")
                      .example("blossom revolve profile.dxf --axis 1,0,0 --point 0,-10,0 --angle 270 -o part.step")
                      .evaluate([](const P& p, const Inputs& inputs, const Progress& progress) {
                        const TopoDS_Shape profile = profileShape(inputs.of(0)[0], p.face, p.solid);
                        const RevolveOptions options{.point = p.point, .direction = p.axis, .angle = p.angle};
                        RevolveResult made = revolve(profile, options, progress);
                        return Evaluated{Brep(made.shape, "Revolution"), Value::object(), std::move(made.warnings)};
                      }),
                  {.activity = "for the revolution"});
}

struct LoftParameters {
  bool ruled = false, solid = true;
  double spacing = 20;
  std::vector<double> heights;
};

bool isDrawnFlat(const Shape& shape) { return shape.kind() == ShapeKind::Region || shape.kind() == ShapeKind::Curves; }

double heightOf(const LoftParameters& p, std::size_t index) {
  return p.heights.empty() ? p.spacing * static_cast<double>(index) : p.heights.at(index);
}

/// Drawings all lie in z = 0: they are stacked. Sections that lie in space stay where they are.
std::vector<InputImage> placesOf(const LoftParameters& p, std::span<const Shape> shapes) {
  const bool lifted = !p.heights.empty() || std::all_of(shapes.begin(), shapes.end(), isDrawnFlat);
  std::vector<InputImage> places;
  for (std::size_t i = 0; i < shapes.size(); ++i)
    places.push_back({i, Eigen::Affine3d(Eigen::Translation3d(0, 0, lifted ? heightOf(p, i) : 0))});
  return places;
}

std::vector<TopoDS_Shape> sectionsOf(const LoftParameters& p, std::span<const Shape> shapes) {
  if (!p.heights.empty() && p.heights.size() != shapes.size())
    throw Error(
        ErrorCode::InvalidParameter,
        fmt::format("The number of heights, {}, differs from the number of sections, {}.", p.heights.size(), shapes.size()),
        "Give one height for each section, or none.");
  std::vector<TopoDS_Shape> sections;
  sections.reserve(shapes.size());
  for (const InputImage& place : placesOf(p, shapes)) {
    const Shape section = Brep(profileShape(shapes[place.input], {}, p.solid));
    sections.push_back(transformed(section, place.map).get<Brep>()->shape());
  }
  return sections;
}

FeatureType loftFeature() {
  using P = LoftParameters;
  return inWorker(
      feature<P>("modeling.loft", "Loft", "A solid through two or more outlines.")
          .icon("loft")
          .keywords({"skin", "blend", "sections"})
          .produces({ShapeKind::Brep})
          .input({.name = "sections",
                  .help = "Outlines in their order.",
                  .kinds = profileKinds,
                  .minimum = 2,
                  .maximum = anyNumber,
                  .use = InputUse::Outline,
                  .asks = "an outline to loft through"})
          .parameter("ruled", &P::ruled, flag(), "Straight from one section to the next instead of smooth through all.")
          .parameter("solid", &P::solid, flag(), "Close both ends; off: an open sheet.")
          .parameter("spacing", &P::spacing, positiveLength(), "Distance of sections that are all drawn in one plane.")
          .parameter("heights", &P::heights, list(length()), "A height for each section, instead of the spacing.")
          .images([](const P& p, const Inputs& inputs) { return placesOf(p, inputs.of(0)); })
          .example("blossom loft base.svg top.svg --spacing 40 -o adapter.step")
          .example("blossom loft a.dxf b.dxf c.dxf --heights 0,15,40 --ruled -o duct.step")
          .evaluate([](const P& p, const Inputs& inputs, const Progress& progress) {
            LoftResult made = loft(sectionsOf(p, inputs.of(0)), {.ruled = p.ruled, .solid = p.solid}, progress);
            return Evaluated{Brep(made.shape, "Loft"), {{"sections", inputs.of(0).size()}}, std::move(made.warnings)};
          }),
      {.activity = "for the loft"});
}

struct PipeParameters {
  PipeCorners corners = PipeCorners::Mitred;
  bool place = true, solid = true;
};

FeatureType pipeFeature() {
  using P = PipeParameters;
  return inWorker(
      feature<P>("modeling.pipe", "Pipe", "A solid that an outline sweeps along a path.")
          .icon("pipe")
          .keywords({"sweep", "tube", "along a path"})
          .produces({ShapeKind::Brep})
          .input({.name = "profile",
                  .help = "The outline that is moved.",
                  .kinds = profileKinds,
                  .use = InputUse::Outline,
                  .asks = "an outline to move along a path"})
          .input({.name = "path",
                  .help = "The curve that it is moved along.",
                  .kinds = {ShapeKind::Curves, ShapeKind::Curve, ShapeKind::Region, ShapeKind::Brep},
                  .use = InputUse::Outline,
                  .asks = "the path to move it along"})
          .parameter("corners", &P::corners, choice({"mitred", "round"}), "What becomes of corners in the path.")
          .parameter(
              "place", &P::place, flag(),
              "Put the origin of the drawing on the start of the path, square to it; off: sweep it from where it lies.")
          .parameter("solid", &P::solid, flag(), solidHelp)
          .example("blossom pipe section.svg path.svg -o rail.step")
          .example("blossom pipe ring.dxf path.dxf --corners round -o tube.step")
          .evaluate([](const P& p, const Inputs& inputs, const Progress& progress) {
            const Shape& profile = inputs.of(0)[0];
            PipeResult made = pipe(profileShape(profile, {}, p.solid), profileShape(inputs.of(1)[0], {}, false),
                                   {.corners = p.corners, .place = p.place}, progress);
            return Evaluated{Brep(made.shape, "Pipe"), Value::object(), std::move(made.warnings)};
          }),
      {.activity = "for the pipe"});
}

}  // namespace

ParameterSpec turn() {
  ParameterSpec spec = angle();
  spec.minimum = -360;
  spec.maximum = 360;
  return spec;
}

void registerProfileFeatures(Registry& registry) {
  registry.addAll(extrudeFeature(), revolveFeature(), loftFeature(), pipeFeature());
}

}  // namespace blossom::modeling
