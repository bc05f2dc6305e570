#include "kernel/deform.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "core/error.h"
#include "kernel/foot_points.h"
#include "kernel/least_squares.h"

namespace blossom::subdivision {
namespace {

/// Falls smaller than this share end the iteration.
constexpr double smallestFall = 1e-6;

class Deformation {
 public:
  Deformation(const LimitShape& shape, std::span<const Vec3> points, std::span<const Vec3> samples,
              const DeformOptions& options, const Progress& progress)
      : shape_(shape),
        before_(points),
        samples_(samples.begin(), samples.end()),
        found_(samples.size()),
        options_(options),
        progress_(progress),
        finder_(shape, progress.part(0, 0.1)),
        edges_(shape.edges()) {
    result_.points.assign(points.begin(), points.end());
    std::vector<Vec3> held;
    for (const Pull& pull : options.pulls) {
      held.push_back(pull.at);
      samples_.push_back(pull.to);
    }
    heldFeet_ = finder_.feet(held, points, {}, progress_);
  }

  DeformResult run() {
    project();
    result_.before = result_.after = distances();
    chooseFree();
    for (int i = 0; i < options_.iterations; ++i) {
      progress_.report(0.2 + 0.75 * i / options_.iterations, "Deforming");
      const std::vector<Vec3> last = result_.points;
      const std::vector<Foot> lastFeet = feet_;
      const double lastRms = result_.after.rms;
      solve();
      project();
      result_.after = distances();
      if (result_.after.rms >= lastRms) {  // keep the best
        result_.points = last;
        feet_ = lastFeet;
        result_.after = distances();
        result_.objective.pop_back();
        break;
      }
      if (result_.after.rms > lastRms * (1 - smallestFall)) break;
    }
    result_.outsideChange = outsideChange();
    findFarthest();
    result_.feet = feet_;
    result_.beyondRange = result_.after.rms > result_.before.rms / 2;
    progress_.report(1, "Deforming");
    return std::move(result_);
  }

 private:
  void project() {
    const std::span<const Vec3> searching(samples_.data(), found_);
    const std::span<const Foot> known(feet_.data(), feet_.empty() ? 0 : found_);
    std::vector<Foot> feet = finder_.feet(searching, result_.points, known, progress_);
    feet.insert(feet.end(), heldFeet_.begin(), heldFeet_.end());
    feet_ = std::move(feet);
  }

  [[nodiscard]] std::vector<Row> rows() const {
    std::vector<Row> rows;
    rows.reserve(feet_.size());
    for (const Foot& foot : feet_) rows.push_back(shape_.row(foot));
    return rows;
  }

  [[nodiscard]] Distances distances() const {
    Distances d;
    for (std::size_t i = 0; i < samples_.size(); ++i) {
      const double each = (combined(shape_.row(feet_[i]), result_.points) - samples_[i]).norm();
      d.rms += each * each;
      d.largest = std::max(d.largest, each);
    }
    d.rms = std::sqrt(d.rms / static_cast<double>(samples_.size()));
    return d;
  }

  void chooseFree() {
    const std::vector<Row> all = rows();
    result_.freePoints = freePoints(options_.free, {samples_, all, found_}, before_, edges_, shape_.isCurve());
    resistance_ = resistanceOf(all, result_.freePoints);
  }

  /// Movements count from where the points were at first, so that the objective is one and the same all the time.
  void solve() {
    const std::vector<Row> all = rows();
    std::vector<Vec3> residuals;
    for (std::size_t i = 0; i < samples_.size(); ++i) residuals.push_back(samples_[i] - combined(all[i], before_));
    const std::vector<Vec3> moved =
        LeastSquares(all, result_.freePoints, resistance_.shares, edges_, lambda(), progress_).solve(residuals);
    for (std::size_t i = 0; i < moved.size(); ++i) {
      const auto p = static_cast<std::size_t>(result_.freePoints[i]);
      result_.points[p] = before_[p] + moved[i];
    }
    double sum = lambda() * stiffness(moved, result_.freePoints, resistance_.shares, edges_);
    for (std::size_t i = 0; i < samples_.size(); ++i) sum += (combined(all[i], result_.points) - samples_[i]).squaredNorm();
    result_.objective.push_back(sum);
  }

  [[nodiscard]] double lambda() const { return options_.lambda * resistance_.strongest; }

  void findFarthest() {
    for (const int point : result_.freePoints) {
      const auto p = static_cast<std::size_t>(point);
      const double move = (result_.points[p] - before_[p]).norm();
      if (move > result_.farthestMove) result_.farthestMove = move, result_.farthestPoint = point;
    }
  }

  [[nodiscard]] double outsideChange() const {
    double largest = 0;
    for (const Row& row : finder_.seedRows()) {
      const bool touched = std::any_of(row.indices.begin(), row.indices.end(), [&](int i) {
        return std::binary_search(result_.freePoints.begin(), result_.freePoints.end(), i);
      });
      if (!touched) largest = std::max(largest, (combined(row, result_.points) - combined(row, before_)).norm());
    }
    return largest;
  }

  const LimitShape& shape_;
  std::span<const Vec3> before_;
  std::vector<Vec3> samples_;  ///< what the pulls are to reach comes last
  std::size_t found_;          ///< so many of them search their feet
  std::vector<Foot> heldFeet_;
  const DeformOptions& options_;
  const Progress& progress_;
  FootFinder finder_;
  std::vector<std::pair<int, int>> edges_;
  std::vector<Foot> feet_;
  Resistance resistance_;  ///< of the free points, by their first feet
  DeformResult result_;
};

}  // namespace

DeformResult deform(const LimitShape& shape, std::span<const Vec3> points, std::span<const Vec3> samples,
                    const DeformOptions& options, const Progress& progress) {
  if (samples.empty() && options.pulls.empty())
    throw Error(ErrorCode::InvalidInput, "The target has no point.", "Give a drawn curve or at least one point.");
  const auto check = [](const Vec3& p, std::size_t i, const char* what) {
    if (p.allFinite()) return;
    throw Error(ErrorCode::InvalidInput, fmt::format("{} {} has a coordinate that is no number.", what, i + 1),
                "Correct the coordinate where the target was made.");
  };
  for (std::size_t i = 0; i < samples.size(); ++i) check(samples[i], i, "Point of the target");
  for (std::size_t i = 0; i < options.pulls.size(); ++i)
    for (const Vec3& p : {options.pulls[i].at, options.pulls[i].to}) check(p, i, "Pull");
  if (!(options.lambda >= 0) || !std::isfinite(options.lambda))
    throw Error(ErrorCode::InvalidParameter, "Lambda is below 0 or no number.", "Give 0 or more.");
  return Deformation(shape, points, samples, options, progress).run();
}

}  // namespace blossom::subdivision
