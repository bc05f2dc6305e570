#pragma once
#include <TopAbs_ShapeEnum.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Vertex.hxx>
#include <string>
#include <vector>

#include "geometry/shape/shape.h"

/// Numbering of sub-shapes, for picking and for parameters of kind SubShape. In a B-rep: the index, from 0, in
/// TopExp::MapShapes of its `shape()` for that type. In a region or curves: edge k is segment k, counted loop by loop (path
/// by path); vertex k is the start of segment k; face 0 is the only face. In a mesh: face k is polygon k, vertex k is vertex
/// k.
namespace blossom {

enum class SubShapeKind { Whole, Face, Edge, Vertex };

/// "face", "edge", "vertex"; "part" for Whole.
std::string subShapeKindName(SubShapeKind);
/// Inverse; Whole for any other name.
SubShapeKind subShapeKindOf(const std::string& name);

/// The sub-shapes of one type, each once, in the order of their numbers.
std::vector<TopoDS_Shape> subShapesOf(const TopoDS_Shape&, TopAbs_ShapeEnum type);
/// TopAbs_VERTEX for Whole, too.
TopAbs_ShapeEnum shapeTypeOf(SubShapeKind);

/// @throws Error NotFound with the number of sub-shapes: "The shape has 12 edges; edge 13 is not among them."
TopoDS_Face faceOf(const Brep&, int index);
TopoDS_Edge edgeOf(const Brep&, int index);
TopoDS_Vertex vertexOf(const Brep&, int index);

}  // namespace blossom
