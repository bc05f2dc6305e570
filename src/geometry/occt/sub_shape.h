#pragma once
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <string>

#include "geometry/shape/shape.h"

/// How parts of a shape are numbered, for picking and for parameters of kind SubShape. Of a B-rep: the place in
/// TopExp::MapShapes of its `shape()` for that type, from 0. Of a region or curves: edges are the segments, loop by loop
/// (path by path); vertex k is the start of segment k; the only face is 0. Of a mesh: face k is polygon k, vertex k is
/// vertex k.
namespace blossom {

enum class SubShapeKind { Whole, Face, Edge, Vertex };

/// @throws Error NotFound saying how many there are: "The shape has 12 edges; edge 13 is not among them."
TopoDS_Face faceOf(const Brep&, int index);
TopoDS_Edge edgeOf(const Brep&, int index);
TopoDS_Vertex vertexOf(const Brep&, int index);

}  // namespace blossom
