#pragma once
#include <filesystem>
#include <memory>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/shape/shape.h"
#include "geometry/tessellate/tessellate.h"
#include "geometry/values/color.h"

// A vtkSmartPointer can only be copied where its type is complete.
#include <vtkActor.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSmartPointer.h>

class vtkRenderer;

namespace blossom {

class PickIndex;

/// Colours and widths of a drawing; one for the dark canvas, one for its light twin.
struct Look {
  Color backgroundTop, backgroundBottom;
  Color made;     ///< the warm accent: what is being made
  Color control;  ///< the cool accent: what controls it
  Color surface;  ///< faces that have no colour of their own
  Color edge;     ///< feature edges of a shape with faces
  Color curve;    ///< drawings and curves without faces
  Color grid;
  double edgeWidth = 1.2;  ///< pixels, at a device pixel ratio of 1
  double pointSize = 6;
  static Look dark();
  static Look light();
};

/// Between two colours; t = 0 gives `from`.
Color mixed(const Color& from, const Color& to, double t);

/// What the screen shows of one shape. The arrays of the Tessellation become vtkPolyData with normals, per-face colours and
/// the cell arrays "face" and "edge" with the numbers for picking. Parts that the shape does not have are null.
struct SceneData {
  vtkSmartPointer<vtkPolyData> faces;
  vtkSmartPointer<vtkPolyData> edges;
  vtkSmartPointer<vtkPolyData> points;
  vtkSmartPointer<vtkPoints> vertices;     ///< by their number; picked, not drawn
  bool solid = false;                      ///< the faces close, outward side out: a cut through them is filled
  std::shared_ptr<const PickIndex> picks;  ///< null until somebody has made it
  bool planar = false;                     ///< a drawing: all of it lies at z = 0, faces have no normals
  /// The faces once more, in parts that go to the graphics card between two events each; empty: `faces` is small enough.
  std::vector<vtkSmartPointer<vtkPolyData>> pieces;
  [[nodiscard]] bool empty() const;
};
/// O(points + triangles). Safe to call from any thread. Without `picks`.
SceneData toSceneData(const Tessellation&);

/// Actors of a shape, ready to be added to a renderer: faces first (one for each piece), then edges, then points.
std::vector<vtkSmartPointer<vtkActor>> makeActors(const SceneData&, const Look&);
/// What part of a shape an actor of `makeActors` draws.
enum class ActorRole { Faces, Edges, Points };
ActorRole roleOf(vtkActor*);

/// Lights and gradient background as Blossom draws them.
void setUpRenderer(vtkRenderer*, const Look&);

/// Looks at everything from the direction given with a small margin: "iso", "top", "bottom", "front", "back", "left",
/// "right", or "auto": top for drawings that lie in a plane z = constant, iso for the rest.
/// @throws Error InvalidParameter for another name.
void fitCamera(vtkRenderer*, const std::string& view = "iso");
/// The names that fitCamera takes.
const std::vector<std::string>& viewNames();

struct PictureOptions {
  int width = 1280;  ///< pixels, 1..32768
  int height = 800;
  std::string view = "auto";  ///< one of viewNames()
  bool lightTheme = false;
  bool transparent = false;
  bool edges = true;
  double chord = 0;  ///< mm; 0: as fine as the picture needs
};

/// Renders shapes to a PNG file with no display (EGL surfaceless context). The image is drawn in tiles at twice its size and
/// scaled down, so it may be larger than any frame buffer. Safe to call from any thread, one picture at a time.
/// @throws Error Internal with the driver's words when no context can be made; InvalidParameter; InvalidInput when there is
/// nothing to draw; FileUnwritable; Cancelled.
void renderPicture(const std::vector<Shape>&, const std::filesystem::path& png, const PictureOptions&,
                   const Progress& = Progress::none());

/// Sends what VTK has to say (GLEW's complaints about a missing display among it) to memory instead of a window or stderr.
/// Called by everything in this room that renders.
void quietVtk();
/// What VTK said since the last call, a line each.
std::vector<std::string> takeVtkMessages();

}  // namespace blossom
