#include "geometry/crossing/crossing_search.h"

#include <Eigen/Geometry>
#include <algorithm>
#include <cmath>
#include <optional>
#include <vector>

#include "geometry/crossing/local_sheets.h"
#include "geometry/crossing/lying_sheets.h"

namespace blossom {
namespace {

constexpr std::size_t highestTried = 200, othersTried = 200;  ///< pairs on which Newton's method begins
constexpr int placesExamined = 20, placesAfterTheFirst = 2;   ///< of two sheets
constexpr std::size_t placesTried = 80;                       ///< those of one sheet included
constexpr double leastSine = 2e-3;  ///< of the angle between sheets: below, they are tangent as far as one can tell
constexpr int tangentExamined = 3, tangentTried = 40;  ///< places of two sheets, and those of one sheet included
constexpr double tangentApart = 100;                   ///< times the depth: nearer places of tangency are one
constexpr double shareOfSize = 0.3;                    ///< the widest ball
constexpr double deepEnough = 8;                       ///< times the depth that is looked for: no wider ball is asked
constexpr double firstRadius = 0.25;                   ///< of the depth that is looked for
constexpr double neededReach = 0.3;                    ///< the same: of the sheet that passes through, on one side
constexpr double offOfRadius = 0.01;                   ///< how far triangles of a ball may be off the smooth face
constexpr double leastOff = 0.01, greatestOff = 0.05;  ///< but of the depth
constexpr double clearOfError = 4;  ///< times that: a reach that the error of both sheets, 4/3 of it each, does not explain

/// The greatest heights, and some evenly chosen among the rest: artefacts of a thin wall may be many.
std::vector<TrianglePair> pairsChosen(const std::vector<TrianglePair>& pairs) {
  const std::size_t front = std::min(pairs.size(), highestTried);
  std::vector<TrianglePair> result(pairs.begin(), pairs.begin() + static_cast<std::ptrdiff_t>(front));
  const std::size_t stride = std::max<std::size_t>(1, (pairs.size() - front) / othersTried);
  for (std::size_t k = front; k < pairs.size(); k += stride) result.push_back(pairs[k]);
  return result;
}

/// The parameters of a point of a triangle, from its share in every corner.
Vec2 parametersAt(const SheetTriangle& t, const std::array<Vec3, 3>& at, const Vec3& p) {
  const Vec3 a = at[1] - at[0], b = at[2] - at[0], x = p - at[0];
  const double aa = a.dot(a), ab = a.dot(b), bb = b.dot(b), ax = a.dot(x), bx = b.dot(x);
  const double whole = aa * bb - ab * ab;
  if (!(whole > 0)) return (t.at[0] + t.at[1] + t.at[2]) / 3;
  const double s = std::clamp((bb * ax - ab * bx) / whole, 0.0, 1.0);
  const double r = std::clamp((aa * bx - ab * ax) / whole, 0.0, 1.0 - s);
  return t.at[0] + s * (t.at[1] - t.at[0]) + r * (t.at[2] - t.at[0]);
}

double longestSide(const std::array<Vec3, 3>& t) {
  return std::max({(t[1] - t[0]).norm(), (t[2] - t[1]).norm(), (t[0] - t[2]).norm()});
}

/// Balls around a meeting of tangent sheets, each twice as wide as the one before, as long as the sheets are two in them.
class TangentBalls {
 public:
  TangentBalls(SheetSurroundings& around, const SheetMeeting& meeting, double first, double widest, const Progress& progress)
      : around_(around), meeting_(meeting), first_(first), progress_(progress) {
    while (radius(count_) <= widest && !around.hangTogether(meeting, radius(count_))) ++count_;
    sketches_.resize(count_);
  }

  [[nodiscard]] std::size_t count() const { return count_; }
  [[nodiscard]] double radius(std::size_t k) const { return std::ldexp(first_, static_cast<int>(k)); }
  const SheetSurroundings::Sketch& sketch(std::size_t k) {
    if (!sketches_[k]) sketches_[k] = around_.sketchAt(meeting_, radius(k), progress_);
    return *sketches_[k];
  }

  /// The first ball in which the sheets leave one another. What keeps within `together` in a ball does so in narrower ones,
  /// so that few of them need be looked at.
  std::size_t firstParted(double together) {
    const auto isTogether = [&](std::size_t k) { return sketch(k).apart && sketch(k).greatest <= together; };
    std::size_t low = 0, high = count_;  // below `low` together, from `high` on perhaps not
    for (std::size_t k = count_; low < high; k = (low + high) / 2) {
      if (k == count_) k = count_ - 1;
      (isTogether(k) ? low = k + 1 : high = k);
    }
    togetherAtFirst_ = low > 0;
    return low;
  }
  /// Asked after firstParted.
  [[nodiscard]] bool partAtOnce() const { return !togetherAtFirst_; }

 private:
  SheetSurroundings& around_;
  const SheetMeeting& meeting_;
  double first_;
  const Progress& progress_;
  std::size_t count_ = 0;
  std::vector<std::optional<SheetSurroundings::Sketch>> sketches_;
  bool togetherAtFirst_ = false;
};

class Examiner {
 public:
  Examiner(const SheetMesh& mesh, const SmoothSheets& sheets, const CrossingOptions& o, const Progress& progress)
      : mesh_(mesh), sheets_(sheets), around_(mesh, sheets), depth_(o.depth * mesh.size), progress_(progress) {}

  CrossingResult run(const MeetingTriangles& found) {
    CrossingResult result;
    result.size = mesh_.size;
    result.triangles = mesh_.triangles.size();
    result.pairs = found.pairs.size();
    int left = placesExamined, tangentLeft = tangentExamined, tangentTries = tangentTried;
    for (const TrianglePair& pair : pairsChosen(found.pairs)) {
      if (left == 0 || examined_.size() == placesTried) break;
      progress_.check();
      const auto meeting = meetingOf(pair);
      if (!meeting || isOnePlace(*meeting)) continue;
      const bool tangent = meeting->sine < leastSine;
      if (tangent) tellIfCovered(*meeting, result);
      if (tangent && (tangentLeft == 0 || tangentTries == 0 || isNear(tangent_, meeting->point, tangentApart))) continue;
      if (isNear(examined_, meeting->point, result.deepest ? 10 : firstRadius)) continue;
      if (!tangent) ++result.meetings, examined_.push_back(meeting->point);
      const std::optional<double> depth = tangent ? depthOfTangent(*meeting) : depthAt(*meeting);
      if (tangent) --tangentTries;
      if (tangent && depth) --tangentLeft, ++result.meetings, tangent_.push_back(meeting->point);
      if (!tangent && depth) --left;
      if (depth.value_or(0) <= 0) continue;
      if (!result.deepest) left = std::min(left, placesAfterTheFirst);
      if (!result.deepest || *depth > result.deepest->depth)
        result.deepest = SurfaceCrossing{meeting->point, meeting->first, meeting->second, *depth};
    }
    for (const auto* lying : {&found.lying, &found.alike})
      for (const TrianglePair& pair : *lying)
        if (const auto meeting = result.covered ? std::nullopt : meetingOf(pair); meeting && !isOnePlace(*meeting))
          tellIfCovered(*meeting, result);
    result.divided = around_.trianglesDivided();
    return result;
  }

 private:
  void tellIfCovered(const SheetMeeting& meeting, CrossingResult& result) const {
    if (!result.covered && sheets_.areOneSurface() && lieOnEachOther(sheets_, meeting, 2 * depth_, mesh_.size))
      result.covered = meeting.point;
  }
  [[nodiscard]] std::optional<SheetMeeting> meetingOf(const TrianglePair& pair) const {
    const SheetTriangle &a = mesh_.triangles[pair.first], &b = mesh_.triangles[pair.second];
    const auto atA = mesh_.at(a), atB = mesh_.at(b);
    const double reach = 2 * (longestSide(atA) + longestSide(atB));
    auto meeting = meet(sheets_, {a.face, parametersAt(a, atA, pair.place)}, {b.face, parametersAt(b, atB, pair.place)},
                        reach, mesh_.size);
    if (!meeting) return {};
    // Beyond a seam another surface goes on.
    const auto inside = [&](const SheetPlace& p) { return SheetPlace{p.face, sheets_.withinDomain(p.face, p.at)}; };
    const SheetPlace first = inside(meeting->first), second = inside(meeting->second);
    if (first.at == meeting->first.at && second.at == meeting->second.at) return meeting;
    return meet(sheets_, first, second, reach, mesh_.size);
  }

  /// Of one face, too: neighbours whose triangles touch because a corner of one lies on a side of the other.
  [[nodiscard]] bool isOnePlace(const SheetMeeting& meeting) const {
    constexpr double same = 1e-6;  // of the size
    if (meeting.first.face != meeting.second.face) return false;
    const SurfaceFrame frame = sheets_.frame(meeting.first.face, meeting.first.at);
    const Vec2 apart = sheets_.apart(meeting.first.face, meeting.first.at, meeting.second.at);
    return apart.x() * frame.du.norm() + apart.y() * frame.dv.norm() <= same * mesh_.size;
  }

  /// @param near as a multiple of the depth
  [[nodiscard]] bool isNear(const std::vector<Vec3>& places, const Vec3& point, double near) const {
    return std::any_of(places.begin(), places.end(),
                       [&](const Vec3& other) { return (other - point).norm() < near * depth_; });
  }

  [[nodiscard]] double offIn(double radius) const {
    return std::clamp(offOfRadius * radius, leastOff * depth_, greatestOff * depth_);
  }
  [[nodiscard]] Passage passageIn(const SheetMeeting& meeting, double radius) {
    return around_.passageAt(meeting, radius, offIn(radius), progress_);
  }

  /// In balls that grow as long as there are two sheets in them; 0 when the sheets do not pass through each other. They
  /// begin where sheets at that angle could be told apart, and end where sheets that pass through each other would have
  /// shown it. On one side a slit may be all that a sheet reaches into, so there it is enough that the reach is no error;
  /// on the other it must be as deep as is looked for, be it in a wider ball, whose error is greater.
  [[nodiscard]] std::optional<double> depthAt(const SheetMeeting& meeting) {
    const double needed = neededReach * depth_;
    const double widest = std::min(shareOfSize * mesh_.size, 8 * depth_ / meeting.sine);
    std::optional<double> found;
    double depth = 0, greater = 0;
    double radius = std::max(firstRadius * depth_, 1.5 * clearOfError * leastOff * depth_ / meeting.sine);
    for (int worse = 0; radius <= widest && worse < 2 && !(greater >= needed && depth >= deepEnough * depth_); radius *= 2) {
      const Passage passage = passageIn(meeting, radius);
      if (!passage.apart) break;
      greater = std::max({greater, passage.greater, passage.lesser >= 0.25 * radius ? needed : 0});
      if (passage.lesser >= clearOfError * offIn(radius) && passage.lesser > depth)
        depth = passage.lesser, worse = 0;
      else if (depth > 0 && greater >= needed)
        ++worse;
      found = greater >= needed ? depth : 0;
    }
    return found;
  }

  /// The same where the sheets are tangent, so that small balls tell nothing: they touch when the first ball in which they
  /// part has one of them on one side only. Wider ones may hold parts of it that come round the border of the other.
  [[nodiscard]] std::optional<double> depthOfTangent(const SheetMeeting& meeting) {
    const double needed = neededReach * depth_;
    TangentBalls balls(around_, meeting, 2 * depth_, shareOfSize * mesh_.size, progress_);
    if (balls.count() == 0) return {};
    std::optional<double> found;
    int worse = 0;
    for (std::size_t k = balls.firstParted(0.5 * clearOfError * leastOff * depth_); k < balls.count() && worse < 2; ++k) {
      const double radius = balls.radius(k), through = clearOfError * offIn(radius), before = found.value_or(0);
      const auto& sketch = balls.sketch(k);
      if (before <= 0 && sketch.apart && sketch.lesser < 0.5 * through) {
        found = 0;
        if (sketch.least >= 2 * needed) break;
        continue;
      }
      const Passage passage = passageIn(meeting, radius);
      if (!passage.apart) break;
      found = passage.lesser >= through && passage.greater >= needed ? std::max(before, passage.lesser) : before;
      if (before > 0 && *found <= before) ++worse;
      if (*found >= deepEnough * depth_ || (*found <= 0 && passage.greater >= 2 * needed)) break;
    }
    return found || !balls.partAtOnce() ? std::optional(found.value_or(0)) : found;
  }

  const SheetMesh& mesh_;
  const SmoothSheets& sheets_;
  SheetSurroundings around_;
  double depth_;
  const Progress& progress_;
  std::vector<Vec3> examined_, tangent_;
};

}  // namespace

CrossingResult searchCrossing(const SheetMesh& mesh, const SmoothSheets& sheets, const MeetingTriangles& found,
                              const CrossingOptions& o, const Progress& progress) {
  return Examiner(mesh, sheets, o, progress).run(found);
}

}  // namespace blossom
