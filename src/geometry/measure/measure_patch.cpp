#include "geometry/measure/measure_patch.h"

#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Bnd_Box.hxx>
#include <Precision.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <algorithm>

#include "core/error.h"
#include "geometry/occt/occt_vector.h"

namespace blossom {

namespace {

Bounds boxOf(const TopoDS_Shape& shape) {
  Bnd_Box box;
  BRepBndLib::Add(shape, box, Standard_False);
  if (box.IsVoid()) throw Error(ErrorCode::InvalidInput, "A part without points cannot be measured.");
  Vec3 low, high;
  box.Get(low.x(), low.y(), low.z(), high.x(), high.y(), high.z());
  Bounds result;
  result.add(low);
  result.add(high);
  return result;
}

void requireFinite(double low, double high) {
  if (!Precision::IsInfinite(low) && !Precision::IsInfinite(high)) return;
  throw Error(ErrorCode::InvalidInput, "A part that reaches to infinity cannot be measured.", "Trim it first.");
}

int samplesAlong(bool straight, int pieces) { return straight ? 9 : std::clamp(5 * pieces, 17, 65); }

bool straightIn(GeomAbs_SurfaceType type, bool alongV) {
  return type == GeomAbs_Plane ||
         (alongV && (type == GeomAbs_Cylinder || type == GeomAbs_Cone || type == GeomAbs_SurfaceOfExtrusion));
}

bool meets(const gp_Pnt& a, const gp_Pnt& b) { return a.IsEqual(b, Precision::Confusion()); }

double between(double low, double high, int i, int count) { return low + (high - low) * i / (count - 1); }

}  // namespace

MeasurePatch::MeasurePatch(const TopoDS_Shape& shape) : box_(boxOf(shape)) {
  if (shape.ShapeType() == TopAbs_VERTEX) {
    vertex_ = toVec(BRep_Tool::Pnt(TopoDS::Vertex(shape)).XYZ());
  } else if (shape.ShapeType() == TopAbs_EDGE) {
    curve_ = std::make_unique<BRepAdaptor_Curve>(TopoDS::Edge(shape));
    low_[0] = curve_->FirstParameter();
    high_[0] = curve_->LastParameter();
    requireFinite(low_[0], high_[0]);
    closed_[0] = meets(curve_->Value(low_[0]), curve_->Value(high_[0]));
  } else {
    const TopoDS_Face face = TopoDS::Face(shape.Oriented(TopAbs_FORWARD));
    surface_ = std::make_unique<BRepAdaptor_Surface>(face, Standard_False);
    trimming_ = std::make_unique<BRepTopAdaptor_FClass2d>(face, 1e-9);
    BRepTools::UVBounds(face, low_[0], high_[0], low_[1], high_[1]);
    requireFinite(low_[0], high_[0]);
    requireFinite(low_[1], high_[1]);
    closed_ = {closes(0), closes(1)};
  }
}

bool MeasurePatch::closes(std::size_t along) const {
  constexpr int places = 3;
  for (int k = 0; k < places; ++k) {
    Parameters first, last;
    first[along] = low_[along], last[along] = high_[along];
    first[1 - along] = last[1 - along] = between(low_[1 - along], high_[1 - along], k, places);
    if (!meets(surface_->Value(first[0], first[1]), surface_->Value(last[0], last[1]))) return false;
  }
  return true;
}

Vec3 MeasurePatch::point(const Parameters& at) const {
  if (surface_) return toVec(surface_->Value(at[0], at[1]).XYZ());
  return curve_ ? toVec(curve_->Value(at[0]).XYZ()) : vertex_;
}

MeasurePatch::Derivatives MeasurePatch::derivatives(const Parameters& at) const {
  if (!surface_ && !curve_) return {vertex_, {Vec3::Zero(), Vec3::Zero()}, {Vec3::Zero(), Vec3::Zero(), Vec3::Zero()}};
  gp_Pnt p;
  gp_Vec u, v, uu, vv, uv;
  if (surface_)
    surface_->D2(at[0], at[1], p, u, v, uu, vv, uv);
  else
    curve_->D2(at[0], p, u, uu);
  return {toVec(p.XYZ()), {toVec(u.XYZ()), toVec(v.XYZ())}, {toVec(uu.XYZ()), toVec(vv.XYZ()), toVec(uv.XYZ())}};
}

bool MeasurePatch::contains(const Parameters& at) const {
  return !trimming_ || trimming_->Perform(gp_Pnt2d(at[0], at[1])) != TopAbs_OUT;
}

const std::vector<MeasurePatch::Sample>& MeasurePatch::samples() const {
  if (samples_.empty()) makeSamples();
  return samples_;
}

double MeasurePatch::spacing() const {
  if (samples_.empty()) makeSamples();
  return spacing_;
}

void MeasurePatch::makeSamples() const {
  if (surface_) {
    countU_ = samplesAlong(straightIn(surface_->GetType(), false), surface_->NbUIntervals(GeomAbs_C2));
    countV_ = samplesAlong(straightIn(surface_->GetType(), true), surface_->NbVIntervals(GeomAbs_C2));
  } else if (curve_) {
    countU_ = samplesAlong(curve_->GetType() == GeomAbs_Line, curve_->NbIntervals(GeomAbs_C2));
  }
  std::vector<Sample> all;
  all.reserve(static_cast<std::size_t>(countU_) * static_cast<std::size_t>(countV_));
  for (int i = 0; i < countU_; ++i)
    for (int j = 0; j < countV_; ++j) {
      const Parameters at{countU_ > 1 ? between(low_[0], high_[0], i, countU_) : low_[0],
                          countV_ > 1 ? between(low_[1], high_[1], j, countV_) : low_[1]};
      all.push_back({point(at), at, i, j});
    }
  const auto step = [&](std::size_t from, std::size_t to) { return (all[to].point - all[from].point).norm(); };
  const auto row = static_cast<std::size_t>(countV_);
  double stepU = 0, stepV = 0;
  for (std::size_t k = 0; k < all.size(); ++k) {
    if (k >= row) stepU = std::max(stepU, step(k - row, k));
    if (k % row > 0) stepV = std::max(stepV, step(k - 1, k));
  }
  spacing_ = (stepU + stepV) / 2;
  for (const Sample& sample : all)
    if (contains(sample.at)) samples_.push_back(sample);
  // The grid may miss a narrow face; Newton's method may still come into it from beside.
  if (samples_.empty()) samples_ = all;
  grid_.assign(all.size(), -1);
  for (std::size_t k = 0; k < samples_.size(); ++k) grid_[cell(samples_[k].i, samples_[k].j)] = static_cast<int>(k);
}

std::size_t MeasurePatch::cell(int i, int j) const {
  return static_cast<std::size_t>(i) * static_cast<std::size_t>(countV_) + static_cast<std::size_t>(j);
}

int MeasurePatch::placeOf(int i, int j) const {
  const bool there = i >= 0 && i < countU_ && j >= 0 && j < countV_;
  return there ? grid_[cell(i, j)] : -1;
}

std::vector<std::size_t> MeasurePatch::localMinima(const std::vector<double>& values) const {
  std::vector<std::size_t> result;
  for (std::size_t k = 0; k < values.size(); ++k) {
    bool lowest = true;
    for (int i = -1; i <= 1 && lowest; ++i)
      for (int j = -1; j <= 1 && lowest; ++j) {
        const int other = placeOf(samples_[k].i + i, samples_[k].j + j);
        lowest = other < 0 || values[static_cast<std::size_t>(other)] >= values[k];
      }
    if (lowest) result.push_back(k);
  }
  return result;
}

}  // namespace blossom
