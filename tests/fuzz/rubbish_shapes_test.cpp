// Shapes that no reader should give and that yet reach a feature: every feature type that is registered, of every plugin,
// refuses them with a sentence and a remedy or makes something sound of them. Where the rubbish is in one place, the
// sentence names it.
#include <fmt/format.h>

#include <cctype>
#include <limits>

#include "document/evaluator.h"
#include "geometry/shape/bounds.h"
#include "support/modeling.h"
#include "support/solids.h"

using namespace blossom;
using namespace blossom::test;

namespace {

constexpr double nan = std::numeric_limits<double>::quiet_NaN();

struct Rubbish {
  std::string name;
  Shape shape;
  bool hasPlace = true;  ///< there is a point where it is wrong
};

Mesh cube() { return boxMesh({0, 0, 0}, {10, 10, 10}); }

Mesh with(Mesh mesh, int vertex, const Vec3& at) {
  mesh.points[static_cast<std::size_t>(vertex)] = at;
  return mesh;
}

Mesh openCube() {
  Mesh mesh = cube();
  mesh.faceStarts.pop_back();
  mesh.faceVertices.resize(static_cast<std::size_t>(mesh.faceStarts.back()));
  return mesh;
}

/// Two cubes put through one another as one mesh.
Mesh crossingCubes() {
  Mesh mesh = cube();
  const Mesh other = boxMesh({5, 5, 5}, {10, 10, 10});
  const int first = static_cast<int>(mesh.points.size());
  mesh.points.insert(mesh.points.end(), other.points.begin(), other.points.end());
  for (std::size_t f = 0; f < other.faceCount(); ++f) {
    std::vector<int> face(other.face(f).begin(), other.face(f).end());
    for (int& v : face) v += first;
    mesh.addFace(face);
  }
  return mesh;
}

/// A third face on an edge.
Mesh finnedCube() {
  Mesh mesh = cube();
  mesh.points.emplace_back(5, -5, -5);
  const int fin[3] = {0, 1, 8};
  mesh.addFace(fin);
  return mesh;
}

Mesh facesBeyondTheirPoints() {
  Mesh mesh = cube();
  const int face[3] = {0, 1, 99};
  mesh.addFace(face);
  return mesh;
}

Region bowTie() { return {{polygon({{0, 0}, {10, 10}, {10, 0}, {0, 10}})}}; }

Region crossingLoops() {
  return {{polygon({{0, 0}, {10, 0}, {10, 10}, {0, 10}}), polygon({{5, 5}, {15, 5}, {15, 15}, {5, 15}})}};
}

Region openLoop() { return {{polygon({{0, 0}, {10, 0}, {10, 10}}, false)}}; }

Region splineWith(const Vec3& pole) {
  Path path = polygon({{0, 0}, {10, 0}, {10, 10}}, false);
  path.closed = true;
  path.segments.emplace_back(Spline2{2, {0, 0, 0, 1, 1, 1}, {{10, 10, 1}, pole, {0, 0, 1}}});
  return {{path}};
}

Toolpath program() {
  Toolpath path;
  path.cutter.diameter = 2;
  path.start = {0, 0, 5};
  path.moves = {{MoveKind::Rapid, {3, 3, 5}}, {MoveKind::Plunge, {3, 3, -1}}, {MoveKind::Feed, {7, 3, -1}}};
  return path;
}

/// Something that every feature type takes gladly, and as one of several smaller.
Shape goodShape(ShapeKind kind, double size = 10) {
  switch (kind) {
    case ShapeKind::Region:
      return rectangle(0, 0, size, size);
    case ShapeKind::Curves:
      return Curves{{polygon({{2, 2}, {4, 5}, {8, 6}}, false)}};
    case ShapeKind::Curve:
      return Curve{2, {0, 0, 0, 1, 1, 1}, {{2, 2, 12, 1}, {5, 5, 13, 1}, {8, 6, 12, 1}}};
    case ShapeKind::Brep:
      return made("box").shape;
    case ShapeKind::Mesh:
      return boxMesh({0, 0, 0}, Vec3::Constant(size));
    case ShapeKind::Toolpath:
      return program();
    case ShapeKind::Setup:
      return made("setup", {{"stock-below", 20}, {"zero", "drawing"}}, {rectangle(0, 0, 40, 40)}).shape;
    default:
      return {};
  }
}

std::vector<Rubbish> rubbishOf(ShapeKind kind) {
  switch (kind) {
    case ShapeKind::Region:
      return {{"nothing at all", Region{}, false},
              {"a loop without segments", Region{{Path{}}}, false},
              {"a bow tie", bowTie()},
              {"loops that cross", crossingLoops()},
              {"an open loop", openLoop()},
              {"no area", Region{{polygon({{0, 0}, {10, 0}, {5, 0}})}}},
              {"a corner that is no number", Region{{polygon({{0, 0}, {10, 0}, {nan, 10}})}}, false},
              {"an infinite corner", Region{{polygon({{0, 0}, {10, 0}, {INFINITY, 10}})}}, false},
              {"a pole that is no number", splineWith({nan, 5, 1}), false},
              {"a pole of no weight", splineWith({0, 10, 0}), false}};
    case ShapeKind::Curves:
      return {{"nothing at all", Curves{}, false},
              {"a path without segments", Curves{{Path{}}}, false},
              {"a point that is no number", Curves{{polygon({{0, 0}, {nan, 4}, {8, 6}}, false)}}, false},
              {"a line of no length", Curves{{polygon({{3, 3}, {3, 3}}, false)}}, false}};
    case ShapeKind::Curve:
      return {{"no poles", Curve{}, false},
              {"a pole that is no number", Curve{1, {0, 0, 1, 1}, {{0, 0, 0, 1}, {nan, 0, 0, 1}}}, false},
              {"knots that fall", Curve{1, {0, 1, 0, 1}, {{0, 0, 0, 1}, {1, 0, 0, 1}}}, false}};
    case ShapeKind::Mesh:
      return {{"nothing at all", Mesh{}, false},
              {"points alone",
               [] {
                 Mesh mesh;
                 mesh.points = cube().points;
                 return mesh;
               }(),
               false},
              {"an open box", openCube()},
              {"boxes through one another", crossingCubes(), false},
              {"a box pulled through itself", with(cube(), 7, {5, 5, -20})},
              {"three faces on an edge", finnedCube()},
              {"a corner that is no number", with(cube(), 3, {nan, 10, 0}), false},
              {"an infinite corner", with(cube(), 3, {INFINITY, 10, 0}), false},
              {"a face beyond the points", facesBeyondTheirPoints(), false}};
    case ShapeKind::Brep:
      return {{"nothing at all", Brep(TopoDS_Shape(), "nothing"), false}};
    case ShapeKind::Toolpath: {
      Toolpath broken = program();
      broken.moves[1].to.z() = nan;
      return {{"no moves", Toolpath{}, false}, {"a move to no number", broken, false}};
    }
    default:
      return {};
  }
}

bool namesPlace(const std::string& message) {
  return std::any_of(message.begin(), message.end(), [](unsigned char c) { return std::isdigit(c) != 0; });
}

bool isSentence(const std::string& text) { return text.size() > 10 && (text.ends_with('.') || text.ends_with('?')); }

/// What no feature may make anything of.
bool isHopeless(const Rubbish& rubbish) {
  return rubbish.name.find("no number") != std::string::npos || rubbish.name.find("infinite") != std::string::npos ||
         rubbish.name.find("beyond") != std::string::npos;
}

/// Where drawn curves do as well, nobody asks for an area.
bool isHarmless(const Rubbish& rubbish, const InputSpec& spec) {
  return (rubbish.name == "a bow tie" || rubbish.name == "no area") &&
         std::find(spec.kinds.begin(), spec.kinds.end(), ShapeKind::Curves) != spec.kinds.end();
}

bool isFinite(const Shape& shape) {
  const Bounds box = bounds(shape);
  return box.empty || (box.low.allFinite() && box.high.allFinite());
}

}  // namespace

class RubbishShapesTest : public QObject {
  Q_OBJECT

 private slots:
  void everyFeatureTypeRefuses_data() {
    QTest::addColumn<QString>("type");
    QTest::addColumn<int>("input");
    QTest::addColumn<int>("kind");
    QTest::addColumn<int>("rubbish");
    for (const auto& type : theApp().registry->types())
      for (std::size_t input = 0; input < type->inputs.size(); ++input)
        for (const ShapeKind kind : kindsOf(type->inputs[input])) {
          const auto all = rubbishOf(kind);
          for (std::size_t r = 0; r < all.size(); ++r)
            QTest::addRow("%s, %s: %s, %s", type->id.c_str(), type->inputs[input].name.c_str(),
                          std::string(shapeKindName(kind)).c_str(), all[r].name.c_str())
                << QString::fromStdString(type->id) << int(input) << int(kind) << int(r);
        }
  }

  void everyFeatureTypeRefuses() {
    QFETCH(QString, type);
    QFETCH(int, input);
    QFETCH(int, kind);
    QFETCH(int, rubbish);
    const auto& declared = *theApp().registry->at(type.toStdString());
    const Rubbish given = rubbishOf(static_cast<ShapeKind>(kind))[static_cast<std::size_t>(rubbish)];
    try {
      const Shape shape = evaluated(declared, static_cast<std::size_t>(input), given.shape);
      QVERIFY2(!isHopeless(given), "it was taken");
      QVERIFY2(isFinite(shape), "what it made is not finite");
      ++taken_;
    } catch (const Error& error) {
      const std::string told = fmt::format("{}: {} [{}]", errorCodeName(error.code()), error.message(), error.hint());
      if (qEnvironmentVariableIsSet("BLOSSOM_SHOW_REFUSALS")) qInfo("%s", told.c_str());
      const bool isOfTheUser = error.code() == ErrorCode::InvalidInput || error.code() == ErrorCode::InvalidParameter ||
                               error.code() == ErrorCode::Degenerate || error.code() == ErrorCode::LimitExceeded;
      QVERIFY2(isOfTheUser, told.c_str());
      QVERIFY2(isSentence(error.message()), told.c_str());
      QVERIFY2(isSentence(error.hint()), told.c_str());
      if (given.hasPlace && !isHarmless(given, declared.inputs[static_cast<std::size_t>(input)]))
        QVERIFY2(namesPlace(error.message()), told.c_str());
      ++refused_;
    }
  }

  /// Else the features above might have refused for another reason.
  void goodShapesAreTaken() {
    for (const char* command : {"morph", "minkowski-sum", "minkowski-difference", "solid-sum", "solid-morph", "offset",
                                "medial-axis", "pocket", "subdivide"}) {
      const auto& type = *theApp().registry->at(command);
      const ShapeKind kind = type.inputs[0].kinds.front();
      try {
        QVERIFY2(!evaluated(type, 0, goodShape(kind)).empty(), command);
      } catch (const Error& error) {
        QFAIL(qPrintable(QStringLiteral("%1: %2").arg(QLatin1String(command), QString::fromStdString(error.message()))));
      }
    }
  }

  void cleanupTestCase() {
    qInfo("figure refused %d", refused_);
    qInfo("figure taken %d", taken_);
  }

 private:
  static std::vector<ShapeKind> kindsOf(const InputSpec& spec) {
    if (!spec.kinds.empty()) return spec.kinds;
    return {ShapeKind::Region, ShapeKind::Curves, ShapeKind::Curve, ShapeKind::Brep, ShapeKind::Mesh, ShapeKind::Toolpath};
  }

  /// The feature type with its defaults, `shape` for one input and something good for the others.
  static Shape evaluated(const FeatureType& type, std::size_t input, const Shape& shape) {
    std::vector<Shape> given;
    for (std::size_t k = 0; k < type.inputs.size(); ++k) {
      const std::size_t first = given.size();
      const ShapeKind kind = kindsOf(type.inputs[k]).front();
      given.resize(first + std::max<std::size_t>(1, type.inputs[k].minimum), goodShape(kind, 2));
      if (first == 0) given[0] = goodShape(kind, 40);
      if (k == input) given[first] = shape;
    }
    return evaluatedFeature(type, completed(type.parameters, Value::object()), arrangedInputs(type, given), Progress::none())
        .shape;
  }

  int refused_ = 0, taken_ = 0;
};

BLOSSOM_TEST(RubbishShapesTest)
#include "rubbish_shapes_test.moc"
