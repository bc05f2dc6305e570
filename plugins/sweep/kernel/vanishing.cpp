#include "kernel/vanishing.h"

#include <fmt/format.h>

#include <algorithm>

#include "core/error.h"
#include "geometry/bspline.h"

namespace blossom::sweep {

namespace {

constexpr double nearZero = 1e-6;
constexpr int deepest = 24;  // 2^-24 of a patch: far below nearZero for every slope that matters

struct Patch {
  double u0, u1, v0, v1;
  std::vector<Vec4> poles;  // (degreeU + 1) rows of degreeV + 1
};

class Search {
 public:
  Search(int degreeU, int degreeV, double scale, const Progress& progress)
      : rows_(static_cast<std::size_t>(degreeU) + 1),
        columns_(static_cast<std::size_t>(degreeV) + 1),
        least_(nearZero * scale),
        progress_(progress) {}

  void settle(const Patch& patch, int depth = 0) const {
    if (keepsToOneSide(patch)) return;
    if (depth == 0) progress_.check();
    const Vec4& corner = patch.poles.front();
    if (depth == deepest || corner.norm() < least_)
      throw Error(
          ErrorCode::Degenerate,
          fmt::format(
              "The orientation of this motion vanishes near u = {:.4g}, v = {:.4g}: a zero quaternion is no rotation.",
              patch.u0, patch.v0),
          "Move the orientation poles around that place so that neighbours turn by less than half a turn.");
    const auto [left, right] = split(patch, true);
    for (const Patch& half : {left, right}) {
      const auto [below, above] = split(half, false);
      settle(below, depth + 1);
      settle(above, depth + 1);
    }
  }

 private:
  [[nodiscard]] bool keepsToOneSide(const Patch& patch) const {
    Vec4 mean = Vec4::Zero();
    for (const Vec4& pole : patch.poles) mean += pole;
    if (mean.norm() < least_) return false;
    mean.normalize();
    return std::all_of(patch.poles.begin(), patch.poles.end(), [&](const Vec4& pole) { return pole.dot(mean) > least_; });
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
  double least_;
  const Progress& progress_;
};

}  // namespace

void requireNonVanishing(const Surface& orientation, const Progress& progress) {
  const BezierSurface bezier = toBezier(orientation);
  double scale = 0;
  for (const Vec4& pole : bezier.poles) scale = std::max(scale, pole.norm());
  if (scale == 0)
    throw Error(ErrorCode::Degenerate, "All orientation poles of this motion are zero: there is no rotation.",
                "Give unit quaternions.");
  const Search search(bezier.degreeU, bezier.degreeV, scale, progress);
  const std::size_t size = static_cast<std::size_t>(bezier.degreeU + 1) * static_cast<std::size_t>(bezier.degreeV + 1);
  for (std::size_t a = 0, at = 0; a + 1 < bezier.breaksU.size(); ++a)
    for (std::size_t b = 0; b + 1 < bezier.breaksV.size(); ++b, at += size)
      search.settle({bezier.breaksU[a],
                     bezier.breaksU[a + 1],
                     bezier.breaksV[b],
                     bezier.breaksV[b + 1],
                     {bezier.poles.begin() + static_cast<std::ptrdiff_t>(at),
                      bezier.poles.begin() + static_cast<std::ptrdiff_t>(at + size)}});
}

}  // namespace blossom::sweep
