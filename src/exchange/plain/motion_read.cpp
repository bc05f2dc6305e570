#include "exchange/plain/motion_read.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>

#include "core/error.h"
#include "exchange/plain/motion_edits.h"
#include "exchange/plain/motion_node.h"

namespace blossom {

namespace {

void requireKnotCount(const MotionNode& node, std::size_t knots, int degree, std::size_t poles) {
  const std::size_t order = static_cast<std::size_t>(degree) + 1;
  if (poles < order) node.fail(fmt::format("belongs to {} poles; degree {} needs at least {}", poles, degree, order));
  if (knots != poles + order)
    node.fail(
        fmt::format("must hold {} knots ({} poles + degree {} + 1); it holds {}", poles + order, poles, degree, knots));
}

/// Both ends have multiplicity degree + 1, and nothing between is torn apart.
void requireClamped(const MotionNode& node, const std::vector<double>& knots, int degree) {
  const std::size_t p = static_cast<std::size_t>(degree), last = knots.size() - 1;
  if (knots[0] != knots[p]) node.fail(fmt::format("must be clamped: its first {} knots must be equal", degree + 1));
  if (knots[last] != knots[last - p]) node.fail(fmt::format("must be clamped: its last {} knots must be equal", degree + 1));
  if (!(knots[p] < knots[last - p])) node.fail("must span more than one value");
}

void requireContinuous(const MotionNode& node, const std::vector<double>& knots, int degree, std::size_t first,
                       std::size_t end) {
  const std::size_t p = static_cast<std::size_t>(degree);
  for (std::size_t i = first; i + p < end; ++i)
    if (knots[i] == knots[i + p])
      node[i].fail(fmt::format("is repeated more than {} times, which tears the factor apart", degree));
}

Curve readTrajectory(const MotionNode& node) {
  node.requireObject({"degree", "knots", "poles", "weights"});
  Curve curve{node.at("degree").degree(), node.at("knots").knots(), {}};
  const MotionNode poles = node.at("poles");
  const std::size_t count = poles.arraySize("points [x, y, z]");
  std::optional<MotionNode> weights;
  if (node.has("weights")) {
    weights.emplace(node.at("weights"));
    if (weights->arraySize("numbers") != count)
      weights->fail(fmt::format("must hold one weight for each of the {} poles", count));
  }
  for (std::size_t i = 0; i < count; ++i) {
    const Vec3 point = poles[i].numbers<3>("a point [x, y, z]");
    const double weight = weights ? (*weights)[i].number() : 1.0;
    if (weight <= 0) (*weights)[i].fail(fmt::format("must be above 0; it is {}", weight));
    curve.poles.emplace_back(point.x() * weight, point.y() * weight, point.z() * weight, weight);
  }
  const MotionNode knots = node.at("knots");
  requireKnotCount(knots, curve.knots.size(), curve.degree, count);
  requireClamped(knots, curve.knots, curve.degree);
  requireContinuous(knots, curve.knots, curve.degree, 1, curve.knots.size() - 1);
  return curve;
}

struct SurfaceForm {
  const char* pole;     ///< what a pole must be
  bool positiveFourth;  ///< its last component is a weight
  double sign;          ///< of the rows that follow after one period; 0: not closed
};

/// The poles, u rows of v columns. @returns the number of rows.
std::size_t readPoles(const MotionNode& node, const SurfaceForm& form, std::vector<Vec4>& poles) {
  const std::size_t rows = node.arraySize("rows of poles, one for each u");
  std::size_t columns = 0;
  for (std::size_t i = 0; i < rows; ++i) {
    const MotionNode row = node[i];
    const std::size_t count = row.arraySize("poles, one for each v");
    if (i == 0) columns = count;
    if (count != columns) row.fail(fmt::format("must hold {} poles like the first row; it holds {}", columns, count));
    if (rows * columns > motionFileEntries)
      node.fail(fmt::format("holds {} poles; at most {} can be read", rows * columns, motionFileEntries));
    for (std::size_t j = 0; j < count; ++j) {
      const MotionNode at = row[j];
      poles.push_back(at.numbers<4>(form.pole));
      if (form.positiveFourth && poles.back()[3] <= 0)
        at[3].fail(fmt::format("is a weight and must be above 0; it is {}", poles.back()[3]));
    }
  }
  return rows;
}

/// u knots of a closed factor: one period u0..un for n rows, or the unwrapped vector for n + degree rows' worth of knots.
Surface closeInU(const MotionNode& knotsMotionNode, int degreeU, int degreeV, std::vector<double> knotsU,
                 std::vector<double> knotsV, std::vector<Vec4> poles, std::size_t rows, double sign) {
  const std::size_t p = static_cast<std::size_t>(degreeU);
  std::vector<double> period = knotsU;
  if (knotsU.size() == rows + 1 + 2 * p) {
    period.assign(knotsU.begin() + degreeU, knotsU.end() - degreeU);
  } else if (knotsU.size() != rows + 1) {
    knotsMotionNode.fail(
        fmt::format("must hold the {} knots of one period (rows + 1) or all {} (rows + 2 degree + 1) of a closed motion "
                    "with {} rows; it holds {}",
                    rows + 1, rows + 1 + 2 * p, rows, knotsU.size()));
  }
  const double length = period.back() - period.front();
  if (!(length > 0)) knotsMotionNode.fail("must span more than one value");
  Surface surface = unwrapped(degreeU, degreeV, period, std::move(knotsV), std::move(poles), sign);
  if (knotsU.size() != period.size()) {
    for (std::size_t i = 0; i < knotsU.size(); ++i)
      if (std::abs(knotsU[i] - surface.knotsU[i]) > 1e-12 * length)
        knotsMotionNode[i].fail(fmt::format("must be {} to continue the period; it is {}", surface.knotsU[i], knotsU[i]));
    surface.knotsU = std::move(knotsU);
  }
  requireContinuous(knotsMotionNode, period, degreeU, 0, period.size());
  if (const int times = seamMultiplicity(period); times > degreeU)
    knotsMotionNode.fail(
        fmt::format("repeats the knot of the seam, {} = {}, {} times, more than {}, which tears the factor apart",
                    period.front(), period.back(), times, degreeU));
  return surface;
}

Surface readSurface(const MotionNode& node, const SurfaceForm& form) {
  const MotionNode degree = node.at("degree"), knots = node.at("knots");
  if (!degree.value.is_array() || degree.value.size() != 2) degree.fail("must be two degrees [in u, in v]");
  if (!knots.value.is_array() || knots.value.size() != 2) knots.fail("must be two knot vectors [in u, in v]");
  const int degreeU = degree[0].degree(), degreeV = degree[1].degree();
  std::vector<double> knotsU = knots[0].knots(), knotsV = knots[1].knots();
  std::vector<Vec4> poles;
  const std::size_t rows = readPoles(node.at("poles"), form, poles), columns = poles.size() / rows;
  requireKnotCount(knots[1], knotsV.size(), degreeV, columns);
  requireClamped(knots[1], knotsV, degreeV);
  requireContinuous(knots[1], knotsV, degreeV, 1, knotsV.size() - 1);
  if (form.sign != 0)
    return closeInU(knots[0], degreeU, degreeV, std::move(knotsU), std::move(knotsV), std::move(poles), rows, form.sign);
  requireKnotCount(knots[0], knotsU.size(), degreeU, rows);
  requireClamped(knots[0], knotsU, degreeU);
  requireContinuous(knots[0], knotsU, degreeU, 1, knotsU.size() - 1);
  return {degreeU, degreeV, std::move(knotsU), std::move(knotsV), std::move(poles)};
}

ClosedU readClosedU(const MotionNode& node) {
  if (!node.has("closed_u")) return ClosedU::No;
  const MotionNode closed = node.at("closed_u");
  if (closed.value == "anti-periodic") return ClosedU::AntiPeriodic;
  if (closed.value == "periodic") return ClosedU::Periodic;
  if (closed.value == false) return ClosedU::No;
  closed.fail("must be \"anti-periodic\" (one full turn), \"periodic\" or false");
}

/// The file vouches for the signs of its quaternions.
bool readSignsKept(const MotionNode& node) {
  if (!node.has(motionFileSigns)) return false;
  const MotionNode signs = node.at(motionFileSigns);
  if (signs.value != motionFileSignsKept)
    signs.fail(fmt::format("must be \"{}\" or left out: then they are aligned where they look lost", motionFileSignsKept));
  return true;
}

void align(Motion& motion, std::vector<std::string>& warnings) {
  const QuaternionAlignment alignment = alignQuaternions(motion);
  if (alignment.flipped > 0)
    warnings.push_back(
        fmt::format("The signs of {} orientation poles were aligned with their neighbours: every pole is the same rotation, "
                    "and from one to the next the motion turns the shorter way.",
                    alignment.flipped));
  if (alignment.opposed > 0)
    warnings.push_back(fmt::format(
        "Neighbouring orientation poles turn by more than half a turn near orientation.poles[{}][{}]; {}check "
        "orientation.closed_u and the poles there.",
        alignment.row, alignment.column, alignment.flipped > 0 ? "" : "they turn the way that the file's signs say; "));
}

void requireDomain(const std::string& path, std::pair<double, double> domain, std::pair<double, double> wanted,
                   const char* direction) {
  if (domain == wanted) return;
  throw Error(ErrorCode::FormatDamaged,
              fmt::format("{} must run from {} to {} in {} like orientation; it runs from {} to {}.", path, wanted.first,
                          wanted.second, direction, domain.first, domain.second),
              "All factors of a motion share one domain.");
}

/// Knots inside the domain, each one of the factor's own.
std::vector<double> readBaseKnots(const MotionNode& node, const SplineSpace& factor) {
  if (!node.value.is_array()) node.fail("must be a list of knots");
  if (node.value.empty()) return {};
  const std::vector<double> knots = node.knots(), own = innerKnots(factor);
  auto next = own.begin();
  for (std::size_t i = 0; i < knots.size(); ++i) {
    next = std::lower_bound(next, own.end(), knots[i]);
    if (next == own.end() || *next != knots[i])
      node[i].fail("must be one of the factor's own knots inside its domain, as often as it has it at most");
    ++next;
  }
  return knots;
}

std::array<std::vector<double>, 2> readBaseKnots(const MotionNode& node, const SplineSpace& u, const SplineSpace& v) {
  if (!node.value.is_array() || node.value.size() != 2) node.fail("must be two lists of knots [in u, in v]");
  return {readBaseKnots(node[0], u), readBaseKnots(node[1], v)};
}

BaseKnots readBase(const MotionNode& node, const Motion& motion) {
  node.requireObject({"trajectory", "orientation", "scaling"});
  const auto knots = [&](const char* name, const Surface& factor) {
    return readBaseKnots(node.at(name), spaceInU(factor, 0), spaceInV(factor));
  };
  return {readBaseKnots(node.at("trajectory"), spaceOf(motion.trajectory)), knots("orientation", motion.orientation),
          knots("scaling", motion.scaling)};
}

}  // namespace

Motion readMotion(const Value& value, std::vector<std::string>& warnings) {
  const MotionNode root{value, ""};
  root.requireObject({"trajectory", "orientation", "scaling", "point", "edits", "base"});
  Motion motion;
  motion.trajectory = readTrajectory(root.at("trajectory"));
  const MotionNode orientation = root.at("orientation"), scaling = root.at("scaling");
  orientation.requireObject({"degree", "knots", "poles", "closed_u", motionFileSigns});
  scaling.requireObject({"degree", "knots", "poles", "closed_u"});
  motion.closedU = readClosedU(orientation);
  if (readClosedU(scaling) != ClosedU::No && motion.closedU == ClosedU::No)
    scaling.at("closed_u").fail("says that scaling is closed, but orientation.closed_u does not");
  const double sign = motion.closedU == ClosedU::AntiPeriodic ? -1 : 1;
  const bool closed = motion.closedU != ClosedU::No;
  motion.orientation = readSurface(orientation, {"a quaternion [w, x, y, z]", false, closed ? sign : 0});
  motion.scaling = readSurface(scaling, {"a scaling [sx, sy, sz, sw]", true, closed ? 1.0 : 0});
  requireDomain("trajectory", motion.trajectory.domain(), motion.domainV(), "v");
  requireDomain("scaling", motion.scaling.domainU(), motion.domainU(), "u");
  requireDomain("scaling", motion.scaling.domainV(), motion.domainV(), "v");
  motion.point = root.at("point").numbers<3>("a point [x, y, z]");
  if (!readSignsKept(orientation)) align(motion, warnings);
  if (root.has("edits")) motion.edits = readEdits(root.at("edits"));
  if (root.has("base")) motion.base = readBase(root.at("base"), motion);
  return motion;
}

}  // namespace blossom
