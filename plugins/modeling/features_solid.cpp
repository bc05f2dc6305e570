#include <optional>
#include <span>
#include <utility>
#include <vector>

#include "core/error.h"
#include "feature/picked_numbers.h"
#include "feature_groups.h"
#include "isolate/in_worker.h"
#include "kernel/parts/boolean.h"
#include "kernel/parts/mesh_solid.h"
#include "kernel/parts/shape_parts.h"
#include "kernel/solid/arrange.h"
#include "kernel/solid/fillet.h"
#include "kernel/solid/shell.h"
#include "profile_input.h"

namespace blossom::modeling {

namespace {

struct BooleanParameters {
  BooleanOperation operation = BooleanOperation::Union;
  double fuzzy = 0;
  bool simplify = true;
};

ParameterSpec smallLength() {
  ParameterSpec spec = length();
  spec.minimum = 0;
  spec.maximum = 10;
  return spec;
}

/// Regions of lines and arcs; nothing where OCCT has to combine them.
std::optional<Region> combinedRegion(const BooleanParameters& p, std::span<const Shape> shapes, const Progress& progress) {
  if (p.fuzzy > 0 || !p.simplify) return std::nullopt;
  std::vector<Region> regions;
  for (const Shape& shape : shapes) {
    if (!shape.get<Region>()) return std::nullopt;
    regions.push_back(*shape.get<Region>());
  }
  std::optional<Region> region = combined(regions, p.operation, progress);
  if (region && region->loops.empty()) refuseNothingLeft(p.operation);
  return region;
}

/// A mesh as the solid that it bounds.
TopoDS_Shape solidShape(const Shape& shape, const Progress& progress) {
  if (const Mesh* mesh = shape.get<Mesh>()) return solidOfMesh(*mesh, progress);
  return asBrep(shape).shape();
}

/// The input of a feature with picked edges or faces, whose numbers are those of the solid.
TopoDS_Shape solidOfPicks(const Inputs& inputs, const std::vector<SubShapeValue>& picked, const Progress& progress) {
  const Shape& shape = inputs.of(0)[0];
  if (shape.kind() == ShapeKind::Mesh && !picked.empty())
    throw Error(ErrorCode::InvalidInput, "Edges and faces are picked of a solid, and this is a mesh.",
                "Make a solid of it with \"Solid from mesh\", then pick them of that.");
  return solidShape(shape, progress);
}

Evaluated booleanOf(const BooleanParameters& p, const Inputs& inputs, const Progress& progress) {
  const auto shapes = inputs.of(0);
  if (auto region = combinedRegion(p, shapes, progress)) {
    Evaluated out;
    out.stats["inputs"] = shapes.size();
    out.shape = *std::move(region);
    return out;
  }
  std::vector<TopoDS_Shape> breps;
  breps.reserve(shapes.size());
  for (const Shape& shape : shapes) {
    if ((shape.kind() == ShapeKind::Region) != (shapes.front().kind() == ShapeKind::Region))
      throw Error(ErrorCode::InvalidInput, "Regions and solids cannot be combined with each other.",
                  "Extrude the region first.");
    breps.push_back(shape.get<Region>() ? profileShape(shape, {}, true) : solidShape(shape, progress));
  }
  BooleanResult made = combine(breps, {p.operation, p.fuzzy, p.simplify}, progress);
  Evaluated out;
  out.stats["inputs"] = shapes.size();
  out.warnings = std::move(made.warnings);
  if (shapes.front().get<Region>())
    out.shape = asRegion(made.shape);
  else
    out.shape = Brep(made.shape);
  return out;
}

FeatureType booleanFeature() {
  using P = BooleanParameters;
  return inWorker(
      feature<P>("modeling.boolean", "Boolean", "Solids or regions united, cut from each other or intersected.")
          .icon("boolean")
          .keywords({"union", "unite", "fuse", "join", "add", "merge", "combine"}, {{"operation", "union"}})
          .keywords({"subtract", "cut", "difference", "hole", "drill", "remove"}, {{"operation", "difference"}})
          .keywords({"intersect", "intersection", "common"}, {{"operation", "intersection"}})
          .produces({ShapeKind::Brep, ShapeKind::Region})
          .input({.name = "shapes",
                  .help = "Solids, or regions. A difference is the first without the others.",
                  .kinds = {ShapeKind::Brep, ShapeKind::Region, ShapeKind::Mesh},
                  .minimum = 2,
                  .maximum = anyNumber,
                  .use = InputUse::Consumed,
                  .asks = "a solid or region to combine"})
          .parameter("operation", &P::operation, choice({"union", "difference", "intersection"}), "The Boolean operation.")
          .parameter("fuzzy", &P::fuzzy, smallLength(), "Faces this close count as touching; 0: only faces that do touch.")
          .parameter("simplify", &P::simplify, flag(), "Join faces on the same surface and edges on the same curve.")
          .example("blossom boolean plate.step pin.step --operation difference -o drilled.step")
          .example("blossom boolean a.step b.step c.step -o all.step")
          .evaluate(booleanOf),
      {.activity = "for the Boolean operation"});
}

InputSpec solidInput(const char* asks) {
  return {.name = "shape",
          .help = "A solid.",
          .kinds = {ShapeKind::Brep, ShapeKind::Mesh},
          .use = InputUse::Consumed,
          .asks = asks};
}

struct FilletParameters {
  double radius = 2;
  std::vector<SubShapeValue> edges;
};

FeatureType filletFeature() {
  using P = FilletParameters;
  return inWorker(
      feature<P>("modeling.fillet", "Fillet", "A solid with rounded edges.")
          .icon("fillet")
          .keywords({"round", "rounding", "blend", "radius", "soft edge"})
          .produces({ShapeKind::Brep})
          .input(solidInput("a solid to round"))
          .parameter("edges", &P::edges, whenNone(list(subShape("edge")), "all sharp edges"), "The edges to round.")
          .parameter("radius", &P::radius, positiveLength(), "Radius of the rounding.")
          .example("blossom fillet block.step --radius 3 -o soft.step")
          .example("blossom fillet block.step --edges shape:edge:0,shape:edge:4 --radius 1.5 -o part.step")
          .evaluate([](const P& p, const Inputs& inputs, const Progress& progress) {
            const FilletResult made =
                fillet(solidOfPicks(inputs, p.edges, progress), {p.radius, numbersOf(p.edges)}, progress);
            return Evaluated{Brep(made.shape), {{"rounded_edges", made.edges}}, {}};
          }),
      {.activity = "for the fillet"});
}

struct ChamferParameters {
  double distance = 2, second = 0;
  std::vector<SubShapeValue> edges;
};

FeatureType chamferFeature() {
  using P = ChamferParameters;
  ParameterSpec second = length();
  second.minimum = 0;
  return inWorker(
      feature<P>("modeling.chamfer", "Chamfer", "A solid with edges cut off by flat strips.")
          .icon("chamfer")
          .keywords({"bevel", "break edge", "slope"})
          .produces({ShapeKind::Brep})
          .input(solidInput("a solid to bevel"))
          .parameter("edges", &P::edges, whenNone(list(subShape("edge")), "all sharp edges"), "The edges to cut off.")
          .parameter("distance", &P::distance, positiveLength(), "Width of the chamfer on both faces.")
          .parameter("second", &P::second, second, "Width on the second of the two faces; 0: as on the first.")
          .example("blossom chamfer block.step --distance 1 -o part.step")
          .example("blossom chamfer block.step --edges shape:edge:2 --distance 2 --second 5 -o part.step")
          .evaluate([](const P& p, const Inputs& inputs, const Progress& progress) {
            const ChamferResult made =
                chamfer(solidOfPicks(inputs, p.edges, progress), {p.distance, p.second, numbersOf(p.edges)}, progress);
            return Evaluated{Brep(made.shape), {{"chamfered_edges", made.edges}}, {}};
          }),
      {.activity = "for the chamfer"});
}

struct ShellParameters {
  double thickness = 2;
  ShellSide side = ShellSide::Inside;
  std::vector<SubShapeValue> faces;
};

FeatureType shellFeature() {
  using P = ShellParameters;
  return inWorker(
      feature<P>("modeling.shell", "Shell", "A solid hollowed out to walls of even thickness.")
          .icon("shell")
          .keywords({"hollow", "thickness", "wall"})
          .produces({ShapeKind::Brep})
          .input(solidInput("a solid to hollow out"))
          .parameter("faces", &P::faces, whenNone(list(subShape("face")), "a closed hollow"), "The faces to open.")
          .parameter("thickness", &P::thickness, positiveLength(), "Thickness of the walls.")
          .parameter("side", &P::side, choice({"inside", "outside"}), "Whether the walls grow into the solid or around it.")
          .example("blossom shell block.step --faces shape:face:5 --thickness 1.5 -o tray.step")
          .evaluate([](const P& p, const Inputs& inputs, const Progress& progress) {
            const ShellResult made =
                shell(solidOfPicks(inputs, p.faces, progress), {p.thickness, p.side, numbersOf(p.faces)}, progress);
            return Evaluated{Brep(made.shape), {{"open_faces", p.faces.size()}}, {}};
          }),
      {.activity = "for the shell"});
}

struct NoParameters {};

FeatureType meshSolidFeature() {
  return inWorker(feature<NoParameters>("modeling.mesh-solid", "Solid from mesh",
                                        "The solid that a closed mesh bounds; what lies in one plane is one face.")
                      .icon("solid")
                      .keywords({"convert", "mesh to solid", "brep", "stl to step", "planar faces"})
                      .produces({ShapeKind::Brep})
                      .input({.name = "mesh",
                              .help = "A closed mesh of at most 20,000 faces.",
                              .kinds = {ShapeKind::Mesh},
                              .use = InputUse::Consumed,
                              .asks = "a mesh to make a solid of"})
                      .example("blossom mesh-solid part.stl -o part.step")
                      .evaluate([](const NoParameters&, const Inputs& inputs, const Progress& progress) {
                        const Mesh& mesh = *inputs.of(0)[0].get<Mesh>();
                        Evaluated out{Brep(solidOfMesh(mesh, progress), mesh.name, mesh.color), Value::object(), {}};
                        out.stats["polygons"] = mesh.faceCount();
                        return out;
                      }),
                  {.activity = "for the solid"});
}

}  // namespace

void registerSolidFeatures(Registry& registry) {
  registry.addAll(booleanFeature(), filletFeature(), chamferFeature(), shellFeature(), meshSolidFeature());
}

}  // namespace blossom::modeling
