#pragma once
#include <TDocStd_Document.hxx>

#include "geometry/shape/brep.h"

namespace blossom {

/// The assembly of an XCAF document: parts shared as in the document, names, and the colours of parts, instances and
/// sub-shapes. Surface colours take precedence over general and curve colours. Names that OCCT makes up are left out.
Brep fromDocument(const Handle(TDocStd_Document) &);

/// A document without an application, which is sufficient for translators.
Handle(TDocStd_Document) newDocument();

}  // namespace blossom
