#pragma once
#include <IGESCAFControl_Writer.hxx>
#include <TDocStd_Document.hxx>

namespace blossom {

/// Sets the names of the transferred IGES entities to those of the instances and parts, in the order of the document. OCCT's
/// own way (SetNameMode) depends on the addresses of shapes, and crashes on an instance without a name.
void writeIgesNames(IGESCAFControl_Writer&, const Handle(TDocStd_Document) &);

}  // namespace blossom
