#pragma once
#include <filesystem>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/shape/shape.h"
#include "geometry/tessellate/tessellate.h"
#include "geometry/values/color.h"
#include "scene/surface_display.h"

// A vtkSmartPointer can only be copied where its type is complete.
#include <vtkActor.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

class vtkRenderer;

namespace blossom {

class PickIndex;

/// Colours and line widths of the scene, for the dark and the light theme.
struct Look {
  Color backgroundTop, backgroundBottom;
  Color made;       ///< the warm accent, for results
  Color madeFaces;  ///< the same for their faces, which are shaded: where lines must be dark, these need not
  Color control;    ///< the cool accent, for controls
  Color surface;    ///< faces without a colour of their own
  Color edge;       ///< feature edges of a shape with faces
  Color curve;      ///< drawings and curves without faces
  Color grid;
  Color fault;             ///< edges of a shape whose feature fails now
  double edgeWidth = 1.2;  ///< pixels, at a device pixel ratio of 1
  double pointSize = 6;
  static Look dark();
  static Look light();
};

/// Linear interpolation of two colours; `from` at t = 0.
Color mixed(const Color& from, const Color& to, double t);

/// Drawing data of one shape. The arrays of the Tessellation become vtkPolyData with normals, per-face colours and the cell
/// arrays "face" and "edge" with the numbers for picking. Data that the shape does not have are null.
struct SceneData {
  vtkSmartPointer<vtkPolyData> faces;
  vtkSmartPointer<vtkPolyData> edges;
  vtkSmartPointer<vtkPolyData> points;
  vtkSmartPointer<vtkPoints> vertices;     ///< by number; picked, not drawn
  bool solid = false;                      ///< the faces are closed and face outwards: sections of them are filled
  std::shared_ptr<const PickIndex> picks;  ///< null until it is built
  bool planar = false;                     ///< a drawing: everything lies in z = 0, faces have no normals
  bool colorsTellKinds = false;            ///< of edges: kept whatever is selected
  /// The faces divided into parts that are uploaded to the GPU one per event turn; empty when `faces` is small enough.
  std::vector<vtkSmartPointer<vtkPolyData>> pieces;
  [[nodiscard]] bool empty() const;
};
/// O(points + triangles). Safe to call from any thread. Without `picks`.
SceneData toSceneData(const Tessellation&);

/// Actors of a shape, ready to be added to a renderer: faces first (one for each piece), then edges, then points.
std::vector<vtkSmartPointer<vtkActor>> makeActors(const SceneData&, const Look&);
/// The data of a shape that an actor of `makeActors` or `makeIsoCurveActor` draws.
enum class ActorRole { Faces, Edges, Points, IsoCurves };
ActorRole roleOf(vtkActor*);

/// Sets lights and gradient background.
void setUpRenderer(vtkRenderer*, const Look&);

/// Places the camera in the given direction so that everything is visible with a small margin: "iso", "top", "bottom",
/// "front", "back", "left", "right", or "auto": top for drawings in a plane z = constant, iso for the rest.
/// @throws Error InvalidParameter for another name.
void fitCamera(vtkRenderer*, const std::string& view = "iso");
/// The names that fitCamera accepts.
const std::vector<std::string>& viewNames();

struct PictureOptions {
  int width = 1280;  ///< pixels, 1..32768
  int height = 800;
  std::string view = "auto";  ///< one of viewNames()
  bool lightTheme = false;
  bool transparent = false;
  bool edges = true;
  double chord = 0;  ///< mm; 0: chosen by the resolution of the picture
  SurfaceDisplay display = SurfaceDisplay::Plain;
  ZebraLook zebra = {};
  int isoCurves = 8;  ///< in each direction of a face
};

/// Renders shapes to a PNG file without a display (EGL surfaceless context). The image is drawn in tiles at twice its size
/// and scaled down, so it may be larger than any frame buffer. Callable from any thread, one picture at a time. Curvatures
/// come with a legend at the lower left. @returns the range of its colours, when curvature is shown.
/// @throws Error Internal with the driver's message when no context can be created; InvalidParameter; InvalidInput when
/// there is nothing to draw; FileUnwritable; Cancelled.
std::optional<CurvatureRange> renderPicture(const std::vector<Shape>&, const std::filesystem::path& png,
                                            const PictureOptions&, const Progress& = Progress::none());

/// Sends what VTK has to say (GLEW's complaints about a missing display among it) to memory instead of a window or stderr.
/// Called by everything in this room that renders.
void quietVtk();
/// The messages of VTK since the last call, one per line.
std::vector<std::string> takeVtkMessages();

}  // namespace blossom
