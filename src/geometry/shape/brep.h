#pragma once
#include <TopoDS_Shape.hxx>
#include <gp_Trsf.hxx>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "geometry/values/color.h"

namespace blossom {

struct BrepPart;

/// One occurrence of a part in an assembly.
struct BrepInstance {
  std::string name;
  std::optional<Color> color;  ///< overrides the colour of the part
  gp_Trsf location;
  std::shared_ptr<const BrepPart> part;
};

/// A part is either a shape (children empty) or an assembly (shape null).
struct BrepPart {
  std::string name;
  std::optional<Color> color;
  TopoDS_Shape shape;
  std::vector<std::pair<TopoDS_Shape, Color>>
      subShapeColors;  ///< faces (or solids, edges) of `shape` with colours of their own
  std::vector<BrepInstance> children;
};

/// Boundary representation: OCCT shapes with the names, colours and instances of an assembly. Lengths in mm. The OCCT shapes
/// are shared and never modified.
class Brep {
 public:
  Brep() = default;
  explicit Brep(TopoDS_Shape shape, std::string name = {}, std::optional<Color> color = {});
  explicit Brep(std::vector<BrepInstance> roots);

  [[nodiscard]] const std::vector<BrepInstance>& roots() const { return roots_; }
  /// All instances at their locations as one shape: a single shape itself, else a compound.
  [[nodiscard]] const TopoDS_Shape& shape() const { return shape_; }

 private:
  std::vector<BrepInstance> roots_;
  TopoDS_Shape shape_;
};

}  // namespace blossom
