
#include "features_outline.h"
#include "core/angle.h"
#include "feature_groups.h"
#include "geometry/planar/single_point.h"
#include "kernel/outline/outline_shapes.h"

namespace blossom::modeling {
namespace {

struct PointParameters {
  Vec3 at = Vec3::Zero();
};

FeatureType pointFeature() {
  using P = PointParameters;
  return feature<P>("modeling.point", "Point", "A point of the plane, out of which a shape can grow in a morph.")
      .icon("point")
      .produces({ShapeKind::Curves})
      .parameter("at", &P::at, point(), "Where it is, in the plane z = 0.")
      .example("blossom point --at 5,-6,0 -o point.svg")
      .evaluate([](const P& p, const Inputs&, const Progress&) -> Evaluated {
        return {Shape(pointDrawing(inPlane(p.at))), Value::object(), {}};
      });
}

Evaluated made(Region region) { return {std::move(region), Value::object(), {}}; }

struct CircleParameters {
  double radius = 10;
  Vec3 center = Vec3::Zero();
};

FeatureType circleFeature() {
  using P = CircleParameters;
  return feature<P>("modeling.circle", "Circle", "A circle, as one exact arc.")
      .icon("circle")
      .produces({ShapeKind::Region})
      .parameter("radius", &P::radius, positiveLength(), "Distance from the centre.")
      .parameter("centre", &P::center, point(), "The centre, in the plane z = 0.")
      .example("blossom circle --radius 25 -o circle.dxf")
      .evaluate([](const P& p, const Inputs&, const Progress&) { return made(circle(p.radius, inPlane(p.center))); });
}

struct EllipseParameters {
  double a = 20, b = 10;
  Vec3 center = Vec3::Zero();
  double rotation = 0;
};

FeatureType ellipseFeature() {
  using P = EllipseParameters;
  return feature<P>("modeling.ellipse", "Ellipse",
                    "An ellipse, as an exact rational curve; a circle when its half-axes are equal.")
      .icon("ellipse")
      .produces({ShapeKind::Region})
      .parameter("a", &P::a, positiveLength(), "First half-axis.")
      .parameter("b", &P::b, positiveLength(), "Second half-axis.")
      .parameter("centre", &P::center, point(), "The centre, in the plane z = 0.")
      .parameter("rotation", &P::rotation, angle(), "Angle from the x axis to the first half-axis.")
      .example("blossom ellipse --a 30 --b 12 --rotation 30 -o ellipse.svg")
      .evaluate([](const P& p, const Inputs&, const Progress&) {
        return made(ellipse(p.a, p.b, inPlane(p.center), toRadians(p.rotation)));
      });
}

enum class PolygonSize { Inscribed, Circumscribed };

struct PolygonParameters {
  int sides = 6;
  double radius = 10;
  PolygonSize size = PolygonSize::Inscribed;
  Vec3 center = Vec3::Zero();
  double rotation = 0;
};

FeatureType polygonFeature() {
  using P = PolygonParameters;
  return feature<P>("modeling.polygon", "Polygon", "A regular polygon.")
      .icon("polygon")
      .keywords({"triangle"}, {{"sides", 3}})
      .keywords({"pentagon"}, {{"sides", 5}})
      .keywords({"hexagon"}, {{"sides", 6}})
      .keywords({"octagon"}, {{"sides", 8}})
      .produces({ShapeKind::Region})
      .parameter("sides", &P::sides, count(3, 10000), "Number of sides.")
      .parameter("radius", &P::radius, positiveLength(), "Radius of the circle around it or inside it.")
      .parameter("size", &P::size, choice({"inscribed", "circumscribed"}),
                 "Whether the corners lie on the circle (inscribed) or the sides touch it (circumscribed).")
      .parameter("centre", &P::center, point(), "The centre, in the plane z = 0.")
      .parameter("rotation", &P::rotation, angle(), "Angle from the x axis to the first corner.")
      .example("blossom polygon --sides 6 --radius 8 --size circumscribed -o nut.dxf")
      .evaluate([](const P& p, const Inputs&, const Progress&) {
        const double radius = p.size == PolygonSize::Inscribed ? p.radius : circumradius(p.sides, p.radius);
        return made(regularPolygon(p.sides, radius, inPlane(p.center), toRadians(p.rotation)));
      });
}

struct StarParameters {
  int points = 5;
  double outer = 20, inner = 8;
  Vec3 center = Vec3::Zero();
  double rotation = 90;
};

FeatureType starFeature() {
  using P = StarParameters;
  return feature<P>("modeling.star", "Star", "A star with straight sides.")
      .icon("star")
      .produces({ShapeKind::Region})
      .parameter("points", &P::points, count(2, 10000), "Number of points.")
      .parameter("outer", &P::outer, positiveLength(), "Distance of the points from the centre.")
      .parameter("inner", &P::inner, positiveLength(), "Distance of the corners between them.")
      .parameter("centre", &P::center, point(), "The centre, in the plane z = 0.")
      .parameter("rotation", &P::rotation, angle(), "Angle from the x axis to the first point.")
      .example("blossom star --points 5 --outer 20 --inner 8 -o star.svg")
      .evaluate([](const P& p, const Inputs&, const Progress&) {
        return made(star(p.points, p.outer, p.inner, inPlane(p.center), toRadians(p.rotation)));
      });
}

struct RectangleParameters {
  double width = 40, height = 20, corner = 0;
  Vec3 center = Vec3::Zero();
  double rotation = 0;
};

FeatureType rectangleFeature() {
  using P = RectangleParameters;
  ParameterSpec corner = length();
  corner.minimum = 0;
  return feature<P>("modeling.rectangle", "Rectangle", "A rectangle with sharp or rounded corners.")
      .icon("rectangle")
      .produces({ShapeKind::Region})
      .parameter("width", &P::width, positiveLength(), "Along x when it is not turned.")
      .parameter("height", &P::height, positiveLength(), "Along y when it is not turned.")
      .parameter("corner", &P::corner, corner, "Radius of the corners; at most half of the shorter side.")
      .parameter("centre", &P::center, point(), "The centre, in the plane z = 0.")
      .parameter("rotation", &P::rotation, angle(), "Rotation about its centre.")
      .example("blossom rectangle --width 60 --height 40 --corner 5 -o plate.dxf")
      .evaluate([](const P& p, const Inputs&, const Progress&) {
        return made(rectangle(p.width, p.height, p.corner, inPlane(p.center), toRadians(p.rotation)));
      });
}

struct SlotParameters {
  double length = 40, width = 10;
  Vec3 center = Vec3::Zero();
  double rotation = 0;
};

FeatureType slotFeature() {
  using P = SlotParameters;
  return feature<P>("modeling.slot", "Slot", "A slot with round ends, as a cutter leaves it.")
      .icon("slot")
      .produces({ShapeKind::Region})
      .parameter("length", &P::length, positiveLength(), "From end to end.")
      .parameter("width", &P::width, positiveLength(), "Across: the diameter of the ends.")
      .parameter("centre", &P::center, point(), "The centre, in the plane z = 0.")
      .parameter("rotation", &P::rotation, angle(), "Angle from the x axis to the length.")
      .example("blossom slot --length 40 --width 8 -o slot.dxf")
      .evaluate([](const P& p, const Inputs&, const Progress&) {
        return made(slot(p.length, p.width, inPlane(p.center), toRadians(p.rotation)));
      });
}

}  // namespace

Vec2 inPlane(const Vec3& p) {
  if (p.z() != 0)
    throw Error(ErrorCode::InvalidParameter, "An outline lies in the plane z = 0; its points have no height of their own.",
                "Set z to 0, and move what you make of the outline instead.");
  return p.head<2>();
}

void registerOutlines(Registry& registry) {
  registry.addAll(circleFeature(), ellipseFeature(), polygonFeature(), starFeature(), rectangleFeature(), slotFeature(),
                  pointFeature(), textFeature(), drawnFeature());
  addOutlineLiterals(registry);
}

}  // namespace blossom::modeling
