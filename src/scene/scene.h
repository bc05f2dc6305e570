#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "core/progress.h"
#include "geometry/color.h"
#include "geometry/shape.h"
#include "geometry/tessellate.h"

#include <vtkSmartPointer.h>

class vtkActor;
class vtkPolyData;
class vtkRenderer;

namespace blossom {

/// Colours and widths of a drawing; one for the dark canvas, one for its light twin.
struct Look {
  Color backgroundTop, backgroundBottom;
  Color made;      ///< the warm accent: what is being made
  Color control;   ///< the cool accent: what controls it
  Color surface;   ///< faces that have no colour of their own
  Color edge;
  double edgeWidth = 1.2;
  double pointSize = 6;
  static Look dark();
  static Look light();
};

/// What the screen shows of one shape. The arrays of the Tessellation become vtkPolyData with normals, per-face colours and a cell
/// array "face" for picking.
struct SceneData {
  vtkSmartPointer<vtkPolyData> faces;
  vtkSmartPointer<vtkPolyData> edges;
  vtkSmartPointer<vtkPolyData> points;
  [[nodiscard]] bool empty() const;
};
SceneData toSceneData(const Tessellation&);

/// Actors of a shape, ready to be added to a renderer.
std::vector<vtkSmartPointer<vtkActor>> makeActors(const SceneData&, const Look&);

/// Lights, gradient background and depth peeling as Blossom draws them.
void setUpRenderer(vtkRenderer*, const Look&);
/// Looks at everything from the direction given ("iso", "top", "front", "right", ..) with a small margin.
void fitCamera(vtkRenderer*, const std::string& view = "iso");

struct PictureOptions {
  int width = 1280;
  int height = 800;
  std::string view = "iso";   ///< iso, top, bottom, front, back, left, right
  bool lightTheme = false;
  bool transparent = false;
  bool edges = true;
  double chord = 0;           ///< mm; 0: as fine as the picture needs
};

/// Renders shapes to a PNG file with no display (EGL surfaceless context).
/// @throws Error Internal with the driver's words when no context can be made; FileUnwritable.
void renderPicture(const std::vector<Shape>&, const std::filesystem::path& png, const PictureOptions&, const Progress& = Progress::none());

class FormatRegistry;
/// Registers PNG as a format that can be written.
void addPictureFormats(FormatRegistry&);

}  // namespace blossom
