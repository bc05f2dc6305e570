#include <map>

#include "exchange/formats.h"
#include "subdivision/kernel/subdivide.h"
#include "support/cages.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;
using namespace blossom::subdivision;

namespace {

/// Largest distance from a point of one set to the nearest of the other, both ways.
double apart(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
  double worst = 0;
  for (const auto& [from, to] : {std::pair(&a, &b), std::pair(&b, &a)})
    for (const Vec3& p : *from) {
      double nearest = std::numeric_limits<double>::infinity();
      for (const Vec3& q : *to) nearest = std::min(nearest, (p - q).squaredNorm());
      worst = std::max(worst, std::sqrt(nearest));
    }
  return worst;
}

std::vector<Vec3> faceCentres(const Mesh& mesh) {
  std::vector<Vec3> centres;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    Vec3 sum = Vec3::Zero();
    for (const int v : mesh.face(f)) sum += mesh.points[static_cast<std::size_t>(v)];
    centres.push_back(sum / static_cast<double>(mesh.face(f).size()));
  }
  return centres;
}

struct EdgeFaces {
  std::vector<std::size_t> faces;
  int point = -1;
};

using Edges = std::map<std::pair<int, int>, EdgeFaces>;

Edges edgesOf(const Mesh& mesh) {
  Edges edges;
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k)
      edges[std::minmax({face[k], face[(k + 1) % face.size()]})].faces.push_back(f);
  }
  return edges;
}

/// One step as Catmull & Clark (1978) print it; boundaries are cubic B-splines whose corners, the vertices of one face,
/// stay.
Mesh catmullClarkStep(const Mesh& mesh) {
  Mesh fine;
  const std::vector<Vec3> centres = faceCentres(mesh);
  Edges edges = edgesOf(mesh);
  const auto at = [&](int v) { return mesh.points[static_cast<std::size_t>(v)]; };
  for (int v = 0; v < static_cast<int>(mesh.points.size()); ++v) {
    Vec3 faces = Vec3::Zero(), middles = Vec3::Zero(), rim = Vec3::Zero();
    int faceCount = 0, edgeCount = 0, rimCount = 0;
    for (std::size_t f = 0; f < mesh.faceCount(); ++f)
      for (const int w : mesh.face(f))
        if (w == v) {
          faces += centres[f];
          ++faceCount;
        }
    for (const auto& [ends, edge] : edges) {
      if (ends.first != v && ends.second != v) continue;
      const Vec3 other = at(ends.first == v ? ends.second : ends.first);
      middles += (at(v) + other) / 2;
      ++edgeCount;
      if (edge.faces.size() != 1) continue;
      rim += other;
      ++rimCount;
    }
    if (rimCount > 0 && faceCount == 1)
      fine.points.push_back(at(v));
    else if (rimCount > 0)
      fine.points.emplace_back(6.0 / 8 * at(v) + rim / 8);
    else
      fine.points.emplace_back((faces / faceCount + 2 * middles / edgeCount + (edgeCount - 3) * at(v)) / edgeCount);
  }
  for (auto& [ends, edge] : edges) {
    edge.point = static_cast<int>(fine.points.size());
    const Vec3 sum = at(ends.first) + at(ends.second);
    fine.points.emplace_back(edge.faces.size() == 1 ? Vec3(sum / 2)
                                                    : Vec3((sum + centres[edge.faces[0]] + centres[edge.faces[1]]) / 4));
  }
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    const int centre = static_cast<int>(fine.points.size());
    fine.points.push_back(centres[f]);
    const auto face = mesh.face(f);
    for (std::size_t k = 0; k < face.size(); ++k) {
      const int here = face[k], next = face[(k + 1) % face.size()], before = face[(k + face.size() - 1) % face.size()];
      addPolygon(fine,
                 {here, edges.at(std::minmax({here, next})).point, centre, edges.at(std::minmax({before, here})).point});
    }
  }
  return fine;
}

/// One step of Loop (1987) on a closed mesh, with his weights.
std::vector<Vec3> loopStep(const Mesh& mesh) {
  const Edges edges = edgesOf(mesh);
  const auto at = [&](int v) { return mesh.points[static_cast<std::size_t>(v)]; };
  std::vector<Vec3> points;
  for (int v = 0; v < static_cast<int>(mesh.points.size()); ++v) {
    Vec3 ring = Vec3::Zero();
    int n = 0;
    for (const auto& [ends, edge] : edges)
      if (ends.first == v || ends.second == v) {
        ring += at(ends.first == v ? ends.second : ends.first);
        ++n;
      }
    const double c = 3.0 / 8 + std::cos(2 * std::numbers::pi / n) / 4;
    const double beta = (5.0 / 8 - c * c) / n;
    points.emplace_back((1 - n * beta) * at(v) + beta * ring);
  }
  for (const auto& [ends, edge] : edges) {
    Vec3 across = Vec3::Zero();
    for (const std::size_t f : edge.faces)
      for (const int v : mesh.face(f))
        if (v != ends.first && v != ends.second) across += at(v);
    points.emplace_back(3.0 / 8 * (at(ends.first) + at(ends.second)) + across / 8);
  }
  return points;
}

Mesh readMesh(const fs::path& path) { return *readShape(standardFormats(), path).shape.get<Mesh>(); }

}  // namespace

/// Refined meshes against positions and rules that share no code with the kernel.
class SubdivisionRefineTest : public QObject {
  Q_OBJECT

 private slots:
  void publishedBaselines() {
    NEED_SHARED_DATA();
    const fs::path folder = sharedData() / "subdivision";
    int compared = 0;
    double worst = 0;
    for (const auto& entry : fs::directory_iterator(folder / "baseline")) {
      const std::string name = entry.path().stem().string();  // catmark_cube_level1
      const std::size_t mark = name.rfind("_level");
      Mesh cage = readMesh(folder / (name.substr(0, mark) + ".obj"));
      // What these positions were made with where the cage does not say it.
      if (std::none_of(cage.otherTags.begin(), cage.otherTags.end(),
                       [](const std::string& tag) { return tag.find("interpolateboundary") != std::string::npos; }))
        cage.otherTags.emplace_back("t interpolateboundary 1/0/0 2");
      // They count the first refinement as level 0.
      const Scheme scheme = name.starts_with("loop") ? Scheme::Loop : Scheme::CatmullClark;
      const Mesh fine = subdivide(cage, {.scheme = scheme, .levels = name.back() - '0' + 1}).mesh;
      const Mesh wanted = readMesh(entry.path());
      QCOMPARE(fine.points.size(), wanted.points.size());
      QCOMPARE(fine.faceCount(), wanted.faceCount());
      const double distance = std::max(apart(fine.points, wanted.points), apart(faceCentres(fine), faceCentres(wanted)));
      qInfo("%s: %.2g", name.c_str(), distance);
      QVERIFY2(distance < 1e-6, name.c_str());
      worst = std::max(worst, distance);
      ++compared;
    }
    qInfo("figure baseline_files %d", compared);
    qInfo("figure baseline_error %.3g", worst);
    QVERIFY(compared >= 20);
  }

  void catmullClarkByHand() {
    auto random = seededRandom();
    for (int k = 0; k < 60; ++k) {
      Mesh cage = k % 3 == 0   ? prism(3 + k % 6)
                  : k % 3 == 1 ? torusCage(3 + k % 4, 3 + k % 5)
                               : gridCage(2 + k % 4, 2 + k % 3);
      if (k % 4 == 1 && k % 3 != 2) cage = withoutFace(cage, static_cast<std::size_t>(k) % cage.faceCount());
      cage = jittered(cage, random, 0.4);
      Mesh wanted = cage;
      for (int level = 1; level <= 2; ++level) {
        wanted = catmullClarkStep(wanted);
        const Mesh fine = subdivide(cage, {.levels = level}).mesh;
        QCOMPARE(fine.points.size(), wanted.points.size());
        QVERIFY(apart(fine.points, wanted.points) < 1e-12);
        QVERIFY(apart(faceCentres(fine), faceCentres(wanted)) < 1e-12);
      }
    }
  }

  void loopByHand() {
    auto random = seededRandom();
    for (int k = 0; k < 20; ++k) {
      const Mesh cage = jittered(octahedron(), random, 0.3);
      const Mesh first = subdivide(cage, {.scheme = Scheme::Loop, .levels = 1}).mesh;
      QVERIFY(apart(first.points, loopStep(cage)) < 1e-12);
      const Mesh second = subdivide(cage, {.scheme = Scheme::Loop, .levels = 2}).mesh;
      QVERIFY(apart(second.points, loopStep(first)) < 1e-12);
    }
  }
};

BLOSSOM_TEST(SubdivisionRefineTest)
#include "subdivision_refine_test.moc"
