#include "geometry/measure/closest_points.h"

#include <BRepClass3d_SolidClassifier.hxx>
#include <BRep_Tool.hxx>
#include <Eigen/Cholesky>
#include <Precision.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_IndexedMapOfShape.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include "core/error.h"
#include "core/tolerance.h"
#include "geometry/measure/measure_patch.h"

namespace blossom {

namespace {

using Parameters = MeasurePatch::Parameters;
using Vector = Eigen::Matrix<double, 4, 1>;
using Matrix = Eigen::Matrix<double, 4, 4>;

constexpr std::size_t startsPerPair = 24;

double boxDistance(const Bounds& a, const Bounds& b) { return (b.low - a.high).cwiseMax(a.low - b.high).cwiseMax(0).norm(); }

/// Half the squared distance of a point of each patch with its first and second derivatives; parameters that a patch does
/// not have stay out of the way as identity.
struct Model {
  double value = 0;
  Vector gradient = Vector::Zero();
  Matrix hessian = Matrix::Identity();
  Matrix gauss = Matrix::Identity();  ///< J^T J, never indefinite
  FootPoints feet;
};

/// Newton's method on a pair of patches, damped after Levenberg and Marquardt, within the rectangles of parameters.
class PairNewton {
 public:
  PairNewton(const MeasurePatch& a, const MeasurePatch& b) : a_(a), b_(b) {
    for (std::size_t i = 0; i < 2; ++i) {
      set(i, i < a.dimension(), a, i);
      set(i + 2, i < b.dimension(), b, i);
    }
  }

  /// Nothing when it ends outside the trimming of a face.
  [[nodiscard]] std::optional<FootPoints> from(const Parameters& atA, const Parameters& atB) const {
    Place best = descend({atA[0], atA[1], atB[0], atB[1]});
    // Where a patch closes in itself, the way down may go on at its other end.
    for (Eigen::Index i = 0; i < 4; ++i) {
      const bool atEnd = best.x[i] == low_[i] || best.x[i] == high_[i];
      if (!atEnd || !isClosed(i)) continue;
      Vector across = best.x;
      across[i] = best.x[i] == low_[i] ? high_[i] : low_[i];
      const Place beyond = descend(across);
      if (beyond.model.value < best.model.value) best = beyond, i = -1;  // another end may be reached from there
    }
    if (!a_.contains({best.x[0], best.x[1]}) || !b_.contains({best.x[2], best.x[3]})) return std::nullopt;
    return best.model.feet;
  }

 private:
  struct Place {
    Vector x;
    Model model;
  };

  [[nodiscard]] bool isClosed(Eigen::Index i) const {
    const std::size_t along = static_cast<std::size_t>(i) % 2;
    return used_[static_cast<std::size_t>(i)] && (i < 2 ? a_ : b_).closed(along);
  }

  [[nodiscard]] Place descend(Vector x) const {
    Model now = model(x);
    double damping = 1e-6;
    for (int step = 0; step < 100 && damping < 1e12; ++step) {
      const Vector next = clamped(x + direction(now, x, damping));
      if (next == x) break;
      const Model then = model(next);
      if (then.value >= now.value) {
        // At the limit of rounding no step gets lower.
        if (std::sqrt(now.value) - std::sqrt(then.value) == 0 && damping > 1) break;
        damping *= 8;
        continue;
      }
      x = next;
      now = then;
      damping = damping < 1e-12 ? 0 : damping / 10;
    }
    return {x, now};
  }

  void set(std::size_t place, bool used, const MeasurePatch& patch, std::size_t i) {
    used_[place] = used;
    const auto k = static_cast<Eigen::Index>(place);
    low_[k] = used ? patch.low()[i] : 0;
    high_[k] = used ? patch.high()[i] : 0;
    const double speed = used ? 1e-3 * patch.box().diagonal() / (high_[k] - low_[k]) : 1;
    floor_[k] = std::max(speed * speed, 1e-30);
  }
  [[nodiscard]] Vector clamped(const Vector& x) const { return x.cwiseMax(low_).cwiseMin(high_); }

  [[nodiscard]] Model model(const Vector& x) const {
    const auto a = a_.derivatives({x[0], x[1]}), b = b_.derivatives({x[2], x[3]});
    Model m;
    const Vec3 gap = a.point - b.point;
    m.feet = {a.point, b.point};
    m.value = gap.squaredNorm() / 2;
    const std::array<Vec3, 4> columns{a.first[0], a.first[1], -b.first[0], -b.first[1]};
    const double curving[4] = {a.second[0].dot(gap), a.second[1].dot(gap), -b.second[0].dot(gap), -b.second[1].dot(gap)};
    for (std::size_t i = 0; i < 4; ++i) {
      if (!used_[i]) continue;
      const auto k = static_cast<Eigen::Index>(i);
      m.gradient[k] = columns[i].dot(gap);
      for (std::size_t j = 0; j < 4; ++j)
        if (used_[j]) m.gauss(k, static_cast<Eigen::Index>(j)) = columns[i].dot(columns[j]);
    }
    m.hessian = m.gauss;
    for (std::size_t i = 0; i < 4; ++i)
      if (used_[i]) m.hessian(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(i)) += curving[i];
    if (used_[1]) m.hessian(0, 1) = m.hessian(1, 0) = m.gauss(0, 1) + a.second[2].dot(gap);
    if (used_[3]) m.hessian(2, 3) = m.hessian(3, 2) = m.gauss(2, 3) - b.second[2].dot(gap);
    return m;
  }

  [[nodiscard]] Vector direction(const Model& m, const Vector& x, double damping) const {
    Vector gradient = m.gradient;
    Matrix hessian = m.hessian, gauss = m.gauss;
    for (Eigen::Index i = 0; i < 4; ++i) {
      // A parameter that would leave its range stays where it is.
      const bool held = (x[i] <= low_[i] && gradient[i] >= 0) || (x[i] >= high_[i] && gradient[i] <= 0);
      if (!held) continue;
      gradient[i] = 0;
      hessian.row(i).setZero();
      hessian.col(i).setZero();
      gauss.row(i).setZero();
      gauss.col(i).setZero();
      hessian(i, i) = gauss(i, i) = 1;
    }
    const Vector scale = gauss.diagonal().cwiseMax(floor_);
    hessian.diagonal() += damping * scale;
    const Eigen::LLT<Matrix> newton(hessian);
    if (newton.info() == Eigen::Success && newton.rcond() > 1e-15) return -newton.solve(gradient);
    gauss.diagonal() += std::max(damping, 1e-9) * scale;
    return -gauss.ldlt().solve(gradient);
  }

  const MeasurePatch& a_;
  const MeasurePatch& b_;
  std::array<bool, 4> used_{};
  Vector low_, high_;
  Vector floor_;  // squares of slow speeds: at a pole a parameter stands still
};

std::vector<MeasurePatch> patchesOf(const TopoDS_Shape& shape, const Progress& progress) {
  std::vector<MeasurePatch> patches;
  for (const TopAbs_ShapeEnum kind : {TopAbs_VERTEX, TopAbs_EDGE, TopAbs_FACE}) {
    TopTools_IndexedMapOfShape parts;
    TopExp::MapShapes(shape, kind, parts);
    patches.reserve(patches.size() + static_cast<std::size_t>(parts.Extent()));
    for (int i = 1; i <= parts.Extent(); ++i) {
      progress.check();
      if (kind == TopAbs_EDGE && BRep_Tool::Degenerated(TopoDS::Edge(parts(i)))) continue;
      patches.emplace_back(parts(i));
    }
  }
  if (patches.empty()) throw Error(ErrorCode::InvalidInput, "A shape without parts has no distance to anything.");
  return patches;
}

/// Collects the best points found so far.
class Search {
 public:
  Search(const std::vector<MeasurePatch>& a, const std::vector<MeasurePatch>& b) : a_(a), b_(b) {
    Bounds boxA, boxB;
    for (const MeasurePatch& patch : a) boxA.add(patch.box());
    for (const MeasurePatch& patch : b) boxB.add(patch.box());
    // Where the boxes overlap, or half way between them.
    middle_ = (boxA.low.cwiseMax(boxB.low) + boxA.high.cwiseMin(boxB.high)) / 2;
    tie_ = 1e-12 * std::max(boxA.diagonal(), boxB.diagonal());
  }

  FootPoints run(const Progress& progress) {
    startSomewhere();
    struct Pair {
      double distance;
      const MeasurePatch *a, *b;
    };
    std::vector<Pair> pairs;
    for (const MeasurePatch& a : a_) {
      progress.check();
      for (const MeasurePatch& b : b_)
        if (const double d = boxDistance(a.box(), b.box()); d <= best_.distance()) pairs.push_back({d, &a, &b});
    }
    // Points before curves before surfaces: they cost least and make the rest needless.
    std::sort(pairs.begin(), pairs.end(), [](const Pair& p, const Pair& q) {
      const std::size_t costP = p.a->dimension() + p.b->dimension(), costQ = q.a->dimension() + q.b->dimension();
      return costP != costQ ? costP < costQ : p.distance < q.distance;
    });
    for (std::size_t i = 0; i < pairs.size(); ++i) {
      progress.report(static_cast<double>(i) / static_cast<double>(pairs.size()), "Measuring distance");
      if (pairs[i].distance <= best_.distance() + tie_) search(*pairs[i].a, *pairs[i].b, progress);
    }
    return best_;
  }

 private:
  void startSomewhere() {
    const auto& first = a_.front().samples().front();
    best_ = {first.point, b_.front().samples().front().point};
  }

  void keep(const FootPoints& found) {
    const double distance = found.distance();
    const auto offCentre = [&](const FootPoints& f) { return ((f.first + f.second) / 2 - middle_).norm(); };
    if (distance < smallest_ - tie_ || (distance <= smallest_ + tie_ && offCentre(found) < offCentre(best_))) best_ = found;
    smallest_ = std::min(smallest_, distance);
  }

  struct Start {
    double distance;
    Parameters a, b;
  };

  void search(const MeasurePatch& a, const MeasurePatch& b, const Progress& progress) {
    const PairNewton newton(a, b);
    const double reach = a.spacing() + b.spacing();
    for (const Start& start : starts(a, b, progress))
      if (start.distance <= best_.distance() + reach)
        if (const auto found = newton.from(start.a, start.b)) keep(*found);
  }

  /// Where the samples of one come nearest to those of the other, seen from both, and where both are in the middle.
  [[nodiscard]] std::vector<Start> starts(const MeasurePatch& a, const MeasurePatch& b, const Progress& progress) const {
    const auto &p = a.samples(), &q = b.samples();
    constexpr double infinite = std::numeric_limits<double>::infinity();
    std::vector<double> squareA(p.size(), infinite), squareB(q.size(), infinite);
    std::vector<std::size_t> ofA(p.size(), 0), ofB(q.size(), 0);
    for (std::size_t i = 0; i < p.size(); ++i) {
      progress.check();
      for (std::size_t j = 0; j < q.size(); ++j) {
        const double square = (p[i].point - q[j].point).squaredNorm();
        if (square < squareA[i]) squareA[i] = square, ofA[i] = j;
        if (square < squareB[j]) squareB[j] = square, ofB[j] = i;
      }
    }
    std::vector<Start> all;
    for (const std::size_t i : a.localMinima(squareA)) all.push_back({std::sqrt(squareA[i]), p[i].at, q[ofA[i]].at});
    for (const std::size_t j : b.localMinima(squareB)) all.push_back({std::sqrt(squareB[j]), p[ofB[j]].at, q[j].at});
    // Surfaces that run along one another are everywhere as near.
    const std::size_t count = std::min(startsPerPair, all.size());
    std::partial_sort(all.begin(), all.begin() + static_cast<std::ptrdiff_t>(count), all.end(),
                      [](const Start& s, const Start& t) { return s.distance < t.distance; });
    all.resize(count);
    all.push_back({0, nearestToMiddle(a), nearestToMiddle(b)});
    return all;
  }

  [[nodiscard]] Parameters nearestToMiddle(const MeasurePatch& patch) const {
    return std::min_element(patch.samples().begin(), patch.samples().end(),
                            [&](const auto& s, const auto& t) {
                              return (s.point - middle_).squaredNorm() < (t.point - middle_).squaredNorm();
                            })
        ->at;
  }

  const std::vector<MeasurePatch>& a_;
  const std::vector<MeasurePatch>& b_;
  FootPoints best_;
  double smallest_ = std::numeric_limits<double>::infinity();
  double tie_ = 0;
  Vec3 middle_;
};

}  // namespace

std::vector<Vec3> representatives(const TopoDS_Shape& shape) {
  std::vector<Vec3> points;
  const auto add = [&](TopAbs_ShapeEnum kind, TopAbs_ShapeEnum notIn) {
    for (TopExp_Explorer part(shape, kind, notIn); part.More(); part.Next()) {
      const TopExp_Explorer vertex(part.Current(), TopAbs_VERTEX);
      if (!vertex.More()) continue;
      const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(vertex.Current()));
      points.emplace_back(p.X(), p.Y(), p.Z());
    }
  };
  add(TopAbs_SOLID, TopAbs_SHAPE);
  add(TopAbs_FACE, TopAbs_SOLID);
  add(TopAbs_EDGE, TopAbs_FACE);
  add(TopAbs_VERTEX, TopAbs_EDGE);
  return points;
}

std::optional<Vec3> pointInside(const std::vector<Vec3>& points, const TopoDS_Shape& shape, const Progress& progress) {
  for (TopExp_Explorer solid(shape, TopAbs_SOLID); solid.More(); solid.Next()) {
    BRepClass3d_SolidClassifier classifier(solid.Current());
    for (const Vec3& p : points) {
      progress.check();
      classifier.Perform(gp_Pnt(p.x(), p.y(), p.z()), Precision::Confusion());
      if (classifier.State() == TopAbs_IN) return p;
    }
  }
  return std::nullopt;
}

FootPoints closestPoints(const TopoDS_Shape& a, const TopoDS_Shape& b, const Progress& progress) {
  if (a.IsNull() || b.IsNull()) throw Error(ErrorCode::InvalidInput, "Nothing has no distance to anything.");
  const std::vector<MeasurePatch> patchesA = patchesOf(a, progress), patchesB = patchesOf(b, progress);
  FootPoints found = Search(patchesA, patchesB).run(progress);
  if (found.distance() <= Tolerance().confusion) return found;
  if (const auto point = pointInside(representatives(a), b, progress)) return {*point, *point};
  if (const auto point = pointInside(representatives(b), a, progress)) return {*point, *point};
  return found;
}

}  // namespace blossom
