#include "kernel/vanishing.h"

#include <fmt/format.h>

#include <Eigen/LU>
#include <algorithm>

#include "core/error.h"
#include "geometry/bspline/bspline.h"

namespace blossom::sweep {

namespace {

constexpr double nearZero = 1e-6;

struct Patch {
  double u0, u1, v0, v1;
  std::vector<Vec4> poles;  // (degreeU + 1) rows of degreeV + 1
};

/// The point of the smallest norm in the affine hull of some poles, as weights that add up to 1.
Eigen::VectorXd affineNearest(const std::vector<Vec4>& poles, const std::vector<std::size_t>& chosen) {
  const auto n = static_cast<Eigen::Index>(chosen.size());
  Eigen::MatrixXd system = Eigen::MatrixXd::Ones(n + 1, n + 1);
  system(n, n) = 0;
  for (Eigen::Index i = 0; i < n; ++i)
    for (Eigen::Index j = 0; j < n; ++j)
      system(i, j) = poles[chosen[static_cast<std::size_t>(i)]].dot(poles[chosen[static_cast<std::size_t>(j)]]);
  Eigen::VectorXd right = Eigen::VectorXd::Zero(n + 1);
  right[n] = 1;
  return system.fullPivLu().solve(right).head(n);
}

std::size_t lowestAlong(const std::vector<Vec4>& poles, const Vec4& direction) {
  const auto lowest = std::min_element(poles.begin(), poles.end(),
                                       [&](const Vec4& a, const Vec4& b) { return a.dot(direction) < b.dot(direction); });
  return static_cast<std::size_t>(lowest - poles.begin());
}

/// A proof that zero lies outside the convex hull of the poles: a direction along which all of them reach `least`. The
/// direction is sought by Wolfe's algorithm for the point of the hull that is nearest to zero (Wolfe, Mathematical
/// Programming 11, 1976); whatever it finds, the comparison alone decides.
bool hullKeepsAway(const std::vector<Vec4>& poles, double minimum) {
  constexpr int maximumSteps = 40;
  std::vector<std::size_t> chosen{0};
  Eigen::VectorXd weights = Eigen::VectorXd::Ones(1);
  Vec4 nearest = poles[0];
  for (int step = 0; step < maximumSteps; ++step) {
    if (!(nearest.norm() >= minimum)) return false;
    const std::size_t lowest = lowestAlong(poles, nearest);
    if (poles[lowest].dot(nearest) >= minimum * nearest.norm()) return true;
    if (std::find(chosen.begin(), chosen.end(), lowest) != chosen.end()) return false;
    chosen.push_back(lowest);
    weights.conservativeResize(weights.size() + 1);
    weights[weights.size() - 1] = 0;
    while (true) {
      const Eigen::VectorXd wanted = affineNearest(poles, chosen);
      // As far towards the point wanted as the hull reaches; the pole that stops it is given up.
      double reach = 1;
      Eigen::Index stopping = -1;
      for (Eigen::Index i = 0; i < wanted.size(); ++i)
        if (wanted[i] <= 0 && weights[i] / (weights[i] - wanted[i]) < reach)
          reach = weights[i] / (weights[i] - wanted[i]), stopping = i;
      weights += reach * (wanted - weights);
      if (stopping < 0) break;
      chosen.erase(chosen.begin() + stopping);
      weights.segment(stopping, weights.size() - 1 - stopping) = weights.tail(weights.size() - 1 - stopping).eval();
      weights.conservativeResize(weights.size() - 1);
    }
    nearest.setZero();
    for (std::size_t i = 0; i < chosen.size(); ++i) nearest += weights[static_cast<Eigen::Index>(i)] * poles[chosen[i]];
  }
  return false;
}

class Search {
 public:
  Search(int degreeU, int degreeV, double scale, const Progress& progress)
      : rows_(static_cast<std::size_t>(degreeU) + 1),
        columns_(static_cast<std::size_t>(degreeV) + 1),
        minimum_(nearZero * scale),
        progress_(progress) {}

  /// Proves distances of half of what is refused: between the two, patches need not shrink without end.
  [[nodiscard]] std::optional<MotionPlace> settle(const Patch& patch) const {
    progress_.check();
    if (hullKeepsAway(patch.poles, minimum_ / 2)) return std::nullopt;
    const double alongU = extent(patch, true), alongV = extent(patch, false);
    const Vec4& corner = patch.poles.front();
    if (corner.norm() < minimum_ || std::max(alongU, alongV) < minimum_ / 1000) return MotionPlace{patch.u0, patch.v0};
    // Across a line of near misses one direction alone needs smaller patches.
    const auto [low, high] = split(patch, alongU >= alongV);
    if (const auto found = settle(low)) return found;
    return settle(high);
  }

 private:
  /// Largest distance between neighbouring poles in one direction.
  [[nodiscard]] double extent(const Patch& patch, bool alongU) const {
    double largest = 0;
    const std::size_t step = alongU ? columns_ : 1;
    for (std::size_t i = 0; i < rows_ - (alongU ? 1 : 0); ++i)
      for (std::size_t j = 0; j < columns_ - (alongU ? 0 : 1); ++j)
        largest = std::max(largest, (patch.poles[i * columns_ + j + step] - patch.poles[i * columns_ + j]).norm());
    return largest;
  }

  /// De Casteljau's algorithm at the middle.
  [[nodiscard]] std::pair<Patch, Patch> split(const Patch& patch, bool alongU) const {
    const double mu = (patch.u0 + patch.u1) / 2, mv = (patch.v0 + patch.v1) / 2;
    Patch low = patch, high = patch;
    (alongU ? low.u1 : low.v1) = alongU ? mu : mv;
    (alongU ? high.u0 : high.v0) = alongU ? mu : mv;
    const std::size_t count = alongU ? rows_ : columns_, lines = alongU ? columns_ : rows_, step = alongU ? columns_ : 1,
                      jump = alongU ? 1 : columns_;
    for (std::size_t line = 0; line < lines; ++line) {
      Vec4* left = low.poles.data() + line * jump;
      Vec4* right = high.poles.data() + line * jump;
      for (std::size_t level = 1; level < count; ++level) {
        for (std::size_t i = 0; i + level < count; ++i) right[i * step] = (right[i * step] + right[(i + 1) * step]) / 2;
        left[level * step] = right[0];
      }
    }
    return {std::move(low), std::move(high)};
  }

  std::size_t rows_, columns_;
  double minimum_;
  const Progress& progress_;
};

}  // namespace

std::optional<MotionPlace> vanishingPlace(const Surface& orientation, const Progress& progress) {
  const BezierSurface bezier = toBezier(orientation);
  double scale = 0;
  for (const Vec4& pole : bezier.poles) scale = std::max(scale, pole.norm());
  if (scale == 0) return MotionPlace{bezier.breaksU.front(), bezier.breaksV.front()};
  const Search search(bezier.degreeU, bezier.degreeV, scale, progress);
  const std::size_t size = static_cast<std::size_t>(bezier.degreeU + 1) * static_cast<std::size_t>(bezier.degreeV + 1);
  for (std::size_t a = 0, at = 0; a + 1 < bezier.breaksU.size(); ++a)
    for (std::size_t b = 0; b + 1 < bezier.breaksV.size(); ++b, at += size)
      if (const auto found = search.settle({bezier.breaksU[a],
                                            bezier.breaksU[a + 1],
                                            bezier.breaksV[b],
                                            bezier.breaksV[b + 1],
                                            {bezier.poles.begin() + static_cast<std::ptrdiff_t>(at),
                                             bezier.poles.begin() + static_cast<std::ptrdiff_t>(at + size)}}))
        return found;
  return std::nullopt;
}

void requireNonVanishing(const Surface& orientation, const Progress& progress) {
  if (std::all_of(orientation.poles.begin(), orientation.poles.end(), [](const Vec4& pole) { return pole.isZero(0); }))
    throw Error(ErrorCode::Degenerate, "All orientation poles of this motion are zero: there is no rotation.",
                "Give unit quaternions.");
  const auto place = vanishingPlace(orientation, progress);
  if (!place) return;
  const auto [shortest, longest] = std::minmax_element(orientation.poles.begin(), orientation.poles.end(),
                                                       [](const Vec4& a, const Vec4& b) { return a.norm() < b.norm(); });
  if (shortest->norm() > 0 && shortest->norm() < 10 * nearZero * longest->norm())
    throw Error(
        ErrorCode::Degenerate,
        fmt::format("The orientation poles of this motion differ too much in length: near u = {:.4g}, v = {:.4g} the "
                    "shortest, {:.2g} of the longest, cannot be told from zero.",
                    place->u, place->v, shortest->norm() / longest->norm()),
        "Bring the quaternions to lengths that are alike.");
  throw Error(
      ErrorCode::Degenerate,
      fmt::format("The orientation of this motion vanishes near u = {:.4g}, v = {:.4g}: a zero quaternion is no rotation.",
                  place->u, place->v),
      "Move the orientation poles around that place so that neighbours turn by less than half a turn.");
}

}  // namespace blossom::sweep
