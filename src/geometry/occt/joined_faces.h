#pragma once
#include <TopoDS_Shape.hxx>

namespace blossom {

enum class JoinedEdges { Stay, Join };

/// A shape whose neighbouring faces on one surface are one face and, when asked for, neighbouring edges on one curve one
/// edge. Null where OCCT fails, as it does at some seams of rings. Edges of the given shape may change even then.
TopoDS_Shape withJoinedFaces(const TopoDS_Shape&, JoinedEdges);

}  // namespace blossom
