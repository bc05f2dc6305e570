#pragma once
#include "feature/feature_type.h"
#include "kernel/limit_curve.h"
#include "scheme_choice.h"

namespace blossom::subdivision {

/// What is made of a cage.
enum class As { Cage, Limit, Faces };

ParameterSpec asChoice();
inline constexpr const char* kAsHelp =
    "The cage itself; limit: a mesh or polygon with its vertices on the limit shape; faces: B-spline faces, or the B-spline "
    "curve. Without a choice the command line takes limit for STL, PLY and OFF and faces for STEP, IGES and BREP.";
/// The choice that suits a file.
ChoiceByOutput asByOutput();

struct PresentOptions {
  Chosen scheme = Chosen::CatmullClark;
  As as = As::Cage;
  int cageLevels = 0;       ///< how often a cage is refined
  int limitLevels = 3;      ///< how often before its vertices move to the limit
  double tolerance = 0.01;  ///< mm, of faces near extraordinary points
};

/// Each sets the shape of `out` and tells in its stats and warnings what was made.
void present(Mesh cage, const PresentOptions&, Evaluated& out, const Progress&);
/// The mesh with rims that lie on each other joined, and a warning that tells it.
Mesh closedCage(const Mesh&, Chosen, Evaluated& out, const Progress&);

/// Tells that the poles of a B-spline curve are taken as a control polygon, if they are. @pre `polygonOf` gives one
void tellIfPoles(const Shape& cage, Evaluated& out);

/// @param like drawn lines or a curve of degree 1
void present(ControlPolygon, const Shape& like, const PresentOptions&, Evaluated& out, const Progress&);
void present(Curve, const PresentOptions&, Evaluated& out, const Progress&);

}  // namespace blossom::subdivision
