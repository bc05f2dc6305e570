#pragma once
#include <TDocStd_Document.hxx>

#include "geometry/shape/brep.h"

namespace blossom {

/// The assembly in an XCAF document: parts shared as in the document, names, and the colours of parts, instances and
/// sub-shapes. Surface colours go before general and curve colours. Names that OCCT invents are left out.
Brep fromDocument(const Handle(TDocStd_Document) &);

/// A document without an application: translators need no more.
Handle(TDocStd_Document) newDocument();

}  // namespace blossom
