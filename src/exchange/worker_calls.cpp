#include "exchange/worker_calls.h"

#include "exchange/brep_import.h"

namespace blossom {

void registerExchangeCalls() {
  registerBrepReader("step.read", readStep);
  registerBrepReader("iges.read", readIges);
  registerBrepReader("brep.read", readBrep);
}

}  // namespace blossom
