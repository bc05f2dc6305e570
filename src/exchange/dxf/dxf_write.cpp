#include "exchange/dxf/dxf_write.h"

#include <dl_dxf.h>
#include <dl_writer_ascii.h>
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>
#include <set>

#include "core/angle.h"
#include "core/error.h"
#include "core/units.h"
#include "exchange/dxf/dxf_drawing.h"
#include "exchange/format/axis_curves.h"
#include "geometry/planar/planar.h"

namespace blossom {
namespace {

/// Numbers that read back as the same double; dxflib's own writer keeps sixteen places after the point.
class ExactWriter final : public DL_WriterA {
 public:
  using DL_WriterA::DL_WriterA;
  using DL_WriterA::dxfString;
  void dxfReal(int code, double value) const override { dxfString(code, formatNumber(value)); }
  [[nodiscard]] bool failed() const { return openFailed(); }
};

/// Characters that DXF does not allow in names become "_".
std::string layerName(const std::string& name) {
  std::string result = name.empty() ? "0" : name.substr(0, 255);
  for (char& c : result)
    if (std::string_view("<>/\\\":;?*|=`,").find(c) != std::string_view::npos || static_cast<unsigned char>(c) < ' ')
      c = '_';
  return result;
}

class DxfWriter {
 public:
  /// @param inSpace curves beside them
  DxfWriter(const Curves& curves, const std::vector<Curve>& inSpace, const std::filesystem::path& path)
      : curves_(curves), inSpace_(inSpace), file_(path.string()) {
    // Opening the file with dxflib sets its version; our own writer then overwrites the file.
    delete dxf_.out(file_.c_str(), DL_Codes::AC1015);
    writer_ = std::make_unique<ExactWriter>(file_.c_str(), DL_Codes::AC1015);
    if (writer_->failed()) throw Error(ErrorCode::FileUnwritable, fmt::format("\"{}\" cannot be written.", file_));
  }

  void write(const Progress& progress) {
    dxf_.writeHeader(*writer_);
    writer_->dxfString(9, "$INSUNITS");
    writer_->dxfInt(70, 4);
    writer_->dxfString(9, "$MEASUREMENT");
    writer_->dxfInt(70, 1);
    writer_->sectionEnd();
    tables();
    blocks();
    writer_->sectionEntities();
    for (std::size_t i = 0; i < curves_.paths.size(); ++i) {
      if (i % 256 == 0) progress.check();
      path(curves_.paths[i]);
    }
    for (const Curve& curve : inSpace_) {
      progress.check();
      spaceCurve(curve);
    }
    writer_->sectionEnd();
    dxf_.writeObjects(*writer_);
    dxf_.writeObjectsEnd(*writer_);
    writer_->dxfEOF();
    writer_->close();
    if (writer_->failed())
      throw Error(ErrorCode::FileUnwritable, "The drawing could not be written to the end.",
                  "Check that the disk is not full.");
  }

 private:
  void tables() {
    ExactWriter& w = *writer_;
    w.sectionTables();
    dxf_.writeVPort(w);
    w.tableLinetypes(3);
    for (const char* name : {"BYBLOCK", "BYLAYER", "CONTINUOUS"})
      dxf_.writeLinetype(w, DL_LinetypeData(name, name, 0, 0, 0.0));
    w.tableEnd();
    std::set<std::string> layers{"0"};
    for (const Path& p : curves_.paths) layers.insert(layerName(p.layer));
    w.tableLayers(static_cast<int>(layers.size()));
    for (const std::string& name : layers)
      dxf_.writeLayer(w, DL_LayerData(name, 0), DL_Attributes("", 7, -1, "CONTINUOUS", 1.0));
    w.tableEnd();
    w.tableStyle(1);
    dxf_.writeStyle(w, DL_StyleData("Standard", 0, 0, 1, 0, 0, 2.5, "txt", ""));
    w.tableEnd();
    dxf_.writeView(w);
    dxf_.writeUcs(w);
    w.tableAppid(1);
    dxf_.writeAppid(w, "ACAD");
    w.tableEnd();
    dxf_.writeDimStyle(w, 1, 1, 1, 1, 1);
    dxf_.writeBlockRecord(w);
    w.tableEnd();
    w.sectionEnd();
  }

  void blocks() {
    writer_->sectionBlocks();
    for (const char* name : {"*Model_Space", "*Paper_Space", "*Paper_Space0"}) {
      dxf_.writeBlock(*writer_, DL_BlockData(name, 0, 0, 0, 0));
      dxf_.writeEndBlock(*writer_, name);
    }
    writer_->sectionEnd();
  }

  void path(const Path& p) {
    const auto isSpline = [](const Segment& s) { return std::holds_alternative<Spline2>(s); };
    if (p.segments.size() > 1 && std::none_of(p.segments.begin(), p.segments.end(), isSpline)) {
      polyline(p);
      return;
    }
    for (const Segment& s : p.segments) {
      if (const Line2* line = std::get_if<Line2>(&s)) {
        begin("LINE", "AcDbLine", p);
        writer_->coord(10, line->from.x(), line->from.y(), 0);
        writer_->coord(11, line->to.x(), line->to.y(), 0);
      } else if (const Arc2* arc = std::get_if<Arc2>(&s)) {
        round(*arc, p);
      } else {
        spline(std::get<Spline2>(s), p);
      }
    }
  }

  void begin(const char* type, const char* subclass, const Path& p) {
    writer_->entity(type);
    writer_->dxfString(100, "AcDbEntity");
    const int rgb = p.color ? static_cast<int>(std::stoul(toHex(*p.color).substr(1), nullptr, 16)) : -1;
    DL_Attributes attributes(layerName(p.layer), p.color ? nearestDxfColor(*p.color) : 256, -1, "BYLAYER", 1.0);
    attributes.setColor24(rgb);
    writer_->entityAttributes(attributes);
    writer_->dxfString(100, subclass);
  }

  /// ARC always runs counter-clockwise, which is no loss for a path of one arc.
  void round(const Arc2& arc, const Path& p) {
    const bool full = std::abs(arc.sweep) >= fullTurn - 1e-12;
    begin(full ? "CIRCLE" : "ARC", "AcDbCircle", p);
    writer_->coord(10, arc.center.x(), arc.center.y(), 0);
    writer_->dxfReal(40, arc.radius);
    if (full) return;
    const double start = arc.sweep > 0 ? arc.start : arc.start + arc.sweep;
    writer_->dxfString(100, "AcDbArc");
    writer_->dxfReal(50, toDegrees(start));
    writer_->dxfReal(51, toDegrees(start + std::abs(arc.sweep)));
  }

  void polyline(const Path& p) {
    // A bulge cannot represent a full circle: arcs of more than half a turn are divided in two.
    std::vector<std::pair<Vec2, double>> vertices;
    for (const Segment& s : p.segments) {
      const Arc2* arc = std::get_if<Arc2>(&s);
      const int pieces = arc && std::abs(arc->sweep) > std::numbers::pi ? 2 : 1;
      for (int i = 0; i < pieces; ++i) {
        const double angle = arc ? arc->start + arc->sweep * i / pieces : 0;
        const Vec2 at = i == 0 ? startPoint(s) : Vec2(arc->center + arc->radius * Vec2(std::cos(angle), std::sin(angle)));
        vertices.emplace_back(at, arc ? std::tan(arc->sweep / pieces / 4) : 0);
      }
    }
    if (!p.closed) vertices.emplace_back(endPoint(p.segments.back()), 0);
    begin("LWPOLYLINE", "AcDbPolyline", p);
    writer_->dxfInt(90, static_cast<int>(vertices.size()));
    writer_->dxfInt(70, p.closed ? 1 : 0);
    for (const auto& [at, bulge] : vertices) {
      writer_->dxfReal(10, at.x());
      writer_->dxfReal(20, at.y());
      if (bulge != 0) writer_->dxfReal(42, bulge);
    }
  }

  void spline(const Spline2& s, const Path& p) {
    constexpr int closed = 1, rational = 4, planar = 8;
    const bool hasWeights = std::any_of(s.poles.begin(), s.poles.end(), [](const Vec3& pole) { return pole.z() != 1; });
    begin("SPLINE", "AcDbSpline", p);
    writer_->dxfInt(70, planar | (hasWeights ? rational : 0) | (p.closed && p.segments.size() == 1 ? closed : 0));
    writer_->dxfInt(71, s.degree);
    writer_->dxfInt(72, static_cast<int>(s.knots.size()));
    writer_->dxfInt(73, static_cast<int>(s.poles.size()));
    writer_->dxfInt(74, 0);
    for (const double knot : s.knots) writer_->dxfReal(40, knot);
    if (hasWeights)
      for (const Vec3& pole : s.poles) writer_->dxfReal(41, pole.z());
    for (const Vec3& pole : s.poles) writer_->coord(10, pole.x() / pole.z(), pole.y() / pole.z(), 0);
  }

  /// A curve that need not lie in a plane: straight lines as a polyline in space, others as a spline.
  void spaceCurve(const Curve& curve) {
    const bool rational = std::any_of(curve.poles.begin(), curve.poles.end(), [](const Vec4& p) { return p.w() != 1; });
    if (curve.degree == 1 && !rational) return spacePolyline(curve);
    begin("SPLINE", "AcDbSpline", {});
    writer_->dxfInt(70, rational ? 4 : 0);
    writer_->dxfInt(71, curve.degree);
    writer_->dxfInt(72, static_cast<int>(curve.knots.size()));
    writer_->dxfInt(73, static_cast<int>(curve.poles.size()));
    writer_->dxfInt(74, 0);
    for (const double knot : curve.knots) writer_->dxfReal(40, knot);
    if (rational)
      for (const Vec4& pole : curve.poles) writer_->dxfReal(41, pole.w());
    for (const Vec4& pole : curve.poles) writer_->coord(10, pole.x() / pole.w(), pole.y() / pole.w(), pole.z() / pole.w());
  }

  void spacePolyline(const Curve& curve) {
    constexpr int isClosed = 1, inSpace = 8, vertexInSpace = 32;
    const bool closed = curve.poles.size() > 2 && curve.poles.front() == curve.poles.back();
    begin("POLYLINE", "AcDb3dPolyline", {});
    writer_->dxfInt(66, 1);  // vertices follow
    writer_->coord(10, 0, 0, 0);
    writer_->dxfInt(70, inSpace | (closed ? isClosed : 0));
    for (std::size_t i = 0; i + (closed ? 1 : 0) < curve.poles.size(); ++i) {
      const Vec4& pole = curve.poles[i];
      begin("VERTEX", "AcDbVertex", {});
      writer_->dxfString(100, "AcDb3dPolylineVertex");
      writer_->coord(10, pole.x(), pole.y(), pole.z());
      writer_->dxfInt(70, vertexInSpace);
    }
    writer_->entity("SEQEND");
    writer_->dxfString(100, "AcDbEntity");
    writer_->dxfString(8, "0");
  }

  const Curves& curves_;
  const std::vector<Curve>& inSpace_;
  std::string file_;
  DL_Dxf dxf_;
  std::unique_ptr<ExactWriter> writer_;
};

}  // namespace

void writeDxf(const Shape& shape, const std::filesystem::path& path, const Value& options, const Progress& progress) {
  const auto* const axis = shape.get<MedialAxis>();
  std::vector<Curve> inSpace;
  if (axis && options.value("heights", false)) inSpace = spaceCurvesOf(*axis);
  if (const Curve* curve = shape.get<Curve>()) inSpace.push_back(*curve);
  const Curves curves = inSpace.empty() ? *drawingOf(shape) : Curves{};
  DxfWriter(curves, inSpace, path).write(progress);
}

}  // namespace blossom
