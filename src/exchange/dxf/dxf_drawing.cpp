#include "exchange/dxf/dxf_drawing.h"

#include <dl_creationadapter.h>
#include <dl_dxf.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "core/angle.h"
#include "core/tolerance.h"
#include "geometry/bspline/bspline.h"
#include "geometry/planar/interpolate.h"
#include "geometry/planar/planar.h"

namespace blossom {

using namespace parse;

namespace {

/// Counter-clockwise sweep from one angle to another, in (0, 2 pi].
double sweepBetween(double start, double end) {
  const double sweep = std::fmod(end - start, fullTurn);
  return sweep <= 1e-12 ? sweep + fullTurn : sweep;
}

std::string blockKey(std::string name) {
  std::transform(name.begin(), name.end(), name.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
  return utf8(name);
}

struct DxfVertex {
  Vec2 point;
  double bulge = 0;
};

/// Segments through the vertices; coincident neighbours count once.
Path polylinePath(const std::vector<DxfVertex>& vertices, bool closed) {
  Path path;
  const std::size_t n = vertices.size();
  for (std::size_t i = 0; i + (closed ? 0 : 1) < n; ++i) {
    const Vec2 &from = vertices[i].point, &to = vertices[(i + 1) % n].point;
    if ((to - from).norm() > 0) path.segments.push_back(bulgeSegment(from, to, vertices[i].bulge));
  }
  path.closed = closed && !path.segments.empty();
  return path;
}

bool meets(const Vec2& a, const Vec2& b) { return (a - b).norm() <= Tolerance{}.confusion; }

/// Takes what dxflib reads and keeps it in blocks.
class Collector final : public DL_CreationAdapter {
 public:
  Collector(const CleanDxf& clean, const Progress& progress) : clean_(clean), progress_(progress) {}

  DxfDrawing take() {
    finishPolyline();
    return std::move(drawing_);
  }

  // dxflib calls this after every object, so it identifies the current one.
  void endSection() override {
    if (++objects_ % 1024 == 0) progress_.check();
  }
  void setVariableInt(const std::string& key, int value, int) override {
    if (key == "$INSUNITS") drawing_.unit = value;
  }
  void addLayer(const DL_LayerData& layer) override {
    drawing_.layers[utf8(layer.name)] = {utf8(layer.name), std::abs(colorIndex()), attributes.getColor24()};
  }

  void addBlock(const DL_BlockData& data) override {
    finishPolyline();
    DxfBlock& block = drawing_.blocks[blockKey(data.name)];
    block = {Vec2(data.bpx, data.bpy), {}};
    target_ = &block;
  }
  void endBlock() override {
    finishPolyline();
    target_ = &drawing_.model;
  }

  void addLine(const DL_LineData& d) override {
    if (d.z1 != d.z2) ++drawing_.flattened;
    const Line2 line{{d.x1, d.y1}, {d.x2, d.y2}};
    if (line.from != line.to) return add({{line}}, false);
    ++drawing_.degenerate;
    if (target_ == &drawing_.model) drawing_.point = line.from;
  }
  void addArc(const DL_ArcData& d) override {
    const double start = toRadians(d.angle1);
    addRound(Arc2{{d.cx, d.cy}, d.radius, start, sweepBetween(start, toRadians(d.angle2))}, false);
  }
  void addCircle(const DL_CircleData& d) override { addRound(Arc2{{d.cx, d.cy}, d.radius, 0, fullTurn}, true); }
  void addEllipse(const DL_EllipseData&) override;

  void addPolyline(const DL_PolylineData& d) override {
    finishPolyline();
    polyline_.emplace(Polyline{item(), (d.flags & 8) != 0, (d.flags & 1) != 0, plane(), {}, 0, false});
  }
  void addVertex(const DL_VertexData& d) override {
    if (!polyline_) return;
    if (polyline_->vertices.empty())
      polyline_->height = d.z;
    else if (d.z != polyline_->height)
      polyline_->climbs = true;
    polyline_->vertices.push_back({{d.x, d.y}, d.bulge});
  }
  void endSequence() override { finishPolyline(); }

  void addSpline(const DL_SplineData& d) override {
    finishPolyline();
    spline_.emplace(d);
    poles_.clear();
    fits_.clear();
    knots_.clear();
    heights_.clear();
  }
  void addControlPoint(const DL_ControlPointData& d) override {
    poles_.emplace_back(d.x, d.y, d.w);
    heights_.push_back(d.z);
  }
  void addFitPoint(const DL_FitPointData& d) override {
    fits_.emplace_back(d.x, d.y);
    heights_.push_back(d.z);
  }
  void addKnot(const DL_KnotData& d) override { knots_.push_back(d.k); }

  void addHatch(const DL_HatchData&) override {
    finishPolyline();
    hatch_ = true;
    loops_.clear();
  }
  void addHatchLoop(const DL_HatchLoopData&) override { loops_.emplace_back(); }
  void addHatchEdge(const DL_HatchEdgeData& edge) override {
    // Taken over at once: a copy would carry members that dxflib never set.
    if (!loops_.empty()) addTo(loops_.back(), edge);
  }
  void addInsert(const DL_InsertData&) override;

  // Ends a polyline, a spline or a hatch, whichever is open.
  void endEntity() override {
    if (spline_)
      finishSpline();
    else if (hatch_)
      finishHatch();
    else
      finishPolyline();
  }

 private:
  struct Polyline {
    DxfItem item;
    bool spatial, closed;
    Eigen::Matrix<double, 2, 3> plane;
    std::vector<DxfVertex> vertices;
    double height;
    bool climbs;
  };

  [[nodiscard]] std::size_t line() const {
    return clean_.objects[std::min(std::max<std::size_t>(objects_, 1), clean_.objects.size()) - 1].line;
  }

  /// Negative for layers that are switched off; beyond 256 there is no meaning.
  [[nodiscard]] int colorIndex() const { return std::clamp(attributes.getColor(), -257, 257); }
  DxfItem item() { return {{utf8(attributes.getLayer()), colorIndex(), attributes.getColor24()}, {}, {}, line()}; }
  [[nodiscard]] Vec3 normal() const {
    const double* n = extrusion->getDirection();
    const Vec3 given(n[0], n[1], n[2]);
    return given.norm() > 1e-9 ? Vec3(given.normalized()) : Vec3(0, 0, 1);
  }
  [[nodiscard]] Eigen::Matrix<double, 2, 3> plane() const { return dxfPlane(normal(), extrusion->getElevation()); }

  void place(DxfItem placed) {
    if (placed.path.segments.empty())
      ++drawing_.degenerate;
    else
      target_->items.push_back(std::move(placed));
  }
  void add(std::vector<Segment> segments, bool closed) {
    finishPolyline();
    DxfItem placed = item();
    placed.path.segments = std::move(segments);
    placed.path.closed = closed;
    place(std::move(placed));
  }
  /// From the plane of the entity to the drawing.
  std::optional<Path> inDrawing(Path path, const Eigen::Matrix<double, 2, 3>& from) {
    const double area = from.leftCols<2>().determinant();
    if (std::abs(area) < 1e-9) {
      ++drawing_.degenerate;
      return {};
    }
    if (std::abs(std::abs(area) - 1) > 1e-12) ++drawing_.flattened;
    const Eigen::Matrix<double, 2, 3> same = dxfPlane(Vec3(0, 0, 1), 0);
    return from == same ? std::move(path) : transformed(path, from);
  }

  void addRound(const Arc2& arc, bool closed) {
    finishPolyline();
    if (!(arc.radius > 0)) {
      ++drawing_.degenerate;
      return;
    }
    if (std::optional<Path> path = inDrawing({{arc}, closed, {}, {}}, plane())) add(std::move(path->segments), closed);
  }

  void finishPolyline();
  void finishSpline();
  void finishHatch();
  void addTo(Curves& loop, const DL_HatchEdgeData&) const;
  std::optional<Segment> hatchSegment(const DL_HatchEdgeData&) const;
  Segment splineSegment(int degree, std::vector<double> knots, std::vector<Vec3> polesAndWeights) const;

  const CleanDxf& clean_;
  const Progress& progress_;
  DxfDrawing drawing_;
  DxfBlock* target_ = &drawing_.model;
  std::size_t objects_ = 0;
  std::optional<Polyline> polyline_;
  std::optional<DL_SplineData> spline_;
  std::vector<Vec3> poles_;
  std::vector<Vec2> fits_;
  std::vector<double> knots_, heights_;
  bool hatch_ = false;
  std::vector<Curves> loops_;  ///< edges of each loop of the hatch at hand
};

void Collector::addEllipse(const DL_EllipseData& d) {
  finishPolyline();
  const Vec3 major(d.mx, d.my, d.mz);
  const Vec3 minor = normal().cross(major) * d.ratio;
  const Vec2 across = minor.head<2>(), along = major.head<2>();
  const double span = d.angle2 - d.angle1;
  const double sweep = std::abs(span - fullTurn) < 1e-9 ? fullTurn : sweepBetween(d.angle1, d.angle2);
  const bool full = std::abs(sweep - fullTurn) < 1e-9;
  const double area = along.x() * across.y() - along.y() * across.x();
  if (!(std::abs(area) > 1e-18)) {
    ++drawing_.degenerate;
    return;
  }
  if (d.mz == 0 && minor.z() == 0) {
    const double ratio = std::copysign(across.norm() / along.norm(), area);
    add({ellipticArc({d.cx, d.cy}, along, ratio, d.angle1, sweep)}, full);
    return;
  }
  ++drawing_.flattened;
  Eigen::Matrix<double, 2, 3> map;
  map << along.x(), across.x(), d.cx, along.y(), across.y(), d.cy;
  add({transformed(Segment(ellipticArc({0, 0}, {1, 0}, 1, d.angle1, sweep)), map)}, full);
}

void Collector::finishPolyline() {
  if (!polyline_) return;
  Polyline polyline = std::move(*polyline_);
  polyline_.reset();
  if (polyline.climbs) ++drawing_.flattened;
  Path path = polylinePath(polyline.vertices, polyline.closed);
  if (path.segments.empty()) {
    ++drawing_.degenerate;
    return;
  }
  std::optional<Path> placed = polyline.spatial ? std::move(path) : inDrawing(std::move(path), polyline.plane);
  if (!placed) return;
  polyline.item.path = std::move(*placed);
  place(std::move(polyline.item));
}

Segment Collector::splineSegment(int degree, std::vector<double> knots, std::vector<Vec3> poles) const {
  for (Vec3& pole : poles) {
    if (!(pole.z() > 0)) throw damaged(line(), fmt::format("a spline has the weight {}.", pole.z()));
    pole.head<2>() *= pole.z();
  }
  Spline2 spline{degree, std::move(knots), std::move(poles)};
  try {
    const Curve curve = toCurve(spline);
    validate(curve);
    if (!(curve.domain().first < curve.domain().second)) throw damaged(line(), "a spline has an empty domain.");
  } catch (const Error& error) {
    throw error.code() == ErrorCode::FormatDamaged ? error : damaged(line(), error.message());
  }
  return spline;
}

void Collector::finishSpline() {
  const DL_SplineData data = *spline_;
  spline_.reset();
  if (std::any_of(heights_.begin(), heights_.end(), [&](double z) { return z != heights_.front(); })) ++drawing_.flattened;
  const bool saysClosed = (data.flags & 1) != 0;
  if (!poles_.empty()) {
    const Segment segment = splineSegment(static_cast<int>(data.degree), knots_, poles_);
    add({segment}, meets(startPoint(segment), endPoint(segment)));
    return;
  }
  const auto tangent = [](double x, double y) {
    return x == 0 && y == 0 ? std::nullopt : std::optional(Vec2(x, y).normalized());
  };
  const bool closed = saysClosed || (fits_.size() > 3 && meets(fits_.front(), fits_.back()));
  std::optional<Spline2> spline = interpolated(fits_, closed, tangent(data.tangentStartX, data.tangentStartY),
                                               tangent(data.tangentEndX, data.tangentEndY));
  if (!spline) {
    ++drawing_.degenerate;
    return;
  }
  ++drawing_.interpolated;
  add({*spline}, closed);
}

std::optional<Segment> Collector::hatchSegment(const DL_HatchEdgeData& e) const {
  // Clockwise edges measure their angles clockwise.
  const double sign = e.type == 2 || e.type == 3 ? (e.ccw ? 1 : -1) : 1;
  switch (e.type) {
    case 1:
      if (e.x1 == e.x2 && e.y1 == e.y2) return {};
      return Line2{{e.x1, e.y1}, {e.x2, e.y2}};
    case 2:
      if (!(e.radius > 0)) return {};
      return Arc2{{e.cx, e.cy}, e.radius, sign * e.angle1, sign * sweepBetween(e.angle1, e.angle2)};
    case 3: {
      const Vec2 axis(e.mx, e.my);
      if (!(axis.norm() * std::abs(e.ratio) > 1e-12)) return {};
      return ellipticArc({e.cx, e.cy}, axis, e.ratio, sign * e.angle1, sign * sweepBetween(e.angle1, e.angle2));
    }
    case 4: {
      std::vector<Vec3> poles;
      for (std::size_t i = 0; i < e.controlPoints.size(); ++i) {
        if (e.controlPoints[i].size() < 2) throw damaged(line(), "a HATCH has a pole with one coordinate only.");
        poles.emplace_back(e.controlPoints[i][0], e.controlPoints[i][1], i < e.weights.size() ? e.weights[i] : 1);
      }
      if (e.degree < 1 || e.degree > 25 || poles.size() < e.degree + 1 || e.knots.size() != poles.size() + e.degree + 1)
        throw damaged(line(), "a HATCH has a spline whose poles, knots and degree do not agree.");
      return splineSegment(static_cast<int>(e.degree), e.knots, std::move(poles));
    }
    default:
      return {};
  }
}

void Collector::addTo(Curves& loop, const DL_HatchEdgeData& edge) const {
  if (!edge.vertices.empty()) {
    std::vector<DxfVertex> vertices;
    for (const std::vector<double>& v : edge.vertices)
      if (v.size() >= 2) vertices.push_back({{v[0], v[1]}, v.size() > 2 ? v[2] : 0});
    if (vertices.size() >= 2) loop.paths.push_back(polylinePath(vertices, true));
  } else if (std::optional<Segment> segment = hatchSegment(edge)) {
    const bool closed = meets(startPoint(*segment), endPoint(*segment));
    loop.paths.push_back({{std::move(*segment)}, closed, {}, {}});
  }
}

void Collector::finishHatch() {
  hatch_ = false;
  for (const Curves& edges : loops_) {
    for (Path& path : joined(edges).paths) {
      DxfItem placed = item();
      if (path.segments.empty()) continue;
      if (std::optional<Path> inPlace = inDrawing(std::move(path), plane())) {
        placed.path = std::move(*inPlace);
        place(std::move(placed));
      }
    }
  }
  loops_.clear();
}

void Collector::addInsert(const DL_InsertData& d) {
  finishPolyline();
  DxfItem placed = item();
  placed.insert = DxfInsert{
      blockKey(d.name),   plane(), {d.ipx, d.ipy}, {d.sx, d.sy}, {d.colSp, d.rowSp}, toRadians(d.angle), std::max(d.cols, 1),
      std::max(d.rows, 1)};
  target_->items.push_back(std::move(placed));
}

}  // namespace

DxfDrawing readDxfDrawing(const CleanDxf& clean, const Progress& progress) {
  Collector collector(clean, progress);
  std::istringstream stream(clean.text);
  DL_Dxf dxf;
  dxf.in(stream, &collector);
  return collector.take();
}

}  // namespace blossom
