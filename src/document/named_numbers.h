#pragma once
#include <string>
#include <vector>

#include "core/dimensioned.h"
#include "core/units.h"
#include "document/document.h"

namespace blossom {

class Registry;

/// A row of the table of named numbers of a document: "width" is "60 mm", "half" is "width/2".
struct NamedNumber {
  std::string name;
  std::string value;  ///< an expression, which may use other names; lengths without a unit are plain numbers
  friend bool operator==(const NamedNumber&, const NamedNumber&) = default;
};

/// The table of a document, as it was written.
std::vector<NamedNumber> numbersOf(const Document&);

/// The values of a table, whose rows may be in any order.
/// @throws Error InvalidParameter: a name that is none or there twice, a value that cannot be computed or needs itself.
NamedNumbers valuesOf(const std::vector<NamedNumber>&);
/// Those of a document; what cannot be computed is left out.
NamedNumbers namedNumbersOf(const Document&);

/// The document with another table, and with the values of all parameters that use its names.
/// @throws Error as valuesOf; InUse when a parameter uses a name that is no more; InvalidParameter naming the feature when a
/// parameter cannot be computed.
Document withNumbers(const Document&, const Registry&, const std::vector<NamedNumber>&);
/// The document with a number under another name, in its table and wherever it is used. @throws as withNumbers; NotFound.
Document withNumberRenamed(const Document&, const Registry&, const std::string& from, const std::string& to);
/// The values of all parameters that use names, computed anew, as after somebody edited the file by hand. What cannot be
/// computed keeps its value.
Document withNumbersApplied(const Document&, const Registry&);

}  // namespace blossom
