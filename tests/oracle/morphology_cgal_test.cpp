#include <CGAL/Exact_predicates_exact_constructions_kernel.h>
#include <CGAL/Nef_polyhedron_3.h>
#include <CGAL/Polygon_mesh_processing/measure.h>
#include <CGAL/Polygon_mesh_processing/triangulate_faces.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/boost/graph/convert_nef_polyhedron_to_polygon_mesh.h>
#include <CGAL/minkowski_sum_3.h>

#include "support/morphology.h"
#include "support/support.h"

using namespace blossom;
using namespace blossom::test;

namespace {

using Kernel = CGAL::Exact_predicates_exact_constructions_kernel;
using Nef = CGAL::Nef_polyhedron_3<Kernel>;
using Surface = CGAL::Surface_mesh<Kernel::Point_3>;

Nef nefOf(const Mesh& mesh) {
  Surface surface;
  std::vector<Surface::Vertex_index> vertices;
  for (const Vec3& p : mesh.points) vertices.push_back(surface.add_vertex({p.x(), p.y(), p.z()}));
  for (std::size_t f = 0; f < mesh.faceCount(); ++f) {
    std::vector<Surface::Vertex_index> face;
    for (const int v : mesh.face(f)) face.push_back(vertices[static_cast<std::size_t>(v)]);
    surface.add_face(face);
  }
  return Nef(surface);
}

double volumeOf(const Nef& nef) {
  Surface surface;
  CGAL::convert_nef_polyhedron_to_polygon_mesh(nef, surface, true);
  return CGAL::to_double(CGAL::Polygon_mesh_processing::volume(surface));
}

/// Corners on a coarse grid, so that both sides are given the very same solid.
Mesh onGrid(Mesh mesh) {
  for (Vec3& p : mesh.points)
    for (int k = 0; k < 3; ++k) p[k] = std::round(p[k] * 64) / 64;
  return mesh;
}

Mesh randomSolid(std::mt19937_64& random, int kind) {
  if (kind % 3 == 1) return onGrid(spikyRing(random, 3, 1.2, 4));
  if (kind % 3 == 2) return lBlock();
  return onGrid(spikyCube(random, 2));
}

}  // namespace

/// Volumes against CGAL's own Minkowski sum.
class MorphologyCgalTest : public QObject {
  Q_OBJECT

 private slots:
  void volumesEqualThoseOfCgal() {
    std::mt19937_64 random = seededRandom();
    double worst = 0;
    constexpr int pairs = 4;
    for (int pair = 0; pair < pairs; ++pair) {
      const Mesh a = randomSolid(random, pair), b = pair == 3 ? onGrid(spikyCube(random, 2)) : cornerTetrahedron();
      Nef first = nefOf(a), second = nefOf(b);
      const double expected = volumeOf(CGAL::minkowski_sum_3(first, second));
      const double made = blossom::test::volumeOf(solidSumOf(a, b));
      COMPARE_NEAR(made, expected, 1e-9 * expected);
      worst = std::max(worst, std::abs(made - expected) / expected);
    }
    qInfo("figure cgal_pairs %d", pairs);
    qInfo("figure cgal_error %.3g", worst);
  }
};

QTEST_APPLESS_MAIN(MorphologyCgalTest)
#include "morphology_cgal_test.moc"
