#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>

#include "app/sample_maker.h"
#include "exchange/format/format.h"
#include "kernel/subdivide.h"

namespace {

using namespace blossom;
namespace fs = std::filesystem;

/// A document under construction. Inputs of a feature are hidden, unless they are to be shown beside the result.
class Sample {
 public:
  Sample(const App& app, fs::path scratch) : app_(app), scratch_(std::move(scratch)) {}

  FeatureId add(const char* command, const char* name, Value parameters, const std::vector<FeatureId>& inputs = {}) {
    const auto type = app_.registry->at(command);
    Feature feature{document_.freshId(command), type->id, name, std::move(parameters), inputs, true, false, Value::object()};
    document_ = document_.with(feature);
    return feature.id;
  }
  /// A mesh as an import that the document carries in itself.
  FeatureId import(const Mesh& mesh, const char* name, const char* file) {
    writeShape(*app_.formats, mesh, scratch_ / file);
    FeatureId id;
    document_ = withImported(app_, document_, scratch_ / file, &id);
    Feature feature = document_.at(id);
    feature.name = name;
    document_ = document_.with(feature);
    return id;
  }
  FeatureId importPoints(const std::vector<Vec3>& points, const char* name, const char* file) {
    std::string text;
    for (const Vec3& p : points) text += fmt::format("{:.4f} {:.4f} {:.4f}\n", p.x(), p.y(), p.z());
    std::FILE* out = std::fopen((scratch_ / file).c_str(), "w");
    if (!out) throw Error(ErrorCode::FileUnwritable, "The points cannot be written.");
    std::fputs(text.c_str(), out);
    std::fclose(out);
    FeatureId id;
    document_ = withImported(app_, document_, scratch_ / file, &id);
    Feature feature = document_.at(id);
    feature.name = name;
    document_ = document_.with(feature);
    return id;
  }
  void hide(const FeatureId& id) {
    Feature feature = document_.at(id);
    feature.visible = false;
    document_ = document_.with(std::move(feature));
  }
  [[nodiscard]] const Document& document() const { return document_; }

 private:
  const App& app_;
  fs::path scratch_;
  Document document_;
};

Value listOf(const std::vector<Vec3>& points) {
  Value list = Value::array();
  for (const Vec3& p : points) list.push_back({p.x(), p.y(), p.z()});
  return list;
}

/// columns x rows quads over (u, v) in the unit square; closed in u, in v, or not.
template <class Place>
Mesh quads(int columns, int rows, bool closedU, bool closedV, const Place& place) {
  Mesh mesh;
  const int nu = columns + (closedU ? 0 : 1), nv = rows + (closedV ? 0 : 1);
  for (int j = 0; j < nv; ++j)
    for (int i = 0; i < nu; ++i)
      mesh.points.push_back(place(static_cast<double>(i) / columns, static_cast<double>(j) / rows));
  const auto at = [&](int i, int j) { return (j % nv) * nu + i % nu; };
  for (int j = 0; j < rows; ++j)
    for (int i = 0; i < columns; ++i) mesh.addFace(std::array{at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)});
  return mesh;
}

/// The curve of Li 2007: a part of it is drawn anew, and the control points on the side to which the drawing bulges follow.
Document pulledCurve(const App& app, const fs::path& scratch) {
  Sample m(app, scratch);
  std::vector<Vec3> polygon;
  for (int i = 0; i <= 14; ++i) polygon.emplace_back(10.0 * i, 12 * std::sin(i * 0.9) + 0.02 * (i - 7) * (i - 7), 0);
  const auto control = m.add("stroke", "Control polygon", {{"points", listOf(polygon)}, {"smooth", false}});
  const auto drawn =
      m.add("stroke", "What is wanted",
            {{"points", listOf({{58, -8.5, 0}, {66, 3, 0}, {74, 18, 0}, {82, 24, 0}, {92, 19, 0}, {104, 1, 0}})}});
  m.add("subdivide", "Before", {{"scheme", "cubic"}, {"as", "faces"}}, {control});
  m.add("deform", "Pulled curve", {{"scheme", "cubic"}, {"free", "paper"}, {"as", "faces"}}, {control, drawn});
  m.hide(control);
  return m.document();
}

/// The surface of Li 2007: samples over a part of a roof, a plane through three of them, and the control points above it.
Document pulledSurface(const App& app, const fs::path& scratch) {
  Sample m(app, scratch);
  const auto roof = [](double x, double y) { return 22 - (x * x + y * y) / 260 + 3 * std::sin(x / 14) * std::cos(y / 17); };
  const Mesh cage = quads(12, 12, false, false, [&](double u, double v) {
    const double x = 120 * u - 60, y = 120 * v - 60;
    return Vec3(x, y, roof(x, y));
  });
  std::vector<Vec3> samples;
  for (int i = -4; i <= 4; ++i)
    for (int j = -4; j <= 4; ++j) {
      const double x = 6.0 * i, y = 6.0 * j, r = std::hypot(x, y);
      if (r <= 26)
        samples.emplace_back(x + 8, y - 6, roof(x + 8, y - 6) + 15 * std::pow(std::cos(r / 26 * std::numbers::pi / 2), 2));
    }
  const auto control = m.import(cage, "Control mesh", "roof.obj");
  const auto wanted = m.importPoints(samples, "What is wanted", "samples.xyz");
  const auto pulled = m.add("deform", "Pulled mesh", {{"free", "paper"}, {"lambda", 1e-3}}, {control, wanted});
  m.add("subdivide", "Roof", {{"levels", 3}, {"as", "limit"}}, {pulled});
  m.hide(control);
  m.hide(wanted);
  m.hide(pulled);
  return m.document();
}

/// A box that is rounded by its subdivision, and a stroke over its back that the hand wants.
Document handMouse(const App& app, const fs::path& scratch) {
  Sample m(app, scratch);
  Mesh box = quads(4, 1, true, false, [](double u, double v) {
    const double angle = 2 * std::numbers::pi * (u + 0.125);
    return Vec3(std::cos(angle) * std::numbers::sqrt2, std::sin(angle) * std::numbers::sqrt2, 2 * v - 1);
  });
  box.addFace(std::array{3, 2, 1, 0});
  box.addFace(std::array{4, 5, 6, 7});
  Mesh body = subdivision::subdivide(box, {.levels = 3}).mesh;
  for (Vec3& p : body.points) p = Vec3(78 * p.x(), 44 * p.y(), p.z() > 0 ? 34 * p.z() : 14 * p.z());
  const auto cage = m.import(body, "Body", "body.obj");
  const auto back = m.add("stroke", "Line of the back",
                          {{"points", listOf({{-50, 0, 26}, {-32, 0, 36}, {-8, 0, 39}, {16, 0, 33}, {40, 0, 24.5}})}});
  const auto pulled = m.add("deform", "Pulled to the line", {{"free", "rings:1"}, {"lambda", 1e-2}}, {cage, back});
  m.add("subdivide", "Mouse", {{"levels", 2}, {"as", "limit"}}, {pulled});
  m.hide(cage);
  m.hide(pulled);
  return m.document();
}

/// Six limit points of a ring are pulled outwards; all of it is one B-spline face, exactly.
Document crown(const App& app, const fs::path& scratch) {
  Sample m(app, scratch);
  const Mesh ring = quads(24, 8, true, true, [](double u, double v) {
    const double a = 2 * std::numbers::pi * u, b = 2 * std::numbers::pi * v, r = 40 + 9 * std::cos(b);
    return Vec3(r * std::cos(a), r * std::sin(a), 9 * std::sin(b));
  });
  const auto cage = m.import(ring, "Ring", "ring.obj");
  const Mesh limit = subdivision::subdivide(ring, {.levels = 0, .limit = true}).mesh;
  Value pulls = Value::array();
  for (std::size_t i = 0; i < 24; i += 4) {
    const Vec3 at = limit.points[2 * 24 + i], to = at + Vec3(0, 0, 12) + 0.12 * Vec3(at.x(), at.y(), 0);
    pulls.push_back({{"at", {at.x(), at.y(), at.z()}}, {"to", {to.x(), to.y(), to.z()}}});
  }
  const auto pulled = m.add("deform", "Pulled ring", {{"pulls", pulls}}, {cage});
  m.add("subdivide", "Crown", {{"as", "faces"}}, {pulled});
  m.hide(cage);
  m.hide(pulled);
  return m.document();
}

}  // namespace

/// make_subdivision_samples FOLDER: writes the sample documents of subdivision.
int main(int argc, char** argv) {
  return samples::run(argc, argv, [](const App& app, const std::filesystem::path& folder) {
    const fs::path scratch = fs::temp_directory_path() / "blossom-subdivision-samples";
    fs::create_directories(scratch);
    saveDocument(pulledCurve(app, scratch), folder / "pulled-curve.blossom");
    saveDocument(pulledSurface(app, scratch), folder / "pulled-surface.blossom");
    saveDocument(handMouse(app, scratch), folder / "hand-mouse.blossom");
    saveDocument(crown(app, scratch), folder / "crown.blossom");
    fs::remove_all(scratch);
  });
}
