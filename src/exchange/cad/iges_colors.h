#pragma once
#include <IGESCAFControl_Reader.hxx>
#include <TDocStd_Document.hxx>

namespace blossom {

/// Adds to a document the colours of faces that the reader lost: OCCT 7.8 copies faces of loose surfaces after it has noted
/// which entity each of them comes from. The copies lie on the same surfaces. O(n) for n faces, unless many lie on one
/// surface.
/// @pre the reader has transferred its model into the document
void addLostFaceColors(const IGESCAFControl_Reader&, const Handle(TDocStd_Document) &);

}  // namespace blossom
