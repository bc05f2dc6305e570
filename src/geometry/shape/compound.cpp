#include "geometry/shape/compound.h"

#include <BRep_Builder.hxx>
#include <TopoDS_Compound.hxx>

namespace blossom {

TopoDS_Shape compoundOf(const std::vector<TopoDS_Shape>& shapes) {
  if (shapes.size() == 1) return shapes.front();
  TopoDS_Compound compound;
  const BRep_Builder builder;
  builder.MakeCompound(compound);
  for (const TopoDS_Shape& shape : shapes) builder.Add(compound, shape);
  return compound;
}

}  // namespace blossom
