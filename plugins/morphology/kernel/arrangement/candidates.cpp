#include "kernel/arrangement/candidates.h"

#include <algorithm>

namespace blossom::morphology::arrangement {

namespace {

Normal3 negated(const Normal3& n) { return {-n[0], -n[1], -n[2]}; }

/// Sums of corners, each made once.
class Sums {
 public:
  Sums(const Features& a, const Features& b, Points& points)
      : a_(a), b_(b), points_(points), made_(a.points.size() * b.points.size(), -1) {}

  int at(int cornerOfA, int cornerOfB) {
    const auto i = static_cast<std::size_t>(cornerOfA), j = static_cast<std::size_t>(cornerOfB);
    int& made = made_[i * b_.points.size() + j];
    if (made < 0) made = points_.at(a_.points[i] + b_.points[j]);
    return made;
  }

 private:
  const Features &a_, &b_;
  Points& points_;
  std::vector<int> made_;
};

class Search {
 public:
  Search(const Features& a, const Features& b, Planes& planes, Points& points)
      : a_(a), b_(b), planes_(planes), points_(points), sums_(a, b, points) {}

  /// Faces of one at corners of the other.
  void facesAtCorners(bool facesOfA, const Progress& progress) {
    const Features &flat = facesOfA ? a_ : b_, &sharp = facesOfA ? b_ : a_;
    for (const Features::Face& face : flat.faces) {
      progress.check();
      for (std::size_t v = 0; v < sharp.points.size(); ++v) {
        if (!supports(face, sharp.corners[v])) continue;
        Facet facet;
        facet.family = facesOfA ? Family::FaceAndCorner : Family::CornerAndFace;
        const int corner = static_cast<int>(v);
        for (std::size_t k = 0; k < 3; ++k)
          facet.corners[k] = facesOfA ? sums_.at(face.corners[k], corner) : sums_.at(corner, face.corners[k]);
        add(facet, face.normal);
      }
    }
  }

  void edgesAtEdges(const Progress& progress) {
    for (const Features::Edge& e : a_.edges) {
      progress.check();
      for (const Features::Edge& f : b_.edges) edgeAtEdge(e, f);
    }
  }

  std::vector<Facet> found() { return std::move(found_); }

 private:
  static bool supports(const Features::Face& face, const Features::Corner& corner) {
    return corner.isTouched && std::all_of(corner.around.begin(), corner.around.end(),
                                           [&](const Grid3& d) { return slope(face.normal, face.about, d) <= 0; });
  }
  static Grid3 along(const Features& solid, const Features::Edge& edge) {
    return solid.points[static_cast<std::size_t>(edge.to)] - solid.points[static_cast<std::size_t>(edge.from)];
  }
  static int slopeOf(const Features& solid, int face, const Grid3& d) {
    if (face == Features::none) return 0;
    const Features::Face& here = solid.faces[static_cast<std::size_t>(face)];
    return slope(here.normal, here.about, d);
  }

  /// The normal +-(d x e) supports an edge along d when e does not rise over one of its faces and does not fall over the
  /// other.
  void edgeAtEdge(const Features::Edge& e, const Features::Edge& f) {
    const Grid3 d = along(a_, e), g = along(b_, f);
    const int leftA = slopeOf(a_, e.left, g), rightA = slopeOf(a_, e.right, g);
    if (leftA * rightA > 0) return;
    const int leftB = slopeOf(b_, f.left, d), rightB = slopeOf(b_, f.right, d);
    if (leftB * rightB > 0) return;
    const Normal3 normal = cross(d, g);
    if (isZero(normal)) return;
    if (leftA >= 0 && rightA <= 0 && leftB <= 0 && rightB >= 0) add(parallelogram(e, f, true), normal);
    if (leftA <= 0 && rightA >= 0 && leftB >= 0 && rightB <= 0) add(parallelogram(e, f, false), negated(normal));
  }
  Facet parallelogram(const Features::Edge& e, const Features::Edge& f, bool firstThenSecond) {
    Facet facet;
    facet.count = 4;
    facet.corners = {sums_.at(e.from, f.from), sums_.at(e.to, f.from), sums_.at(e.to, f.to), sums_.at(e.from, f.to)};
    if (!firstThenSecond) std::swap(facet.corners[1], facet.corners[3]);
    return facet;
  }
  void add(Facet facet, const Normal3& normal) {
    const auto [plane, sameWay] = planes_.add(normal, points_.grid(facet.corners[0]));
    facet.plane = plane;
    facet.sameWay = sameWay;
    for (std::size_t k = 0; k < facet.count; ++k) points_.note(facet.corners[k], plane);
    found_.push_back(facet);
  }

  const Features &a_, &b_;
  Planes& planes_;
  Points& points_;
  Sums sums_;
  std::vector<Facet> found_;
};

}  // namespace

std::vector<Facet> candidates(const Features& a, const Features& b, Planes& planes, Points& points,
                              const Progress& progress) {
  Search search(a, b, planes, points);
  search.facesAtCorners(true, progress);
  search.facesAtCorners(false, progress);
  search.edgesAtEdges(progress);
  return search.found();
}

}  // namespace blossom::morphology::arrangement
