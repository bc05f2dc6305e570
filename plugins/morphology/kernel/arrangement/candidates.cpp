#include "kernel/arrangement/candidates.h"

#include <algorithm>
#include <utility>

#include "core/parallel.h"

namespace blossom::morphology::arrangement {

namespace {

Normal3 negated(const Normal3& n) { return {-n[0], -n[1], -n[2]}; }

/// A corner of the first shape and one of the second.
using CornerPair = std::array<int, 2>;

Grid3 placeOf(const Features& a, const Features& b, const CornerPair& corners) {
  return a.points[static_cast<std::size_t>(corners[0])] + b.points[static_cast<std::size_t>(corners[1])];
}

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

/// Sums of corners, each made once. Few of all pairs of corners of large shapes make any.
class Sums {
 public:
  Sums(const Features& a, const Features& b, Points& points) : a_(a), b_(b), points_(points) {}

  int at(const CornerPair& corners) {
    const std::uint64_t hash =
        mixedHash(mixedHash(0, static_cast<std::uint64_t>(corners[0])), static_cast<std::uint64_t>(corners[1]));
    const int known = byCorners_.find(hash, [&](int k) { return made_[static_cast<std::size_t>(k)].corners == corners; });
    if (known >= 0) return made_[static_cast<std::size_t>(known)].point;
    const int point = points_.at(placeOf(a_, b_, corners));
    byCorners_.add(hash, static_cast<int>(made_.size()));
    made_.push_back({corners, point});
    return point;
  }

 private:
  struct Sum {
    CornerPair corners{};
    int point = 0;
  };

  const Features &a_, &b_;
  Points& points_;
  std::vector<Sum> made_;
  NumberTable byCorners_;  ///< of `made_`
};

/// A facet without numbers of points and a plane, as it is made beside others.
struct Draft {
  Family family = Family::EdgeAndEdge;
  std::array<CornerPair, 4> corners{};
  std::size_t count = 3;
  Planes::Directed plane;
};

/// Drafts of some pairs of features.
struct Drafts {
  std::vector<Draft> all;
  FacetCounts found{};
  std::size_t leftOut = 0;
};

/// Drafts of the facets that two features make.
class Drafting {
 public:
  Drafting(const Features& a, const Features& b, const SumCore* core) : a_(a), b_(b), core_(core) {}

  void faceAtCorner(int face, int corner, bool faceOfA, Drafts& made) const {
    const Features &flat = faceOfA ? a_ : b_, &sharp = faceOfA ? b_ : a_;
    const Features::Face& here = flat.faces[static_cast<std::size_t>(face)];
    if (!supports(here, sharp.corners[static_cast<std::size_t>(corner)])) return;
    Draft draft;
    draft.family = faceOfA ? Family::FaceAndCorner : Family::CornerAndFace;
    for (std::size_t k = 0; k < 3; ++k)
      draft.corners[k] = faceOfA ? CornerPair{here.corners[k], corner} : CornerPair{corner, here.corners[k]};
    add(draft, here.normal, made);
  }

  void edgeAtEdge(int edgeOfA, int edgeOfB, Drafts& made) const {
    const Features::Edge &e = a_.edges[static_cast<std::size_t>(edgeOfA)], &f = b_.edges[static_cast<std::size_t>(edgeOfB)];
    const Ways ways = supporting(a_, e, b_, f);
    if (!ways.along && !ways.against) return;
    const Normal3 normal = cross(directionOf(a_, e), directionOf(b_, f));
    if (isZero(normal)) return;
    if (ways.along) add(parallelogram(e, f, true), normal, made);
    if (ways.against) add(parallelogram(e, f, false), negated(normal), made);
  }

 private:
  static Draft parallelogram(const Features::Edge& e, const Features::Edge& f, bool firstThenSecond) {
    Draft draft;
    draft.count = 4;
    draft.corners = {CornerPair{e.from, f.from}, {e.to, f.from}, {e.to, f.to}, {e.from, f.to}};
    if (!firstThenSecond) std::swap(draft.corners[1], draft.corners[3]);
    return draft;
  }
  void add(Draft draft, const Normal3& normal, Drafts& made) const {
    ++made.found[static_cast<std::size_t>(draft.family)];
    if (isInCore(draft)) {
      ++made.leftOut;
      return;
    }
    draft.plane = Planes::directed(normal, placeOf(a_, b_, draft.corners[0]));
    made.all.push_back(draft);
  }
  [[nodiscard]] bool isInCore(const Draft& draft) const {
    if (!core_) return false;
    std::array<Grid3, 4> corners;
    for (std::size_t k = 0; k < draft.count; ++k) corners[k] = placeOf(a_, b_, draft.corners[k]);
    return core_->holds({corners.data(), draft.count});
  }

  const Features &a_, &b_;
  const SumCore* core_;
};

/// Makes facets of drafts, one after the other: points and planes are shared.
class FacetMaker {
 public:
  FacetMaker(const Features& a, const Features& b, Planes& planes, Points& points)
      : planes_(planes), points_(points), sums_(a, b, points) {}

  void add(const Drafts& drafts) {
    for (const Draft& draft : drafts.all) add(draft);
    for (std::size_t family = 0; family < drafts.found.size(); ++family) made_.found[family] += drafts.found[family];
    made_.leftOut += drafts.leftOut;
  }

  Candidates made() { return std::move(made_); }

 private:
  void add(const Draft& draft) {
    Facet facet;
    facet.family = draft.family;
    facet.count = draft.count;
    for (std::size_t k = 0; k < draft.count; ++k) facet.corners[k] = sums_.at(draft.corners[k]);
    const auto [plane, sameWay] = planes_.add(draft.plane);
    facet.plane = plane;
    facet.sameWay = sameWay;
    for (std::size_t k = 0; k < facet.count; ++k) points_.note(facet.corners[k], plane);
    made_.facets.push_back(facet);
  }

  Planes& planes_;
  Points& points_;
  Sums sums_;
  Candidates made_;
};

/// Facets of all pairs, drafted beside each other by draft(pair, drafts).
template <class DraftPair>
void addFacets(const std::vector<FeaturePairs::Pair>& pairs, FacetMaker& maker, const Progress& progress,
               const DraftPair& draft) {
  constexpr std::size_t pairsOfPart = 1024, partsAtATime = 256;
  for (std::size_t start = 0; start < pairs.size(); start += pairsOfPart * partsAtATime) {
    const std::size_t left = pairs.size() - start;
    std::vector<Drafts> parts(std::min(partsAtATime, (left + pairsOfPart - 1) / pairsOfPart));
    parallelFor(parts.size(), 1, progress, [&](std::size_t first, std::size_t last) {
      for (std::size_t part = first; part < last; ++part) {
        const std::size_t from = start + part * pairsOfPart;
        for (std::size_t k = from; k < std::min(from + pairsOfPart, pairs.size()); ++k) draft(pairs[k], parts[part]);
      }
    });
    for (const Drafts& part : parts) {
      progress.check();
      maker.add(part);
    }
  }
}

}  // namespace

Candidates candidates(const Features& a, const Features& b, const FeaturePairs& pairs, const SumCore* core, Planes& planes,
                      Points& points, const Progress& progress) {
  const Drafting drafting(a, b, core);
  FacetMaker maker(a, b, planes, points);
  using Pair = FeaturePairs::Pair;
  addFacets(pairs.facesAndCorners, maker, progress,
            [&](const Pair& pair, Drafts& made) { drafting.faceAtCorner(pair[0], pair[1], true, made); });
  addFacets(pairs.cornersAndFaces, maker, progress,
            [&](const Pair& pair, Drafts& made) { drafting.faceAtCorner(pair[1], pair[0], false, made); });
  addFacets(pairs.edges, maker, progress,
            [&](const Pair& pair, Drafts& made) { drafting.edgeAtEdge(pair[0], pair[1], made); });
  return maker.made();
}

}  // namespace blossom::morphology::arrangement
