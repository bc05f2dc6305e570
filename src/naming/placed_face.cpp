#include "naming/placed_face.h"

#include <BRepBndLib.hxx>
#include <BRepTools.hxx>
#include <BRep_Tool.hxx>
#include <Precision.hxx>
#include <cmath>
#include <gp_Pnt.hxx>
#include <gp_Pnt2d.hxx>

#include "geometry/occt/occt_vector.h"

namespace blossom {

namespace {

gp_Pnt point(const Vec3& p) { return {p.x(), p.y(), p.z()}; }

}  // namespace

PlacedFace::PlacedFace(const TopoDS_Face& face) : face_(TopoDS_Face(face)) {
  BRepBndLib::Add(face_, box_, Standard_False);
  surface_ = new ShapeAnalysis_Surface(BRep_Tool::Surface(face_));
  border_ = std::make_unique<BRepTopAdaptor_FClass2d>(face_, Precision::PConfusion());
  findInside();
}

// The points of a low-discrepancy sequence in the rectangle of parameters: they lie in no place that constructions prefer.
void PlacedFace::findInside() {
  double u0 = 0, u1 = 0, v0 = 0, v1 = 0;
  BRepTools::UVBounds(face_, u0, u1, v0, v1);
  if (Precision::IsInfinite(u0) || Precision::IsInfinite(u1) || Precision::IsInfinite(v0) || Precision::IsInfinite(v1))
    return;
  constexpr int tries = 2000, wanted = 2;
  double s = 0.4142135623730951, t = 0.7320508075688772;
  for (int k = 0; k < tries && static_cast<int>(inside_.size()) < wanted; ++k) {
    const gp_Pnt2d uv(u0 + s * (u1 - u0), v0 + t * (v1 - v0));
    if (border_->Perform(uv, Standard_False) == TopAbs_IN) inside_.push_back(toVec(surface_->Value(uv)));
    s = std::fmod(s + 0.7548776662466927, 1.0);
    t = std::fmod(t + 0.5698402909980532, 1.0);
  }
}

bool PlacedFace::onSurface(const Vec3& p, double tolerance) const {
  static_cast<void>(surface_->ValueOfUV(point(p), tolerance));
  return surface_->Gap() <= tolerance;
}

bool PlacedFace::holds(const Vec3& p, double tolerance) const {
  Bnd_Box reach = box_;
  reach.Enlarge(tolerance);
  if (reach.IsOut(point(p))) return false;
  const gp_Pnt2d uv = surface_->ValueOfUV(point(p), tolerance);
  return surface_->Gap() <= tolerance && border_->Perform(uv, Standard_True) != TopAbs_OUT;
}

}  // namespace blossom
