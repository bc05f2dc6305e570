#include "geometry/occt/joined_faces.h"

#include <ShapeUpgrade_UnifySameDomain.hxx>
#include <Standard_Failure.hxx>
#include <Standard_OutOfMemory.hxx>

namespace blossom {

TopoDS_Shape withJoinedFaces(const TopoDS_Shape& shape, JoinedEdges edges) {
  try {
    ShapeUpgrade_UnifySameDomain unify(shape, edges == JoinedEdges::Join, Standard_True, Standard_False);
    unify.Build();
    return unify.Shape();
  } catch (const Standard_OutOfMemory&) {
    throw;
  } catch (const Standard_Failure&) {
    return {};
  }
}

}  // namespace blossom
