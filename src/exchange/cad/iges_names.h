#pragma once
#include <IGESCAFControl_Writer.hxx>
#include <TDocStd_Document.hxx>

namespace blossom {

/// Gives the entities of what was transferred the names of their uses and parts, in the order of the document. OCCT's own
/// way (SetNameMode) goes by the addresses of shapes, and falls over a use that has no name.
void writeIgesNames(IGESCAFControl_Writer&, const Handle(TDocStd_Document) &);

}  // namespace blossom
