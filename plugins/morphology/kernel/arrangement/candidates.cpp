#include "kernel/arrangement/candidates.h"

#include <algorithm>
#include <unordered_map>

namespace blossom::morphology::arrangement {

namespace {

Normal3 negated(const Normal3& n) { return {-n[0], -n[1], -n[2]}; }

/// Sums of corners, each made once. Few of all pairs of corners of large shapes make any.
class Sums {
 public:
  Sums(const Features& a, const Features& b, Points& points) : a_(a), b_(b), points_(points) {}

  int at(int cornerOfA, int cornerOfB) {
    const auto i = static_cast<std::size_t>(cornerOfA), j = static_cast<std::size_t>(cornerOfB);
    const auto [it, fresh] = made_.try_emplace(i * b_.points.size() + j, 0);
    if (fresh) it->second = points_.at(a_.points[i] + b_.points[j]);
    return it->second;
  }

 private:
  const Features &a_, &b_;
  Points& points_;
  std::unordered_map<std::size_t, int> made_;
};

class Search {
 public:
  Search(const Features& a, const Features& b, Planes& planes, Points& points)
      : a_(a), b_(b), planes_(planes), points_(points), sums_(a, b, points) {}

  void faceAtCorner(int face, int corner, bool faceOfA) {
    const Features &flat = faceOfA ? a_ : b_, &sharp = faceOfA ? b_ : a_;
    const Features::Face& here = flat.faces[static_cast<std::size_t>(face)];
    if (!supports(here, sharp.corners[static_cast<std::size_t>(corner)])) return;
    Facet facet;
    facet.family = faceOfA ? Family::FaceAndCorner : Family::CornerAndFace;
    for (std::size_t k = 0; k < 3; ++k)
      facet.corners[k] = faceOfA ? sums_.at(here.corners[k], corner) : sums_.at(corner, here.corners[k]);
    add(facet, here.normal);
  }

  void edgeAtEdge(int edgeOfA, int edgeOfB) {
    const Features::Edge &e = a_.edges[static_cast<std::size_t>(edgeOfA)], &f = b_.edges[static_cast<std::size_t>(edgeOfB)];
    if (e.isConvex && f.isConvex) edgeAtEdge(e, f);
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

std::vector<Facet> candidates(const Features& a, const Features& b, const FeaturePairs& pairs, Planes& planes,
                              Points& points, const Progress& progress) {
  Search search(a, b, planes, points);
  std::size_t count = 0;
  const auto poll = [&] {
    if (++count % 1024 == 0) progress.check();
  };
  for (const auto& [face, corner] : pairs.facesAndCorners) poll(), search.faceAtCorner(face, corner, true);
  for (const auto& [corner, face] : pairs.cornersAndFaces) poll(), search.faceAtCorner(face, corner, false);
  for (const auto& [e, f] : pairs.edges) poll(), search.edgeAtEdge(e, f);
  return search.found();
}

}  // namespace blossom::morphology::arrangement
