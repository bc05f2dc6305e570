#pragma once

namespace blossom {

/// Makes the readers of STEP, IGES and BREP callable in `blossom-worker`.
void registerExchangeCalls();

}  // namespace blossom
