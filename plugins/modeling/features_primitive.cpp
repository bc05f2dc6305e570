#include "feature_groups.h"
#include "kernel/solid/primitives.h"

namespace blossom::modeling {

namespace {

/// Every primitive stands somewhere.
struct Placed {
  Vec3 position{0, 0, 0};
  Vec3 axis{0, 0, 1};
  double turn = 0;
  [[nodiscard]] Placement placement() const { return {position, axis, turn}; }
};

struct BoxParameters : Placed {
  double width = 40, depth = 30, height = 20;
  BoxAnchor anchor = BoxAnchor::Corner;
};
struct CylinderParameters : Placed {
  double radius = 10, height = 30, angle = 360;
};
struct ConeParameters : Placed {
  double bottomRadius = 15, topRadius = 0, height = 30, angle = 360;
};
struct SphereParameters : Placed {
  double radius = 15, angle = 360;
};
struct TorusParameters : Placed {
  double radius = 20, tube = 5, angle = 360;
};

ParameterSpec partOfATurn() {
  ParameterSpec spec = angle();
  spec.minimum = 0;
  spec.aboveMinimum = true;
  spec.maximum = 360;
  return spec;
}

template <class P>
FeatureType primitive(FeatureBuilder<P>& builder, TopoDS_Shape (*make)(const P&), const char* title) {
  return builder.parameter("position", static_cast<Vec3 P::*>(&P::position), point(), "Its position.")
      .parameter("axis", static_cast<Vec3 P::*>(&P::axis), vector(), "Direction of its z axis.")
      .parameter("turn", static_cast<double P::*>(&P::turn), angle(), "Rotation about its axis.")
      .produces({ShapeKind::Brep})
      .evaluate([make, title](const P& p, const Inputs&, const Progress&) {
        return Evaluated{Brep(make(p), title), Value::object(), {}};
      });
}

FeatureType box() {
  using P = BoxParameters;
  auto builder = feature<P>("modeling.box", "Box", "A box with three edge lengths.");
  builder.icon("box")
      .keywords({"cube", "block", "cuboid"})
      .parameter("width", &P::width, positiveLength(), "Length along its x axis.")
      .parameter("depth", &P::depth, positiveLength(), "Length along its y axis.")
      .parameter("height", &P::height, positiveLength(), "Length along its axis.")
      .parameter("anchor", &P::anchor, choice({"corner", "base", "centre"}),
                 "The point at the position: a corner, the middle of the base or the middle of the box.")
      .example("blossom box --width 60 --depth 40 --height 10 -o plate.step")
      .example("blossom box --anchor centre --position 0,0,5 -o block.stl");
  return primitive<P>(
      builder,
      [](const P& p) {
        return makeBox(
            {.width = p.width, .depth = p.depth, .height = p.height, .anchor = p.anchor, .placement = p.placement()});
      },
      "Box");
}

FeatureType cylinder() {
  using P = CylinderParameters;
  auto builder = feature<P>("modeling.cylinder", "Cylinder", "A round cylinder, or a wedge of one.");
  builder.icon("cylinder")
      .parameter("radius", &P::radius, positiveLength(), "Radius of the base.")
      .parameter("height", &P::height, positiveLength(), "Length along the axis.")
      .parameter("angle", &P::angle, partOfATurn(), "Less than a full turn leaves a wedge.")
      .example("blossom cylinder --radius 8 --height 40 -o pin.step")
      .example("blossom cylinder --radius 20 --height 5 --angle 90 --axis 1,0,0 -o quarter.stl");
  return primitive<P>(
      builder,
      [](const P& p) {
        return makeCylinder({.radius = p.radius, .height = p.height, .angle = p.angle, .placement = p.placement()});
      },
      "Cylinder");
}

FeatureType cone() {
  using P = ConeParameters;
  auto builder = feature<P>("modeling.cone", "Cone", "A cone, pointed or cut off.");
  builder.icon("cone")
      .parameter("bottom-radius", &P::bottomRadius, lengthFromZero(), "Radius at its position; 0 makes a point.")
      .parameter("top-radius", &P::topRadius, lengthFromZero(), "Radius at its height; 0 makes a point.")
      .parameter("height", &P::height, positiveLength(), "Length along the axis.")
      .parameter("angle", &P::angle, partOfATurn(), "Less than a full turn leaves a wedge.")
      .example("blossom cone --bottom-radius 12 --top-radius 4 --height 25 -o frustum.step");
  return primitive<P>(
      builder,
      [](const P& p) {
        return makeCone({.bottomRadius = p.bottomRadius,
                         .topRadius = p.topRadius,
                         .height = p.height,
                         .angle = p.angle,
                         .placement = p.placement()});
      },
      "Cone");
}

FeatureType sphere() {
  using P = SphereParameters;
  auto builder = feature<P>("modeling.sphere", "Sphere", "A sphere, or a wedge of one.");
  builder.icon("sphere")
      .parameter("radius", &P::radius, positiveLength(), "Distance of the surface from the centre.")
      .parameter("angle", &P::angle, partOfATurn(), "Less than a full turn leaves a wedge.")
      .example("blossom sphere --radius 25 --position 0,0,25 -o ball.step");
  return primitive<P>(
      builder, [](const P& p) { return makeSphere({.radius = p.radius, .angle = p.angle, .placement = p.placement()}); },
      "Sphere");
}

FeatureType torus() {
  using P = TorusParameters;
  auto builder = feature<P>("modeling.torus", "Torus", "A ring of round section.");
  builder.icon("torus")
      .parameter("radius", &P::radius, positiveLength(), "Distance of the tube's middle from the axis.")
      .parameter("tube", &P::tube, positiveLength(), "Radius of the tube; smaller than the radius of the ring.")
      .parameter("angle", &P::angle, partOfATurn(), "Less than a full turn leaves a bend.")
      .example("blossom torus --radius 30 --tube 6 -o ring.step")
      .example("blossom torus --radius 30 --tube 6 --angle 90 -o elbow.step");
  return primitive<P>(
      builder,
      [](const P& p) {
        return makeTorus({.radius = p.radius, .tube = p.tube, .angle = p.angle, .placement = p.placement()});
      },
      "Torus");
}

}  // namespace

void registerPrimitives(Registry& registry) { registry.addAll(box(), cylinder(), cone(), sphere(), torus()); }

}  // namespace blossom::modeling
