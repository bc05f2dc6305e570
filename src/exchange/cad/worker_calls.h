#pragma once

namespace blossom {

/// Makes the readers and writers of STEP, IGES and BREP callable in `blossom-worker`.
void registerExchangeCalls();

}  // namespace blossom
