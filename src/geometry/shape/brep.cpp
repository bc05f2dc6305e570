#include "geometry/shape/brep.h"

#include <TopLoc_Location.hxx>

#include "geometry/shape/compound.h"

namespace blossom {
namespace {

/// Some files mirror or scale their instances; OCCT accepts such locations only without its check.
TopoDS_Shape placed(const TopoDS_Shape& shape, const gp_Trsf& location) {
  return location.Form() == gp_Identity ? shape : shape.Moved(TopLoc_Location(location), Standard_False);
}

void collect(const BrepInstance& instance, const gp_Trsf& parent, std::vector<TopoDS_Shape>& shapes) {
  if (!instance.part) return;
  const gp_Trsf location = parent * instance.location;
  if (!instance.part->shape.IsNull()) shapes.push_back(placed(instance.part->shape, location));
  for (const BrepInstance& child : instance.part->children) collect(child, location, shapes);
}

}  // namespace

Brep::Brep(TopoDS_Shape shape, std::string name, std::optional<Color> color) {
  auto part = std::make_shared<BrepPart>();
  part->name = name;
  part->color = color;
  part->shape = shape;
  roots_.push_back({std::move(name), {}, gp_Trsf(), std::move(part)});
  shape_ = std::move(shape);
}

Brep::Brep(std::vector<BrepInstance> roots) : roots_(std::move(roots)) {
  std::vector<TopoDS_Shape> shapes;
  for (const BrepInstance& root : roots_) collect(root, gp_Trsf(), shapes);
  if (!shapes.empty()) shape_ = compoundOf(shapes);
}

}  // namespace blossom
