#include "kernel/morph/morph.h"

#include <fmt/format.h>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <memory>
#include <mutex>
#include <optional>

#include "core/error.h"
#include "core/parallel.h"
#include "geometry/planar/planar.h"
#include "geometry/planar/sums/flattening.h"
#include "geometry/planar/sums/region_sum.h"
#include "kernel/morph/blended_area.h"
#include "kernel/morph/expansion.h"
#include "kernel/morph/extrapolation.h"
#include "kernel/morph/point_shape.h"
#include "kernel/morph/repetition.h"
#include "kernel/morph/thinning.h"

namespace blossom::minkowski {

using namespace planar;

namespace {

constexpr std::size_t maximumShapes = 32;

SoundRegion recursive(std::span<const SoundRegion> shapes, std::span<const double> t, Adder& add, Thinning& thin,
                      const Progress& progress) {
  if (t.empty()) return shapes.front();
  const auto earlier = t.first(t.size() - 1);
  SoundRegion first = recursive(shapes.first(shapes.size() - 1), earlier, add, thin, progress);
  SoundRegion second = recursive(shapes.subspan(1), earlier, add, thin, progress);
  if (!earlier.empty()) {  // the control shapes themselves stay as they are
    first = thin(std::move(first), progress);
    second = thin(std::move(second), progress);
  }
  return between(first, second, t.back(), add, progress);
}

SoundRegion bottomUp(std::vector<SoundRegion> shapes, std::span<const double> t, Adder& add, Thinning& thin,
                     const Progress& progress) {
  for (const double level : t) {
    for (std::size_t i = 0; i + 1 < shapes.size(); ++i) {
      shapes[i] = between(shapes[i], shapes[i + 1], level, add, progress);
      if (shapes.size() > 2) shapes[i] = thin(std::move(shapes[i]), progress);
    }
    shapes.pop_back();
  }
  return shapes.front();
}

/// All repetitions of a shape in one, which is right for convex shapes only.
SoundRegion convexAt(std::span<const SoundRegion> shapes, std::span<const double> t, Adder& add, const Progress& progress) {
  std::optional<SoundRegion> total;
  const std::vector<double> shares = sharesOf(t);
  for (std::size_t i = 0; i < shares.size(); ++i) {
    if (!(shares[i] > 0)) continue;
    const SoundRegion term = scaled(shapes[i], shares[i]);
    total = total ? add(*total, term, progress) : term;
  }
  return *total;
}

std::string nameOf(std::size_t i) { return fmt::format("control shape {}", i + 1); }

void check(std::span<const Region> shapes, std::span<const Arguments> arguments) {
  if (shapes.size() < 2)
    throw Error(ErrorCode::InvalidParameter, "A morph needs at least two control shapes.", "Give another shape.");
  if (shapes.size() > maximumShapes)
    throw Error(ErrorCode::LimitExceeded,
                fmt::format("A morph has at most {} control shapes; {} are given.", maximumShapes, shapes.size()),
                "Join several morphs, one after the other.");
  for (const Arguments& t : arguments) {
    if (t.size() + 1 != shapes.size())
      throw Error(ErrorCode::InvalidParameter,
                  fmt::format("The blossom of {} control shapes takes {} {}, not {}.", shapes.size(), shapes.size() - 1,
                              shapes.size() == 2 ? "number" : "numbers", t.size()),
                  "Give one number for each control shape after the first.");
    for (const double level : t)
      if (!std::isfinite(level))
        throw Error(ErrorCode::InvalidParameter, fmt::format("Every t must be a finite number; one is {}.", level));
  }
}

class Morph {
 public:
  Morph(std::span<const Region> regions, const MorphOptions& options, const Progress& progress)
      : regions_(regions), points_(regions), options_(options), add_(options.maximumWork) {
    for (std::size_t i = 0; i < regions.size(); ++i)
      shapes_.push_back(
          soundControl(regions[i], {.tolerance = options.tolerance, .effort = &add_.effort()}, nameOf(i), progress));
    if (options.areaPreserving) area_.emplace(shapes_);
    if (options.degreeElevate) elevate(progress);
    if (options.evaluation == EvaluationOrder::Convex) refuseHollows();
    for (const Region& region : regions)
      if (!pointIn(region)) tolerance_ = std::min(tolerance_, options.tolerance.value_or(defaultTolerance(region)));
    expansion_.emplace(shapes_, tolerance_, add_);
  }

  /// Chooses the order of evaluation when it is automatic, counts its sums and computes what in-betweens share.
  void prepare(std::span<const Arguments> arguments, const Progress& progress) {
    std::vector<Arguments> all;
    for (const Arguments& t : arguments)
      if (!isBeyond(t) && !isEnd(t)) all.push_back(elevated(t));
    std::vector<bool> convex;
    for (const SoundRegion& shape : shapes_) convex.push_back(repeatsAsMultiple(shape));
    if (options_.evaluation == EvaluationOrder::Automatic) options_.evaluation = quickestWay(all, convex);
    isUsed_ = !all.empty();
    add_.plan(add_.count() + sumsNeeded(options_.evaluation, all, convex));
    for (SoundRegion& shape : shapes_) add_.keep(shape);
    if (options_.evaluation != EvaluationOrder::Explicit) return;
    refuseManyTerms(all);
    for (const Arguments& t : all) expansion_->repeatFor(t, progress);
  }

  /// @param progress of the whole morph
  Region at(const Arguments& t, const Progress& progress) {
    if (isEnd(t)) return t.front() < 0.5 ? regions_.front() : regions_.back();
    InBetween made = isBeyond(t) ? beyond(t, progress) : inBetween(elevated(t), progress);
    const std::vector<double> shares = sharesOf(t);
    if (area_) made = area_->of(made, shares);
    const std::scoped_lock lock(mutex_);
    deviation_ = std::max(deviation_, made.deviation);
    if (warnings_.empty()) warnOfLines(takesSplines(t), made.shape.region, options_.tolerance, warnings_);
    return points_.moved(std::move(made.shape.region), shares);
  }

  [[nodiscard]] std::size_t sums() const { return add_.count(); }
  [[nodiscard]] std::optional<EvaluationOrder> evaluation() const {
    return isUsed_ ? std::optional(options_.evaluation) : std::nullopt;
  }
  [[nodiscard]] double deviation() const { return deviation_; }
  [[nodiscard]] std::vector<std::string> warnings() const {
    std::vector<std::string> all = warnings_;
    if (std::find(regionsConvex_.begin(), regionsConvex_.end(), false) != regionsConvex_.end())
      all.emplace_back(
          "Degree elevation keeps a morph for convex control shapes only; one of these is not convex, so the in-betweens "
          "differ.");
    return all;
  }

 private:
  void refuseHollows() const {
    for (std::size_t i = 1; i + 1 < shapes_.size(); ++i)
      if (!repeatsAsMultiple(shapes_[i]))
        throw Error(ErrorCode::InvalidInput,
                    fmt::format("Control shape {}{} is not convex, so its repetitions are not multiples of it.", i + 1,
                                options_.degreeElevate ? " of the elevated morph" : ""),
                    "Choose the explicit evaluation.");
  }

  static void refuseManyTerms(std::span<const Arguments> all) {
    for (const Arguments& t : all)
      if (choicesOf(t) > mostChoices)
        throw Error(ErrorCode::LimitExceeded,
                    fmt::format("The explicit form of {} different blossom numbers has too many terms.", t.size()),
                    "Choose the bottom-up evaluation.");
  }

  /// Whether the in-between is the first or the last shape, to rounding.
  static bool isEnd(const Arguments& t) {
    constexpr double rounding = 1e-9;
    const double end = std::round(t.front());
    const auto isThere = [&](double level) {
      return level == end || (isBeyond({&level, 1}) && std::abs(level - end) < rounding);
    };
    return (end == 0 || end == 1) && std::all_of(t.begin(), t.end(), isThere);
  }

  /// A'_i = i/(n+1) A_(i-1) + (1 - i/(n+1)) A_i.
  void elevate(const Progress& progress) {
    for (const SoundRegion& shape : shapes_) regionsConvex_.push_back(repeatsAsMultiple(shape));
    std::vector<SoundRegion> more{shapes_.front()};
    const double count = static_cast<double>(shapes_.size());
    add_.plan(shapes_.size() - 1);
    for (std::size_t i = 1; i < shapes_.size(); ++i)
      more.push_back(between(shapes_[i], shapes_[i - 1], static_cast<double>(i) / count, add_, progress));
    more.push_back(shapes_.back());
    shapes_ = std::move(more);
  }

  /// Beyond the ends, where there is a shape, of an area above 0 if that is blended.
  std::optional<InBetween> continued(const Arguments& t, const Progress& progress) {
    return hasArea(t) ? continuedTo(elevated(t), shapes_, add_, progress) : std::nullopt;
  }

  [[nodiscard]] bool hasArea(const Arguments& t) const { return !area_ || area_->blended(sharesOf(t)) > 0; }

  InBetween beyond(const Arguments& t, const Progress& progress) {
    if (auto shape = continued(t, progress)) return std::move(*shape);
    const char* const why =
        hasArea(t) ? "no shape there leads through both ends" : "the areas of the shapes blend to none there";
    if (std::adjacent_find(t.begin(), t.end(), std::not_equal_to<>()) != t.end())
      throw Error(ErrorCode::InvalidParameter,
                  fmt::format("The morph cannot be continued to these blossom numbers: {}.", why),
                  "Give numbers nearer to 0..1.");
    const auto isThere = [&](double level) { return continued(diagonal(t.size(), level), progress).has_value(); };
    const double end = t.front() > 1 ? 1 : 0, works = farthestTowards(t.front(), isThere, progress);
    throw Error(
        ErrorCode::InvalidParameter, fmt::format("The morph cannot be continued to t = {}: {}.", t.front(), why),
        works == end ? fmt::format("These shapes go no farther than t = {}.", end) : fmt::format("t = {} works.", works));
  }

  [[nodiscard]] bool takesSplines(const Arguments& t) const {
    const std::vector<double> shares = sharesOf(t);
    for (std::size_t i = 0; i < shares.size(); ++i)
      if (shares[i] != 0 && hasSplines(regions_[i])) return true;
    return false;
  }

  [[nodiscard]] Arguments elevated(const Arguments& t) const {
    return shapes_.size() == regions_.size() ? t : diagonal(shapes_.size() - 1, t.front());
  }

  InBetween inBetween(const Arguments& t, const Progress& progress) {
    const auto levels = static_cast<double>(t.size());  // of which each fills dents once
    Thinning thin(expansion_->toleranceAt(t) / levels);
    switch (options_.evaluation) {
      case EvaluationOrder::Recursive: {
        SoundRegion shape = recursive(shapes_, t, add_, thin, progress);
        return {std::move(shape), levels * thin.deepest()};
      }
      case EvaluationOrder::BottomUp: {
        SoundRegion shape = bottomUp(shapes_, t, add_, thin, progress);
        return {std::move(shape), levels * thin.deepest()};
      }
      case EvaluationOrder::Convex:
        return {convexAt(shapes_, t, add_, progress), 0};
      case EvaluationOrder::Automatic:  // chosen when it is prepared
      case EvaluationOrder::Explicit:
        break;
    }
    return expansion_->at(t, progress);
  }

  std::span<const Region> regions_;
  PointPlaces points_;
  MorphOptions options_;
  bool isUsed_ = false;  ///< an in-between is computed in the order of evaluation
  Adder add_;
  std::vector<SoundRegion> shapes_;
  double tolerance_ = HUGE_VAL;
  std::vector<bool> regionsConvex_;
  std::optional<BlendedArea> area_;  ///< that in-betweens are given
  std::optional<Expansion> expansion_;
  std::mutex mutex_;
  double deviation_ = 0;               ///< the largest of all in-betweens
  std::vector<std::string> warnings_;  ///< of in-betweens
};

/// Progress is reported in steps of a fiftieth, because the sums of many frames report too often.
Progress inSteps(const Progress& progress) {
  constexpr double step = 0.02;
  const auto last = std::make_shared<std::atomic<double>>(-1.0);  // shared by all parts, which report from any thread
  return Progress(progress.token(), [&progress, last](double fraction, const std::string& stage) {
    double before = *last;
    if (std::abs(fraction - before) < step || !last->compare_exchange_strong(before, fraction)) return;
    progress.report(fraction, stage);
  });
}

void refuseUnequal(const std::vector<double>& t) {
  if (std::adjacent_find(t.begin(), t.end(), std::not_equal_to<>()) != t.end())
    throw Error(ErrorCode::InvalidParameter,
                "A morph whose degree is elevated has no place for different blossom parameters.",
                "Leave out the degree elevation or the blossom parameters.");
}

/// On all cores.
std::vector<Region> atTheSameTime(Morph& evaluation, std::span<const Arguments> arguments, const Progress& progress) {
  std::vector<Region> regions(arguments.size());
  const Progress each(progress.token());
  std::atomic<std::size_t> done = 0;
  parallelFor(arguments.size(), 1, each, [&](std::size_t begin, std::size_t end) {
    for (std::size_t k = begin; k < end; ++k) {
      regions[k] = evaluation.at(arguments[k], each);
      progress.report(static_cast<double>(++done) / static_cast<double>(arguments.size()), "Adding shapes");
    }
  });
  return regions;
}

}  // namespace

std::vector<double> diagonal(std::size_t degree, double t) { return std::vector<double>(degree, t); }

MorphResult morph(std::span<const Region> shapes, std::span<const std::vector<double>> arguments,
                  const MorphOptions& options, const Progress& progress) {
  check(shapes, arguments);
  if (options.degreeElevate) std::for_each(arguments.begin(), arguments.end(), refuseUnequal);
  const Progress steps = inSteps(progress);
  Morph evaluation(shapes, options, steps);
  evaluation.prepare(arguments, steps);
  MorphResult result;
  if (arguments.size() == 1 || options.maximumWork != Effort::unlimited) {
    for (const Arguments& t : arguments) {
      progress.check();
      result.regions.push_back(evaluation.at(t, steps));
    }
  } else {
    result.regions = atTheSameTime(evaluation, arguments, progress);
  }
  result.sums = evaluation.sums();
  result.evaluation = evaluation.evaluation();
  result.deviation = evaluation.deviation();
  result.warnings = evaluation.warnings();
  return result;
}

}  // namespace blossom::minkowski
