#include <BRepBuilderAPI_MakeVertex.hxx>
#include <BRepExtrema_DistShapeShape.hxx>
#include <map>

#include "app/sample_maker.h"
#include "feature/frame_by_frame.h"
#include "kernel/parts/placement.h"
#include "kernel/parts/shape_parts.h"

namespace {

using namespace blossom;

/// A document in the making, evaluated as it grows, so that edges and faces can be named by a point on them.
class Model {
 public:
  explicit Model(const App& app) : app_(app) {}

  /// Adds a feature and hides its inputs.
  FeatureId add(const char* command, const char* name, Value parameters, const std::vector<FeatureId>& inputs = {}) {
    const auto type = app_.registry->at(command);
    Feature feature{document_.freshId(command), type->id, name, std::move(parameters), inputs, true, false, Value::object()};
    std::vector<Shape> shapes;
    for (const FeatureId& input : inputs) {
      shapes.push_back(shapes_.at(input));
      Feature hidden = document_.at(input);
      hidden.visible = false;
      document_ = document_.with(std::move(hidden));
    }
    shapes_[feature.id] =
        evaluatedFeature(*type, completed(type->parameters, feature.parameters), arrangedInputs(*type, shapes), {}).shape;
    document_ = document_.with(feature);
    return feature.id;
  }

  [[nodiscard]] Value edge(const FeatureId& id, const Vec3& at) const { return nearest(id, at, TopAbs_EDGE, "edge"); }
  [[nodiscard]] Value face(const FeatureId& id, const Vec3& at) const { return nearest(id, at, TopAbs_FACE, "face"); }
  [[nodiscard]] const Document& document() const { return document_; }

 private:
  [[nodiscard]] Value nearest(const FeatureId& id, const Vec3& at, TopAbs_ShapeEnum type, const char* kind) const {
    const TopoDS_Shape point = BRepBuilderAPI_MakeVertex(modeling::toPoint(at)).Shape();
    const auto parts = modeling::subShapesOf(shapes_.at(id).get<Brep>()->shape(), type);
    for (std::size_t i = 0; i < parts.size(); ++i)
      if (BRepExtrema_DistShapeShape(parts[i], point).Value() < 1e-6)
        return {{"input", "shape"}, {"kind", kind}, {"index", i}};
    throw Error(ErrorCode::NotFound, fmt::format("No {} of {} passes through the point wanted.", kind, id));
  }

  const App& app_;
  Document document_;
  std::map<FeatureId, Shape> shapes_;
};

Document bracket(const App& app) {
  Model m(app);
  const auto plate = m.add("box", "Foot", {{"width", 80}, {"depth", 60}, {"height", 8}});
  const auto wall = m.add("box", "Wall", {{"width", 80}, {"depth", 8}, {"height", 60}, {"position", {0, 52, 0}}});
  const auto angle = m.add("boolean", "Angle", {{"operation", "union"}}, {plate, wall});
  const Value corners = {m.edge(angle, {0, 0, 4}), m.edge(angle, {80, 0, 4}), m.edge(angle, {0, 56, 60}),
                         m.edge(angle, {80, 56, 60})};
  const auto round = m.add("fillet", "Round corners", {{"edges", corners}, {"radius", 12}}, {angle});
  const auto neck = m.add("fillet", "Neck", {{"edges", {m.edge(round, {40, 52, 8})}}, {"radius", 10}}, {round});
  const auto bolt = m.add("cylinder", "Bolt", {{"radius", 4.5}, {"height", 20}, {"position", {16, 16, -5}}});
  const auto bolts = m.add("pattern", "Bolts", {{"count", 2}, {"step", {48, 0, 0}}}, {bolt});
  const auto shaft =
      m.add("cylinder", "Shaft", {{"radius", 14}, {"height", 20}, {"axis", {0, 1, 0}}, {"position", {40, 47, 36}}});
  const auto drilled = m.add("boolean", "Drilled", {{"operation", "difference"}}, {neck, bolts, shaft});
  m.add("chamfer", "Bracket", {{"edges", {m.edge(drilled, {54, 52, 36}), m.edge(drilled, {54, 60, 36})}}, {"distance", 1}},
        {drilled});
  return m.document();
}

Document flange(const App& app) {
  Model m(app);
  const auto rim = m.add("rectangle", "Rim", {{"width", 34}, {"height", 10}, {"centre", {33, 5, 0}}});
  const auto neck = m.add("rectangle", "Neck", {{"width", 9}, {"height", 40}, {"centre", {20.5, 20, 0}}});
  const auto section = m.add("boolean", "Section", {{"operation", "union"}}, {rim, neck});
  const auto body = m.add("revolve", "Body", Value::object(), {section});
  const auto upright = m.add("transform", "Upright", {{"angle", 90}, {"axis", {1, 0, 0}}}, {body});
  const auto root = m.add("fillet", "Root", {{"edges", {m.edge(upright, {0, 25, 10})}}, {"radius", 6}}, {upright});
  const auto bolt = m.add("cylinder", "Bolt", {{"radius", 4}, {"height", 30}, {"position", {39, 0, -10}}});
  const auto bolts = m.add("pattern", "Bolts", {{"kind", "circular"}, {"count", 8}}, {bolt});
  const auto drilled = m.add("boolean", "Drilled", {{"operation", "difference"}}, {root, bolts});
  const Value rims = {m.edge(drilled, {0, 50, 10}), m.edge(drilled, {0, 50, 0}), m.edge(drilled, {0, 25, 40})};
  m.add("chamfer", "Flange", {{"edges", rims}, {"distance", 1.5}}, {drilled});
  return m.document();
}

Document duct(const App& app) {
  Model m(app);
  const auto inlet = m.add("rectangle", "Inlet", {{"width", 70}, {"height", 40}, {"corner", 8}});
  const auto outlet = m.add("circle", "Outlet", {{"radius", 18}, {"centre", {20, 0, 0}}});
  const auto body = m.add("loft", "Body", {{"spacing", 80}}, {inlet, outlet});
  m.add("shell", "Duct", {{"faces", {m.face(body, {0, 0, 0}), m.face(body, {20, 0, 80})}}, {"thickness", 2}}, {body});
  return m.document();
}

Value segment(const char* kind, const Vec2& to, bool tangent = false) {
  return {{"kind", kind}, {"to", {to.x(), to.y(), 0}}, {"tangent", tangent}};
}

Document keyTag(const App& app) {
  Model m(app);
  const Value around = {segment("line", {70, 0}), segment("arc", {70, 30}, true), segment("line", {0, 30}),
                        segment("arc", {0, 0}, true)};
  const auto outline = m.add("outline", "Outline", {{"segments", around}});
  const auto hole = m.add("circle", "Eye", {{"radius", 4}, {"centre", {77, 15, 0}}});
  const auto flat = m.add("boolean", "Blank", {{"operation", "difference"}}, {outline, hole});
  const auto plate = m.add("extrude", "Plate", {{"height", 3}}, {flat});
  const auto text = m.add("text", "Name", {{"text", "Blossom"}, {"style", "bold"}, {"height", 11}, {"at", {-7, 9.5, 0}}});
  const auto letters = m.add("extrude", "Letters", {{"height", 4.5}}, {text});
  m.add("boolean", "Key tag", {{"operation", "union"}}, {plate, letters});
  return m.document();
}

}  // namespace

/// make_modeling_samples FOLDER: writes the sample documents of ordinary CAD.
int main(int argc, char** argv) {
  return samples::run(argc, argv, [](const App& app, const std::filesystem::path& folder) {
    saveDocument(bracket(app), folder / "bracket.blossom");
    saveDocument(flange(app), folder / "flange.blossom");
    saveDocument(duct(app), folder / "duct.blossom");
    saveDocument(keyTag(app), folder / "key-tag.blossom");
  });
}
