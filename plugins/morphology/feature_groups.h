#pragma once
#include "feature/registry.h"
#include "kernel/control.h"
#include "kernel/morphology.h"

namespace blossom::morphology {

void registerBall(Registry&);
void registerSums(Registry&);
void registerMorph(Registry&);
void registerGrowth(Registry&);

/// The solids as one mesh, or as a sequence when `times` is not empty.
Evaluated evaluatedFrom(MorphologyResult, const std::vector<double>& times = {});

/// Cells of a preview; 0: the solid itself. The window sets it while something is dragged
/// (document/evaluation/quick_preview.h).
inline ParameterSpec previewCells() { return count(0, 100); }
inline constexpr const char* previewHelp =
    "Makes a preview of so many cells along the longest side, which is quick for any shapes; 0: the solid itself.";

/// Help text of the deviation parameter of every feature with solids as inputs.
inline constexpr const char* deviationHelp =
    "Largest distance between a curved solid or curve and the polyhedron made of it.";

/// 0, 1/(n-1), .., 1.
std::vector<double> frameTimes(int frames);
/// Of the ball by which a solid grows or melts.
ParameterSpec ballRadius();

/// A curve that a user begins with, which leaves t as it is.
inline Value straightControl() { return Value::array({Value::array({0.0, 0.0}), Value::array({1.0, 1.0})}); }
/// f(t) of the parameters `control` and `curve` at each time.
std::vector<double> controlled(Control, const Value& curve, std::vector<double> times);

ParameterSpec controlChoice();
/// Only for the control "curve".
ParameterSpec controlCurveSpec();

inline const std::vector<ShapeKind> solidKinds{ShapeKind::Mesh, ShapeKind::Brep};
inline const std::vector<ShapeKind> elementKinds{ShapeKind::Mesh,   ShapeKind::Brep,  ShapeKind::Region,
                                                 ShapeKind::Curves, ShapeKind::Curve, ShapeKind::Surface};

}  // namespace blossom::morphology
