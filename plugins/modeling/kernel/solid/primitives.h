#pragma once
#include <TopoDS_Shape.hxx>

#include "kernel/parts/placement.h"

/// Solids with closed forms. Lengths in mm, angles in degrees; O(1).
/// All throw Error InvalidParameter for measures that make no solid.
namespace blossom::modeling {

/// Point of a box that lies at its position.
enum class BoxAnchor { Corner, Base, Centre };

struct BoxOptions {
  double width = 40;   ///< along x
  double depth = 30;   ///< along y
  double height = 20;  ///< along z
  BoxAnchor anchor = BoxAnchor::Corner;
  Placement placement;
};
TopoDS_Shape makeBox(const BoxOptions&);

/// The centre of the base is at the position. An `angle` below 360 makes a wedge.
struct CylinderOptions {
  double radius = 10;
  double height = 30;
  double angle = 360;
  Placement placement;
};
TopoDS_Shape makeCylinder(const CylinderOptions&);

/// One of the radii may be 0; equal ones make a cylinder.
struct ConeOptions {
  double bottomRadius = 15;
  double topRadius = 0;
  double height = 30;
  double angle = 360;
  Placement placement;
};
TopoDS_Shape makeCone(const ConeOptions&);

struct SphereOptions {
  double radius = 15;
  double angle = 360;
  Placement placement;
};
TopoDS_Shape makeSphere(const SphereOptions&);

/// `tube` is the radius of the tube around the circle of `radius`.
struct TorusOptions {
  double radius = 20;
  double tube = 5;
  double angle = 360;
  Placement placement;
};
TopoDS_Shape makeTorus(const TorusOptions&);

}  // namespace blossom::modeling
