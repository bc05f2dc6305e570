#include "exchange/cad/worker_calls.h"

#include "exchange/cad/brep_export.h"
#include "exchange/cad/brep_import.h"

namespace blossom {

void registerExchangeCalls() {
  registerBrepReader("step.read", readStep);
  registerBrepReader("iges.read", readIges);
  registerBrepReader("brep.read", readBrep);
  registerBrepWriter("step.write", writeStep);
  registerBrepWriter("iges.write", writeIges);
  registerBrepWriter("brep.write", writeBrep);
}

}  // namespace blossom
