#include "exchange/formats.h"

namespace blossom {

FormatRegistry standardFormats() {
  FormatRegistry registry;
#define BLOSSOM_ADD_FORMAT(NAME) registry.add(NAME##Format());
  BLOSSOM_FORMATS(BLOSSOM_ADD_FORMAT)
#undef BLOSSOM_ADD_FORMAT
  return registry;
}

}  // namespace blossom
