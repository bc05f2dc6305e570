#pragma once
#include <TopoDS_Shape.hxx>
#include <vector>

namespace blossom {

/// The shape itself when it is alone, else a compound of all, an empty one of none. The shapes are shared.
TopoDS_Shape compoundOf(const std::vector<TopoDS_Shape>&);

}  // namespace blossom
