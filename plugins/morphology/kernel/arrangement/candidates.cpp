#include "kernel/arrangement/candidates.h"

#include <algorithm>
#include <unordered_map>

#include "core/parallel.h"

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

/// Which of two normals, d x g of their directions and the opposite one, support two edges.
struct Ways {
  bool along = false, against = false;
};

Grid3 directionOf(const Features& shape, const Features::Edge& edge) {
  return shape.points[static_cast<std::size_t>(edge.to)] - shape.points[static_cast<std::size_t>(edge.from)];
}

int slopeOf(const Features& shape, int face, const Grid3& d) {
  if (face == Features::none) return 0;
  const Features::Face& here = shape.faces[static_cast<std::size_t>(face)];
  return slope(here.normal, here.about, d);
}

/// A normal +-(d x g) supports an edge along d when g does not rise over one of its faces and does not fall over the other.
Ways supporting(const Features& a, const Features::Edge& e, const Features& b, const Features::Edge& f) {
  if (!e.isConvex || !f.isConvex) return {};
  const Grid3 d = directionOf(a, e), g = directionOf(b, f);
  const int leftA = slopeOf(a, e.left, g), rightA = slopeOf(a, e.right, g);
  if (leftA * rightA > 0) return {};
  const int leftB = slopeOf(b, f.left, d), rightB = slopeOf(b, f.right, d);
  if (leftB * rightB > 0) return {};
  return {leftA >= 0 && rightA <= 0 && leftB <= 0 && rightB >= 0, leftA <= 0 && rightA >= 0 && leftB >= 0 && rightB <= 0};
}

bool supports(const Features::Face& face, const Features::Corner& corner) {
  return corner.isTouched && std::all_of(corner.around.begin(), corner.around.end(),
                                         [&](const Grid3& d) { return slope(face.normal, face.about, d) <= 0; });
}

/// Makes the facets, one after the other: points and planes are shared.
class FacetMaker {
 public:
  FacetMaker(const Features& a, const Features& b, Planes& planes, Points& points)
      : a_(a), b_(b), planes_(planes), points_(points), sums_(a, b, points) {}

  /// @pre the corner is supported
  void faceAtCorner(int face, int corner, bool faceOfA) {
    const Features::Face& here = (faceOfA ? a_ : b_).faces[static_cast<std::size_t>(face)];
    Facet facet;
    facet.family = faceOfA ? Family::FaceAndCorner : Family::CornerAndFace;
    for (std::size_t k = 0; k < 3; ++k)
      facet.corners[k] = faceOfA ? sums_.at(here.corners[k], corner) : sums_.at(corner, here.corners[k]);
    add(facet, here.normal);
  }

  void edgeAtEdge(int edgeOfA, int edgeOfB, Ways ways) {
    const Features::Edge &e = a_.edges[static_cast<std::size_t>(edgeOfA)], &f = b_.edges[static_cast<std::size_t>(edgeOfB)];
    const Normal3 normal = cross(directionOf(a_, e), directionOf(b_, f));
    if (isZero(normal)) return;
    if (ways.along) add(parallelogram(e, f, true), normal);
    if (ways.against) add(parallelogram(e, f, false), negated(normal));
  }

  std::vector<Facet> made() { return std::move(made_); }

 private:
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
    made_.push_back(facet);
  }

  const Features &a_, &b_;
  Planes& planes_;
  Points& points_;
  Sums sums_;
  std::vector<Facet> made_;
};

/// test(pair) for all pairs, beside each other.
template <class Answer, class Test>
std::vector<Answer> tested(const std::vector<FeaturePairs::Pair>& pairs, const Progress& progress, const Test& test) {
  std::vector<Answer> answers(pairs.size());
  parallelFor(pairs.size(), 2048, progress, [&](std::size_t first, std::size_t last) {
    for (std::size_t k = first; k < last; ++k) answers[k] = test(pairs[k]);
  });
  return answers;
}

}  // namespace

std::vector<Facet> candidates(const Features& a, const Features& b, const FeaturePairs& pairs, Planes& planes,
                              Points& points, const Progress& progress) {
  FacetMaker maker(a, b, planes, points);
  const auto supported = [](const Features& flat, int face, const Features& sharp, int corner) -> char {
    return supports(flat.faces[static_cast<std::size_t>(face)], sharp.corners[static_cast<std::size_t>(corner)]) ? 1 : 0;
  };
  const auto onA = tested<char>(pairs.facesAndCorners, progress,
                                [&](const FeaturePairs::Pair& pair) { return supported(a, pair[0], b, pair[1]); });
  const auto onB = tested<char>(pairs.cornersAndFaces, progress,
                                [&](const FeaturePairs::Pair& pair) { return supported(b, pair[1], a, pair[0]); });
  const auto ways = tested<Ways>(pairs.edges, progress, [&](const FeaturePairs::Pair& pair) {
    return supporting(a, a.edges[static_cast<std::size_t>(pair[0])], b, b.edges[static_cast<std::size_t>(pair[1])]);
  });
  const auto poll = [&](std::size_t k) {
    if (k % 1024 == 0) progress.check();
  };
  for (std::size_t k = 0; k < onA.size(); ++k) {
    poll(k);
    if (onA[k]) maker.faceAtCorner(pairs.facesAndCorners[k][0], pairs.facesAndCorners[k][1], true);
  }
  for (std::size_t k = 0; k < onB.size(); ++k) {
    poll(k);
    if (onB[k]) maker.faceAtCorner(pairs.cornersAndFaces[k][1], pairs.cornersAndFaces[k][0], false);
  }
  for (std::size_t k = 0; k < ways.size(); ++k) {
    poll(k);
    if (ways[k].along || ways[k].against) maker.edgeAtEdge(pairs.edges[k][0], pairs.edges[k][1], ways[k]);
  }
  return maker.made();
}

}  // namespace blossom::morphology::arrangement
