#include "kernel/morphology.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "core/error.h"
#include "core/stopwatch.h"
#include "kernel/finished.h"
#include "kernel/prepared.h"
#include "kernel/united.h"

namespace blossom::morphology {

namespace {

/// One operation: its counters, and the steps that several of them share.
class Work {
 public:
  explicit Work(const Progress& progress) : progress_(progress) {}

  [[nodiscard]] Prepared prepare(const Operand& operand, const CommonGrid& grid, double from, double to) {
    Stopwatch watch;
    Prepared made = prepared(operand, grid, progress_.part(from, to));
    stats_.checkMs += watch.lapMs();
    warnings_.insert(warnings_.end(), made.warnings.begin(), made.warnings.end());
    return made;
  }

  [[nodiscard]] Parts apart(const Prepared& operand, double from, double to) {
    Stopwatch watch;
    progress_.report(from, "Taking apart");
    Parts parts = partsOf(operand, progress_.part(from, to));
    stats_.decomposeMs += watch.lapMs();
    return parts;
  }

  [[nodiscard]] Solid sum(const Parts& a, const Parts& b, double from, double to) {
    stats_.partsA = partCount(a);
    stats_.partsB = partCount(b);
    SumCounts counts;
    Solid made = sumOf(a, b, counts, progress_.part(from, to));
    stats_.pairs += counts.pairs;
    stats_.candidates += counts.candidates;
    stats_.sumMs += counts.sumMs;
    stats_.uniteMs += counts.uniteMs;
    return made;
  }

  /// weightA a + weightB b of two solids.
  [[nodiscard]] Solid nefSum(const Prepared& a, double weightA, const Prepared& b, double weightB, double from, double to) {
    Stopwatch watch;
    stats_.way = Way::Nef;
    Solid made = minkowskiSum(a.solid, weightA, b.solid, weightB, progress_.part(from, to));
    stats_.sumMs += watch.lapMs();
    return made;
  }

  [[nodiscard]] Parts outside(const Solid& solid, const Bounds& frame, double from, double to) {
    Stopwatch watch;
    progress_.report(from, "Taking apart");
    Parts parts = convexPartsOutside(solid, frame, progress_.part(from, to));
    stats_.decomposeMs += watch.lapMs();
    return parts;
  }

  /// An exact result as an operand, rounded as if it came from a file: it has faces that are bent by less than rounding, and
  /// every bend would be taken apart. As it is where rounding would make it cross itself.
  [[nodiscard]] Prepared asOperand(const Solid& solid, const Bounds& bounds, const CommonGrid& grid, double from,
                                   double to) {
    Prepared made;
    made.solid = solid;
    made.bounds = bounds;
    if (isConvex(solid)) return made;
    Operand rounded;
    rounded.mesh = finished(solid, Vec3::Zero(), progress_.part(from, (from + to) / 2)).mesh;
    try {
      made = prepared(rounded, grid, progress_.part((from + to) / 2, to));
    } catch (const Error& error) {
      if (error.code() != ErrorCode::InvalidInput) throw;
    }
    return made;
  }

  /// The operand as it is, its bodies made one where they meet.
  void finish(const Prepared& operand, double from, double to) {
    finish(operand.bodiesMeet ? united(operand.solid) : operand.solid, operand.centre, from, to);
  }
  void finish(const Solid& solid, const Vec3& centre, double from, double to) {
    Stopwatch watch;
    finish(finished(solid, centre, progress_.part(from, to)), watch);
  }
  void finish(const Prism& prism, const Vec3& centre, double from, double to) {
    stats_.prisms = true;
    Stopwatch watch;
    finish(finished(trianglesOf(prism, progress_.part(from, to)), centre, progress_.part(from, to)), watch);
  }
  void add(Mesh mesh) { solids_.push_back(std::move(mesh)); }
  void warn(std::string sentence) { warnings_.push_back(std::move(sentence)); }

  [[nodiscard]] MorphologyResult result() {
    progress_.report(1);
    return {std::move(solids_), stats_, std::move(warnings_)};
  }
  [[nodiscard]] const Progress& progress() const { return progress_; }
  MorphologyStats& stats() { return stats_; }

 private:
  void finish(Finished made, Stopwatch& watch) {
    solids_.push_back(std::move(made.mesh));
    if (!made.warning.empty()) warn(std::move(made.warning));
    stats_.outputMs += watch.lapMs();
  }

  const Progress& progress_;
  MorphologyStats stats_;
  std::vector<Mesh> solids_;
  std::vector<std::string> warnings_;
};

Bounds plus(const Bounds& a, const Bounds& b) {
  Bounds sum;
  sum.add(a.low + b.low);
  sum.add(a.high + b.high);
  return sum;
}

/// {x : x + b inside a} of boxes; empty when b is as large as a.
Bounds minus(const Bounds& a, const Bounds& b) {
  Bounds room;
  const Vec3 low = a.low - b.low, high = a.high - b.high;
  if ((high - low).minCoeff() <= 0) return room;
  room.add(low);
  room.add(high);
  return room;
}

/// What remains of a solid by different elements; what lies outside of it is taken apart once.
class Eroder {
 public:
  Eroder(Work& work, Solid solid, const Bounds& bounds) : work_(work), solid_(std::move(solid)), bounds_(bounds) {}

  /// `reach` are the bounds of the element.
  [[nodiscard]] Solid by(const Parts& element, const Bounds& reach, double grid, double from, double to) {
    const Bounds room = minus(bounds_, reach);
    if (room.empty) return nullptr;
    if (isConvex(solid_)) {
      work_.stats().partsA = 1;
      work_.stats().partsB = partCount(element);
      Stopwatch watch;
      Solid made = shrunk(solid_, element, work_.progress().part(from, to));
      work_.stats().sumMs += watch.lapMs();
      return made;
    }
    const double third = (to - from) / 3;
    if (!outside_) outside_ = work_.outside(solid_, bounds_, from, from + third);
    const Solid beyond = work_.sum(outside_, scaled(element, -1, grid), from + third, to);
    Stopwatch watch;
    Solid made = cutFrom(room, beyond, work_.progress());
    work_.stats().uniteMs += watch.lapMs();
    return made;
  }

 private:
  Work& work_;
  Solid solid_;
  Bounds bounds_;
  Parts outside_;
};

void requireSolid(const Operand& operand) {
  if (operand.form != Operand::Form::Body)
    throw Error(ErrorCode::InvalidInput, fmt::format("{} is not a solid: it has no volume.", operand.name),
                "Extrude it first, or choose a solid or a closed mesh.");
}

[[noreturn]] void nothingLeft(const std::string& name, const std::string& remedy) {
  throw Error(ErrorCode::Degenerate,
              fmt::format("Nothing is left of {}: there is no room in it for what it is melted by.", name), remedy);
}

std::string inSentence(std::string name) {
  if (!name.empty() && name[0] == 'T') name[0] = 't';
  return name;
}

constexpr const char* smallerElement = "Choose a smaller second shape.";

struct Pair {
  CommonGrid grid;
  Prepared a, b;
};

Pair prepare(Work& work, const Operand& a, const Operand& b) {
  const CommonGrid grid = gridFor(a.bounds(), b.bounds());
  Pair pair{grid, work.prepare(a, grid, 0, 0.05), {}};
  pair.b = work.prepare(b, grid, 0.05, 0.1);
  return pair;
}

/// Both as prisms along one axis.
struct PrismPair {
  Prism a, b;
};
std::optional<PrismPair> asPrisms(const Pair& pair) {
  for (const Prism& a : pair.a.prisms)
    for (const Prism& b : pair.b.prisms)
      if (a.axis == b.axis) return PrismPair{a, b};
  return std::nullopt;
}

void refuseFlatSum(const Solid& sum) {
  if (isEmpty(sum))
    throw Error(ErrorCode::Degenerate, "The sum has no volume: both shapes are thin, and in one plane or one line.",
                "Choose a solid for one of them.");
}

}  // namespace

MorphologyResult solidSum(const Operand& a, const Operand& b, const Progress& progress, Way way) {
  if (way == Way::Nef) {
    requireSolid(a);
    requireSolid(b);
  }
  Work work(progress);
  const Pair pair = prepare(work, a, b);
  if (const auto prisms = way == Way::Nef ? std::nullopt : asPrisms(pair)) {
    work.finish(sum(prisms->a, prisms->b, progress.part(0.1, 0.9)), pair.a.centre + pair.b.centre, 0.9, 1);
    return work.result();
  }
  const auto byParts = [&] {
    const Parts partsA = work.apart(pair.a, 0.1, 0.2), partsB = work.apart(pair.b, 0.2, 0.3);
    return work.sum(partsA, partsB, 0.3, 0.95);
  };
  const Solid sum = way == Way::Nef ? work.nefSum(pair.a, 1, pair.b, 1, 0.1, 0.95) : byParts();
  refuseFlatSum(sum);
  work.finish(sum, pair.a.centre + pair.b.centre, 0.95, 1);
  return work.result();
}

MorphologyResult solidDifference(const Operand& a, const Operand& b, const Progress& progress) {
  requireSolid(a);
  Work work(progress);
  const Pair pair = prepare(work, a, b);
  if (const auto prisms = asPrisms(pair)) {
    const auto left = difference(prisms->a, prisms->b, progress.part(0.1, 0.9));
    if (!left) nothingLeft(inSentence(a.name), smallerElement);
    work.finish(*left, pair.a.centre - pair.b.centre, 0.9, 1);
    return work.result();
  }
  Eroder eroder(work, pair.a.solid, pair.a.bounds);
  const Solid left = eroder.by(work.apart(pair.b, 0.1, 0.2), pair.b.bounds, pair.grid.step, 0.2, 0.95);
  if (isEmpty(left)) nothingLeft(inSentence(a.name), smallerElement);
  work.finish(left, pair.a.centre - pair.b.centre, 0.95, 1);
  return work.result();
}

MorphologyResult solidOpening(const Operand& a, const Operand& b, const Progress& progress) {
  requireSolid(a);
  Work work(progress);
  const Pair pair = prepare(work, a, b);
  if (const auto prisms = asPrisms(pair)) {
    const auto left = difference(prisms->a, prisms->b, progress.part(0.1, 0.5));
    if (!left) nothingLeft(inSentence(a.name), smallerElement);
    work.finish(sum(*left, prisms->b, progress.part(0.5, 0.9)), pair.a.centre, 0.9, 1);
    return work.result();
  }
  const Parts partsB = work.apart(pair.b, 0.1, 0.15);
  Eroder eroder(work, pair.a.solid, pair.a.bounds);
  const Solid left = eroder.by(partsB, pair.b.bounds, pair.grid.step, 0.15, 0.5);
  if (isEmpty(left)) nothingLeft(inSentence(a.name), smallerElement);
  const Prepared core = work.asOperand(left, minus(pair.a.bounds, pair.b.bounds), pair.grid, 0.5, 0.55);
  const Solid opened = work.sum(work.apart(core, 0.55, 0.6), partsB, 0.6, 0.95);
  work.finish(opened, pair.a.centre + core.centre, 0.95, 1);
  return work.result();
}

MorphologyResult solidClosing(const Operand& a, const Operand& b, const Progress& progress) {
  requireSolid(a);
  Work work(progress);
  const Pair pair = prepare(work, a, b);
  constexpr const char* lost = "The closing has lost the solid.";
  if (const auto prisms = asPrisms(pair)) {
    const auto closed = difference(sum(prisms->a, prisms->b, progress.part(0.1, 0.5)), prisms->b, progress.part(0.5, 0.9));
    if (!closed) throw Error(ErrorCode::Internal, lost, "Please report the two shapes.");
    work.finish(*closed, pair.a.centre, 0.9, 1);
    return work.result();
  }
  const Parts partsA = work.apart(pair.a, 0.1, 0.15), partsB = work.apart(pair.b, 0.15, 0.2);
  const Solid sum = work.sum(partsA, partsB, 0.2, 0.6);
  const Prepared grown = work.asOperand(sum, plus(pair.a.bounds, pair.b.bounds), pair.grid, 0.6, 0.65);
  Eroder eroder(work, grown.solid, grown.bounds);
  const Solid closed = eroder.by(partsB, pair.b.bounds, pair.grid.step, 0.65, 0.95);
  if (isEmpty(closed)) throw Error(ErrorCode::Internal, lost, "Please report the two shapes.");
  work.finish(closed, pair.a.centre + grown.centre, 0.95, 1);
  return work.result();
}

MorphologyResult solidMorph(const Operand& a, const Operand& b, const std::vector<double>& weights, const Progress& progress,
                            Way way) {
  requireSolid(a);
  requireSolid(b);
  Work work(progress);
  const Pair pair = prepare(work, a, b);
  const auto between = [](double w) { return w > 0 && w < 1; };
  const auto prisms = way == Way::Nef ? std::nullopt : asPrisms(pair);
  Parts partsA, partsB;
  if (way == Way::Corefined && !prisms && std::any_of(weights.begin(), weights.end(), between)) {
    partsA = work.apart(pair.a, 0.1, 0.15);
    partsB = work.apart(pair.b, 0.15, 0.2);
  }
  const double share = 0.8 / static_cast<double>(std::max<std::size_t>(1, weights.size()));
  double from = 0.2;
  for (const double w : weights) {
    if (!between(w)) {
      work.finish(w <= 0 ? pair.a : pair.b, from, from + share);
    } else if (prisms) {
      work.finish(sum(scaled(prisms->a, 1 - w), scaled(prisms->b, w), progress.part(from, from + 0.9 * share)),
                  (1 - w) * pair.a.centre + w * pair.b.centre, from + 0.9 * share, from + share);
    } else {
      const Solid sum = way == Way::Nef ? work.nefSum(pair.a, 1 - w, pair.b, w, from, from + 0.9 * share)
                                        : work.sum(scaled(partsA, 1 - w, pair.grid.step), scaled(partsB, w, pair.grid.step),
                                                   from, from + 0.9 * share);
      work.finish(sum, (1 - w) * pair.a.centre + w * pair.b.centre, from + 0.9 * share, from + share);
    }
    from += share;
  }
  return work.result();
}

namespace {

Operand ballOperand(double radius, const GrowOptions& options) {
  Operand operand;
  operand.mesh = ball({radius, options.subdivisions, options.fit}).mesh;
  operand.name = "The ball";
  return operand;
}

double largestOf(const std::vector<double>& radii) {
  return radii.empty() ? 0 : *std::max_element(radii.begin(), radii.end());
}

/// The solid itself where the radius is 0, otherwise what `step` makes of it with the ball; stops where that is nothing.
template <class Step>
void eachRadius(Work& work, const Operand& a, const GrowOptions& options, const Step& step) {
  requireSolid(a);
  const double largest = largestOf(options.radii);
  const Operand widest = ballOperand(largest > 0 ? largest : 1, options);
  const CommonGrid grid = gridFor(a.bounds(), widest.bounds());
  const Prepared solid = work.prepare(a, grid, 0, 0.1);
  const double share = 0.9 / static_cast<double>(std::max<std::size_t>(1, options.radii.size()));
  double from = 0.1;
  for (std::size_t k = 0; k < options.radii.size(); ++k, from += share) {
    const double radius = options.radii[k];
    if (!(radius > 0)) {
      work.finish(solid, from, from + share);
      continue;
    }
    Prepared element = prepared(ballOperand(radius, options), grid, Progress::none());
    const Solid made = step(solid, element, grid, from, from + 0.9 * share);
    if (isEmpty(made)) {
      if (k == 0 || (k == 1 && !(options.radii[0] > 0) && options.radii.size() == 2))
        nothingLeft(inSentence(a.name), "Choose a smaller radius.");
      work.warn(fmt::format("Nothing is left from a radius of {:.6g} mm on; the sequence ends after {} frames.", radius, k));
      break;
    }
    work.finish(made, solid.centre, from + 0.9 * share, from + share);
  }
}

}  // namespace

MorphologyResult inflated(const Operand& a, const GrowOptions& options, const Progress& progress, Way way) {
  Work work(progress);
  Parts parts;
  eachRadius(work, a, options,
             [&](const Prepared& solid, const Prepared& element, const CommonGrid&, double from, double to) {
               if (way == Way::Nef) return work.nefSum(solid, 1, element, 1, from, to);
               if (!parts) parts = work.apart(solid, from, from + 0.2 * (to - from));
               return work.sum(parts, partsOf(element, Progress::none()), from + 0.2 * (to - from), to);
             });
  return work.result();
}

MorphologyResult melted(const Operand& a, const GrowOptions& options, const Progress& progress) {
  Work work(progress);
  std::optional<Eroder> eroder;
  eachRadius(work, a, options,
             [&](const Prepared& solid, const Prepared& element, const CommonGrid& grid, double from, double to) {
               if (!eroder) eroder.emplace(work, solid.solid, solid.bounds);
               return eroder->by(partsOf(element, Progress::none()), element.bounds, grid.step, from, to);
             });
  return work.result();
}

}  // namespace blossom::morphology
