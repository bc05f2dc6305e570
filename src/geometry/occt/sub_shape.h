#pragma once
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <string>

#include "geometry/shape/shape.h"

/// Numbering of sub-shapes, for picking and for parameters of kind SubShape. In a B-rep: the index, from 0, in
/// TopExp::MapShapes of its `shape()` for that type. In a region or curves: edge k is segment k, counted loop by loop (path
/// by path); vertex k is the start of segment k; face 0 is the only face. In a mesh: face k is polygon k, vertex k is vertex
/// k.
namespace blossom {

enum class SubShapeKind { Whole, Face, Edge, Vertex };

/// @throws Error NotFound with the number of sub-shapes: "The shape has 12 edges; edge 13 is not among them."
TopoDS_Face faceOf(const Brep&, int index);
TopoDS_Edge edgeOf(const Brep&, int index);
TopoDS_Vertex vertexOf(const Brep&, int index);

}  // namespace blossom
