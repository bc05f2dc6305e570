#pragma once
#include "feature/feature_type.h"
#include "kernel/limit_curve.h"
#include "scheme_choice.h"

namespace blossom::subdivision {

/// Form of the result made of a cage.
enum class As { Cage, Limit, Faces };

ParameterSpec asChoice();
inline constexpr const char* kAsHelp =
    "The cage itself; limit: a mesh or polygon with its vertices on the limit shape; faces: B-spline faces, or the B-spline "
    "curve. By default the command line uses limit for STL, PLY and OFF and faces for STEP, IGES and BREP.";
/// The default form by output file.
ChoiceByOutput asByOutput();

struct PresentOptions {
  SchemeChoice scheme = SchemeChoice::CatmullClark;
  As as = As::Cage;
  int cageLevels = 0;       ///< refinements of a cage
  int limitLevels = 3;      ///< refinements before vertices are moved to the limit
  double tolerance = 0.01;  ///< mm, of faces near extraordinary points
};

/// Sets the shape of `out`, and its stats and warnings.
void present(Mesh cage, const PresentOptions&, Evaluated& out, const Progress&);
/// The mesh with coincident boundaries joined, and a warning about it.
Mesh closedCage(const Mesh&, SchemeChoice, Evaluated& out, const Progress&);

/// Adds a warning when the poles of a B-spline curve are used as a control polygon. @pre `polygonOf` returns one
void tellIfPoles(const Shape& cage, Evaluated& out);

/// @param like drawn lines or a curve of degree 1
void present(ControlPolygon, const Shape& like, const PresentOptions&, Evaluated& out, const Progress&);
void present(Curve, const PresentOptions&, Evaluated& out, const Progress&);

}  // namespace blossom::subdivision
